#include "core/mesh/triangle_tree.h"

#include "core/base/parallel.h"
#include "core/mesh/morton.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace pbffd {
namespace {

/// Boxes are kept in single precision and are a little larger than what they hold.
constexpr float margin = 1e-6F;

Bounds boundsOfCorners(const Points& positions, std::span<const Index> corners) {
  Bounds bounds;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 at = positions.row(corners[i]);
    bounds.low = i == 0 ? at : Vec3(bounds.low.cwiseMin(at));
    bounds.high = i == 0 ? at : Vec3(bounds.high.cwiseMax(at));
  }
  return bounds;
}

std::vector<Index> inMortonOrder(const Points& positions, std::span<const Index> corners,
                                 const Bounds& bounds) {
  const MortonCode code(bounds);
  std::vector<std::pair<std::uint64_t, Index>> order(corners.size() / 3);
  parallelFor(order.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const Vec3 center = (positions.row(corners[3 * t]) + positions.row(corners[3 * t + 1]) +
                           positions.row(corners[3 * t + 2])) /
                          3.0;
      order[t] = {code(center.cwiseMax(bounds.low).cwiseMin(bounds.high)), static_cast<Index>(t)};
    }
  });
  parallelSort(order);
  std::vector<Index> sorted;
  sorted.reserve(corners.size());
  for (const auto& [key, t] : order) {
    for (int k = 0; k < 3; ++k) {
      sorted.push_back(corners[3 * static_cast<std::size_t>(t) + k]);
    }
  }
  return sorted;
}

}  // namespace

struct TriangleTree::Segment {
  Vec3 from;
  Vec3 to;
  Lanes center[3];  ///< the middle in the unit cube, the same in all lanes
  Lanes half[3];    ///< half the way from one end to the other
  Lanes halfSize[3];

  Segment(const Vec3& a, const Vec3& b, const TriangleTree& tree) : from(a), to(b) {
    const Eigen::Vector3f middle = (tree.scale_ * (0.5 * (a + b) - tree.origin_)).cast<float>();
    const Eigen::Vector3f step = (tree.scale_ * 0.5 * (b - a)).cast<float>();
    for (int axis = 0; axis < 3; ++axis) {
      center[axis].setConstant(middle[axis]);
      half[axis].setConstant(step[axis]);
      halfSize[axis].setConstant(std::abs(step[axis]) + margin);
    }
  }

  /// Separating axes between the segment and four boxes: the box's three and the three cross products. A bit
  /// for each box that it may meet.
  unsigned mayMeet(const Boxes& boxes) const {
    Lanes offset[3];
    Lanes extent[3];
    for (int axis = 0; axis < 3; ++axis) {
      extent[axis] = 0.5F * (boxes.high[axis] - boxes.low[axis]);
      offset[axis] = center[axis] - 0.5F * (boxes.high[axis] + boxes.low[axis]);
    }
    // By how much the two are apart along the axis that parts them best.
    Lanes gap = Lanes::Constant(-1.0F);
    for (int axis = 0; axis < 3; ++axis) {
      const int next = (axis + 1) % 3;
      const int last = (axis + 2) % 3;
      gap = gap.max(offset[axis].abs() - (extent[axis] + halfSize[axis]));
      gap = gap.max((offset[next] * half[last] - offset[last] * half[next]).abs() -
                    (extent[next] * halfSize[last] + extent[last] * halfSize[next] + margin));
    }
    unsigned meets = 0;
    for (Index lane = 0; lane < arity; ++lane) {
      meets |= static_cast<unsigned>(gap[lane] <= 0.0F) << lane;
    }
    return meets;
  }
};

TriangleTree::TriangleTree(const Points& positions, std::span<const Index> corners) : positions_(positions) {
  const Bounds bounds = boundsOfCorners(positions, corners);
  const double longest = (bounds.high - bounds.low).maxCoeff();
  origin_ = bounds.center();
  scale_ = longest > 0.0 ? 1.0 / longest : 1.0;
  corners_ = inMortonOrder(positions, corners, bounds);
  if (corners_.empty()) {
    return;
  }
  nodeCounts_.push_back((triangleCount() + leafSize - 1) / leafSize);
  do {
    nodeCounts_.push_back((nodeCounts_.back() + arity - 1) / arity);
  } while (nodeCounts_.back() > 1);
  buildBoxes();
}

void TriangleTree::buildBoxes() {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  boxes_.resize(nodeCounts_.size() - 1);
  for (std::size_t l = 0; l < boxes_.size(); ++l) {
    boxes_[l].resize(static_cast<std::size_t>(nodeCounts_[l + 1]));
    parallelFor(boxes_[l].size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        for (Index lane = 0; lane < arity; ++lane) {
          const Index child = static_cast<Index>(n) * arity + lane;
          Eigen::Array3f low = Eigen::Array3f::Constant(infinity);
          Eigen::Array3f high = Eigen::Array3f::Constant(-infinity);
          const auto include = [&](const Eigen::Array3f& from, const Eigen::Array3f& to) {
            low = low.min(from);
            high = high.max(to);
          };
          if (l == 0) {
            for (Index t = child * leafSize; t < std::min((child + 1) * leafSize, triangleCount()); ++t) {
              for (int k = 0; k < 3; ++k) {
                const Eigen::Array3f at = (scale_ * (corner(t, k) - origin_)).cast<float>();
                include(at - margin, at + margin);
              }
            }
          } else if (child < nodeCounts_[l]) {
            const Boxes& below = boxes_[l - 1][static_cast<std::size_t>(child)];
            for (Index k = 0; k < arity; ++k) {
              include({below.low[0][k], below.low[1][k], below.low[2][k]},
                      {below.high[0][k], below.high[1][k], below.high[2][k]});
            }
          }
          // A box of nothing lies where no segment comes.
          const bool isEmpty = !(low[0] <= high[0]);
          for (int axis = 0; axis < 3; ++axis) {
            boxes_[l][n].low[axis][lane] = isEmpty ? 1e9F : low[axis];
            boxes_[l][n].high[axis][lane] = isEmpty ? 1e9F : high[axis];
          }
        }
      }
    });
  }
}

bool TriangleTree::isCrossed(const Vec3& from, const Vec3& to) const {
  if (corners_.empty()) {
    return false;
  }
  const Segment segment(from, to, *this);
  std::pair<Index, Index> open[128];  // level, node
  int size = 0;
  open[size++] = {levelCount() - 1, 0};
  while (size > 0) {
    const auto [level, node] = open[--size];
    if (level == 0) {
      if (isCrossedByLeaf(node, segment)) {
        return true;
      }
      continue;
    }
    unsigned meets =
        segment.mayMeet(boxes_[static_cast<std::size_t>(level) - 1][static_cast<std::size_t>(node)]);
    for (; meets != 0; meets &= meets - 1) {
      open[size++] = {level - 1, node * arity + std::countr_zero(meets)};
    }
  }
  return false;
}

void TriangleTree::cornersOfLeaf(Index leaf, const Vec3& from, LeafCorners& corners) const {
  const Index first = leaf * leafSize;
  const Index count = std::min(leafSize, triangleCount() - first);
  const Index* vertex = &corners_[3 * static_cast<std::size_t>(first)];
  for (Index t = 0; t < count; ++t) {
    for (std::size_t k = 0; k < 9; k += 3, ++vertex) {
      const double* const at = positions_.data() + 3 * static_cast<std::size_t>(*vertex);
      corners[k][t] = static_cast<float>(scale_ * (at[0] - from[0]));
      corners[k + 1][t] = static_cast<float>(scale_ * (at[1] - from[1]));
      corners[k + 2][t] = static_cast<float>(scale_ * (at[2] - from[2]));
    }
  }
  for (LeafLanes& lanes : corners) {
    lanes.tail(leafSize - count).setOnes();
  }
}

bool TriangleTree::isCrossedByLeaf(Index leaf, const Segment& segment) const {
  LeafCorners p;
  cornersOfLeaf(leaf, segment.from, p);
  const Eigen::Vector3f way = (scale_ * (segment.to - segment.from)).cast<float>();
  // Six volumes over the way and an edge each: the line must pass all edges on the same side. Their sum is the
  // volume over the way and the triangle, so the crossing lies at `start` of `along` on the way.
  const LeafLanes x = p[4] * p[8] - p[5] * p[7];
  const LeafLanes y = p[5] * p[6] - p[3] * p[8];
  const LeafLanes z = p[3] * p[7] - p[4] * p[6];
  const LeafLanes bc = way[0] * x + way[1] * y + way[2] * z;
  const LeafLanes ca = way[0] * (p[7] * p[2] - p[8] * p[1]) + way[1] * (p[8] * p[0] - p[6] * p[2]) +
                       way[2] * (p[6] * p[1] - p[7] * p[0]);
  const LeafLanes ab = way[0] * (p[1] * p[5] - p[2] * p[4]) + way[1] * (p[2] * p[3] - p[0] * p[5]) +
                       way[2] * (p[0] * p[4] - p[1] * p[3]);
  const LeafLanes start = p[0] * x + p[1] * y + p[2] * z;
  const LeafLanes along = ab + bc + ca;
  // All of these at least 0, or all at most 0.
  const LeafLanes least = ab.min(bc).min(ca).min(start).min(along - start);
  const LeafLanes most = ab.max(bc).max(ca).max(start).max(along - start);
  for (Index k = 0; k < leafSize; ++k) {
    if (along[k] != 0.0F && (least[k] >= 0.0F || most[k] <= 0.0F)) {
      return true;
    }
  }
  return false;
}

}  // namespace pbffd
