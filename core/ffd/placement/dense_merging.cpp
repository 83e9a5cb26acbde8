#include "core/ffd/placement/dense_merging.h"

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <tuple>

namespace pbffd {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

class Rows {
 public:
  explicit Rows(const Points& points)
      : x_(points.col(0)),
        y_(points.col(1)),
        z_(points.col(2)),
        best_(static_cast<std::size_t>(points.rows())) {
    for (Index i = 0; i < count(); ++i) {
      look(i);
    }
  }

  /// The pair of least distance, of several the one of the lowest places; `kept` < `gone`.
  Merge closest() const {
    std::tuple<double, Index, Index> least{nowhere, -1, -1};
    for (Index i = 0; i < count(); ++i) {
      const Partner& partner = best_[static_cast<std::size_t>(i)];
      // The other way about it is found from the lower place; equal distances of a pair are equal bits.
      if (const std::tuple pair{partner.squared, i, partner.place}; partner.place > i && pair < least) {
        least = pair;
      }
    }
    return {std::get<1>(least), std::get<2>(least)};
  }

  void merge(const Merge& pair) {
    const Index kept = pair.kept;
    const Index gone = pair.gone;
    x_[kept] = 0.5 * (x_[kept] + x_[gone]);
    y_[kept] = 0.5 * (y_[kept] + y_[gone]);
    z_[kept] = 0.5 * (z_[kept] + z_[gone]);
    x_[gone] = y_[gone] = z_[gone] = nowhere;
    best_[static_cast<std::size_t>(gone)] = {};
    look(kept);
    fromKept_.swap(distances_);
    for (Index i = 0; i < count(); ++i) {
      Partner& partner = best_[static_cast<std::size_t>(i)];
      if (i == kept || partner.place < 0) {
        continue;
      }
      if (partner.place == kept || partner.place == gone) {
        look(i);
      } else if (const double squared = fromKept_[i];
                 squared < partner.squared || (squared == partner.squared && kept < partner.place)) {
        partner = {kept, squared};
      }
    }
  }

  Vec3 point(Index i) const { return {x_[i], y_[i], z_[i]}; }
  bool isAlive(Index i) const { return x_[i] < nowhere; }
  Index count() const { return static_cast<Index>(x_.size()); }

 private:
  struct Partner {
    Index place = -1;  ///< -1: none is left
    double squared = nowhere;
  };

  /// Finds the partner of a point; leaves the squared distances from it in `distances_`.
  void look(Index i) {
    // In the order in which squaredNorm() adds.
    distances_ = (x_ - x_[i]).square() + ((y_ - y_[i]).square() + (z_ - z_[i]).square());
    distances_[i] = nowhere;
    const double squared = distances_.minCoeff();
    Index place = 0;
    while (distances_[place] != squared) {
      ++place;
    }
    best_[static_cast<std::size_t>(i)] = squared < nowhere ? Partner{place, squared} : Partner{};
  }

  Eigen::ArrayXd x_;
  Eigen::ArrayXd y_;
  Eigen::ArrayXd z_;
  Eigen::ArrayXd distances_;
  Eigen::ArrayXd fromKept_;
  std::vector<Partner> best_;
};

}  // namespace

MergedPoints mergeFewClosestPairs(const Points& points, Index target) {
  Rows rows(points);
  MergedPoints merged;
  const Index merges = std::max<Index>(0, rows.count() - std::max<Index>(target, 1));
  for (Index i = 0; i < merges; ++i) {
    merged.merges.push_back(rows.closest());
    rows.merge(merged.merges.back());
  }
  merged.points.resize(rows.count() - merges, 3);
  for (Index place = 0; place < rows.count(); ++place) {
    if (rows.isAlive(place)) {
      merged.points.row(static_cast<Index>(merged.places.size())) = rows.point(place);
      merged.places.push_back(place);
    }
  }
  return merged;
}

}  // namespace pbffd
