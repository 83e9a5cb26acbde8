#include "ui/models/influence.h"

#include <algorithm>
#include <unordered_set>

namespace pbffd::ui {
namespace {

/// One flag a place of the level.
std::vector<char> chosenPlaces(const Level& level, const std::vector<PointId>& points) {
  const std::unordered_set<PointId> wanted(points.begin(), points.end());
  std::vector<char> chosen(static_cast<std::size_t>(level.size()), 0);
  for (Index place = 0; place < level.size(); ++place) {
    chosen[static_cast<std::size_t>(place)] = wanted.contains(level[place].id) ? 1 : 0;
  }
  return chosen;
}

void count(Influence& influence, double weight) {
  if (weight > 0.0) {
    ++influence.reached;
    const int bin = std::clamp(static_cast<int>(weight * Influence::binCount), 0, Influence::binCount - 1);
    ++influence.histogram[static_cast<std::size_t>(bin)];
  }
}

void keepStrongest(Influence& influence, double weight, PointId point) {
  if (weight > influence.strongest) {
    influence.strongest = weight;
    influence.strongestPoint = point;
  }
}

}  // namespace

Influence influenceOnMesh(const Parameterization& weights, const Level& finest,
                          const std::vector<PointId>& points) {
  constexpr Index size = Parameterization::blockSize;
  const std::vector<char> chosen = chosenPlaces(finest, points);
  Influence influence;
  influence.total = weights.vertexCount;
  for (Index block = 0; block < weights.blockCount(); ++block) {
    std::array<double, size> sums{};
    for (Index entry = weights.blockStart[static_cast<std::size_t>(block)];
         entry < weights.blockStart[static_cast<std::size_t>(block) + 1]; ++entry) {
      const Index place = weights.points[static_cast<std::size_t>(entry)];
      if (chosen[static_cast<std::size_t>(place)] == 0) {
        continue;
      }
      for (Index k = 0; k < size; ++k) {
        const double weight = weights.weights[static_cast<std::size_t>(entry * size + k)];
        sums[static_cast<std::size_t>(k)] += weight;
        keepStrongest(influence, weight, finest[place].id);
      }
    }
    for (const double sum : sums) {
      count(influence, sum);
    }
  }
  return influence;
}

Influence influenceOnPoints(const PointWeights& weights, const Level& level,
                            const std::vector<PointId>& points) {
  const std::vector<char> chosen = chosenPlaces(level, points);
  Influence influence;
  influence.total = static_cast<Index>(weights.start.size()) - 1;
  for (Index row = 0; row < influence.total; ++row) {
    double sum = 0.0;
    for (Index entry = weights.start[static_cast<std::size_t>(row)];
         entry < weights.start[static_cast<std::size_t>(row) + 1]; ++entry) {
      const Index place = weights.points[static_cast<std::size_t>(entry)];
      if (chosen[static_cast<std::size_t>(place)] != 0) {
        const double weight = weights.weights[static_cast<std::size_t>(entry)];
        sum += weight;
        keepStrongest(influence, weight, level[place].id);
      }
    }
    count(influence, sum);
  }
  return influence;
}

}  // namespace pbffd::ui
