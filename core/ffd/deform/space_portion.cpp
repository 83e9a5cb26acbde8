#include "core/ffd/deform/space_portion.h"

#include "core/ffd/weights/membership.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace pbffd {
namespace {

/// Rows of `places` sorted into the cells of a grid over them, the cells along a Morton curve: what is near
/// comes together. How well decides the speed alone.
std::vector<Index> cellOrder(const Points& places) {
  constexpr int bits = 5;
  constexpr double cells = 1 << bits;
  const Vec3 low = places.colwise().minCoeff();
  const double longest = (places.colwise().maxCoeff().transpose() - low).maxCoeff();
  const double scale = longest > 0.0 ? cells / longest : 0.0;
  std::vector<std::uint16_t> codes(static_cast<std::size_t>(places.rows()));
  std::vector<Index> next((std::size_t{1} << (3 * bits)) + 1, 0);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    unsigned code = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double share = scale * (places(static_cast<Eigen::Index>(i), axis) - low[axis]);
      // What is no finite number ends in the first or the last cell.
      const auto cell = share >= 0.0 ? static_cast<unsigned>(std::min(share, cells - 1.0)) : 0U;
      for (int bit = 0; bit < bits; ++bit) {
        code |= (cell >> bit & 1U) << (3 * bit + axis);
      }
    }
    codes[i] = static_cast<std::uint16_t>(code);
    ++next[code + 1];
  }
  for (std::size_t c = 1; c < next.size(); ++c) {
    next[c] += next[c - 1];
  }
  std::vector<Index> order(codes.size());
  for (std::size_t i = 0; i < codes.size(); ++i) {
    order[static_cast<std::size_t>(next[codes[i]]++)] = static_cast<Index>(i);
  }
  return order;
}

/// A vector a lane.
struct LaneVectors {
  Lanes x{};
  Lanes y{};
  Lanes z{};

  Vec3 operator[](std::size_t k) const { return {x[k], y[k], z[k]}; }
};

LaneVectors pointsOf(const PointBlocks& blocks, Index block) {
  LaneVectors points;
  for (Index k = 0; k < PointBlocks::blockSize; ++k) {
    const Vec3 point = blocks.point(block, k);
    const auto lane = static_cast<std::size_t>(k);
    points.x[lane] = point.x();
    points.y[lane] = point.y();
    points.z[lane] = point.z();
  }
  return points;
}

/// Adds weight x displacement to each lane: the very bits of Displacement at each point.
void add(const Displacement& displacement, const LaneVectors& points, const Lanes& weights, LaneVectors& sum) {
  const Mat3& a = displacement.linear;
  const Vec3& center = displacement.center;
  const Vec3& shift = displacement.shift;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const double x = points.x[k] - center.x();
    const double y = points.y[k] - center.y();
    const double z = points.z[k] - center.z();
    sum.x[k] += weights[k] * (a(0, 0) * x + a(0, 1) * y + a(0, 2) * z + shift.x());
    sum.y[k] += weights[k] * (a(1, 0) * x + a(1, 1) * y + a(1, 2) * z + shift.y());
    sum.z[k] += weights[k] * (a(2, 0) * x + a(2, 1) * y + a(2, 2) * z + shift.z());
  }
}

Lanes product(const Lanes& a, const Lanes& b) {
  Lanes result;
  for (std::size_t k = 0; k < a.size(); ++k) {
    result[k] = a[k] * b[k];
  }
  return result;
}

/// Evaluates the places of one portion, block by block.
class PortionEvaluation {
 public:
  PortionEvaluation(const PreparedSpace& space, const Points& places)
      : space_(space),
        order_(cellOrder(places)),
        blocks_(places, order_),
        nearestVertex_(order_.size(), -1),
        block_(space.values, blocks_) {
    std::vector<Membership> memberships(static_cast<std::size_t>(space.level.size()));
    for (std::size_t j = 0; j < memberships.size(); ++j) {
      if (space.level[static_cast<Index>(j)].enabled) {
        memberships[j] = pointsInside(blocks_, space.values.region(static_cast<Index>(j)));
      }
    }
    lists_ = listsOf(memberships, blocks_.blockCount());
  }

  SpaceImage image(const Points& places, bool withGradients) {
    SpaceImage image;
    image.positions = places;
    image.gradients.assign(withGradients ? order_.size() : 0, Mat3::Identity());
    for (Index block = 0; block < blocks_.blockCount(); ++block) {
      if (!space_.displacements.touches(lists_.list(block))) {
        continue;
      }
      restrictToReach(block);
      block_.evaluate(block, lists_.list(block));
      movePositions(block, image.positions);
      if (withGradients) {
        turn(block, image.gradients);
      }
    }
    return image;
  }

 private:
  std::size_t firstSlot(Index block) const { return static_cast<std::size_t>(block) * PointBlocks::blockSize; }
  std::size_t slotsIn(Index block) const {
    return std::min<std::size_t>(PointBlocks::blockSize, order_.size() - firstSlot(block));
  }

  /// Takes from the lists of a block the places whose nearest vertex does not count.
  void restrictToReach(Index block) {
    const auto begin = static_cast<std::size_t>(lists_.start[static_cast<std::size_t>(block)]);
    const auto end = static_cast<std::size_t>(lists_.start[static_cast<std::size_t>(block) + 1]);
    for (std::size_t e = begin; e < end; ++e) {
      const auto j = static_cast<std::size_t>(lists_.points[e]);
      if (space_.cuts[j].isWhole()) {
        continue;
      }
      const Region& region = space_.values.region(lists_.points[e]);
      unsigned counted = 0;
      for (unsigned left = lists_.members[e]; left != 0; left &= left - 1) {
        const int k = std::countr_zero(left);
        const Index vertex = nearestVertex(block, k);
        counted |= static_cast<unsigned>(space_.cuts[j].counts(vertex, *space_.mesh, region)) << k;
      }
      lists_.members[e] = static_cast<std::uint16_t>(counted);
    }
  }

  Index nearestVertex(Index block, int k) {
    Index& nearest = nearestVertex_[firstSlot(block) + static_cast<std::size_t>(k)];
    if (nearest < 0) {
      nearest = space_.mesh->nearestVertex().nearest(blocks_.point(block, k)).index;
    }
    return nearest;
  }

  void movePositions(Index block, Points& positions) const {
    const LaneVectors points = pointsOf(blocks_, block);
    const BlockList list = lists_.list(block);
    const LevelDisplacements& displacements = space_.displacements;
    LaneVectors sum;
    unsigned reached = 0;
    for (std::size_t e = 0; e < list.points.size(); ++e) {
      if (const auto j = static_cast<std::size_t>(list.points[e]); displacements.isMoved[j] != 0) {
        add(displacements.points[j], points, product(block_.entries()[e], block_.toWeight()), sum);
        reached |= list.members[e];
      }
    }
    if (displacements.isMasterMoved) {
      add(displacements.master, points, product(block_.master(), block_.toWeight()), sum);
      reached = ~0U;
    }
    for (std::size_t k = 0; k < slotsIn(block); ++k) {
      // A place that nothing moves keeps its very bits, the sign of a zero included.
      if ((reached >> k & 1U) != 0 && block_.toWeight()[k] > 0.0) {
        positions.row(order_[firstSlot(block) + k]) = (points[k] + sum[k]).transpose();
      }
    }
  }

  void turn(Index block, std::vector<Mat3>& gradients) const {
    const BlockList list = lists_.list(block);
    for (std::size_t k = 0; k < slotsIn(block); ++k) {
      gradients[static_cast<std::size_t>(order_[firstSlot(block) + k])] = gradientAt(block, k, list);
    }
  }

  /// I + sum_j w_j grad d_j + d_j (grad w_j)^T, with grad w_j = (grad f_j - w_j sum_i grad f_i) /
  /// sum_i f_i for the basis values f.
  Mat3 gradientAt(Index block, std::size_t k, const BlockList& list) const {
    const Vec3 place = blocks_.point(block, static_cast<Index>(k));
    const double toWeight = block_.toWeight()[k];
    Mat3 gradient = Mat3::Identity();
    Vec3 slopes = Vec3::Zero();
    Vec3 displaced = Vec3::Zero();
    const auto addTerm = [&](const Displacement& displacement, bool isMoved, double weight, const Vec3& slope) {
      slopes += slope;
      if (isMoved) {
        const Vec3 moved = displacement(place);
        gradient += weight * displacement.linear + toWeight * moved * slope.transpose();
        displaced += weight * moved;
      }
    };
    for (std::size_t e = 0; e < list.points.size(); ++e) {
      if ((list.members[e] >> k & 1U) != 0) {
        const Index j = list.points[e];
        const auto at = static_cast<std::size_t>(j);
        addTerm(space_.displacements.points[at], space_.displacements.isMoved[at] != 0,
                block_.entries()[e][k] * toWeight,
                slopeOf(space_.values.region(j), space_.values.strength(j), place));
      }
    }
    const bool varies = space_.values.hasMasterRegion();
    addTerm(space_.displacements.master, space_.displacements.isMasterMoved, block_.master()[k] * toWeight,
            varies ? slopeOf(space_.values.masterRegion(), 1.0, place) : Vec3(Vec3::Zero()));
    return gradient - toWeight * displaced * slopes.transpose();
  }

  /// The gradient of a basis value over space.
  Vec3 slopeOf(const Region& region, double strength, const Vec3& place) const {
    const Vec3 u = region.parameter(place);
    const double slope = 2.0 * strength * basisSlope(space_.values.basis(), u.squaredNorm());
    return slope * (region.toLocal.transpose() * u);
  }

  const PreparedSpace& space_;
  std::vector<Index> order_;
  PointBlocks blocks_;
  std::vector<Index> nearestVertex_;  ///< one a slot; -1 where nobody has asked yet
  BlockLists lists_;
  BlockValues block_;
};

}  // namespace

SpaceImage imageOfPortion(const PreparedSpace& space, const Points& places, bool withGradients) {
  if (places.allFinite()) {
    return PortionEvaluation(space, places).image(places, withGradients);
  }
  // A place without finite coordinates would take its neighbours' box along: it stays, evaluated elsewhere.
  Points finite = places;
  for (Eigen::Index i = 0; i < places.rows(); ++i) {
    if (!places.row(i).allFinite()) {
      finite.row(i).setZero();
    }
  }
  SpaceImage image = PortionEvaluation(space, finite).image(finite, withGradients);
  for (Eigen::Index i = 0; i < places.rows(); ++i) {
    if (!places.row(i).allFinite()) {
      image.positions.row(i) = places.row(i);
      std::fill_n(image.gradients.begin() + i, withGradients ? 1 : 0, Mat3::Identity());
    }
  }
  return image;
}

}  // namespace pbffd
