#include "tests/core/mesh/io/io_support.h"

#include "core/base/error.h"

#include <algorithm>
#include <stdexcept>

namespace pbffd::test {

Mesh parsed(const std::string& name, const std::string& bytes) {
  return parseMesh(std::make_shared<const std::string>(bytes), name);
}

std::string failureOf(const std::string& name, const std::string& bytes) {
  try {
    parsed(name, bytes);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return {};
}

DeformedShape moved(const Mesh& mesh, const Mat3& linear, const Vec3& shift) {
  DeformedShape shape;
  shape.positions = (mesh.positions * linear.transpose()).rowwise() + shift.transpose();
  shape.gradients.assign(static_cast<std::size_t>(mesh.vertexCount()), linear);
  return shape;
}

DeformedShape atRest(const Mesh& mesh) {
  return {mesh.positions, {}};
}

Mat3 quarterTurn() {
  Mat3 turn;
  turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  return turn;
}

std::string rewritten(const Mesh& mesh, const DeformedShape& shape) {
  return encodeMesh(mesh, shape, mesh.source.format);
}

Mesh converted(const Mesh& mesh, const DeformedShape& shape, const std::string& name) {
  return parsed(name, encodeMesh(mesh, shape, formatOfEnding(name)));
}

const Attribute* attribute(const Mesh& mesh, const std::string& name, AttributeDomain domain) {
  const auto found = std::ranges::find_if(
      mesh.attributes, [&](const Attribute& one) { return one.name == name && one.domain == domain; });
  return found == mesh.attributes.end() ? nullptr : &*found;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) {
    throw std::invalid_argument("not there: " + from);
  }
  return text.replace(at, from.size(), to);
}

}  // namespace pbffd::test
