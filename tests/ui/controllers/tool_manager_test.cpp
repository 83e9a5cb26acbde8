#include "ui/controllers/tool_manager.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"
#include "tests/ui/views/open_view.h"

#include <QSignalSpy>
#include <QtTest>

#include <cmath>

namespace pbffd::ui {
namespace {

/// Far apart on the screen; the last one is inside.
const std::vector<Vec3> points{{0.5, 0.5, 0.5}, {-0.5, 0.5, 0.5}, {0.5, -0.5, -0.5}, {0, 0, 0}};

/// A view with tools, and the mouse and keys that a user would use.
struct Bench {
  Bench() : open(pbffd::test::cube(), points), tools(open.document, open.viewport, open.theme) {
    open.viewport.surface()->setFocus();
  }

  void press(const QPoint& at, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mousePress(open.viewport.surface(), Qt::LeftButton, modifiers, at);
  }
  /// Qt's own test function for moves knows no modifiers.
  void move(const QPoint& at, Qt::KeyboardModifiers modifiers = {}, Qt::MouseButtons held = Qt::LeftButton) {
    QMouseEvent event(QEvent::MouseMove, at, open.viewport.surface()->mapToGlobal(QPointF(at)), Qt::NoButton,
                      held, modifiers);
    QCoreApplication::sendEvent(open.viewport.surface(), &event);
  }
  void release(const QPoint& at, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mouseRelease(open.viewport.surface(), Qt::LeftButton, modifiers, at);
  }
  void click(const QPoint& at, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mouseClick(open.viewport.surface(), Qt::LeftButton, modifiers, at);
  }
  void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {}) {
    press(from, modifiers);
    move(from + (to - from) / 2, modifiers);
    move(to, modifiers);
    release(to, modifiers);
  }
  void keys(const QString& text) { QTest::keyClicks(open.viewport.surface(), text); }
  void key(Qt::Key which, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(open.viewport.surface(), which, modifiers);
  }
  const std::vector<PointId>& selected() { return open.document.selection().points(); }
  Vec3 centerOf(PointId id) { return open.point(id).pose.center; }
  QPoint screen(const Vec3& world) {
    const Vec3 at = open.viewport.projected(world);
    return {qRound(at.x()), qRound(at.y())};
  }
  /// A place on the gizmo's arrow along an axis, while the gizmo is at `center`.
  QPoint onArrow(const Vec3& center, int axis) {
    const double length = 0.7 * GizmoSizes::length * open.viewport.pixelSizeAt(center);
    return screen(center + length * Vec3::Unit(axis));
  }

  test::OpenView open;
  ToolManager tools;
};

bool sameBits(const Project& first, const Project& second) {
  return first.controls == second.controls;
}

}  // namespace

class ToolManagerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void clicksSelectToggleAndClear() {
    Bench bench;
    bench.click(bench.open.placeOf(1));
    QCOMPARE(bench.selected(), (std::vector<PointId>{1}));
    bench.click(bench.open.placeOf(2), Qt::ShiftModifier);
    QCOMPARE(bench.selected(), (std::vector<PointId>{1, 2}));
    bench.click(bench.open.placeOf(1), Qt::ShiftModifier);
    QCOMPARE(bench.selected(), (std::vector<PointId>{2}));
    bench.click({4, 4});
    QVERIFY(bench.selected().empty());
    QCOMPARE(bench.open.document.history().count(), 0);
  }

  void secondClickInPlaceTakesTheNextBehind() {
    Bench bench;
    bench.open.view.setOrthographic(true);
    bench.open.viewport.lookFrom(Viewport::Side::front);
    Move move;
    move.where.points = {4};
    move.by = {Vec3(0.5, 0.5, 0)};
    QVERIFY(bench.open.document.perform(move));
    // Points 1 and 4 now lie one behind the other, nearly.
    const QPoint at = bench.open.placeOf(1);
    bench.click(at);
    const PointId first = bench.selected().at(0);
    bench.click(at);
    const PointId second = bench.selected().at(0);
    QVERIFY(first != second);
    QVERIFY(bench.tools.active().hint().contains(QStringLiteral("2 of 2")));
    bench.click(at);
    QCOMPARE(bench.selected().at(0), first);
  }

  void boxSelectsAddsAndRemoves() {
    Bench bench;
    bench.drag({2, 2}, {638, 478});
    QCOMPARE(bench.selected().size(), std::size_t(4));
    const QPoint at = bench.open.placeOf(2);
    bench.drag(at - QPoint(25, 25), at + QPoint(20, 20), Qt::ControlModifier);
    QCOMPARE(bench.selected(), (std::vector<PointId>{1, 3, 4}));
    bench.drag(at - QPoint(25, 25), at + QPoint(20, 20), Qt::ShiftModifier);
    QCOMPARE(bench.selected().size(), std::size_t(4));
    bench.drag(at - QPoint(25, 25), at + QPoint(20, 20));
    QCOMPARE(bench.selected(), (std::vector<PointId>{2}));
  }

  void smallMotionIsAClick() {
    Bench bench;
    const QPoint at = bench.open.placeOf(1);
    bench.press(at);
    bench.move(at + QPoint(2, 2));
    bench.release(at + QPoint(2, 2));
    QCOMPARE(bench.selected(), (std::vector<PointId>{1}));
    QCOMPARE(bench.open.document.history().count(), 0);
  }

  void draggedPointFollowsTheCursorAsOneEntry() {
    Bench bench;
    const QPoint from = bench.open.placeOf(1);
    const Vec3 before = bench.centerOf(1);
    bench.click(from);
    bench.drag(from, from + QPoint(40, -30));
    QCOMPARE(bench.open.document.history().count(), 1);
    const QPoint after = bench.open.placeOf(1);
    QVERIFY((after - from - QPoint(40, -30)).manhattanLength() <= 1);
    const Vec3 by = bench.centerOf(1) - before;
    QVERIFY(std::abs(by.dot(bench.open.viewport.viewDirection())) < 1e-9);
    bench.open.document.undo();
    QCOMPARE(bench.centerOf(1), before);
  }

  void arrowOfTheGizmoMovesAlongItsAxis() {
    Bench bench;
    bench.tools.setActive(ToolId::move);
    bench.click(bench.open.placeOf(1));
    const Vec3 before = bench.centerOf(1);
    const QPoint from = bench.onArrow(before, 1);
    const double length = 50.0 * bench.open.viewport.pixelSizeAt(before);
    const QPoint to = bench.screen(before + Vec3(0, 0.7 * GizmoSizes::length * length / 50.0 + length, 0));
    bench.drag(from, to);
    const Vec3 by = bench.centerOf(1) - before;
    QCOMPARE(by.x(), 0.0);
    QCOMPARE(by.z(), 0.0);
    QVERIFY(std::abs(by.y() - length) < 0.03 * length);
    QCOMPARE(bench.open.document.history().count(), 1);
  }

  void modalMoveByATypedNumberIsExact() {
    Bench bench;
    bench.click(bench.open.placeOf(1));
    const Vec3 before = bench.centerOf(1);
    bench.keys("g");
    QVERIFY(bench.tools.isBusy());
    QCOMPARE(bench.tools.active().id(), ToolId::move);
    bench.move({100, 100}, {}, Qt::NoButton);
    bench.keys("x0.5");
    const auto* const readOut = bench.open.viewport.findChild<QWidget*>(QStringLiteral("readOut"));
    QVERIFY(readOut->isVisible());
    QCOMPARE(readOut->property("value").toString(), QStringLiteral("X 0.5|"));
    bench.key(Qt::Key_Return);
    QVERIFY(!bench.tools.isBusy());
    QVERIFY(!readOut->isVisible());
    QCOMPARE(bench.centerOf(1), Vec3(before + Vec3(0.5, 0, 0)));
    QCOMPARE(bench.open.document.history().count(), 1);
  }

  void escapeAndRightClickRestoreTheVeryBits() {
    Bench bench;
    bench.click(bench.open.placeOf(1));
    const Project before = bench.open.document.shown();
    const std::vector<float> positions = bench.open.document.deformation()->positions();
    for (const bool byKey : {true, false}) {
      bench.keys("g");
      bench.move(byKey ? QPoint(120, 90) : QPoint(300, 60), {}, Qt::NoButton);
      QCoreApplication::processEvents();
      QVERIFY(!sameBits(bench.open.document.shown(), before));
      if (byKey) {
        bench.key(Qt::Key_Escape);
      } else {
        QTest::mouseClick(bench.open.viewport.surface(), Qt::RightButton, {}, {120, 90});
      }
      QVERIFY(!bench.tools.isBusy());
      QVERIFY(sameBits(bench.open.document.shown(), before));
      QCOMPARE(bench.open.document.deformation()->positions(), positions);
      QCOMPARE(bench.open.document.history().count(), 0);
      QCOMPARE(bench.tools.active().id(), ToolId::move);
    }
  }

  void escapeInADragRestoresAndTheReleaseDoesNothing() {
    Bench bench;
    bench.tools.setActive(ToolId::move);
    bench.click(bench.open.placeOf(1));
    const Project before = bench.open.document.shown();
    const QPoint from = bench.onArrow(bench.centerOf(1), 0);
    bench.press(from);
    bench.move(from + QPoint(30, 0));
    QVERIFY(bench.tools.isBusy());
    bench.key(Qt::Key_Escape);
    bench.release(from + QPoint(30, 0));
    QVERIFY(sameBits(bench.open.document.shown(), before));
    QCOMPARE(bench.open.document.history().count(), 0);
    QCOMPARE(bench.selected(), (std::vector<PointId>{1}));
  }

  void leftClickConfirmsAModalMove() {
    Bench bench;
    bench.click(bench.open.placeOf(1));
    bench.keys("g");
    bench.move(bench.open.placeOf(1) + QPoint(50, 10), {}, Qt::NoButton);
    bench.click(bench.open.placeOf(1));
    QVERIFY(!bench.tools.isBusy());
    QCOMPARE(bench.open.document.history().count(), 1);
    QCOMPARE(bench.selected(), (std::vector<PointId>{1}));
  }

  void confirmingNothingLeavesNoEntry() {
    Bench bench;
    bench.click(bench.open.placeOf(1));
    bench.keys("g");
    bench.key(Qt::Key_Return);
    QCOMPARE(bench.open.document.history().count(), 0);
  }

  void modalRotationTurnsTheFrame() {
    Bench bench;
    bench.click(bench.open.placeOf(1));
    bench.keys("rz90");
    bench.key(Qt::Key_Enter);
    const Mat3 axes = bench.open.point(1).pose.axes;
    QVERIFY((axes.col(0) - Vec3::UnitY()).norm() < 1e-12);
    QVERIFY((bench.centerOf(1) - points[0]).norm() < 1e-12);
    QCOMPARE(bench.open.document.history().count(), 1);
  }

  void modalScaleStretchesTheFrame() {
    Bench bench;
    bench.click(bench.open.placeOf(1));
    bench.keys("sy2");
    bench.key(Qt::Key_Return);
    QVERIFY((bench.open.point(1).pose.axes.col(1) - Vec3(0, 2, 0)).norm() < 1e-12);
    QVERIFY((bench.open.point(1).pose.axes.col(0) - Vec3(1, 0, 0)).norm() < 1e-12);
  }

  void modalKeyWithoutSelectionOnlyChoosesTheTool() {
    Bench bench;
    QSignalSpy chosen(&bench.tools, &ToolManager::activeChanged);
    bench.keys("s");
    QVERIFY(!bench.tools.isBusy());
    QCOMPARE(bench.tools.active().id(), ToolId::scale);
    QCOMPARE(chosen.count(), 1);
    bench.key(Qt::Key_Escape);
    QCOMPARE(bench.tools.active().id(), ToolId::select);
  }

  void lockedPointsAreNotMoved() {
    Bench bench;
    Lock lock;
    lock.where.points = {1};
    QVERIFY(bench.open.document.perform(lock));
    bench.open.document.selection().replace({1});
    bench.keys("g");
    QVERIFY(!bench.tools.isBusy());
  }

  void hintsNameTheKeys() {
    Bench bench;
    QSignalSpy hints(&bench.tools, &ToolManager::hintChanged);
    bench.click(bench.open.placeOf(1));
    bench.keys("gy");
    const QString hint = hints.last().at(0).toString();
    QVERIFY(hint.startsWith(QStringLiteral("Moving along Y")));
    QVERIFY(hint.contains(QStringLiteral("[Shift] precise")));
    bench.key(Qt::Key_Escape);
  }

  void hoveringShowsThePoint() {
    Bench bench;
    bench.move(bench.open.placeOf(2), {}, Qt::NoButton);
    QCOMPARE(bench.open.viewport.hoveredPoint(), PointId(2));
    bench.move({4, 4}, {}, Qt::NoButton);
    QCOMPARE(bench.open.viewport.hoveredPoint(), PointId(0));
  }

  void goingOnElsewhereInTheWindowEndsTheGesture() {
    Bench bench;
    bench.click(bench.open.placeOf(1));
    bench.keys("r");
    const Project before = bench.open.document.committed();
    bench.move(bench.open.placeOf(2), {}, Qt::NoButton);
    QSignalSpy hints(&bench.tools, &ToolManager::hintChanged);
    const auto loseFocus = [&](Qt::FocusReason reason) {
      QFocusEvent event(QEvent::FocusOut, reason);
      QCoreApplication::sendEvent(bench.open.viewport.surface(), &event);
    };
    loseFocus(Qt::ActiveWindowFocusReason);
    QVERIFY(bench.tools.isBusy());
    loseFocus(Qt::MouseFocusReason);
    QVERIFY(!bench.tools.isBusy());
    QVERIFY(sameBits(bench.open.document.shown(), before));
    QCOMPARE(hints.last().at(0).toString(), bench.tools.active().hint());
  }

  void openingAnotherDocumentEndsTheGesture() {
    Bench bench;
    bench.click(bench.open.placeOf(1));
    bench.keys("g");
    bench.open.document.close();
    QVERIFY(!bench.tools.isBusy());
    bench.move({50, 50}, {}, Qt::NoButton);
    bench.open.frame();
  }

  void rightClickAsksForAMenu() {
    Bench bench;
    QSignalSpy menus(&bench.tools, &ToolManager::menuRequested);
    QTest::mouseClick(bench.open.viewport.surface(), Qt::RightButton, {}, {50, 60});
    QCOMPARE(menus.count(), 1);
    QCOMPARE(menus.at(0).at(0).toPoint(), QPoint(50, 60));
  }

  void everyGizmoDragIsSeenAndUndone() {
    for (const ToolId id : {ToolId::rotate, ToolId::scale}) {
      Bench bench;
      bench.tools.setActive(id);
      bench.open.document.selection().replace({1, 2});
      const Project before = bench.open.document.shown();
      const Vec3 pivot = 0.5 * (points[0] + points[1]);
      // The outer ring of the one, the arm along y of the other.
      const QPoint from =
          id == ToolId::rotate
              ? bench.screen(pivot + GizmoSizes::length * bench.open.viewport.pixelSizeAt(pivot) *
                                         bench.open.viewport.rightDirection())
              : bench.onArrow(pivot, 1);
      bench.drag(from, from + QPoint(0, -40));
      QCOMPARE(bench.open.document.history().count(), 1);
      QVERIFY(!sameBits(bench.open.document.shown(), before));
      bench.open.document.undo();
      QVERIFY(sameBits(bench.open.document.shown(), before));
    }
  }
};

const pbffd::test::Registration<ToolManagerTest> registration;

}  // namespace pbffd::ui

#include "tool_manager_test.moc"
