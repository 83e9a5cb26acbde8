#include "core/mesh/nearest.h"

#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace pbffd {
namespace {

/// What nanoflann asks of a set of points.
struct Cloud {
  const Points& points;

  std::size_t kdtree_get_point_count() const { return static_cast<std::size_t>(points.rows()); }
  double kdtree_get_pt(std::size_t row, std::size_t axis) const {
    return points(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(axis));
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Row = std::uint32_t;
using KdTree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud, double, Row>,
                                                   Cloud, 3, Row>;

/// The nearest point with the lowest index: nanoflann's own result sets leave ties to the tree's order.
class LowestNearest {
 public:
  using DistanceType = double;
  using IndexType = Row;

  std::size_t size() const { return index_ < 0 ? 0 : 1; }
  bool full() const { return true; }
  void sort() {}
  bool addPoint(double squared, Row index) {
    const Index candidate = static_cast<Index>(index);
    if (squared < squared_ || (squared == squared_ && candidate < index_)) {
      squared_ = squared;
      index_ = candidate;
    }
    return true;
  }
  /// A little more than the best, so that nodes with a tie are looked at too.
  double worstDist() const {
    return index_ < 0 ? std::numeric_limits<double>::max()
                      : std::nextafter(squared_, std::numeric_limits<double>::max());
  }
  NearestPoints::Neighbour result() const { return {index_, index_ < 0 ? 0.0 : std::sqrt(squared_)}; }

 private:
  Index index_ = -1;
  double squared_ = std::numeric_limits<double>::max();
};

/// All points within a squared distance, the border included.
class AllWithin {
 public:
  using DistanceType = double;
  using IndexType = Row;

  explicit AllWithin(double squared) : squared_(squared) {}
  std::size_t size() const { return found_.size(); }
  bool full() const { return true; }
  void sort() {}
  bool addPoint(double squared, Row index) {
    if (squared <= squared_) {
      found_.push_back({static_cast<Index>(index), squared});
    }
    return true;
  }
  double worstDist() const { return std::nextafter(squared_, std::numeric_limits<double>::max()); }
  /// By distance and then index, with true distances.
  std::vector<NearestPoints::Neighbour> take() {
    std::sort(found_.begin(), found_.end(), [](const auto& a, const auto& b) {
      return a.distance != b.distance ? a.distance < b.distance : a.index < b.index;
    });
    for (auto& neighbour : found_) {
      neighbour.distance = std::sqrt(neighbour.distance);
    }
    return std::move(found_);
  }

 private:
  double squared_;
  std::vector<NearestPoints::Neighbour> found_;
};

}  // namespace

struct NearestPoints::Tree {
  Points own;
  Cloud cloud;
  KdTree index;

  explicit Tree(Points copied) : own(std::move(copied)), cloud{own}, index(3, cloud, parameters()) {}
  explicit Tree(const Points* kept) : cloud{*kept}, index(3, cloud, parameters()) {}

 private:
  static nanoflann::KDTreeSingleIndexAdaptorParams parameters() {
    return nanoflann::KDTreeSingleIndexAdaptorParams(16);
  }
};

NearestPoints::NearestPoints(const Points& points) : tree_(std::make_unique<Tree>(Points(points))) {}
NearestPoints::NearestPoints(std::unique_ptr<Tree> tree) : tree_(std::move(tree)) {}
NearestPoints NearestPoints::over(const Points& points) {
  return NearestPoints(std::make_unique<Tree>(&points));
}
NearestPoints::~NearestPoints() = default;
NearestPoints::NearestPoints(NearestPoints&&) noexcept = default;
NearestPoints& NearestPoints::operator=(NearestPoints&&) noexcept = default;

NearestPoints::Neighbour NearestPoints::nearest(const Vec3& query) const {
  LowestNearest best;
  if (tree_->cloud.points.rows() > 0) {
    tree_->index.findNeighbors(best, query.data(), {});
  }
  return best.result();
}

std::vector<NearestPoints::Neighbour> NearestPoints::nearest(const Vec3& query, int k) const {
  const auto count = static_cast<std::size_t>(std::min<Eigen::Index>(k, tree_->cloud.points.rows()));
  if (count == 0) {
    return {};
  }
  std::vector<Row> indices(count);
  std::vector<double> squared(count);
  nanoflann::KNNResultSet<double, Row> farthest(count);
  farthest.init(indices.data(), squared.data());
  tree_->index.findNeighbors(farthest, query.data(), {});
  // The ball of the k-th neighbour holds every point that ties with it; the lowest indices stay.
  AllWithin all(squared.back());
  tree_->index.findNeighbors(all, query.data(), {});
  std::vector<Neighbour> neighbours = all.take();
  neighbours.resize(count);
  return neighbours;
}

std::vector<NearestPoints::Neighbour> NearestPoints::within(const Vec3& query, double radius) const {
  if (tree_->cloud.points.rows() == 0) {
    return {};
  }
  AllWithin all(radius * radius);
  tree_->index.findNeighbors(all, query.data(), {});
  return all.take();
}

}  // namespace pbffd
