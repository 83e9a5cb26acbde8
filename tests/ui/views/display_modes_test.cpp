#include "tests/support/shapes.h"
#include "tests/support/test_main.h"
#include "tests/ui/views/open_view.h"

#include <QtTest>

namespace pbffd::ui {
namespace {

const std::vector<Vec3> cubePoints{{0.5, 0.5, 0.5}, {-0.5, 0.5, 0.5}, {0.5, -0.5, -0.5}, {0, 0, 0}};

}  // namespace

/// How the surface is drawn: shaded, with edges, see-through, beside its rest shape.
class DisplayModesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyDisplayModeDrawsSomethingElse() {
    test::OpenView open(pbffd::test::sphere(6, 8), cubePoints);
    open.view.setDisplayMode(DisplayMode::wire);
    const QImage wire = open.frame();
    open.view.setDisplayMode(DisplayMode::shaded);
    const QImage shaded = open.frame();
    open.view.setDisplayMode(DisplayMode::seeThrough);
    const QImage seeThrough = open.frame();
    open.view.setMeshShown(false);
    const QImage hidden = open.frame();
    QVERIFY(test::differingPixels(wire, shaded, 2) > 100);
    QVERIFY(test::differingPixels(shaded, seeThrough) > 5000);
    QVERIFY(test::differingPixels(seeThrough, hidden) > 5000);
  }

  void edgesFadeWhereTheyLieCloseTogether() {
    const auto strength = [](int squares, bool isTilted) {
      test::OpenView open(pbffd::test::sheet(squares), {});
      open.view.setGridShown(false);
      open.viewport.lookFrom(Viewport::Side::front);
      open.viewport.orbitBy(isTilted ? 75 : 0, 0);
      const QImage wire = open.frame();
      open.view.setDisplayMode(DisplayMode::shaded);
      const QImage shaded = open.frame();
      int tolerance = 0;
      while (test::differingPixels(wire, shaded, tolerance) > 0) {
        ++tolerance;
      }
      return tolerance;
    };
    // Squares of 38, 8 and 3 pixels; those of 8 tilted so that they are 2 wide.
    const int wide = strength(10, false);
    const int close = strength(48, false);
    QVERIFY2(wide > 10, QByteArray::number(wide).constData());
    QVERIFY2(close > 1 && close < wide - 3, QByteArray::number(close).constData());
    QCOMPARE(strength(48, true), 0);
    QCOMPARE(strength(128, false), 0);
  }

  void ghostIsSeenBesideTheMovedShapeOnly() {
    test::OpenView open(pbffd::test::sphere(), cubePoints);
    QVERIFY(open.document.perform(Move{{std::nullopt, {1}}, {Vec3(-0.4, -0.5, 0)}, Follow::none, {}}));
    const QImage without = open.frame();
    open.view.setGhostShown(true);
    const QImage with = open.frame();
    const int seen = test::differingPixels(without, with, 2);
    QVERIFY(seen > 50);
    QVERIFY(seen < with.width() * with.height() / 4);
  }
};

const pbffd::test::Registration<DisplayModesTest> registration;

}  // namespace pbffd::ui

#include "display_modes_test.moc"
