#include "core/ffd/levels/frames_follow.h"

#include "core/base/parallel.h"
#include "core/ffd/rest_centres.h"
#include "core/mesh/nearest.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>

namespace pbffd {
namespace {

constexpr int neighbourCount = 10;
constexpr int fewestNeighbours = 3;

/// The share of the trace that is added to the covariance: it picks the least rotation where the neighbours
/// lie on a line, and is too small to be seen elsewhere.
constexpr double regularization = 1e-3;

/// The rotation nearest to a matrix.
Mat3 rotationOf(const Mat3& matrix) {
  const Eigen::JacobiSVD<Mat3> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 left = svd.matrixU();
  if ((left * svd.matrixV().transpose()).determinant() < 0.0) {
    left.col(2) = -left.col(2);
  }
  return left * svd.matrixV().transpose();
}

class Follower {
 public:
  Follower(const Level& level, const std::vector<Index>& places, const std::vector<Vec3>& displacements)
      : level_(level),
        displacements_(displacements),
        entryOf_(static_cast<std::size_t>(level.size()), -1),
        centres_(restCentres(level)) {
    for (std::size_t k = 0; k < places.size(); ++k) {
      entryOf_[places[k]] = static_cast<Index>(k);
    }
  }

  Mat3 rotation(Index place) const {
    const Vec3 own = displacements_[entryOf_[place]];
    const Vec3 restCenter = level_[place].rest.center;
    Mat3 covariance = Mat3::Zero();
    double trace = 0.0;
    int moved = 0;
    bool turned = false;
    for (const auto& neighbour : centres_.nearest(restCenter, neighbourCount + 1)) {
      const Index entry = entryOf_[neighbour.index];
      if (neighbour.index == place || entry < 0) {
        continue;
      }
      const Vec3 offset = level_[neighbour.index].pose.center - level_[place].pose.center;
      const Vec3 difference = displacements_[entry] - own;
      // Near neighbours tell more; by their distance at rest, which no edit changes.
      const double weight = neighbour.distance > 0.0 ? 1.0 / neighbour.distance : 0.0;
      covariance += weight * (offset + difference) * offset.transpose();
      trace += weight * offset.squaredNorm();
      turned = turned || difference != Vec3::Zero();
      ++moved;
    }
    if (moved < fewestNeighbours || !turned || !(trace > 0.0)) {
      return Mat3::Identity();
    }
    return rotationOf(covariance + regularization * trace * Mat3::Identity());
  }

 private:
  const Level& level_;
  const std::vector<Vec3>& displacements_;
  std::vector<Index> entryOf_;  ///< of a place of the level: its place among the moved, or -1
  NearestPoints centres_;
};

}  // namespace

std::vector<Mat3> followingRotations(const Level& level, const std::vector<Index>& places,
                                     const std::vector<Vec3>& displacements) {
  std::vector<Mat3> rotations(places.size(), Mat3::Identity());
  if (static_cast<int>(places.size()) <= fewestNeighbours) {
    return rotations;
  }
  const Follower follower(level, places, displacements);
  constexpr std::size_t grain = 256;
  parallelFor(places.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      rotations[k] = follower.rotation(places[k]);
    }
  });
  return rotations;
}

}  // namespace pbffd
