#include "app/yardsticks/median.h"
#include "tests/bench/scene.h"

#include <benchmark/benchmark.h>

#include <Eigen/SparseCore>

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkThinPlateSplineTransform.h>

#include <functional>

// What others do for the same mesh, in the same run: how many times slower than a full pass they are is counted
// beside their times.

namespace pbffd::bench {
namespace {

void measure(benchmark::State& state, const std::function<void()>& work) {
  for (auto _ : state) {
    work();
    benchmark::ClobberMemory();
  }
  state.counters["times_slower"] = medianSeconds(work) / fullPassSeconds(theScene(), true);
}

/// McDonnell & Qin, eq. (7) by the letter, V = WP + DA, sparse and in double precision, on one thread.
void eigenEquationSeven(benchmark::State& state) {
  Scene& scene = theScene();
  scene.setReach(Reach::all);
  const Level& level = scene.set.finest();
  const Points& vertices = scene.mesh->positions();
  const PointWeights rows = weightsAt(vertices, *scene.mesh, scene.set.basis, scene.set.master, level);
  const Index count = level.size() + 1;
  std::vector<Eigen::Triplet<double>> inW;
  std::vector<Eigen::Triplet<double>> inD;
  const auto add = [&](Index i, Index j, double weight, const Frame& rest) {
    const Vec3 u = Region(rest).parameter(vertices.row(i));
    inW.emplace_back(i, j, weight);
    for (int axis = 0; axis < 3; ++axis) {
      inD.emplace_back(i, axis * count + j, weight * u[axis]);
    }
  };
  for (Index i = 0; i < vertices.rows(); ++i) {
    for (Index e = rows.start[i]; e < rows.start[i + 1]; ++e) {
      add(i, rows.points[e], rows.weights[e], level[rows.points[e]].rest);
    }
    add(i, count - 1, rows.master[i], scene.set.master.rest);
  }
  Eigen::SparseMatrix<double, Eigen::RowMajor> w(vertices.rows(), count);
  Eigen::SparseMatrix<double, Eigen::RowMajor> d(vertices.rows(), 3 * count);
  w.setFromTriplets(inW.begin(), inW.end());
  d.setFromTriplets(inD.begin(), inD.end());
  const Eigen::MatrixXd p = Eigen::MatrixXd::Random(count, 3);
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(3 * count, 3);
  Eigen::MatrixXd v(vertices.rows(), 3);
  measure(state, [&] {
    v.noalias() = w * p;
    v.noalias() += d * a;
  });
}
BENCHMARK(eigenEquationSeven)->Unit(benchmark::kMillisecond)->UseRealTime();

/// VTK's thin-plate spline with a landmark at each control point; its system is solved before, not counted.
void vtkThinPlateSpline(benchmark::State& state) {
  Scene& scene = theScene();
  vtkNew<vtkPoints> from;
  vtkNew<vtkPoints> to;
  const LevelMaps maps = movedMaps(scene, true, 0.1);
  for (Index j = 0; j < scene.set.finest().size(); ++j) {
    const Vec3 center = scene.set.finest()[j].rest.center;
    from->InsertNextPoint(center.data());
    to->InsertNextPoint(applyMap(maps.points[static_cast<std::size_t>(j)], center).data());
  }
  vtkNew<vtkThinPlateSplineTransform> spline;
  spline->SetBasisToR();
  spline->SetSourceLandmarks(from);
  spline->SetTargetLandmarks(to);
  spline->Update();
  vtkNew<vtkPoints> vertices;
  for (Index v = 0; v < scene.mesh->vertexCount(); ++v) {
    const Vec3 position = scene.mesh->positions().row(v);
    vertices->InsertNextPoint(position.data());
  }
  measure(state, [&] {
    vtkNew<vtkPoints> moved;
    spline->TransformPoints(vertices, moved);
    benchmark::DoNotOptimize(moved->GetPoint(0));
  });
}
BENCHMARK(vtkThinPlateSpline)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace pbffd::bench
