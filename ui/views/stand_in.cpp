#include "ui/views/stand_in.h"

#include "core/base/parallel.h"
#include "core/base/pieces.h"

#include <Eigen/Geometry>
#include <numeric>
#include <utility>

namespace pbffd::ui {
namespace {

constexpr std::size_t grain = 1024;

Vec3 rowOf(const std::vector<float>& rows, Index row) {
  const float* const first = rows.data() + 3 * static_cast<std::size_t>(row);
  return {first[0], first[1], first[2]};
}

void setRow(std::vector<float>& rows, std::size_t row, const Vec3& value) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rows[3 * row + axis] = static_cast<float>(value[static_cast<Index>(axis)]);
  }
}

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
  made.whole = fansAround(mesh.triangles().vertices(), placeOfVertex, made.slots.size(), progress);
  for (Index& other : made.whole.others) {
    other = slotOfVertex[other];
  }
  std::vector<Index> self(made.slots.size());
  std::iota(self.begin(), self.end(), 0);
  made.coarse = fansAround(made.triangles, self, self.size(), progress);
  return made;
}

StandIn::Fans StandIn::fansAround(std::span<const Index> triangles, const std::vector<Index>& placeOfVertex,
                                  std::size_t places, const Progress& progress) {
  const auto forEachTaken = [&](const auto& body) {
    forEachIn(static_cast<Index>(triangles.size() / 3), progress, [&](Index triangle) {
      const Index* const corner = &triangles[3 * static_cast<std::size_t>(triangle)];
      for (int k = 0; k < 3; ++k) {
        if (const Index place = placeOfVertex[corner[k]]; place >= 0) {
          body(place, corner[(k + 1) % 3], corner[(k + 2) % 3]);
        }
      }
    });
  };
  Fans fans;
  fans.start.assign(places + 1, 0);
  forEachTaken([&](Index place, Index, Index) { fans.start[place + 1] += 2; });
  std::partial_sum(fans.start.begin(), fans.start.end(), fans.start.begin());
  fans.others.resize(static_cast<std::size_t>(fans.start.back()));
  std::vector<Index> next(fans.start.begin(), fans.start.end() - 1);
  forEachTaken([&](Index place, Index second, Index third) {
    fans.others[next[place]++] = second;
    fans.others[next[place]++] = third;
  });
  return fans;
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
                   unevenNormals_.assign(3 * made_.slots.size(), 0.0F);
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
  unevenNormals_ = {};
}

void StandIn::follow(const std::vector<float>& positions) {
  takePositionsAndNormals(positions);
  evenNormals();
}

void StandIn::takePositionsAndNormals(const std::vector<float>& positions) {
  parallelFor(made_.slots.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 position = rowOf(positions, made_.slots[i]);
      Vec3 normal = Vec3::Zero();
      for (Index f = made_.whole.start[i]; f < made_.whole.start[i + 1]; f += 2) {
        normal += (rowOf(positions, made_.whole.others[f]) - position)
                      .cross(rowOf(positions, made_.whole.others[f + 1]) - position);
      }
      normal.stableNormalize();
      setRow(positions_, i, position);
      setRow(unevenNormals_, i, normal);
    }
  });
}

/// With those of its neighbours, each of which is in two triangles of the fan.
void StandIn::evenNormals() {
  parallelFor(made_.slots.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Vec3 normal = 2.0 * rowOf(unevenNormals_, static_cast<Index>(i));
      for (Index f = made_.coarse.start[i]; f < made_.coarse.start[i + 1]; ++f) {
        normal += rowOf(unevenNormals_, made_.coarse.others[f]);
      }
      normal.stableNormalize();
      setRow(normals_, i, normal);
    }
  });
}

}  // namespace pbffd::ui
