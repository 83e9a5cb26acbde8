#pragma once

#include "core/mesh/mesh.h"

namespace pbffd::test {

// Meshes made in code, so that no test depends on a file.

/// A unit cube about the origin: 8 vertices, 6 quads, closed.
Mesh cube();

/// A sphere of radius 1: rings x segments quads with triangles at the poles, closed.
Mesh sphere(int rings = 16, int segments = 32);

/// A closed cylinder about the x axis from 0 to `length`: the bar of the bending tasks.
Mesh cylinder(double length = 4.0, double radius = 0.5, int rings = 40, int segments = 24);

/// A flat sheet of n x n quads over [-1, 1]^2 in the plane z = 0: an open surface.
Mesh sheet(int n = 10);

/// Two arms side by side: closed cylinders about the x axis, `gap` apart in y, joined at x = 0 by a block:
/// one component where the arms are near in space and far along the surface.
Mesh fork(double gap = 0.2, int rings = 30, int segments = 16);

/// The meshes as one, without joining them.
Mesh merged(const Mesh& first, const Mesh& second);

/// The mesh with every position mapped by x -> scale * x + shift.
Mesh placedAt(Mesh mesh, double scale, const Vec3& shift);

/// The mesh with every face split into triangles.
Mesh triangulated(const Mesh& mesh);

}  // namespace pbffd::test
