#include "ui/views/drag_detail.h"
#include "core/base/error.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"
#include "ui/document/document.h"
#include "ui/views/surface_store.h"

#include <QSignalSpy>
#include <QtTest>

#include <atomic>
#include <memory>
#include <new>

#include <vtkNew.h>
#include <vtkRenderer.h>

namespace pbffd::ui {
namespace {

constexpr double slow = 0.1;
constexpr double quick = 0.001;

std::shared_ptr<const RestMesh> largeMesh(int segments = 300) {
  return std::make_shared<const RestMesh>(pbffd::test::sphere(200, segments));
}

/// What a view does with it, but for the drawing: how long frames take is told by the test.
struct Drawn {
  explicit Drawn(const std::shared_ptr<const RestMesh>& mesh, StandIn::Coarsen coarsen = coarseMesh)
      : detail(document, nullptr, std::move(coarsen)), actor(*renderer) {
    show(mesh);
  }

  void show(const std::shared_ptr<const RestMesh>& mesh) {
    surface.choose(mesh, nullptr);
    actor.setMesh(mesh, surface.buffers());
    ++frame.revision;
  }

  /// Frames at rest, or of a drag, that take so long each.
  void frames(double seconds, bool isDragged = false, int count = 3) {
    frame.isDragged = isDragged;
    for (int i = 0; i < count; ++i) {
      frame.revision += isDragged ? 1 : 0;
      detail.prepare(actor, surface, frame);
      detail.drawn(seconds);
    }
  }

  bool waitUntilBuilt() {
    return QTest::qWaitFor([&] { return !detail.standIn().isBuilding(); }, 20000);
  }

  Document document;
  DragDetail detail;
  vtkNew<vtkRenderer> renderer;
  MeshActor actor;
  SurfaceStore surface;
  DragDetail::Frame frame{false, 0, DisplayMode::wire, {640, 480}};
};

/// Builds no stand-in until it is told to, or until it is cancelled.
struct Gate {
  std::atomic<bool> isOpen{false};
  std::atomic<int> entered{0};
  std::atomic<int> left{0};

  StandIn::Coarsen coarsen() {
    return [this](const RestMesh& mesh, Index most, const Progress& progress) {
      ++entered;
      while (!isOpen && !progress.isCancelled()) {
        QThread::msleep(1);
      }
      ++left;
      return coarseMesh(mesh, most, progress);
    };
  }
};

}  // namespace

/// When a coarse stand-in is drawn in place of a large mesh, and how fine it is.
class DragDetailTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void fastMeshesAreDrawnWhole() {
    Drawn drawn(largeMesh());
    drawn.frames(quick);
    QVERIFY(!drawn.detail.standIn().isBuilding());
    drawn.frames(quick, true);
    QVERIFY(!drawn.detail.isSimplified());
  }

  void smallMeshesAreMeasuredInDragsAloneAndHaveNoStandIn() {
    Drawn drawn(std::make_shared<const RestMesh>(pbffd::test::sphere(64, 128)));
    drawn.frames(slow);
    QVERIFY(!drawn.detail.isMeasuring());
    drawn.frames(quick, true);
    QVERIFY(drawn.detail.isMeasuring());
    QVERIFY(!drawn.detail.isSimplified());
    drawn.frames(quick);
    QVERIFY(!drawn.detail.isMeasuring());
    // What else can be left out is.
    drawn.frames(slow, true);
    QVERIFY(drawn.detail.isSimplified());
    drawn.frames(quick, true);
    QVERIFY(drawn.detail.isSimplified());
    QVERIFY(!drawn.detail.isStoodIn());
    QVERIFY(!drawn.detail.standIn().isBuilding());
    drawn.frames(quick);
    QVERIFY(!drawn.detail.isSimplified());
  }

  void slowMeshesAreStoodInForInDrags() {
    Drawn drawn(largeMesh());
    QSignalSpy changes(&drawn.detail, &DragDetail::simplifiedChanged);
    drawn.frames(slow);
    QVERIFY(drawn.detail.isMeasuring());
    QVERIFY(drawn.waitUntilBuilt());
    QVERIFY(!drawn.detail.isSimplified());
    drawn.frames(quick, true);
    QVERIFY(drawn.detail.isStoodIn());
    drawn.frames(slow);
    QVERIFY(!drawn.detail.isSimplified());
    QCOMPARE(changes.count(), 2);
  }

  void standInGetsCoarserWhereItIsSlowToo() {
    Drawn drawn(largeMesh(1000));
    drawn.frames(0.034);
    QVERIFY(drawn.waitUntilBuilt());
    const Index first = drawn.detail.standIn().triangleCount();
    drawn.frames(slow, true);
    QVERIFY(drawn.waitUntilBuilt());
    QVERIFY(drawn.detail.standIn().triangleCount() < 0.75 * first);
    QVERIFY(drawn.detail.standIn().triangleCount() > 0.3 * first);
    // And stays so, while frames with it are fast: the finer one would be too slow again.
    drawn.frames(quick, true, 6);
    drawn.frames(0.034);
    QVERIFY(!drawn.detail.standIn().isBuilding());
  }

  void standInGetsFinerInASmallerView() {
    Drawn drawn(largeMesh(1000));
    drawn.frames(10 * slow);
    QVERIFY(drawn.waitUntilBuilt());
    const Index first = drawn.detail.standIn().triangleCount();
    drawn.frame.size = {320, 240};
    drawn.frames(0.034);
    QVERIFY(drawn.waitUntilBuilt());
    QVERIFY(drawn.detail.standIn().triangleCount() > 2 * first);
    // The finer one takes the other's place in the drag.
    drawn.frames(quick, true);
    QVERIFY(drawn.detail.isStoodIn());
  }

  void smallDifferencesBuildNothing() {
    Drawn drawn(largeMesh(1000));
    drawn.frames(0.05);
    QVERIFY(drawn.waitUntilBuilt());
    drawn.frame.size = {600, 440};
    drawn.frames(0.04);
    QVERIFY(!drawn.detail.standIn().isBuilding());
  }

  void aMeshThatIsReplacedWhileItsStandInIsBuiltGetsNone() {
    Gate gate;
    Drawn drawn(largeMesh(), gate.coarsen());
    drawn.frames(slow);
    QTRY_COMPARE(gate.entered.load(), 1);
    drawn.show(largeMesh(260));
    drawn.frames(quick);
    QTRY_COMPARE(gate.left.load(), 1);
    QVERIFY(drawn.waitUntilBuilt());
    QVERIFY(!drawn.detail.standIn().isReady());
    drawn.frames(quick, true);
    QVERIFY(!drawn.detail.isSimplified());
    // The other mesh is judged by itself.
    gate.isOpen = true;
    drawn.frames(slow);
    QTRY_COMPARE(gate.entered.load(), 2);
    QVERIFY(drawn.waitUntilBuilt());
    drawn.frames(quick, true);
    QVERIFY(drawn.detail.isStoodIn());
  }

  void closingTheMeshStopsTheBuilding() {
    Gate gate;
    Drawn drawn(largeMesh(), gate.coarsen());
    drawn.frames(slow);
    QTRY_COMPARE(gate.entered.load(), 1);
    drawn.show(nullptr);
    drawn.frames(quick);
    QVERIFY(!drawn.detail.isMeasuring());
    QTRY_COMPARE(gate.left.load(), 1);
    QVERIFY(drawn.waitUntilBuilt());
    QVERIFY(!drawn.detail.canSimplify());
  }

  void theViewMayGoWhileAStandInIsBuilt() {
    Gate gate;
    auto drawn = std::make_unique<Drawn>(largeMesh(), gate.coarsen());
    drawn->frames(slow);
    QTRY_COMPARE(gate.entered.load(), 1);
    drawn.reset();
    QCOMPARE(gate.left.load(), 1);
  }

  void whatFailedIsToldOnceAndTriedAgainWithTheNextDrag() {
    int tries = 0;
    bool fails = true;
    Drawn drawn(largeMesh(), [&](const RestMesh& mesh, Index most, const Progress& progress) {
      ++tries;
      if (fails) {
        throw std::bad_alloc();
      }
      return coarseMesh(mesh, most, progress);
    });
    QSignalSpy told(&drawn.detail, &DragDetail::failed);
    drawn.frames(slow);
    QVERIFY(drawn.waitUntilBuilt());
    drawn.frames(slow);
    QVERIFY(drawn.waitUntilBuilt());
    QCOMPARE(tries, 1);
    drawn.frames(slow, true);
    QVERIFY(drawn.waitUntilBuilt());
    drawn.frames(slow, true);
    QVERIFY(drawn.waitUntilBuilt());
    QCOMPARE(tries, 2);
    QVERIFY(!drawn.detail.isStoodIn());
    QCOMPARE(told.count(), 1);
    QVERIFY(told.front().front().toString().contains("memory"));
    drawn.frames(slow);
    fails = false;
    drawn.frames(slow, true);
    QVERIFY(drawn.waitUntilBuilt());
    drawn.frames(quick, true);
    QVERIFY(drawn.detail.isStoodIn());
  }
};

const pbffd::test::Registration<DragDetailTest> registration;

}  // namespace pbffd::ui

#include "drag_detail_test.moc"
