#pragma once

#include "core/ffd/basis.h"
#include "core/ffd/control_point.h"

#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <vector>

namespace pbffd {

/// The control points of one level. A value whose points are shared between copies, so that a changed copy
/// costs a pointer a point and what changed.
class Level {
 public:
  Index size() const { return static_cast<Index>(points_.size()); }
  bool empty() const { return points_.empty(); }
  const ControlPoint& operator[](Index place) const { return *points_[place]; }

  void append(ControlPoint point) { points_.push_back(std::make_shared<const ControlPoint>(std::move(point))); }
  /// Appends a point of another level, shared with it.
  void append(const Level& other, Index place) { points_.push_back(other.points_[place]); }
  void replace(Index place, ControlPoint point) {
    points_[place] = std::make_shared<const ControlPoint>(std::move(point));
  }
  void remove(Index place) { points_.erase(points_.begin() + place); }

  /// The place of the point with this identifier; none when it is not of this level. O(size).
  std::optional<Index> find(PointId id) const;

  /// Whether the two hold the very same point object there (a quick test of "not changed").
  bool shares(Index place, const Level& other) const { return points_[place] == other.points_[place]; }

  bool operator==(const Level& other) const;

  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = ControlPoint;
    using difference_type = std::ptrdiff_t;
    using pointer = const ControlPoint*;
    using reference = const ControlPoint&;

    Iterator() = default;
    explicit Iterator(const std::shared_ptr<const ControlPoint>* at) : at_(at) {}
    reference operator*() const { return **at_; }
    pointer operator->() const { return at_->get(); }
    Iterator& operator++() {
      ++at_;
      return *this;
    }
    Iterator operator++(int) { return Iterator(at_++); }
    bool operator==(const Iterator&) const = default;

   private:
    const std::shared_ptr<const ControlPoint>* at_ = nullptr;
  };
  Iterator begin() const { return Iterator(points_.data()); }
  Iterator end() const { return Iterator(points_.data() + points_.size()); }

 private:
  std::vector<std::shared_ptr<const ControlPoint>> points_;
};

enum class MasterMode { constant, paper };

/// The control point that holds what no other one reaches (McDonnell & Qin, 3.2.2).
struct Master {
  double value = 0.01;  ///< its basis value in mode `constant`; in mode `paper` the kernel over `rest` rules
  MasterMode mode = MasterMode::constant;
  Frame rest;
  Frame pose;

  AffineMap map() const { return mapBetween(rest, pose); }
  bool operator==(const Master&) const = default;
};

/// The deformation space: levels[0] is the coarsest (level 1 in everything that a user sees), the last one
/// binds the mesh; the master belongs to each. There is always at least one level, which may be empty.
struct ControlSet {
  Basis basis;
  Master master;
  std::vector<Level> levels{1};

  const Level& finest() const { return levels.back(); }
  bool operator==(const ControlSet&) const = default;
};

/// The maps M of a level and the master: what the mesh, or the next finer level, is blended from.
struct LevelMaps {
  std::vector<AffineMap> points;  ///< one a control point of the level
  AffineMap master = identityMap();
};
LevelMaps mapsOf(const ControlSet& set, const Level& level);

}  // namespace pbffd
