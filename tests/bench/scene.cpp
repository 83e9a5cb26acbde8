#include "tests/bench/scene.h"

#include "app/yardsticks/median.h"
#include "core/mesh/io/mesh_io.h"
#include "tests/support/shapes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace pbffd::bench {
namespace {

constexpr int pointCount = 200;
constexpr double wantedInfluences = 16.0;

std::string& meshFile() {
  static std::string file;
  return file;
}

/// Each next point is the vertex farthest from all before, of a sample of the vertices.
std::vector<Index> spacedVertices(const RestMesh& mesh) {
  const Index step = std::max(1, mesh.vertexCount() / 20000);
  std::vector<Index> chosen;
  std::vector<double> distance(static_cast<std::size_t>(mesh.vertexCount()),
                               std::numeric_limits<double>::max());
  Index next = 0;
  while (static_cast<int>(chosen.size()) < pointCount) {
    chosen.push_back(next);
    const Vec3 last = mesh.positions().row(next);
    double farthest = -1.0;
    for (Index v = 0; v < mesh.vertexCount(); v += step) {
      double& least = distance[static_cast<std::size_t>(v)];
      least = std::min(least, (mesh.positions().row(v).transpose() - last).squaredNorm());
      if (least > farthest) {
        farthest = least;
        next = v;
      }
    }
  }
  return chosen;
}

double influencesOf(const Parameterization& weights) {
  double sum = 0.0;
  for (const std::uint16_t members : weights.members) {
    sum += std::popcount(members);
  }
  return sum / weights.vertexCount;
}

void setRadius(Level& level, double radius) {
  for (Index j = 0; j < level.size(); ++j) {
    ControlPoint point = level[j];
    point.rest.axes = radius * Mat3::Identity();
    point.pose = point.rest;
    level.replace(j, point);
  }
}

Scene makeScene() {
  Scene scene;
  scene.mesh =
      std::make_shared<const RestMesh>(meshFile().empty() ? test::sphere(707, 1414) : readMesh(meshFile()));
  const RestMesh& mesh = *scene.mesh;
  double side = 0.05 * mesh.diagonal();
  for (const Index vertex : spacedVertices(mesh)) {
    ControlPoint point;
    point.id = scene.set.finest().size() + 1;
    point.rest.center =
        mesh.positions().row(vertex).transpose() + side * mesh.normals().row(vertex).transpose();
    side = -side;
    scene.set.levels[0].append(point);
  }
  scene.setReach(Reach::all);
  double low = 0.0;
  double high = mesh.diagonal();
  for (int i = 0; i < 12; ++i) {
    setRadius(scene.set.levels[0], 0.5 * (low + high));
    scene.influences = influencesOf(scene.weights());
    (scene.influences < wantedInfluences ? low : high) = 0.5 * (low + high);
  }
  scene.set.master.rest = {mesh.bounds().center(), 0.6 * mesh.diagonal() * Mat3::Identity()};
  scene.set.master.pose = scene.set.master.rest;
  mesh.graph();
  return scene;
}

}  // namespace

void Scene::setReach(Reach reach) {
  for (Index j = 0; j < set.finest().size(); ++j) {
    ControlPoint point = set.finest()[j];
    point.reach = reach;
    set.levels[0].replace(j, point);
  }
}

void useMesh(const std::string& file) {
  meshFile() = file;
}

Scene& theScene() {
  static Scene scene = makeScene();
  return scene;
}

std::shared_ptr<const Parameterization> sharedWeights(Scene& scene) {
  scene.setReach(Reach::all);
  return std::make_shared<const Parameterization>(scene.weights());
}

LevelMaps movedMaps(const Scene& scene, bool turned, double amount) {
  LevelMaps maps = mapsOf(scene.set, scene.set.finest());
  for (std::size_t j = 0; j < maps.points.size(); ++j) {
    const double angle = 0.1 * amount * static_cast<double>(1 + j % 7);
    maps.points[j].col(3) += amount * Vec3(std::sin(angle), 0.01, -0.02) * scene.mesh->diagonal();
    if (turned) {
      maps.points[j].leftCols<2>() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle), 0, 0;
    }
  }
  return maps;
}

double fullPassSeconds(Scene& scene, bool turned) {
  LiveDeformation live(scene.mesh, sharedWeights(scene));
  const LevelMaps maps[2] = {movedMaps(scene, turned, 0.1), movedMaps(scene, turned, 0.2)};
  int turn = 0;
  return medianSeconds([&] { live.updatePositions(maps[turn ^= 1]); });
}

Mesh growingMesh() {
  return test::triangulated(meshFile().empty() ? test::sphere(160, 320) : readMesh(meshFile()));
}

const Triad& theTriad() {
  static const Triad triad = measureTriad();
  return triad;
}

}  // namespace pbffd::bench
