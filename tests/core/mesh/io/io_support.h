#pragma once

#include "core/mesh/io/mesh_io.h"

#include <string>

namespace pbffd::test {

/// The mesh that a file of this name and content holds.
Mesh parsed(const std::string& name, const std::string& bytes);

/// The message of the InvalidInput that reading such a file ends in; empty when it can be read.
std::string failureOf(const std::string& name, const std::string& bytes);

/// The mesh moved by `shift`, turned by `linear` about the origin before, with the gradients of that.
DeformedShape moved(const Mesh& mesh, const Mat3& linear, const Vec3& shift = Vec3::Zero());

/// The mesh as it is.
DeformedShape atRest(const Mesh& mesh);

/// A quarter turn about the z axis: x to y. Exact in binary numbers.
Mat3 quarterTurn();

/// The file of the mesh in its own format.
std::string rewritten(const Mesh& mesh, const DeformedShape& shape);

/// The mesh that the file of this shape in another format holds.
Mesh converted(const Mesh& mesh, const DeformedShape& shape, const std::string& name);

/// Null where there is none.
const Attribute* attribute(const Mesh& mesh, const std::string& name, AttributeDomain domain);

/// The bytes of numbers, one after the other.
template <class... Numbers>
std::string bytesOf(Numbers... numbers) {
  std::string bytes;
  (bytes.append(reinterpret_cast<const char*>(&numbers), sizeof numbers), ...);
  return bytes;
}

/// The same with the bytes of each number in the other order.
template <class... Numbers>
std::string swappedBytesOf(Numbers... numbers) {
  std::string bytes;
  const auto add = [&](const std::string& one) { bytes.append(one.rbegin(), one.rend()); };
  (add(bytesOf(numbers)), ...);
  return bytes;
}

/// A copy with the first `from` replaced; the text must be there.
std::string replaced(std::string text, const std::string& from, const std::string& to);

}  // namespace pbffd::test
