#include "core/mesh/winding_number.h"

#include "core/base/parallel.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numbers>
#include <utility>

namespace pbffd {
namespace {

/// A part of the surface is seen from afar at this many times its radius (Barill et al.: 2).
constexpr double openingRatio = 2.0;

/// Adds up angles by multiplying complex numbers, with one arctangent at the end.
class AngleSum {
 public:
  /// Adds the argument of (x, y), which lies within half a turn.
  void add(double x, double y) {
    if (x == 0.0 && y == 0.0) {
      return;
    }
    const double re = x_ * x - y_ * y;
    const double im = x_ * y + y_ * x + 0.0;  // no negative zero, which atan2 takes for half a turn back
    turns_ += (y_ >= 0.0 && y >= 0.0 && im < 0.0) - (y_ < 0.0 && y < 0.0 && im >= 0.0);
    const double size = std::max(std::abs(re), std::abs(im));
    x_ = re / size;
    y_ = im / size;
  }
  double total() const { return std::atan2(y_, x_) + 2.0 * std::numbers::pi * turns_; }

 private:
  double x_ = 1.0;
  double y_ = 0.0;
  int turns_ = 0;
};

/// Half the solid angle of a triangle seen from the origin (van Oosterom and Strackee 1983).
void addHalfSolidAngle(const Vec3& a, const Vec3& b, const Vec3& c, AngleSum& sum) {
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  sum.add(la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb, a.dot(b.cross(c)));
}

/// The same of the triangles of a leaf at a time, a sum a lane, in single precision: what matters is how far
/// corners lie from the point, and that is rounded after the difference was taken.
class LeafAngleSums {
 public:
  void add(const TriangleTree::LeafCorners& p) {
    const Lanes la = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
    const Lanes lb = (p[3] * p[3] + p[4] * p[4] + p[5] * p[5]).sqrt();
    const Lanes lc = (p[6] * p[6] + p[7] * p[7] + p[8] * p[8]).sqrt();
    const Lanes ab = p[0] * p[3] + p[1] * p[4] + p[2] * p[5];
    const Lanes bc = p[3] * p[6] + p[4] * p[7] + p[5] * p[8];
    const Lanes ca = p[6] * p[0] + p[7] * p[1] + p[8] * p[2];
    addArguments(la * lb * lc + ab * lc + bc * la + ca * lb, p[0] * (p[4] * p[8] - p[5] * p[7]) +
                                                                 p[1] * (p[5] * p[6] - p[3] * p[8]) +
                                                                 p[2] * (p[3] * p[7] - p[4] * p[6]));
  }

  double total() const {
    AngleSum sum;
    int turns = 0;
    for (Index k = 0; k < TriangleTree::leafSize; ++k) {
      sum.add(x_[k], y_[k]);
      turns += turns_[static_cast<std::size_t>(k)];
    }
    return sum.total() + 2.0 * std::numbers::pi * turns;
  }

 private:
  using Lanes = TriangleTree::LeafLanes;
  using Bits = std::array<std::uint32_t, TriangleTree::leafSize>;

  static Bits bitsOf(const Lanes& lanes) {
    Bits bits;
    std::memcpy(bits.data(), lanes.data(), sizeof(bits));
    return bits;
  }

  /// As AngleSum::add(), lane by lane.
  void addArguments(const Lanes& x, const Lanes& y) {
    const Lanes re = x_ * x - y_ * y;
    const Lanes im = x_ * y + y_ * x + 0.0F;
    const Lanes size = re.abs().max(im.abs());
    if (!(size.minCoeff() > 0.0F)) {
      addWhereNotZero(x, y);
      return;
    }
    const Bits before = bitsOf(y_);
    const Bits added = bitsOf(y);
    const Bits after = bitsOf(im);
    for (std::size_t k = 0; k < before.size(); ++k) {
      // By the bits of the signs.
      turns_[k] += static_cast<int>((~before[k] & ~added[k] & after[k]) >> 31);
      turns_[k] -= static_cast<int>((before[k] & added[k] & ~after[k]) >> 31);
    }
    x_ = re / size;
    y_ = im / size;
  }

  /// A triangle with a corner in the point adds nothing.
  void addWhereNotZero(Lanes x, Lanes y) {
    for (Index k = 0; k < TriangleTree::leafSize; ++k) {
      if (!(std::max(std::abs(x_[k] * x[k] - y_[k] * y[k]), std::abs(x_[k] * y[k] + y_[k] * x[k])) > 0.0F)) {
        x[k] = 1.0F;
        y[k] = 0.0F;
      }
    }
    addArguments(x, y);
  }

  Lanes x_ = Lanes::Constant(1.0F);
  Lanes y_ = Lanes::Constant(0.0F);
  std::array<int, TriangleTree::leafSize> turns_{};
};

}  // namespace

double exactWindingNumber(const Points& positions, std::span<const Index> corners, const Vec3& point) {
  double sum = 0.0;
  for (std::size_t t = 0; t < corners.size(); t += 3) {
    const auto at = [&](std::size_t k) -> Vec3 { return positions.row(corners[t + k]).transpose() - point; };
    AngleSum one;
    addHalfSolidAngle(at(0), at(1), at(2), one);
    sum += one.total();
  }
  return sum / (2.0 * std::numbers::pi);
}

/// What a part of the surface is from afar, in double precision while the tree is built.
struct WindingNumber::Expansion {
  Vec3 center = Vec3::Zero();
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());  ///< of a box that holds the part
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());
  double radius = -1.0;  ///< of a ball around the centre that holds the part; negative: nothing is there
  double area = 0.0;
  Vec3 dipole = Vec3::Zero();
  Mat3 quadrupole = Mat3::Zero();

  static Expansion of(const std::vector<Expansion>& parts) {
    Expansion whole;
    double count = 0.0;
    Vec3 plain = Vec3::Zero();
    for (const Expansion& part : parts) {
      whole.area += part.area;
      whole.center += part.area * part.center;
      whole.dipole += part.dipole;
      whole.low = whole.low.cwiseMin(part.low);
      whole.high = whole.high.cwiseMax(part.high);
      plain += part.center;
      count += 1.0;
    }
    whole.center = whole.area > 0.0 ? Vec3(whole.center / whole.area) : Vec3(plain / std::max(count, 1.0));
    for (const Expansion& part : parts) {
      const Vec3 offset = part.center - whole.center;
      whole.quadrupole += part.quadrupole + offset * part.dipole.transpose();
      whole.radius = std::max(whole.radius, offset.norm() + part.radius);
    }
    // Of two balls that hold it the smaller one.
    const Vec3 corner = (whole.high - whole.center).cwiseMax(whole.center - whole.low);
    whole.radius = std::min(whole.radius, corner.norm());
    return whole;
  }
};

WindingNumber::WindingNumber(const Points& positions, std::span<const Index> corners)
    : tree_(positions, corners) {
  build();
}

WindingNumber::Expansion WindingNumber::expansionOfLeaf(Index leaf) const {
  std::vector<Expansion> triangles;
  const Index end = std::min((leaf + 1) * TriangleTree::leafSize, tree_.triangleCount());
  for (Index t = leaf * TriangleTree::leafSize; t < end; ++t) {
    Vec3 p[3];
    for (int k = 0; k < 3; ++k) {
      p[k] = tree_.scale() * (tree_.corner(t, k) - tree_.origin());
    }
    Expansion one;
    one.center = (p[0] + p[1] + p[2]) / 3.0;
    one.dipole = 0.5 * (p[1] - p[0]).cross(p[2] - p[0]);
    one.area = one.dipole.norm();
    for (const Vec3& corner : p) {
      one.radius = std::max(one.radius, (corner - one.center).norm());
      one.low = one.low.cwiseMin(corner);
      one.high = one.high.cwiseMax(corner);
    }
    triangles.push_back(one);
  }
  return Expansion::of(triangles);
}

void WindingNumber::build() {
  if (tree_.levelCount() == 0) {
    return;
  }
  std::vector<Expansion> below(static_cast<std::size_t>(tree_.nodeCount(0)));
  parallelFor(below.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      below[n] = expansionOfLeaf(static_cast<Index>(n));
    }
  });
  for (Index level = 1; level < tree_.levelCount(); ++level) {
    std::vector<Expansion> here(static_cast<std::size_t>(tree_.nodeCount(level)));
    std::vector<Moments> moments(here.size());
    parallelFor(here.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        const std::size_t first = n * TriangleTree::arity;
        const std::size_t last = std::min(first + TriangleTree::arity, below.size());
        here[n] = Expansion::of({below.begin() + static_cast<std::ptrdiff_t>(first),
                                 below.begin() + static_cast<std::ptrdiff_t>(last)});
        for (std::size_t lane = 0; lane < TriangleTree::arity; ++lane) {
          const Expansion part = first + lane < last ? below[first + lane] : Expansion{};
          const Mat3& q = part.quadrupole;
          const double six[6] = {q(0, 0),           q(1, 1),           q(2, 2),
                                 q(0, 1) + q(1, 0), q(1, 2) + q(2, 1), q(2, 0) + q(0, 2)};
          const auto k = static_cast<Eigen::Index>(lane);
          const double reach = openingRatio * std::max(part.radius, 0.0);
          // A place without a part is never opened, and gives nothing.
          moments[n].nearSquared[k] = part.radius < 0.0 ? -1.0F : static_cast<float>(reach * reach);
          for (int axis = 0; axis < 3; ++axis) {
            moments[n].center[axis][k] = part.radius < 0.0 ? 1e6F : static_cast<float>(part.center[axis]);
            moments[n].dipole[axis][k] = static_cast<float>(part.dipole[axis]);
          }
          moments[n].trace[k] = static_cast<float>(q.trace());
          for (int i = 0; i < 6; ++i) {
            moments[n].quadrupole[i][k] = static_cast<float>(six[i]);
          }
        }
      }
    });
    moments_.push_back(std::move(moments));
    below = std::move(here);
  }
}

double WindingNumber::farField(const Moments& m, const Lanes* point, unsigned& near) const {
  const Lanes x = m.center[0] - point[0];
  const Lanes y = m.center[1] - point[1];
  const Lanes z = m.center[2] - point[2];
  const Lanes squared = x * x + y * y + z * z;
  const Lanes inverse = squared.inverse();
  const Lanes cubed = inverse * inverse.sqrt();
  const Lanes along = x * (x * m.quadrupole[0] + y * m.quadrupole[3]) +
                      y * (y * m.quadrupole[1] + z * m.quadrupole[4]) +
                      z * (z * m.quadrupole[2] + x * m.quadrupole[5]);
  Lanes value =
      cubed * (x * m.dipole[0] + y * m.dipole[1] + z * m.dipole[2] + m.trace - 3.0F * inverse * along);
  // Plain loops, since Eigen knows no masks; the value of what is near may well be infinite.
  near = 0;
  for (Index lane = 0; lane < TriangleTree::arity; ++lane) {
    near |= static_cast<unsigned>(squared[lane] <= m.nearSquared[lane]) << lane;
  }
  for (unsigned left = near; left != 0; left &= left - 1) {
    value[std::countr_zero(left)] = 0.0F;
  }
  return value.cast<double>().sum();
}

double WindingNumber::at(const Vec3& point) const {
  if (tree_.levelCount() == 0) {
    return 0.0;
  }
  const Eigen::Vector3f unit = (tree_.scale() * (point - tree_.origin())).cast<float>();
  const Lanes lanes[3] = {Lanes::Constant(unit[0]), Lanes::Constant(unit[1]), Lanes::Constant(unit[2])};
  double far = 0.0;
  LeafAngleSums angles;
  TriangleTree::LeafCorners corners;
  std::pair<Index, Index> open[128];  // level, node
  int size = 0;
  open[size++] = {tree_.levelCount() - 1, 0};
  while (size > 0) {
    const auto [level, node] = open[--size];
    if (level == 0) {
      tree_.cornersOfLeaf(node, point, corners);
      angles.add(corners);
      continue;
    }
    unsigned near = 0;
    far += farField(moments_[static_cast<std::size_t>(level) - 1][static_cast<std::size_t>(node)], lanes, near);
    for (; near != 0; near &= near - 1) {
      open[size++] = {level - 1, node * TriangleTree::arity + std::countr_zero(near)};
    }
  }
  return far / (4.0 * std::numbers::pi) + angles.total() / (2.0 * std::numbers::pi);
}

}  // namespace pbffd
