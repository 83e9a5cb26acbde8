#include "app/dataset/apply.h"
#include "core/project/edit.h"
#include "tests/support/shapes.h"

#include <benchmark/benchmark.h>
#include <vtkAppendFilter.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>

// What `pbffd apply` takes for a .vtu of as many cells as points, every one of them in the regions of control
// points that moved, and what VTK takes to read and write the same file. The arguments of each: how the file is
// written, and the points along its side.

namespace pbffd::bench {
namespace {

namespace fs = std::filesystem;

enum Mode { raw, asVtkDoesByDefault, ascii };

/// 215^3 points are 9.9 million.
constexpr int full = 215;
constexpr int small = 100;

/// Half the side of the cube, which lies within the unit sphere.
constexpr double half = 0.55;

void write(vtkUnstructuredGrid* grid, const fs::path& path, std::int64_t mode) {
  const vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(grid);
  writer->SetFileName(path.c_str());
  if (mode == raw) {
    writer->SetCompressorTypeToNone();
    writer->EncodeAppendedDataOff();
    writer->SetHeaderTypeToUInt64();
  } else if (mode == ascii) {
    writer->SetDataModeToAscii();
  }
  writer->Write();
}

/// A cube of cells with a vector at each point.
vtkSmartPointer<vtkUnstructuredGrid> cells(int side) {
  const vtkNew<vtkImageData> image;
  image->SetDimensions(side, side, side);
  image->SetOrigin(-half, -half, -half);
  const double spacing = 2.0 * half / (side - 1);
  image->SetSpacing(spacing, spacing, spacing);
  const vtkNew<vtkFloatArray> velocity;
  velocity->SetName("velocity");
  velocity->SetNumberOfComponents(3);
  velocity->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i) {
    const double* point = image->GetPoint(i);
    velocity->SetTuple3(i, -point[1], point[0], 0.5);
  }
  image->GetPointData()->AddArray(velocity);
  const vtkNew<vtkAppendFilter> toGrid;
  toGrid->SetInputData(image);
  toGrid->Update();
  return toGrid->GetOutput();
}

/// The file of a benchmark, made when first asked for.
class Files {
 public:
  explicit Files(const benchmark::State& state)
      : folder_(fs::temp_directory_path() /
                ("bench_apply_" + std::to_string(state.range(0)) + "_" + std::to_string(state.range(1)))) {
    fs::create_directories(folder_);
    write(cells(static_cast<int>(state.range(1))), source(), state.range(0));
  }
  ~Files() { fs::remove_all(folder_); }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;

  fs::path source() const { return folder_ / "in.vtu"; }
  fs::path target() const { return folder_ / "out.vtu"; }

 private:
  fs::path folder_;
};

const Files& filesOf(const benchmark::State& state) {
  static std::map<std::pair<std::int64_t, std::int64_t>, std::unique_ptr<Files>> all;
  std::unique_ptr<Files>& files = all[{state.range(0), state.range(1)}];
  if (!files) {
    files = std::make_unique<Files>(state);
  }
  return *files;
}

/// 200 points about a sphere, every one moved.
const Project& project() {
  static const Project made = [] {
    EditWorkspace workspace;
    Project project = projectOf(std::make_shared<const RestMesh>(test::sphere(100, 160)));
    project = apply(project, Place{.options = {}, .keepEdits = false, .symmetric = {}}, workspace).project;
    std::vector<PointId> points;
    for (const ControlPoint& point : project.controls.finest()) {
      points.push_back(point.id);
    }
    return apply(project, Move{{std::nullopt, points}, {Vec3(0.1, 0.05, 0.0)}, Follow::none, {}}, workspace)
        .project;
  }();
  return made;
}

void readAndWriteByVtk(benchmark::State& state) {
  const Files& files = filesOf(state);
  for (auto _ : state) {
    const vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(files.source().c_str());
    reader->Update();
    write(reader->GetOutput(), files.target(), state.range(0));
  }
}

void applyWith(benchmark::State& state, const ApplyOptions& options) {
  const Files& files = filesOf(state);
  project();
  for (auto _ : state) {
    applyToFile(project(), files.source(), files.target(), options);
  }
}

void applyToVtu(benchmark::State& state) {
  applyWith(state, {});
}

void applyAndTurnVectors(benchmark::State& state) {
  ApplyOptions options;
  options.transports = {parseTransport("velocity")};
  applyWith(state, options);
}

void files(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgsProduct({{raw, asVtkDoesByDefault, ascii}, {small, full}})
      ->ArgNames({"mode", "side"})
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}
BENCHMARK(readAndWriteByVtk)->Apply(files);
BENCHMARK(applyToVtu)->Apply(files);
BENCHMARK(applyAndTurnVectors)->Apply(files);

}  // namespace
}  // namespace pbffd::bench

BENCHMARK_MAIN();
