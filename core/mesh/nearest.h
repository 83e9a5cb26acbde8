#pragma once

#include "core/base/types.h"

#include <memory>
#include <vector>

namespace pbffd {

/// A kd-tree over points: the only user of nanoflann.
class NearestPoints {
 public:
  /// Copies the points.
  explicit NearestPoints(const Points& points);
  /// Keeps a reference to points that live as long and stay as they are.
  static NearestPoints over(const Points& points);
  ~NearestPoints();
  NearestPoints(NearestPoints&&) noexcept;
  NearestPoints& operator=(NearestPoints&&) noexcept;

  struct Neighbour {
    Index index;
    double distance;
  };

  /// The nearest point, the lowest index on a tie; index -1 when there are no points.
  Neighbour nearest(const Vec3& query) const;

  /// The k nearest, or all when there are fewer, by distance and then index.
  std::vector<Neighbour> nearest(const Vec3& query, int k) const;

  /// All within `radius`, by distance and then index.
  std::vector<Neighbour> within(const Vec3& query, double radius) const;

 private:
  struct Tree;
  explicit NearestPoints(std::unique_ptr<Tree> tree);

  std::unique_ptr<Tree> tree_;
};

}  // namespace pbffd
