#include "core/ffd/deform/space_portion.h"

#include "core/ffd/deform/space_kernels.h"
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

DisplacementNumbers numbersOf(const Displacement& displacement) {
  return {displacement.center.data(), displacement.linear.data(), displacement.shift.data()};
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
      if (withGradients) {
        const GradientSums sums = gradientSums(block);
        move(block, sums.displaced, image.positions);
        turn(block, sums, image.gradients);
      } else {
        move(block, displacementSums(block).data(), image.positions);
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
      nearest = space_.nearest->nearest(blocks_.point(block, k), lastFound_);
      lastFound_ = nearest;
    }
    return nearest;
  }

  SpaceTerm termOf(Index block, const Displacement& displacement, const Lanes& values) const {
    return {blocks_.numbers(block), numbersOf(displacement), values.data(), block_.toWeight().data()};
  }

  /// sum_j w_j d_j of the 16 places: x, y, z.
  std::array<double, 48> displacementSums(Index block) const {
    const SpaceKernels& kernels = spaceKernels();
    const LevelDisplacements& displacements = space_.displacements;
    const BlockList list = lists_.list(block);
    std::array<double, 48> sums{};
    for (std::size_t e = 0; e < list.points.size(); ++e) {
      if (const auto j = static_cast<std::size_t>(list.points[e]); displacements.isMoved[j] != 0) {
        kernels.addDisplacement(termOf(block, displacements.points[j], block_.entries()[e]), sums.data());
      }
    }
    if (displacements.isMasterMoved) {
      kernels.addDisplacement(termOf(block, displacements.master, block_.master()), sums.data());
    }
    return sums;
  }

  /// Bit k: whether anything that moved reaches the k-th place.
  unsigned reachedIn(Index block) const {
    const BlockList list = lists_.list(block);
    unsigned reached = space_.displacements.isMasterMoved ? ~0U : 0U;
    for (std::size_t e = 0; e < list.points.size(); ++e) {
      const auto j = static_cast<std::size_t>(list.points[e]);
      reached |= space_.displacements.isMoved[j] != 0 ? list.members[e] : 0U;
    }
    return reached;
  }

  /// sums: sum_j w_j d_j of the 16 places: x, y, z.
  void move(Index block, const double* sums, Points& positions) const {
    const unsigned reached = reachedIn(block);
    const double* const points = blocks_.numbers(block);
    for (std::size_t k = 0; k < slotsIn(block); ++k) {
      // A place that nothing moves keeps its very bits, the sign of a zero included.
      if ((reached >> k & 1U) != 0 && block_.toWeight()[k] > 0.0) {
        positions.row(order_[firstSlot(block) + k]) << points[k] + sums[k], points[16 + k] + sums[16 + k],
            points[32 + k] + sums[32 + k];
      }
    }
  }

  /// I + sum_j w_j grad d_j + d_j (grad w_j)^T, with grad w_j = (grad f_j - w_j sum_i grad f_i) /
  /// sum_i f_i for the basis values f.
  void turn(Index block, const GradientSums& sums, std::vector<Mat3>& gradients) const {
    for (std::size_t k = 0; k < slotsIn(block); ++k) {
      Mat3& gradient = gradients[static_cast<std::size_t>(order_[firstSlot(block) + k])];
      for (std::size_t row = 0; row < 3; ++row) {
        const double displaced = block_.toWeight()[k] * sums.displaced[16 * row + k];
        for (std::size_t column = 0; column < 3; ++column) {
          gradient(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
              sums.linear[16 * (3 * row + column) + k] - displaced * sums.slopes[16 * column + k];
        }
      }
    }
  }

  /// Beginning from the identity.
  GradientSums gradientSums(Index block) const {
    const SpaceKernels& kernels = spaceKernels();
    const LevelDisplacements& displacements = space_.displacements;
    const BlockList list = lists_.list(block);
    GradientSums sums{};
    for (std::size_t diagonal = 0; diagonal < 3; ++diagonal) {
      std::fill_n(sums.linear + 64 * diagonal, 16, 1.0);
    }
    const auto add = [&](const Displacement& displacement, bool isMoved, const Lanes& values,
                         const InfluenceNumbers& influence) {
      if (isMoved) {
        kernels.addGradient(termOf(block, displacement, values), influence, sums);
      } else {
        kernels.addSlope(blocks_.numbers(block), influence, sums);
      }
    };
    for (std::size_t e = 0; e < list.points.size(); ++e) {
      const Index j = list.points[e];
      const auto at = static_cast<std::size_t>(j);
      add(displacements.points[at], displacements.isMoved[at] != 0, block_.entries()[e],
          {space_.values.numbers()[j], list.members[e]});
    }
    // A constant master has no slope anywhere.
    const unsigned varying = space_.values.hasMasterRegion() ? 0xffffU : 0U;
    add(displacements.master, displacements.isMasterMoved, block_.master(),
        {{space_.values.masterRegion().numbers(), numbersOf(space_.values.basis()), 1.0}, varying});
    return sums;
  }

  const PreparedSpace& space_;
  std::vector<Index> order_;
  PointBlocks blocks_;
  std::vector<Index> nearestVertex_;  ///< one a slot; -1 where nobody has asked yet
  Index lastFound_ = 0;
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
