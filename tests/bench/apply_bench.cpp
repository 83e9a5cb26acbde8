#include "app/dataset/apply.h"
#include "core/project/edit.h"
#include "tests/support/shapes.h"

#include <benchmark/benchmark.h>
#include <vtkAppendFilter.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <filesystem>

// What `pbffd apply` takes for a .vtu of ten million points and as many cells, and what VTK takes to read and
// write the same file.

namespace pbffd::bench {
namespace {

namespace fs = std::filesystem;

/// 215^3 points are 9.9 million.
constexpr int side = 215;

/// state.range(0): how the file is written.
enum Mode { raw, asVtkDoesByDefault };

void write(vtkUnstructuredGrid* grid, const fs::path& path, Mode mode) {
  const vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(grid);
  writer->SetFileName(path.c_str());
  if (mode == raw) {
    writer->SetCompressorTypeToNone();
    writer->EncodeAppendedDataOff();
    writer->SetHeaderTypeToUInt64();
  }
  writer->Write();
}

/// A cube of cells about the unit sphere.
vtkSmartPointer<vtkUnstructuredGrid> cells() {
  const vtkNew<vtkImageData> image;
  image->SetDimensions(side, side, side);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->SetSpacing(2.0 / (side - 1), 2.0 / (side - 1), 2.0 / (side - 1));
  const vtkNew<vtkAppendFilter> toGrid;
  toGrid->SetInputData(image);
  toGrid->Update();
  return toGrid->GetOutput();
}

/// The files of all benchmarks, made when first asked for.
class Files {
 public:
  explicit Files(Mode mode)
      : folder_(fs::temp_directory_path() / (mode == raw ? "bench_raw" : "bench_default")) {
    fs::create_directories(folder_);
    write(cells(), source(), mode);
  }
  ~Files() { fs::remove_all(folder_); }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;

  fs::path source() const { return folder_ / "in.vtu"; }
  fs::path target() const { return folder_ / "out.vtu"; }

 private:
  fs::path folder_;
};

const Files& files(Mode mode) {
  if (mode == raw) {
    static const Files ofRaw(raw);
    return ofRaw;
  }
  static const Files ofDefault(asVtkDoesByDefault);
  return ofDefault;
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
  const auto mode = static_cast<Mode>(state.range(0));
  const Files& file = files(mode);
  for (auto _ : state) {
    const vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(file.source().c_str());
    reader->Update();
    write(reader->GetOutput(), file.target(), mode);
  }
}

void applyToVtu(benchmark::State& state) {
  const Files& file = files(static_cast<Mode>(state.range(0)));
  project();
  for (auto _ : state) {
    applyToFile(project(), file.source(), file.target());
  }
}

BENCHMARK(readAndWriteByVtk)->Arg(raw)->Arg(asVtkDoesByDefault)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(applyToVtu)->Arg(raw)->Arg(asVtkDoesByDefault)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace pbffd::bench

BENCHMARK_MAIN();
