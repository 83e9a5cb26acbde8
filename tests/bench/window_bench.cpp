#include "core/ffd/deform/deformation.h"
#include "core/mesh/io/mesh_io.h"
#include "tests/support/shapes.h"
#include "ui/document/job_runner.h"
#include "ui/views/viewport.h"
#include "ui/window/main_window.h"

#include <benchmark/benchmark.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QMouseEvent>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

namespace pbffd::bench {
namespace {

/// The workbench's window with a mesh open, its points placed and one of them selected by a click.
class OpenWindow {
 public:
  /// `frameBudget`: seconds that a frame of a drag may take before a coarse mesh is drawn.
  OpenWindow(const QString& mesh, double frameBudget)
      : window_(ui::MainWindow::Options{ui::Theme::Choice::dark, false, {}}) {
    window_.resize(1920, 1200);
    window_.viewport().setFrameBudget(frameBudget);
    window_.show();
    window_.openFile(mesh);
    ui::Document& document = window_.document();
    isReady_ = QTest::qWaitForWindowExposed(&window_) &&
               QTest::qWaitFor([&] { return !document.jobs().isRunning(); }, 300000) && document.isOpen();
    QTest::qWait(500);
    isReady_ = isReady_ && selectOne();
    for (int i = 0; i < 4; ++i) {
      surface().update();
      QCoreApplication::processEvents();
    }
    // Until the coarse mesh is there, if frames were too slow.
    QElapsedTimer waited;
    waited.start();
    while (!window_.viewport().canSimplify() && waited.elapsed() < 4000) {
      QTest::qWait(50);
    }
  }

  bool isReady() const { return isReady_; }
  ui::MainWindow& window() { return window_; }
  QWidget& surface() { return *window_.viewport().surface(); }
  QPointF grip() const { return grip_; }

  /// As the window system sends it. Everything up to the request for a frame happens within.
  void mouse(QEvent::Type type, const QPointF& at, Qt::MouseButton button, Qt::MouseButtons held) {
    QMouseEvent event(type, at, surface().mapToGlobal(at), button, held, {});
    QCoreApplication::sendEvent(&surface(), &event);
  }

 private:
  /// The first point that a click takes where it is seen.
  bool selectOne() {
    for (const ControlPoint& point : window_.document().shown().controls.finest()) {
      const Vec3 at = window_.viewport().projected(point.pose.center);
      grip_ = QPointF(std::round(at.x()), std::round(at.y()));
      const auto found = window_.viewport().pointsAt(grip_);
      if (!found.empty() && found.front() == point.id && surface().childAt(grip_.toPoint()) == nullptr) {
        QTest::mouseClick(&surface(), Qt::LeftButton, {}, grip_.toPoint());
        return window_.document().selection().points() == std::vector<PointId>{point.id};
      }
    }
    return false;
  }

  ui::MainWindow window_;
  QPointF grip_;
  bool isReady_ = false;
};

struct Buffers {
  explicit Buffers(const LiveDeformation& deformation)
      : positions(deformation.positions()), normals(deformation.normals()) {}
  std::vector<float> positions;
  std::vector<float> normals;
};

/// Against a deformation that is made anew.
bool isUpToDate(const ui::Document& document) {
  const Project& project = document.shown();
  LiveDeformation expected(project.mesh, document.parameterization());
  expected.update(mapsOf(project.controls, project.controls.finest()));
  return document.deformation()->positions() == expected.positions() &&
         document.deformation()->normals() == expected.normals();
}

/// From the mouse event of a drag of one point until the positions and normals, and all else that hangs on them
/// but the frame, are new. One event a turn of the event loop, as they come; the frame is counted beside it,
/// and how many of the frames were drawn from a coarse mesh: the normals of the whole then wait for the release.
void dragByTheMouse(benchmark::State& state, const QString& mesh, double frameBudget) {
  OpenWindow open(mesh, frameBudget);
  if (!open.isReady()) {
    state.SkipWithError("the mesh could not be opened, or no point could be selected");
    return;
  }
  ui::Document& document = open.window().document();
  open.mouse(QEvent::MouseButtonPress, open.grip(), Qt::LeftButton, Qt::LeftButton);
  int step = 0;
  double vertices = 0.0;
  double deforming = 0.0;
  double handling = 0.0;
  double drawing = 0.0;
  double simplified = 0.0;
  for (auto _ : state) {
    const double angle = 0.2 * ++step;
    const QPointF at = open.grip() + QPointF(30.0 + 20.0 * std::sin(angle), 20.0 * std::cos(angle));
    const Buffers before(*document.deformation());
    QElapsedTimer timer;
    timer.start();
    open.mouse(QEvent::MouseMove, at, Qt::NoButton, Qt::LeftButton);
    const auto spent = static_cast<double>(timer.nsecsElapsed());
    state.SetIterationTime(1e-9 * spent);
    const bool isSimplified = open.window().viewport().isSimplified();
    const Buffers after(*document.deformation());
    if (before.positions == after.positions || (!isSimplified && before.normals == after.normals)) {
      state.SkipWithError("a mouse event moved nothing, or turned no normal");
      break;
    }
    deforming += document.lastMilliseconds();
    handling += 1e-6 * spent;
    vertices += document.lastMovedVertices();
    timer.start();
    QCoreApplication::processEvents();
    drawing += 1e-6 * static_cast<double>(timer.nsecsElapsed());
    simplified += open.window().viewport().isSimplified() ? 1.0 : 0.0;
  }
  open.mouse(QEvent::MouseButtonRelease, open.grip(), Qt::LeftButton, Qt::NoButton);
  QCoreApplication::processEvents();
  if (!isUpToDate(document)) {
    state.SkipWithError("after the release positions or normals are not those of the control points");
  }
  state.counters["vertices"] = static_cast<double>(document.shown().mesh->vertexCount());
  state.counters["deforming_ms"] = benchmark::Counter(deforming, benchmark::Counter::kAvgIterations);
  state.counters["frame_ms"] = benchmark::Counter(drawing, benchmark::Counter::kAvgIterations);
  state.counters["frames_per_second"] =
      1e3 * static_cast<double>(state.iterations()) / std::max(handling + drawing, 1e-9);
  state.counters["simplified"] = benchmark::Counter(simplified, benchmark::Counter::kAvgIterations);
  state.counters["moved"] = benchmark::Counter(vertices, benchmark::Counter::kAvgIterations);
}

}  // namespace
}  // namespace pbffd::bench

// bench_window [MESH] [--benchmark_...]: a mesh file of one's own in place of a sphere of 50,000 vertices.
int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "xcb");
  qputenv("QT_XCB_GL_INTEGRATION", "xcb_glx");
  QSurfaceFormat surface;
  surface.setVersion(3, 2);
  surface.setProfile(QSurfaceFormat::CoreProfile);
  surface.setSamples(0);
  QSurfaceFormat::setDefaultFormat(surface);
  QStandardPaths::setTestModeEnabled(true);
  QApplication application(argc, argv);
  benchmark::Initialize(&argc, argv);
  QTemporaryDir folder;
  QString mesh = folder.filePath("sphere.off");
  if (argc > 1) {
    mesh = QString::fromLocal8Bit(argv[1]);
  } else {
    using namespace pbffd;
    const Mesh sphere = test::sphere(160, 313);
    const std::string bytes = encodeMesh(sphere, DeformedShape{sphere.positions, {}}, MeshFormat::off);
    QFile file(mesh);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes.data(), static_cast<qint64>(bytes.size())) < 0) {
      std::cerr << "The sphere could not be written.\n";
      return 1;
    }
  }
  const auto add = [&](const char* name, double frameBudget) {
    benchmark::RegisterBenchmark(name, pbffd::bench::dragByTheMouse, mesh, frameBudget)
        ->Iterations(60)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  };
  add("dragByTheMouse", 1.0 / 30.0);
  add("dragByTheMouse, always whole", 1e9);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
