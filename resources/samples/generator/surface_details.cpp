#include "resources/samples/generator/surface_details.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace pbffd::samples {
namespace {

/// Twice the area in length, by Newell.
Vec3 areaNormal(const Points& positions, std::span<const Index> corners) {
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 a = positions.row(corners[i]);
    const Vec3 b = positions.row(corners[(i + 1) % corners.size()]);
    normal += a.cross(b);
  }
  return normal;
}

/// Rows of a table, each written once: equal to six digits is equal.
template <int Width>
class Table {
 public:
  using Row = Eigen::Matrix<double, Width, 1>;

  Index rowOf(const Row& row) {
    std::array<long, Width> key;
    for (int i = 0; i < Width; ++i) {
      key[i] = std::lround(row[i] * 1e6);
    }
    const auto [entry, isNew] = index_.emplace(key, static_cast<Index>(rows_.size()));
    if (isNew) {
      rows_.push_back(row);
    }
    return entry->second;
  }

  Eigen::Matrix<double, Eigen::Dynamic, Width, Eigen::RowMajor> matrix() const {
    Eigen::Matrix<double, Eigen::Dynamic, Width, Eigen::RowMajor> matrix(rows_.size(), Width);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      matrix.row(static_cast<Eigen::Index>(i)) = rows_[i];
    }
    return matrix;
  }

 private:
  std::map<std::array<long, Width>, Index> index_;
  std::vector<Row> rows_;
};

}  // namespace

void addCreasedNormals(Sample& sample, double degrees) {
  std::vector<Vec3> ofFace;
  std::vector<std::vector<Index>> facesAround(sample.positions.rows());
  for (Index f = 0; f < sample.faces.size(); ++f) {
    ofFace.push_back(areaNormal(sample.positions, sample.faces[f]));
    for (const Index vertex : sample.faces[f]) {
      facesAround[vertex].push_back(f);
    }
  }
  const double least = std::cos(degrees * std::numbers::pi / 180.0);
  Table<3> table;
  for (Index f = 0; f < sample.faces.size(); ++f) {
    for (const Index vertex : sample.faces[f]) {
      Vec3 sum = Vec3::Zero();
      for (const Index other : facesAround[vertex]) {
        if (ofFace[f].normalized().dot(ofFace[other].normalized()) >= least) {
          sum += ofFace[other];
        }
      }
      sample.normalOfCorner.push_back(table.rowOf(sum.normalized()));
    }
  }
  sample.normals = table.matrix();
}

void addBoxTextures(Sample& sample) {
  const Bounds bounds = boundsOf(sample.positions);
  const double size = (bounds.high - bounds.low).maxCoeff();
  Table<2> table;
  for (Index f = 0; f < sample.faces.size(); ++f) {
    int axis = 0;
    areaNormal(sample.positions, sample.faces[f]).cwiseAbs().maxCoeff(&axis);
    for (const Index vertex : sample.faces[f]) {
      const Vec3 at = (sample.positions.row(vertex).transpose() - bounds.low) / size;
      sample.textureOfCorner.push_back(
          table.rowOf(Eigen::Vector2d((axis + at[(axis + 1) % 3]) / 3.0, at[(axis + 2) % 3])));
    }
  }
  sample.textures = table.matrix();
}

void addSingleGroup(Sample& sample) {
  sample.groups = {sample.name};
  sample.groupOfFace.assign(static_cast<std::size_t>(sample.faces.size()), 0);
}

}  // namespace pbffd::samples
