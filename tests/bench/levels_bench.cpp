#include "core/ffd/levels/hierarchy.h"
#include "core/project/edit.h"
#include "tests/bench/scene.h"

#include <benchmark/benchmark.h>

#include <memory>

namespace pbffd::bench {
namespace {

constexpr int levelCount = 5;
constexpr int placedPoints = 1000;

/// The scene's mesh with a thousand placed points on five levels, and what edits of it share.
struct LevelScene {
  LevelScene() {
    Place place;
    place.options.points = placedPoints;
    place.options.levels = levelCount;
    project = apply(projectOf(theScene().mesh), place, workspace).project;
    weights = workspace.weights.parameterization(project.mesh, project.controls);
  }

  EditWorkspace workspace;
  Project project;
  std::shared_ptr<const Parameterization> weights;
};

LevelScene& theLevels() {
  static LevelScene scene;
  return scene;
}

Move nudge(const LevelScene& scene, int level, std::vector<PointId> points, double share) {
  Move move;
  move.where = {level, std::move(points)};
  move.by = {share * scene.project.mesh->diagonal() * Vec3(1, 0.5, -0.2)};
  return move;
}

/// The finest points that an edit takes elsewhere.
std::vector<PointId> movedFinest(const Project& before, const Project& after) {
  std::vector<PointId> moved;
  for (Index i = 0; i < after.controls.finest().size(); ++i) {
    const ControlPoint& point = after.controls.finest()[i];
    if (!(point.pose == before.controls.finest()[i].pose)) {
      moved.push_back(point.id);
    }
  }
  return moved;
}

/// A drag as the workbench does it: the edit applied anew to what it began from, then positions and normals.
/// range(0): the level of the one point that is dragged; range(1): whether instead the finest points that it
/// carries are dragged, which moves the same vertices.
void dragAtLevel(benchmark::State& state) {
  LevelScene& scene = theLevels();
  const auto level = static_cast<int>(state.range(0));
  const Level& points = scene.project.controls.levels[static_cast<std::size_t>(level - 1)];
  Move move = nudge(scene, level, {points[points.size() / 2].id}, 0.01);
  const auto carried = movedFinest(scene.project, apply(scene.project, move, scene.workspace).project);
  if (state.range(1) != 0) {
    move = nudge(scene, levelCount, carried, 0.01);
  }
  LiveDeformation live(scene.project.mesh, scene.weights);
  live.update(mapsOf(scene.project.controls, scene.project.controls.finest()));
  Index moved = 0;
  for (auto _ : state) {
    move.by[0] *= -1.0;
    const Project shown = apply(scene.project, move, scene.workspace).project;
    scene.workspace.weights.parameterization(shown.mesh, shown.controls);
    moved = live.update(mapsOf(shown.controls, shown.controls.finest()));
  }
  state.counters["carried"] = static_cast<double>(carried.size());
  state.counters["vertices"] = static_cast<double>(moved);
}
BENCHMARK(dragAtLevel)
    ->ArgNames({"level", "at_finest"})
    ->ArgsProduct({{1, 2, 3, 4, 5}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// range(0): the shape of the regions.
void buildFiveLevels(benchmark::State& state) {
  const Level& finest = theLevels().project.controls.finest();
  const auto shape = static_cast<RegionShape>(state.range(0));
  for (auto _ : state) {
    PointId nextId = theLevels().project.nextId;
    benchmark::DoNotOptimize(buildLevels(finest, levelCount, nextId, shape));
  }
}
BENCHMARK(buildFiveLevels)->ArgName("ellipsoids")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace pbffd::bench
