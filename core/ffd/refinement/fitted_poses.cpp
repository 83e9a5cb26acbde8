#include "core/ffd/refinement/fitted_poses.h"

#include "core/base/parallel.h"
#include "core/ffd/deform/deformation.h"
#include "core/ffd/deform/space_deformation.h"
#include "core/ffd/weights/reach.h"
#include "core/mesh/nearest_face_vertex.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <numeric>

namespace pbffd {
namespace {

/// What the places around count for, all together, against all vertices.
constexpr double shareOfPlacesAround = 0.1;
/// By how much a region becomes smaller where its map does not follow, and how often at most; where no vertex
/// would be left in it, the strength is halved instead.
constexpr double shrinking = 0.8;
constexpr double weakening = 0.5;
constexpr int mostRounds = 24;
/// Where the nearest vertex lies at most, between centre and border.
constexpr double touchedAt = 0.8;

/// The places around a point, in units of its region: the centre, on the axes, and between them.
const std::vector<Vec3>& placesAround() {
  static const std::vector<Vec3> places = [] {
    std::vector<Vec3> made{Vec3::Zero()};
    for (int k = 0; k < 3; ++k) {
      made.emplace_back(0.6 * Vec3::Unit(k));
      made.emplace_back(-0.6 * Vec3::Unit(k));
    }
    for (int corner = 0; corner < 8; ++corner) {
      made.emplace_back(0.4 * Vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1));
    }
    return made;
  }();
  return places;
}

/// A least squares fit of displacements that are affine in u: d = shift + change u.
class AffineFit {
 public:
  void add(const Vec3& u, const Vec3& displacement, double weight) {
    const Eigen::Vector4d row(1.0, u.x(), u.y(), u.z());
    normal_.noalias() += weight * row * row.transpose();
    right_.noalias() += weight * row * displacement.transpose();
  }

  /// Row 0: the shift, rows 1 to 3: the change along each axis.
  Eigen::Matrix<double, 4, 3> solved() const { return normal_.ldlt().solve(right_); }

 private:
  Eigen::Matrix4d normal_ = Eigen::Matrix4d::Zero();
  Eigen::Matrix<double, 4, 3> right_ = Eigen::Matrix<double, 4, 3>::Zero();
};

class Fit {
 public:
  Fit(std::vector<ControlPoint> points, const std::shared_ptr<const RestMesh>& mesh, const ControlSet& set,
      const Progress& progress)
      : points_(std::move(points)),
        mesh_(*mesh),
        surface_(*mesh),
        set_(set),
        progress_(progress),
        space_(mesh, set, ReachRule::asStored, progress),
        before_(deformed(set)),
        blocks_(mesh_.positions(), mesh_.mortonOrder()),
        walks_(mesh_),
        reached_(points_.size()) {}

  FittedPoints within(double allowed) {
    std::vector<std::size_t> pending(points_.size());
    std::iota(pending.begin(), pending.end(), 0);
    Eigen::VectorXd change;
    for (int round = 0; round < mostRounds && !pending.empty(); ++round) {
      progress_.report("Refining: poses", static_cast<double>(round) / mostRounds);
      fit(pending);
      change = changes();
      pending = weakened(change, allowed, round + 1 < mostRounds);
    }
    return {std::move(points_), change.size() == 0 ? 0.0 : change.maxCoeff()};
  }

 private:
  Points deformed(const ControlSet& set) const {
    return deformExactly(mesh_, set, parameterize(mesh_, set.basis, set.master, set.finest(), progress_),
                         progress_);
  }

  /// How far each vertex would be moved by adding the points as they are.
  Eigen::VectorXd changes() const {
    ControlSet with = set_;
    for (const ControlPoint& point : points_) {
      with.levels.back().append(point);
    }
    return (deformed(with) - before_).rowwise().norm();
  }

  void fit(const std::vector<std::size_t>& pending) {
    const auto count = static_cast<Index>(placesAround().size());
    Points around(static_cast<Index>(pending.size()) * count, 3);
    for (std::size_t i = 0; i < pending.size(); ++i) {
      const Frame& rest = points_[pending[i]].rest;
      for (Index k = 0; k < count; ++k) {
        around.row(static_cast<Index>(i) * count + k) =
            rest.center + rest.axes * placesAround()[static_cast<std::size_t>(k)];
      }
    }
    const Points moved = space_.positions(around, progress_) - around;
    parallelFor(pending.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !progress_.isCancelled(); ++i) {
        const Index first = static_cast<Index>(i) * count;
        fitOne(pending[i], around.middleRows(first, count), moved.middleRows(first, count));
      }
    });
    progress_.throwIfCancelled();
  }

  void fitOne(std::size_t place, const Points& around, const Points& moved) {
    ControlPoint& point = points_[place];
    reached_[place] = reachedBy(point);
    const Region region(point.rest);
    AffineFit affine;
    double sum = 0.0;
    for (const Index vertex : reached_[place]) {
      const Vec3 u = region.parameter(mesh_.positions().row(vertex));
      const double value = basisValue(set_.basis, u.squaredNorm());
      affine.add(u, before_.row(vertex) - mesh_.positions().row(vertex), value);
      sum += value;
    }
    addAround(affine, place, around, moved, sum);
    const Eigen::Matrix<double, 4, 3> solution = affine.solved();
    point.pose.center = point.rest.center + solution.row(0).transpose();
    point.pose.axes = point.rest.axes + solution.bottomRows<3>().transpose();
  }

  /// Places whose nearest vertex is of another limb say nothing; where that leaves none, all count.
  void addAround(AffineFit& affine, std::size_t place, const Points& around, const Points& moved,
                 double sumOfVertices) const {
    const std::vector<Index>& reached = reached_[place];
    std::vector<Index> used;
    for (Index k = 0; k < static_cast<Index>(around.rows()); ++k) {
      const Index vertex = mesh_.nearestVertex().nearest(around.row(k)).index;
      if (std::binary_search(reached.begin(), reached.end(), vertex)) {
        used.push_back(k);
      }
    }
    if (used.size() < 4) {
      used.resize(static_cast<std::size_t>(around.rows()));
      std::iota(used.begin(), used.end(), 0);
    }
    const double weight =
        sumOfVertices > 0.0 ? shareOfPlacesAround * sumOfVertices / static_cast<double>(used.size()) : 1.0;
    for (const Index k : used) {
      affine.add(placesAround()[static_cast<std::size_t>(k)], moved.row(k), weight);
    }
  }

  /// The vertices that the point counts, ascending.
  std::vector<Index> reachedBy(const ControlPoint& point) {
    const std::vector<Index>& order = mesh_.mortonOrder();
    const Membership members = pbffd::reachedBy(point, blocks_, walks_);
    std::vector<Index> vertices;
    for (std::size_t e = 0; e < members.blocks.size(); ++e) {
      for (Index k = 0; k < PointBlocks::blockSize; ++k) {
        if ((members.members[e] >> k & 1) != 0) {
          vertices.push_back(order[static_cast<std::size_t>(members.blocks[e] * PointBlocks::blockSize + k)]);
        }
      }
    }
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  }

  void shrink(ControlPoint& point) const {
    const Frame smaller{point.rest.center, shrinking * point.rest.axes};
    if (Region(smaller).squaredDistance(surface_.to(smaller.center)) <= touchedAt * touchedAt) {
      point.rest = smaller;
    } else {
      point.strength *= weakening;
    }
  }

  /// Those that reach a vertex which moves too far get less influence.
  std::vector<std::size_t> weakened(const Eigen::VectorXd& change, double allowed, bool isAnotherRound) {
    std::vector<std::size_t> smaller;
    for (std::size_t i = 0; i < points_.size() && isAnotherRound; ++i) {
      const auto isTooFar = [&](Index vertex) { return !(change[vertex] <= allowed); };
      if (std::any_of(reached_[i].begin(), reached_[i].end(), isTooFar)) {
        shrink(points_[i]);
        smaller.push_back(i);
      }
    }
    return smaller;
  }

  std::vector<ControlPoint> points_;
  const RestMesh& mesh_;
  NearestFaceVertex surface_;
  const ControlSet& set_;
  const Progress& progress_;
  SpaceDeformation space_;
  Points before_;
  PointBlocks blocks_;
  ReachWalks walks_;
  std::vector<std::vector<Index>> reached_;  ///< one a point: the vertices that it moves
};

}  // namespace

FittedPoints fittedPoints(std::vector<ControlPoint> points, const std::shared_ptr<const RestMesh>& mesh,
                          const ControlSet& set, double allowed, const Progress& progress) {
  for (ControlPoint& point : points) {
    point.pose = point.rest;
  }
  const bool isMoved = !(set.master.pose == set.master.rest) ||
                       std::any_of(set.finest().begin(), set.finest().end(),
                                   [](const ControlPoint& point) { return !(point.pose == point.rest); });
  if (!isMoved || points.empty()) {
    return {std::move(points), 0.0};
  }
  return Fit(std::move(points), mesh, set, progress).within(allowed);
}

}  // namespace pbffd
