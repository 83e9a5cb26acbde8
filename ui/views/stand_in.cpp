#include "ui/views/stand_in.h"

#include "core/base/parallel.h"
#include "core/base/pieces.h"

#include <Eigen/Geometry>
#include <numeric>
#include <utility>

namespace pbffd::ui {
namespace {

constexpr std::size_t grain = 1024;

}  // namespace

StandIn::StandIn(QObject* parent, Coarsen coarsen) : QObject(parent), coarsen_(std::move(coarsen)) {
  connect(&jobs_, &JobRunner::failed, this, [this](const QString& message) {
    mostTriangles_ = 0;
    Q_EMIT failed(message);
  });
}

/// Its vertices in the order of the slots, so that following reads memory forwards.
StandIn::Made StandIn::made(const CoarseMesh& coarse, const RestMesh& mesh, const Progress& progress) {
  const std::vector<Index>& order = mesh.mortonOrder();
  std::vector<Index> placeOfVertex(order.size(), -1);
  for (const Index vertex : coarse.vertices) {
    placeOfVertex[vertex] = 0;
  }
  Made made;
  std::vector<Index> slotOfVertex(order.size());
  forEachIn(mesh.vertexCount(), progress, [&](Index slot) {
    slotOfVertex[order[slot]] = slot;
    if (Index& place = placeOfVertex[order[slot]]; place == 0) {
      place = static_cast<Index>(made.slots.size());
      made.slots.push_back(slot);
    }
  });
  made.triangles.reserve(coarse.triangles.size());
  for (const Index corner : coarse.triangles) {
    made.triangles.push_back(placeOfVertex[coarse.vertices[corner]]);
  }
  listFans(mesh.triangles(), placeOfVertex, made, progress);
  for (Index& other : made.fans) {
    other = slotOfVertex[other];
  }
  return made;
}

/// By vertices of the mesh; -1 is the place of those that are not taken.
void StandIn::listFans(const Triangles& all, const std::vector<Index>& placeOfVertex, Made& made,
                       const Progress& progress) {
  made.fanStart.assign(made.slots.size() + 1, 0);
  const auto forEachTaken = [&](const auto& body) {
    forEachIn(all.size(), progress, [&](Index triangle) {
      const Index* const corner = &all.vertices()[3 * static_cast<std::size_t>(triangle)];
      for (int k = 0; k < 3; ++k) {
        if (const Index place = placeOfVertex[corner[k]]; place >= 0) {
          body(place, corner[(k + 1) % 3], corner[(k + 2) % 3]);
        }
      }
    });
  };
  forEachTaken([&](Index place, Index, Index) { made.fanStart[place + 1] += 2; });
  std::partial_sum(made.fanStart.begin(), made.fanStart.end(), made.fanStart.begin());
  made.fans.resize(static_cast<std::size_t>(made.fanStart.back()));
  std::vector<Index> next(made.fanStart.begin(), made.fanStart.end() - 1);
  forEachTaken([&](Index place, Index second, Index third) {
    made.fans[next[place]++] = second;
    made.fans[next[place]++] = third;
  });
}

void StandIn::build(const std::shared_ptr<const RestMesh>& mesh, Index mostTriangles) {
  if (mesh == mesh_ && mostTriangles == mostTriangles_) {
    return;
  }
  mesh_ = mesh;
  mostTriangles_ = mostTriangles;
  jobs_.start({"stand-in", {}, [this, mesh, mostTriangles](const Progress& progress) -> JobRunner::Deliver {
                 const CoarseMesh coarse = coarsen_(*mesh, mostTriangles, progress);
                 const auto result = std::make_shared<Made>(made(coarse, *mesh, progress));
                 return [this, result] {
                   made_ = std::move(*result);
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
