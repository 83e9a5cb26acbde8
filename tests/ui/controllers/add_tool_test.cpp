#include "ui/controllers/add_tool.h"

#include "tests/support/shapes.h"
#include "tests/support/test_main.h"
#include "tests/ui/views/open_view.h"
#include "ui/controllers/tool_manager.h"

#include <QtTest>

#include <cmath>

namespace pbffd::ui {

class AddToolTest : public QObject {
  Q_OBJECT

  test::OpenView open_{pbffd::test::sphere(), {{0.5, 0.5, 0}, {-0.5, -0.5, 0}}};
  ToolManager tools_{open_.document, open_.viewport, open_.theme};

  QWidget* surface() { return open_.viewport.surface(); }
  const Level& level() { return open_.document.shown().controls.finest(); }
  static QPoint middle() { return {320, 240}; }

 private Q_SLOTS:
  void init() {
    open_.document.goTo(0);
    tools_.setActive(ToolId::add);
  }

  void clickAddsAPointOnTheSurface() {
    const Vec3 place = open_.viewport.surfaceAt(middle()).value().position;
    QTest::mouseClick(surface(), Qt::LeftButton, {}, middle());
    QCOMPARE(level().size(), 3);
    const ControlPoint& added = level()[2];
    QVERIFY((added.pose.center - place).norm() < 1e-6);
    QVERIFY(added.kind == PointKind::manual);
    QCOMPARE(open_.document.selection().points(), std::vector<PointId>{added.id});
    QCOMPARE(open_.document.history().count(), 1);
  }

  void dragSetsTheRadius() {
    const Vec3 place = open_.viewport.surfaceAt(middle()).value().position;
    QTest::mousePress(surface(), Qt::LeftButton, {}, middle());
    QVERIFY(tools_.isBusy());
    QTest::mouseMove(surface(), middle() + QPoint(30, 40));
    QTest::mouseRelease(surface(), Qt::LeftButton, {}, middle() + QPoint(30, 40));
    QCOMPARE(level().size(), 3);
    const double expected = 50.0 * open_.viewport.pixelSizeAt(place);
    QVERIFY(std::abs(level()[2].rest.axes(0, 0) / expected - 1.0) < 1e-9);
  }

  void escapeCancelsADrag() {
    QTest::mousePress(surface(), Qt::LeftButton, {}, middle());
    QTest::mouseMove(surface(), middle() + QPoint(30, 40));
    QTest::keyClick(surface(), Qt::Key_Escape);
    QVERIFY(!tools_.isBusy());
    QTest::mouseRelease(surface(), Qt::LeftButton, {}, middle() + QPoint(30, 40));
    QCOMPARE(level().size(), 2);
    QCOMPARE(tools_.active().id(), ToolId::add);
    QTest::keyClick(surface(), Qt::Key_Escape);
    QCOMPARE(tools_.active().id(), ToolId::select);
  }

  void besideTheSurfaceNothingIsAdded() {
    QTest::mouseClick(surface(), Qt::LeftButton, {}, {5, 5});
    QCOMPARE(level().size(), 2);
    QVERIFY(!tools_.isBusy());
  }
};

const pbffd::test::Registration<AddToolTest> registration;

}  // namespace pbffd::ui

#include "add_tool_test.moc"
