#include "app/yardsticks/brute_force.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pbffd {
namespace {

constexpr Index verticesAtATime = 4096;

/// One of the level's points ready for eq. (3).
struct Influence {
  Index place;
  Region region;
  double strength;
};

std::vector<Influence> enabledOnes(const Level& level) {
  std::vector<Influence> influences;
  for (Index j = 0; j < level.size(); ++j) {
    if (level[j].enabled) {
      influences.push_back({j, Region(level[j].rest), level[j].strength});
    }
  }
  return influences;
}

double masterValue(const Basis& basis, const Master& master, const Region& region, const Vec3& vertex) {
  return master.mode == MasterMode::constant ? master.value
                                             : basisValue(basis, region.parameter(vertex).squaredNorm());
}

/// Ends the row of a vertex: divides its values by their sum (eq. (5)).
void endRow(VertexWeights::Run& run, std::vector<double>& values, double sum) {
  for (const double value : values) {
    run.weights.push_back(static_cast<float>(value / sum));
  }
  run.start.push_back(static_cast<Index>(run.points.size()));
  values.clear();
}

/// Has start(v) make what is called for the vertices of a run that begins at v, one after the other: it adds
/// the control points and values of a vertex and returns their sum with the master's. Runs go in parallel.
template <class Start>
VertexWeights byRuns(Index vertexCount, const Start& start) {
  VertexWeights result;
  result.runLength = verticesAtATime;
  result.runs.resize(static_cast<std::size_t>((vertexCount + verticesAtATime - 1) / verticesAtATime));
  parallelFor(result.runs.size(), 1, [&](std::size_t begin, std::size_t end) {
    std::vector<double> values;
    for (std::size_t r = begin; r < end; ++r) {
      const Index first = static_cast<Index>(r) * verticesAtATime;
      auto visit = start(first);
      for (Index v = first; v < std::min(first + verticesAtATime, vertexCount); ++v) {
        endRow(result.runs[r], values, visit(v, result.runs[r].points, values));
      }
    }
  });
  return result;
}

}  // namespace

VertexWeights weightsByBruteForce(const RestMesh& mesh, const Basis& basis, const Master& master,
                                  const Level& level) {
  const std::vector<Influence> influences = enabledOnes(level);
  const Region masterRegion(master.rest);
  return byRuns(mesh.vertexCount(), [&](Index) {
    return [&](Index v, std::vector<Index>& points, std::vector<double>& values) {
      const Vec3 vertex = mesh.positions().row(v);
      double sum = 0.0;
      for (const Influence& influence : influences) {
        const double squared = influence.region.parameter(vertex).squaredNorm();
        if (squared < 1.0) {
          points.push_back(influence.place);
          values.push_back(influence.strength * basisValue(basis, squared));
          sum += values.back();
        }
      }
      return sum + masterValue(basis, master, masterRegion, vertex);
    };
  });
}

VertexWeights weightsByWalking(const RestMesh& mesh, const Basis& basis, const Master& master,
                               const Level& level) {
  const std::vector<Influence> influences = enabledOnes(level);
  std::vector<Reached> reached(influences.size());
  parallelFor(influences.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      reached[i] = reachedVertices(mesh, level[influences[i].place]);
    }
  });
  const Region masterRegion(master.rest);
  return byRuns(mesh.vertexCount(), [&](Index first) {
    // Of each control point the next vertex that it counts; they ascend.
    std::vector<std::size_t> next(reached.size());
    for (std::size_t i = 0; i < next.size(); ++i) {
      const std::vector<Index>& vertices = reached[i].vertices;
      next[i] = static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), first) -
                                         vertices.begin());
    }
    return [&, next](Index v, std::vector<Index>& points, std::vector<double>& values) mutable {
      double sum = 0.0;
      for (std::size_t i = 0; i < next.size(); ++i) {
        if (next[i] < reached[i].vertices.size() && reached[i].vertices[next[i]] == v) {
          points.push_back(influences[i].place);
          values.push_back(influences[i].strength * basisValue(basis, reached[i].uSquared[next[i]++]));
          sum += values.back();
        }
      }
      return sum + masterValue(basis, master, masterRegion, mesh.positions().row(v));
    };
  });
}

double greatestDifference(const VertexWeights& weights, const Parameterization& parameterization,
                          const RestMesh& mesh) {
  double greatest = 0.0;
  std::vector<double> difference(static_cast<std::size_t>(parameterization.pointCount), 0.0);
  for (Index slot = 0; slot < mesh.vertexCount(); ++slot) {
    const Index vertex = mesh.mortonOrder()[static_cast<std::size_t>(slot)];
    const VertexWeights::Run& run = weights.runs[static_cast<std::size_t>(vertex / weights.runLength)];
    const auto row = static_cast<std::size_t>(vertex % weights.runLength);
    for (auto e = static_cast<std::size_t>(run.start[row]); e < static_cast<std::size_t>(run.start[row + 1]);
         ++e) {
      difference[static_cast<std::size_t>(run.points[e])] = run.weights[e];
    }
    const auto block = static_cast<std::size_t>(slot / Parameterization::blockSize);
    const auto lane = static_cast<std::size_t>(slot % Parameterization::blockSize);
    for (auto e = static_cast<std::size_t>(parameterization.blockStart[block]);
         e < static_cast<std::size_t>(parameterization.blockStart[block + 1]); ++e) {
      difference[static_cast<std::size_t>(parameterization.points[e])] -=
          parameterization.weights[Parameterization::blockSize * e + lane];
    }
    for (double& one : difference) {
      greatest = std::max(greatest, std::abs(std::exchange(one, 0.0)));
    }
  }
  return greatest;
}

}  // namespace pbffd
