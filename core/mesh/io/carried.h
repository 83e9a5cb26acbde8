#pragma once

#include "core/mesh/mesh.h"

#include <optional>

namespace pbffd::io {

// What a mesh says beside its shape, in one form whatever the format it came from, so that another format
// can take it along.

/// Normals of vertices or corners, 3 numbers a row: OBJ's vn, PLY's nx ny nz, OFF's normals.
std::optional<Attribute> normalsOf(const Mesh& mesh);

/// Texture coordinates of vertices or corners, 2 or 3 numbers a row.
std::optional<Attribute> textureCoordinatesOf(const Mesh& mesh);

/// Colours of the vertices or the faces from 0 to 1, 3 or 4 numbers a row. Nothing where some lack one.
std::optional<Attribute> colorsOf(const Mesh& mesh, AttributeDomain domain);

/// Whether such colours are multiples of 1/255, as precisely as text files write them.
bool areBytes(const Attribute& colors);

/// The attribute, of vertices or corners, with a row for each vertex, in the vertex domain. Nothing where
/// corners of one vertex differ, or where a vertex that is used has none.
std::optional<Attribute> perVertex(const Mesh& mesh, const Attribute& attribute);

}  // namespace pbffd::io
