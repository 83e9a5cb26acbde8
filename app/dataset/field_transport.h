#pragma once

#include "core/base/types.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pbffd {

/// What the three numbers of a row of an array are: a vector turns and stretches with the material, a normal
/// stays square to the surface and keeps its length.
enum class FieldKind { vector, normal };

/// An array of a data set that is to turn with the deformation.
struct Transport {
  std::string array;
  std::optional<FieldKind> kind;  ///< none: a normal where the data set or the name says so, else a vector
};

/// "NAME", "NAME:vector" or "NAME:normal". Throws InvalidInput for an empty name.
Transport parseTransport(std::string_view text);

/// All of them. Throws InvalidInput also where one array is named twice.
std::vector<Transport> parseTransports(const std::vector<std::string>& texts);

/// Whether an array's name says that it holds normals.
bool namesNormals(std::string_view name);

/// The field at a place after the deformation, by its gradient there: G v, or the cofactors of G times the
/// normal, at the length that it had.
Vec3 transported(const Mat3& gradient, const Vec3& value, FieldKind kind);

/// Each row by the gradient beside it.
void transportRows(Points& rows, const std::vector<Mat3>& gradients, FieldKind kind);

}  // namespace pbffd
