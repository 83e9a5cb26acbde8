#include "core/mesh/io/reshaped.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/mesh/normals.h"

#include <Eigen/Geometry>

#include <cmath>
#include <utility>

namespace pbffd::io {
namespace {

/// det(F) F^-T, which also exists for a singular F: it takes the normal of an area to that of its image.
Mat3 cofactor(const Mat3& f) {
  Mat3 result;
  result.col(0) = f.col(1).cross(f.col(2));
  result.col(1) = f.col(2).cross(f.col(0));
  result.col(2) = f.col(0).cross(f.col(1));
  return result;
}

/// Where no gradients are known: at each vertex the least rotation that takes its normal at rest to that of
/// the deformed faces.
std::vector<Mat3> leastRotations(const Mesh& mesh, const Points& deformed) {
  const Triangles triangles = triangulate(mesh.positions, mesh.faces);
  const Points before = vertexNormals(mesh.positions, triangles);
  const Points after = vertexNormals(deformed, triangles);
  std::vector<Mat3> rotations(static_cast<std::size_t>(mesh.vertexCount()), Mat3::Identity());
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3 from = before.row(v);
    const Vec3 to = after.row(v);
    if (from != to && !from.isZero(0.0) && !to.isZero(0.0)) {
      rotations[static_cast<std::size_t>(v)] = Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
    }
  }
  return rotations;
}

/// Adds up what the gradients make of normals.
class NormalSums {
 public:
  NormalSums(const Attribute& normals, const std::vector<Mat3>& gradients)
      : before_(Eigen::Map<const Points>(normals.values.data(),
                                         static_cast<Eigen::Index>(normals.values.size() / 3), 3)),
        sums_(Points::Zero(before_.rows(), 3)),
        isTurned_(static_cast<std::size_t>(before_.rows()), 0),
        gradients_(gradients) {}

  void add(Index row, Index vertex) {
    const Mat3& gradient = gradients_[static_cast<std::size_t>(vertex)];
    sums_.row(row) += (cofactor(gradient) * before_.row(row).transpose()).transpose();
    if (gradient != Mat3::Identity()) {
      isTurned_[static_cast<std::size_t>(row)] = 1;
    }
  }

  /// A row that nothing turns, or whose turned normals cancel out, stays.
  TurnedNormals finish() {
    Points values = before_;
    for (Eigen::Index row = 0; row < values.rows(); ++row) {
      const double scale = before_.row(row).stableNorm() / sums_.row(row).stableNorm();
      if (isTurned_[static_cast<std::size_t>(row)] != 0 && std::isfinite(scale)) {
        values.row(row) = scale * sums_.row(row);
      }
    }
    return {std::move(values), std::move(before_)};
  }

 private:
  Points before_;
  Points sums_;
  std::vector<char> isTurned_;
  const std::vector<Mat3>& gradients_;
};

}  // namespace

Reshaped::Reshaped(const Mesh& mesh, const DeformedShape& shape, const Progress& progress)
    : mesh_(mesh), shape_(shape), progress_(progress) {
  const auto vertices = static_cast<std::size_t>(mesh.vertexCount());
  if (shape.positions.rows() != mesh.positions.rows() ||
      (!shape.gradients.empty() && shape.gradients.size() != vertices)) {
    fail(format("The shape has {} positions and the mesh {} vertices", shape.positions.rows(), vertices),
         "Take the shape of the same mesh.");
  }
  if (!shape.positions.allFinite()) {
    fail("The deformed shape has a coordinate that is not a finite number", "Undo the last edit.");
  }
  isMoved_ = (shape.positions.array() != mesh.positions.array()).any();
}

TurnedNormals Reshaped::turned(const Attribute& normals) const {
  const bool isKnown = !shape_.gradients.empty();
  const std::vector<Mat3> rotations = isKnown ? std::vector<Mat3>() : leastRotations(mesh_, shape_.positions);
  NormalSums sums(normals, isKnown ? shape_.gradients : rotations);
  if (normals.domain == AttributeDomain::vertex) {
    for (Index v = 0; v < mesh_.vertexCount(); ++v) {
      sums.add(v, v);
    }
  } else {
    for (std::size_t corner = 0; corner < normals.rowOfCorner.size(); ++corner) {
      if (const Index row = normals.rowOfCorner[corner]; row >= 0) {
        sums.add(row, mesh_.faces.vertices()[corner]);
      }
    }
  }
  return sums.finish();
}

Input Reshaped::source() const {
  return {*mesh_.source.bytes, mesh_.source.name, Progress()};
}

void Reshaped::checkpoint(std::size_t done, std::size_t all) const {
  progress_.throwIfCancelled();
  progress_.report("Writing the mesh", all == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(all));
}

void Reshaped::fail(std::string_view what, std::string_view advice) const {
  const std::string& name = mesh_.source.name;
  throw InvalidInput(format("Could not export {}. {}. {}", name.empty() ? "the mesh" : name, what, advice));
}

}  // namespace pbffd::io
