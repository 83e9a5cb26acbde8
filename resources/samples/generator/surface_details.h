#pragma once

#include "resources/samples/generator/sample.h"

namespace pbffd::samples {

/// Fills in normals that are smooth where neighbouring faces meet at less than `degrees`, sharp elsewhere.
void addCreasedNormals(Sample& sample, double degrees);

/// Fills in texture coordinates by looking at each face along the axis that it faces most: three squares of
/// the texture beside each other for x, y and z.
void addBoxTextures(Sample& sample);

/// Puts all faces into one group of the sample's name.
void addSingleGroup(Sample& sample);

}  // namespace pbffd::samples
