#include "core/mesh/alignment.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/text.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace pbffd {
namespace {

constexpr int coarseCount = 300;  ///< points a side while many turns are tried
constexpr int fineCount = 4000;   ///< points a side for the few best
constexpr int coarseRounds = 12;
constexpr int fineRounds = 60;
constexpr int keptCandidates = 6;
constexpr double cellsAcrossRadius = 8.0;  ///< of the thinning grid

Points rowsOf(const Points& points, const std::vector<Eigen::Index>& rows) {
  return points(rows, Eigen::all);
}

Points finiteRows(const Points& points) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (points.row(i).allFinite()) {
      rows.push_back(i);
    }
  }
  return static_cast<Eigen::Index>(rows.size()) == points.rows() ? points : rowsOf(points, rows);
}

/// At most `count` rows, evenly spread over the order of the rows.
Points everyNth(const Points& points, Eigen::Index count) {
  if (points.rows() <= count) {
    return points;
  }
  std::vector<Eigen::Index> rows(static_cast<std::size_t>(count));
  for (Eigen::Index i = 0; i < count; ++i) {
    rows[static_cast<std::size_t>(i)] = i * points.rows() / count;
  }
  return rowsOf(points, rows);
}

double radiusOf(const Points& points, const Eigen::RowVector3d& center) {
  return std::sqrt((points.rowwise() - center).squaredNorm() / static_cast<double>(points.rows()));
}

/// The means of the points in each cell of a grid: evenly spread however the points are.
Points thinned(const Points& points) {
  const Eigen::RowVector3d center = points.colwise().mean();
  const double cell = radiusOf(points, center) / cellsAcrossRadius;
  if (!(cell > 0.0)) {
    return points.topRows(1);
  }
  using Key = std::array<double, 3>;
  std::vector<std::pair<Key, Eigen::Index>> keys(static_cast<std::size_t>(points.rows()));
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Eigen::RowVector3d at = ((points.row(static_cast<Eigen::Index>(i)) - center) / cell).array().floor();
    keys[i] = {{at.x(), at.y(), at.z()}, static_cast<Eigen::Index>(i)};
  }
  std::sort(keys.begin(), keys.end());
  Points means(points.rows(), 3);
  Eigen::Index count = 0;
  for (std::size_t begin = 0, end = 0; begin < keys.size(); begin = end) {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (; end < keys.size() && keys[end].first == keys[begin].first; ++end) {
      sum += points.row(keys[end].second);
    }
    means.row(count++) = sum / static_cast<double>(end - begin);
  }
  return means.topRows(count);
}

/// Centroid, principal axes (columns, a right-handed frame) and rms radius.
struct Moments {
  Vec3 center;
  Mat3 axes;
  double radius;

  Moments(const Points& points, const char* whose) : center(points.colwise().mean().transpose()) {
    const Points about = points.rowwise() - center.transpose();
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(about.transpose() * about /
                                                     static_cast<double>(points.rows()));
    radius = radiusOf(points, center.transpose());
    if (!(solver.eigenvalues()[1] > 1e-12 * solver.eigenvalues()[2])) {
      throw InvalidInput(
          format("Could not align the meshes: the points of {} lie on a line or at one place, so "
                 "no turn can be told. Apply the project without alignment.",
                 whose));
    }
    axes = solver.eigenvectors();
    axes.col(2) = axes.col(0).cross(axes.col(1));
  }
};

/// The 24 turns that take the coordinate axes to each other.
std::vector<Mat3> axisTurns() {
  std::vector<Mat3> turns;
  std::array<int, 3> order{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Mat3 turn = Mat3::Zero();
      for (int k = 0; k < 3; ++k) {
        turn(order[static_cast<std::size_t>(k)], k) = (signs >> k & 1) != 0 ? -1.0 : 1.0;
      }
      if (turn.determinant() > 0.0) {
        turns.push_back(turn);
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return turns;
}

/// Turns spread over all of them, for shapes whose principal axes say little.
std::vector<Mat3> spreadTurns() {
  std::vector<Mat3> turns;
  for (const double angle : {0.0, 0.25, 0.5, 0.75}) {
    for (const Vec3& axis : {Vec3(1, 1, 1), Vec3(1, -1, 1), Vec3(-1, 1, 1), Vec3(1, 1, -1)}) {
      turns.emplace_back(Eigen::AngleAxisd(angle * 3.141592653589793, axis.normalized()).matrix());
    }
  }
  std::vector<Mat3> all;
  for (const Mat3& turn : turns) {
    for (const Mat3& byAxes : axisTurns()) {
      all.push_back(turn * byAxes);
    }
  }
  return all;
}

/// Where to start from: the turn that there is first, then those of the principal axes, then the spread ones.
std::vector<Similarity> startsOf(const Moments& from, const Moments& to) {
  std::vector<Mat3> turns{Mat3::Identity()};
  for (const Mat3& turn : axisTurns()) {
    turns.push_back(to.axes * turn * from.axes.transpose());
  }
  const std::vector<Mat3> spread = spreadTurns();
  turns.insert(turns.end(), spread.begin(), spread.end());
  std::vector<Similarity> starts;
  for (const Mat3& turn : turns) {
    const double scale = to.radius / from.radius;
    starts.push_back({scale, turn, to.center - scale * (turn * from.center)});
  }
  return starts;
}

/// One side of the pairing.
struct Side {
  Points points;
  const NearestPoints* tree;
  const Points* treePoints;
};

/// Pairs in both directions: row i of `from` belongs to row i of `to`.
struct Pairs {
  Points from;
  Points to;
  std::vector<double> distances;  ///< in the units of `to`, under the map that paired them

  double mean() const {
    return std::accumulate(distances.begin(), distances.end(), 0.0) / static_cast<double>(distances.size());
  }
};

Pairs pair(const Side& from, const Side& to, const Similarity& similarity) {
  const AffineMap map = similarity.map();
  const AffineMap inverse = similarity.inverse();
  const Eigen::Index ahead = from.points.rows();
  Pairs pairs;
  pairs.from.resize(ahead + to.points.rows(), 3);
  pairs.to.resize(pairs.from.rows(), 3);
  pairs.distances.resize(static_cast<std::size_t>(pairs.from.rows()));
  parallelFor(pairs.distances.size(), 500, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Eigen::Index>(begin); i < static_cast<Eigen::Index>(end); ++i) {
      if (i < ahead) {
        const Vec3 image = applyMap(map, from.points.row(i).transpose());
        pairs.from.row(i) = from.points.row(i);
        pairs.to.row(i) = to.treePoints->row(to.tree->nearest(image).index);
      } else {
        const Vec3 image = applyMap(inverse, to.points.row(i - ahead).transpose());
        pairs.from.row(i) = from.treePoints->row(from.tree->nearest(image).index);
        pairs.to.row(i) = to.points.row(i - ahead);
      }
      const Vec3 moved = applyMap(map, pairs.from.row(i).transpose());
      pairs.distances[static_cast<std::size_t>(i)] = (moved - pairs.to.row(i).transpose()).norm();
    }
  });
  return pairs;
}

/// Cauchy's weights about the median: pairs that fit rule, strays fade.
std::vector<double> robustWeights(const std::vector<double>& distances, double least) {
  std::vector<double> sorted = distances;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double unit = std::max(*middle, least);
  std::vector<double> weights(distances.size());
  std::transform(distances.begin(), distances.end(), weights.begin(),
                 [unit](double d) { return 1.0 / (1.0 + (d / unit) * (d / unit)); });
  return weights;
}

struct Candidate {
  Similarity similarity;
  double cost;  ///< the mean distance of the pairs
};

Candidate refined(const Side& from, const Side& to, Similarity similarity, bool isRobust, int rounds) {
  const double least = 1e-14 * boundsOf(*to.treePoints).diagonal();
  Candidate best{similarity, 0.0};
  Pairs pairs = pair(from, to, similarity);
  best.cost = pairs.mean();
  for (int round = 0; round < rounds && best.cost > least; ++round) {
    similarity = fitSimilarity(
        pairs.from, pairs.to,
        isRobust ? robustWeights(pairs.distances, least) : std::vector<double>(pairs.distances.size(), 1.0));
    pairs = pair(from, to, similarity);
    const double cost = pairs.mean();
    const bool isSettled = std::abs(cost - best.cost) <= 1e-9 * best.cost;
    if (cost < best.cost) {
      best = {similarity, cost};
    }
    if (isSettled) {
      break;
    }
  }
  return best;
}

/// Of candidates that fit alike the first: the turn that there was, before others of a symmetric shape.
std::vector<Candidate> bestOf(std::vector<Candidate> candidates, std::size_t count) {
  std::stable_sort(candidates.begin() + 1, candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  candidates.resize(std::min(count, candidates.size()));
  return candidates;
}

/// How far along `from` is from `to`: the mean distance of all its points.
double meanDistance(const Points& from, const NearestPoints& to, const AffineMap& map) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < from.rows(); ++i) {
    sum += to.nearest(applyMap(map, from.row(i).transpose())).distance;
  }
  return sum / static_cast<double>(from.rows());
}

std::vector<Candidate> coarseCandidates(const Points& from, const Points& to, const Progress& progress) {
  const Points thinFrom = thinned(from);
  const Points thinTo = thinned(to);
  const std::vector<Similarity> starts =
      startsOf(Moments(thinFrom, "the other mesh"), Moments(thinTo, "the project's mesh"));
  const NearestPoints fromTree(thinFrom);
  const NearestPoints toTree(thinTo);
  const Side fromSide{everyNth(thinFrom, coarseCount), &fromTree, &thinFrom};
  const Side toSide{everyNth(thinTo, coarseCount), &toTree, &thinTo};
  std::vector<Candidate> candidates(starts.size());
  parallelFor(starts.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      progress.throwIfCancelled();
      candidates[c] = refined(fromSide, toSide, starts[c], false, coarseRounds);
    }
  });
  return bestOf(std::move(candidates), keptCandidates);
}

}  // namespace

Similarity fitSimilarity(const Points& from, const Points& to, const std::vector<double>& weights) {
  const Eigen::Map<const Eigen::VectorXd> w(weights.data(), static_cast<Eigen::Index>(weights.size()));
  const double total = w.sum();
  const Vec3 fromCenter = from.transpose() * w / total;
  const Vec3 toCenter = to.transpose() * w / total;
  const Points fromAbout = from.rowwise() - fromCenter.transpose();
  const Points toAbout = to.rowwise() - toCenter.transpose();
  const Mat3 covariance = toAbout.transpose() * w.asDiagonal() * fromAbout / total;
  const double variance = w.dot(fromAbout.rowwise().squaredNorm()) / total;
  const Eigen::JacobiSVD<Mat3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vec3 signs = Vec3::Ones();
  signs.z() = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  Similarity similarity;
  similarity.rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  similarity.scale = svd.singularValues().dot(signs) / variance;
  similarity.translation = toCenter - similarity.scale * (similarity.rotation * fromCenter);
  return similarity;
}

Alignment alignSimilar(const Points& points, const RestMesh& rest, const Progress& progress) {
  progress.report("Aligning");
  const Points from = finiteRows(points);
  const Points to = finiteRows(rest.positions());
  if (from.rows() == 0 || to.rows() == 0) {
    throw InvalidInput(
        "Could not align the meshes: one of them has no points. Apply the project without alignment.");
  }
  std::vector<Candidate> candidates = coarseCandidates(from, to, progress);
  const NearestPoints fromTree(from);
  const NearestPoints toTree(to);
  const Side fromSide{everyNth(from, fineCount), &fromTree, &from};
  const Side toSide{everyNth(to, fineCount), &toTree, &to};
  for (Candidate& candidate : candidates) {
    progress.throwIfCancelled();
    candidate = refined(fromSide, toSide, candidate.similarity, true, fineRounds);
  }
  constexpr double alike = 1e-3;
  const double least =
      std::min_element(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        return a.cost < b.cost;
      })->cost;
  const auto chosen = std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& candidate) {
    return candidate.cost <= least * (1.0 + alike) + 1e-12 * rest.diagonal();
  });
  return {chosen->similarity, meanDistance(fromSide.points, toTree, chosen->similarity.map())};
}

}  // namespace pbffd
