#pragma once

#include "core/ffd/placement/decimation.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace pbffd {

/// Finds for a point the partner that it may best merge with, while points merge: one kd-tree a group,
/// whose boxes grow with the mid-points and which is built anew when half of its points are gone.
/// Keeps references to the rules.
class PartnerSearch {
 public:
  PartnerSearch(const Points& points, const MergeRules& rules);

  struct Partner {
    Index place = -1;  ///< -1: none
    double cost = std::numeric_limits<double>::infinity();
  };
  /// The nearest partner, the lowest place on a tie, whatever the rules put back: none has a lower cost. May
  /// run at the same time for different places.
  Partner nearest(Index place) const;

  /// The partner of least cost, the lowest place on a tie; none where many of the nearest must not merge and no
  /// other was met.
  Partner best(Index place);

  /// By how much the rules put this pair back.
  double factorOf(Index place, Index other);

  /// The mid-point takes the place `kept`; `gone` is no more.
  void merge(Index kept, Index gone);

  /// How often the point of this place has changed.
  std::uint32_t version(Index place) const { return versions_[place]; }
  bool isAlive(Index place) const { return leafOf_[place] >= 0; }
  Vec3 point(Index place) const { return points_.row(place); }
  Index aliveCount() const { return alive_; }

 private:
  struct Node {
    Vec3 low;
    Vec3 high;
    Index begin;  ///< of the slots
    Index end;
    Index parent;
    Index left = -1;    ///< its children are left and left + 1; -1: a leaf
    Index lowestPlace;  ///< no point of it has a lower one
    Index alive;        ///< points that are not gone
  };
  struct NearestQuery;
  struct FewQuery;
  struct Known {
    Index other;
    std::uint32_t version;  ///< of the other
    double factor;
  };

  void build();
  Index addNode(Index begin, Index end, Index parent);
  void split(Index node);
  /// Visits the points that the query may still take, near ones first.
  template <class Query>
  void search(Query& query) const;

  const MergeRules& rules_;
  Points points_;              ///< one a place
  std::vector<Index> order_;   ///< the place of each slot; those of a node are next to each other
  std::vector<Index> slotOf_;  ///< one a place
  Points inSlots_;             ///< the points once more, one a slot; infinity where one is gone
  std::vector<Index> leafOf_;  ///< one a place; -1: gone
  std::vector<Index> rootOf_;  ///< one a place: the tree of its group
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> versions_;    ///< one a place
  std::vector<std::vector<Known>> known_;  ///< one a place: factors above 1 as they were asked for
  Index alive_ = 0;
  Index builtWith_ = 0;
};

}  // namespace pbffd
