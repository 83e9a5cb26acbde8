#include "ui/views/stand_in.h"

#include "core/base/parallel.h"
#include "core/mesh/coarse_mesh.h"

#include <Eigen/Geometry>
#include <numeric>
#include <utility>

namespace pbffd::ui {
namespace {

constexpr std::size_t grain = 1024;

}  // namespace

StandIn::StandIn(QObject* parent) : QObject(parent) {}

/// Its vertices in the order of the slots, so that following reads memory forwards.
StandIn::Made StandIn::make(const RestMesh& mesh, Index mostTriangles, const Progress& progress) {
  const CoarseMesh coarse = coarseMesh(mesh, mostTriangles, progress);
  const std::vector<Index>& order = mesh.mortonOrder();
  std::vector<Index> placeOfVertex(order.size(), -1);
  for (const Index vertex : coarse.vertices) {
    placeOfVertex[vertex] = 0;
  }
  Made made;
  std::vector<Index> slotOfVertex(order.size());
  for (std::size_t slot = 0; slot < order.size(); ++slot) {
    slotOfVertex[order[slot]] = static_cast<Index>(slot);
    if (Index& place = placeOfVertex[order[slot]]; place == 0) {
      place = static_cast<Index>(made.slots.size());
      made.slots.push_back(static_cast<Index>(slot));
    }
  }
  made.triangles.reserve(coarse.triangles.size());
  for (const Index corner : coarse.triangles) {
    made.triangles.push_back(placeOfVertex[coarse.vertices[corner]]);
  }
  progress.throwIfCancelled();
  listFans(mesh.triangles().vertices, placeOfVertex, made);
  for (Index& other : made.fans) {
    other = slotOfVertex[other];
  }
  return made;
}

/// By vertices of the mesh; -1 is the place of those that are not taken.
void StandIn::listFans(const std::vector<Index>& corners, const std::vector<Index>& placeOfVertex, Made& made) {
  made.fanStart.assign(made.slots.size() + 1, 0);
  for (const Index vertex : corners) {
    if (const Index place = placeOfVertex[vertex]; place >= 0) {
      made.fanStart[place + 1] += 2;
    }
  }
  std::partial_sum(made.fanStart.begin(), made.fanStart.end(), made.fanStart.begin());
  made.fans.resize(static_cast<std::size_t>(made.fanStart.back()));
  std::vector<Index> next(made.fanStart.begin(), made.fanStart.end() - 1);
  for (std::size_t c = 0; c < corners.size(); ++c) {
    if (const Index place = placeOfVertex[corners[c]]; place >= 0) {
      const std::size_t first = c / 3 * 3;
      made.fans[next[place]++] = corners[first + (c + 1) % 3];
      made.fans[next[place]++] = corners[first + (c + 2) % 3];
    }
  }
}

void StandIn::build(const std::shared_ptr<const RestMesh>& mesh, Index mostTriangles) {
  if (mesh == mesh_ && mostTriangles == mostTriangles_) {
    return;
  }
  mesh_ = mesh;
  mostTriangles_ = mostTriangles;
  jobs_.start({"stand-in", {}, [this, mesh, mostTriangles](const Progress& progress) -> JobRunner::Deliver {
                 const auto made = std::make_shared<Made>(make(*mesh, mostTriangles, progress));
                 return [this, made] {
                   made_ = std::move(*made);
                   positions_.assign(3 * made_.slots.size(), 0.0F);
                   normals_.assign(3 * made_.slots.size(), 0.0F);
                   Q_EMIT ready();
                 };
               }});
}

void StandIn::clear() {
  jobs_.cancel();
  mesh_ = nullptr;
  mostTriangles_ = 0;
  made_ = {};
  positions_ = {};
  normals_ = {};
}

void StandIn::follow(const std::vector<float>& positions) {
  const auto at = [&](Index slot) -> Vec3 {
    const float* const position = positions.data() + 3 * static_cast<std::size_t>(slot);
    return {position[0], position[1], position[2]};
  };
  parallelFor(made_.slots.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 position = at(made_.slots[i]);
      Vec3 normal = Vec3::Zero();
      for (Index f = made_.fanStart[i]; f < made_.fanStart[i + 1]; f += 2) {
        normal += (at(made_.fans[f]) - position).cross(at(made_.fans[f + 1]) - position);
      }
      normal.stableNormalize();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        positions_[3 * i + axis] = static_cast<float>(position[static_cast<Index>(axis)]);
        normals_[3 * i + axis] = static_cast<float>(normal[static_cast<Index>(axis)]);
      }
    }
  });
}

}  // namespace pbffd::ui
