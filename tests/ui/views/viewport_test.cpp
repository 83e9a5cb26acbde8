#include "tests/support/shapes.h"
#include "tests/support/test_main.h"
#include "tests/ui/views/open_view.h"

#include <QSignalSpy>
#include <QWheelEvent>
#include <QtTest>

#include <cmath>

namespace pbffd::ui {
namespace {

const std::vector<Vec3> cubePoints{{0.5, 0.5, 0.5}, {-0.5, 0.5, 0.5}, {0.5, -0.5, -0.5}, {0, 0, 0}};

Move moveOf(PointId id, const Vec3& by) {
  Move move;
  move.where.points = {id};
  move.by = {by};
  return move;
}

/// A pixel of the picture at a place in logical pixels.
QColor colorAt(const QImage& picture, const QPointF& at, double ratio) {
  return picture.pixelColor((ratio * at).toPoint());
}

}  // namespace

class ViewportTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void meshAndBackgroundAreSeen() {
    test::OpenView open(pbffd::test::sphere(), {});
    QVERIFY(open.isReady());
    const QImage picture = open.frame();
    const double ratio = open.viewport.devicePixelRatioF();
    QCOMPARE(picture.size(), (QSizeF(640, 480) * ratio).toSize());
    const QColor middle = colorAt(picture, {320, 240}, ratio);
    const QColor corner = colorAt(picture, {630, 6}, ratio);
    QVERIFY(middle.lightness() > 90);
    QVERIFY(corner.lightness() < 70);
    QCOMPARE(picture.pixelColor(3, 3).alpha(), 255);
  }

  void movingPointsChangesThePictureWithoutCopies() {
    test::OpenView open(pbffd::test::sphere(), cubePoints);
    const QImage before = open.frame();
    const float* const buffer = open.document.deformation()->positions().data();
    QVERIFY(open.document.preview(moveOf(1, Vec3(0.6, 0.8, 0))));
    const QImage moved = open.frame();
    QVERIFY(test::differingPixels(before, moved) > 1000);
    QCOMPARE(open.document.deformation()->positions().data(), buffer);
    open.document.cancelPreview();
    QCOMPARE(test::differingPixels(before, open.frame()), 0);
  }

  void framingLeavesRoomForWhatLiesOverTheTop() {
    test::OpenView open(pbffd::test::sphere(), {});
    open.viewport.resize(640, 320);
    for (const bool orthographic : {false, true}) {
      open.view.setOrthographic(orthographic);
      for (const int covered : {0, 60}) {
        open.viewport.setCovered(0, covered);
        open.viewport.frameAll();
        double top = open.viewport.height();
        for (Index v = 0; v < open.document.shown().mesh->vertexCount(); ++v) {
          top = std::min(top, open.viewport.projected(open.document.shown().mesh->positions().row(v)).y());
        }
        QVERIFY2(top > covered - 1e-6 && top < covered + 50, QByteArray::number(top).constData());
      }
    }
  }

  void projectedPointsAreFoundAgain() {
    test::OpenView open(pbffd::test::cube(), cubePoints);
    for (PointId id = 1; id <= 4; ++id) {
      const std::vector<PointId> found = open.viewport.pointsAt(open.placeOf(id));
      QVERIFY(std::find(found.begin(), found.end(), id) != found.end());
    }
    QVERIFY(open.viewport.pointsAt({5, 5}).empty());
    QCOMPARE(open.viewport.pointsIn(QRectF(0, 0, 640, 480)).size(), std::size_t(4));
  }

  void pointsAreDrawnWhereTheyArePicked() {
    test::OpenView open(pbffd::test::cube(), {{0, 0.6, 0}});
    const double ratio = open.viewport.devicePixelRatioF();
    const QColor expected = open.theme.color(QStringLiteral("point.interior"));
    const QColor seen = colorAt(open.frame(), open.placeOf(1), ratio);
    QVERIFY2(std::abs(seen.red() - expected.red()) < 20 && std::abs(seen.blue() - expected.blue()) < 20,
             qPrintable(seen.name()));
  }

  void hiddenAndLockedPointsAreNotPicked() {
    test::OpenView open(pbffd::test::cube(), cubePoints);
    open.view.setPointsShown({1}, false);
    Lock lock;
    lock.where.points = {2};
    QVERIFY(open.document.perform(lock));
    QCOMPARE(open.viewport.pointsIn(QRectF(0, 0, 640, 480)), (std::vector<PointId>{3, 4}));
  }

  void surfaceIsHitWhereTheRayMeetsIt() {
    test::OpenView open(pbffd::test::sphere(64, 128), {});
    const auto hit = open.viewport.surfaceAt({320, 240});
    QVERIFY(hit.has_value());
    QVERIFY(std::abs(hit->position.norm() - 1.0) < 2e-3);
    const Vec3 back = open.viewport.projected(hit->position);
    QVERIFY(std::hypot(back.x() - 320, back.y() - 240) < 1e-3);
    QVERIFY(!open.viewport.surfaceAt({5, 5}));
  }

  void farFromTheOriginThePictureIsTheSame() {
    test::OpenView near(pbffd::test::sphere(), {});
    test::OpenView far(pbffd::test::placedAt(pbffd::test::sphere(), 1.0, Vec3(1e6, 2e6, -3e6)), {});
    near.view.setGridShown(false);
    far.view.setGridShown(false);
    QVERIFY(test::differingPixels(near.frame(), far.frame()) < 300);
  }

  void middleDragOrbitsAboutThePointUnderTheCursor() {
    test::OpenView open(pbffd::test::sphere(), {});
    const auto hit = open.viewport.surfaceAt({350, 220});
    QTest::mousePress(open.viewport.surface(), Qt::MiddleButton, {}, {350, 220});
    QTest::mouseMove(open.viewport.surface(), {420, 260});
    QTest::mouseRelease(open.viewport.surface(), Qt::MiddleButton, {}, {420, 260});
    const Vec3 at = open.viewport.projected(hit->position);
    QVERIFY(std::hypot(at.x() - 350, at.y() - 220) < 1e-6);
    QVERIFY(std::abs(open.viewport.camera().yaw - 0.5236) > 0.1);
    QCOMPARE(open.document.history().count(), 0);
  }

  void wheelZoomsToTheCursor() {
    test::OpenView open(pbffd::test::sphere(), {});
    const auto hit = open.viewport.surfaceAt({350, 220});
    const double before = open.viewport.camera().distance;
    QWheelEvent wheel({350, 220}, open.viewport.surface()->mapToGlobal(QPointF(350, 220)), {}, {0, 120}, {}, {},
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(open.viewport.surface(), &wheel);
    QVERIFY(open.viewport.camera().distance < before);
    const Vec3 at = open.viewport.projected(hit->position);
    QVERIFY(std::hypot(at.x() - 350, at.y() - 220) < 1e-6);
  }

  void keysTurnAndFrame() {
    test::OpenView open(pbffd::test::cube(), cubePoints);
    const Camera first = open.viewport.camera();
    QTest::keyClick(open.viewport.surface(), Qt::Key_3, Qt::KeypadModifier);
    QVERIFY((open.viewport.viewDirection() + Vec3::UnitX()).norm() < 1e-12);
    QTest::keyClick(open.viewport.surface(), Qt::Key_7, Qt::AltModifier);
    QVERIFY((open.viewport.viewDirection() + Vec3::UnitY()).norm() < 1e-12);
    QTest::keyClick(open.viewport.surface(), Qt::Key_5, Qt::KeypadModifier);
    QVERIFY(open.view.isOrthographic());
    open.document.selection().replace({1});
    QTest::keyClick(open.viewport.surface(), Qt::Key_F);
    QVERIFY((open.viewport.camera().focus - cubePoints[0]).norm() < 1e-9);
    QTest::keyClick(open.viewport.surface(), Qt::Key_Home);
    QVERIFY((open.viewport.camera().focus - first.focus).norm() < 1e-6);
  }

  void regionsOfTheSelectionAreDrawn() {
    test::OpenView open(pbffd::test::cube(), cubePoints);
    const QImage without = open.frame();
    open.document.selection().replace({1});
    const QImage with = open.frame();
    open.view.setRegions(RegionDisplay::none);
    const QImage none = open.frame();
    QVERIFY(test::differingPixels(without, with) > 2000);
    QVERIFY(test::differingPixels(with, none) > 2000);
  }

  void hierarchyIsDrawnOnDemandAndFollowsADrag() {
    test::OpenView open(pbffd::test::cube(), cubePoints);
    QVERIFY(open.document.perform(SetLevels{3}));
    open.document.selection().setLevel(1);
    const PointId root = open.document.shown().controls.levels[0][0].id;
    open.document.selection().replace({root});
    open.view.setRegions(RegionDisplay::none);
    const QImage without = open.frame();
    open.view.setHierarchy(HierarchyDisplay::selection);
    const QImage with = open.frame();
    QVERIFY(test::differingPixels(without, with) > 100);
    // One point stands for all, so its branches are the whole tree.
    open.view.setHierarchy(HierarchyDisplay::all);
    QCOMPARE(test::differingPixels(with, open.frame()), 0);
    open.view.setMeshShown(false);
    Move move = moveOf(root, Vec3(0.3, 0.2, 0));
    move.where.level = 1;
    const QImage still = open.frame();
    QVERIFY(open.document.preview(move));
    QVERIFY(test::differingPixels(still, open.frame()) > 100);
    open.document.cancelPreview();
    QCOMPARE(test::differingPixels(still, open.frame()), 0);
  }

  void aCoarsePointUnderTheCursorShowsWhatItStandsFor() {
    test::OpenView open(pbffd::test::cube(), cubePoints);
    QVERIFY(open.document.perform(SetLevels{2}));
    open.view.setRegions(RegionDisplay::none);
    open.document.selection().setLevel(1);
    const ControlPoint& coarse = open.document.shown().controls.levels[0][0];
    const Vec3 at = open.viewport.projected(coarse.pose.center);
    // Half way to a point of the finer level, where neither has its glyph.
    const ControlPoint& child = open.document.shown().controls.levels[1][0];
    QVERIFY(coarse.mergedFrom.front() == child.id);
    const Vec3 middle = 0.5 * (at + open.viewport.projected(child.pose.center));
    const double ratio = open.viewport.devicePixelRatioF();
    const QColor before = colorAt(open.frame(), {middle.x(), middle.y()}, ratio);
    open.viewport.setHoveredPoint(coarse.id);
    QVERIFY(colorAt(open.frame(), {middle.x(), middle.y()}, ratio) != before);
    open.viewport.setHoveredPoint(0);
    QCOMPARE(colorAt(open.frame(), {middle.x(), middle.y()}, ratio), before);
  }

  void otherLevelsAreHiddenOrDots() {
    test::OpenView open(pbffd::test::cube(), cubePoints);
    QVERIFY(open.document.perform(SetLevels{2}));
    open.view.setMeshShown(false);
    open.view.setGridShown(false);
    open.document.selection().setLevel(1);
    const QPoint fine = open.placeOf(1);
    const QImage hidden = open.frame();
    open.view.setLevelShown(2, true);
    const QImage dots = open.frame();
    const double ratio = open.viewport.devicePixelRatioF();
    const double seen = test::differingPixels(hidden, dots) / (ratio * ratio);
    QVERIFY2(seen > 20 && seen < 400, QByteArray::number(seen).constData());
    QVERIFY(open.viewport.pointsAt(fine).empty());
    open.document.selection().setLevel(2);
    QCOMPARE(open.viewport.pointsAt(fine), std::vector<PointId>{1});
  }

  void cloudOfPointsIsDrawn() {
    Mesh cloud;
    cloud.positions = pbffd::test::sphere().positions;
    test::OpenView open(cloud, {});
    open.view.setGridShown(false);
    const QImage picture = open.frame();
    open.view.setMeshShown(false);
    QVERIFY(test::differingPixels(picture, open.frame()) > 500);
  }

  void themeChangesLive() {
    test::OpenView open(pbffd::test::cube(), cubePoints);
    const QImage dark = open.frame();
    open.theme.choose(Theme::Choice::light);
    const QImage light = open.frame();
    QVERIFY(light.pixelColor(620, 20).lightness() > dark.pixelColor(620, 20).lightness() + 100);
    open.theme.choose(Theme::Choice::dark);
    QCOMPARE(test::differingPixels(dark, open.frame()), 0);
  }

  void manyChangesMakeOneFrame() {
    test::OpenView open(pbffd::test::cube(), cubePoints);
    QTest::qWait(50);
    QSignalSpy frames(&open.viewport, &Viewport::rendered);
    for (int i = 0; i < 10; ++i) {
      open.viewport.orbitBy(1, 0);
      open.document.selection().replace({1 + i % 4});
    }
    QTest::qWait(100);
    QVERIFY(frames.count() >= 1 && frames.count() <= 2);
  }

  void manyResizesMakeOneFrame() {
    test::OpenView open(pbffd::test::cube(), cubePoints);
    QTest::qWait(50);
    const QImage before = open.frame();
    QSignalSpy frames(&open.viewport, &Viewport::rendered);
    for (int step = 1; step <= 8; ++step) {
      open.viewport.resize(640 - 10 * step, 480 - 10 * step);
    }
    open.viewport.resize(640, 480);
    open.viewport.resize(600, 480);
    QTRY_VERIFY(frames.count() >= 1);
    QTest::qWait(100);
    QVERIFY2(frames.count() <= 2, QByteArray::number(frames.count()).constData());
    const QImage after = open.frame();
    QCOMPARE(after.width(), qRound(600 * open.viewport.devicePixelRatioF()));
    open.viewport.resize(640, 480);
    QCOMPARE(test::differingPixels(before, open.frame(), 0), 0);
  }

  void closingAndReopeningLeavesNothingBehind() {
    for (int i = 0; i < 3; ++i) {
      test::OpenView open(pbffd::test::sphere(), cubePoints);
      QVERIFY(open.isReady());
      open.document.close();
      open.frame();
      QVERIFY(open.viewport.pointsIn(QRectF(0, 0, 640, 480)).empty());
      QVERIFY(!open.viewport.surfaceAt({320, 240}));
    }
  }

  void movingToAnotherWindowKeepsThePicture() {
    test::OpenView open(pbffd::test::sphere(), cubePoints);
    const QImage before = open.frame();
    QWidget other;
    other.resize(640, 480);
    open.viewport.setParent(&other);
    open.viewport.setGeometry(0, 0, 640, 480);
    other.show();
    open.viewport.show();
    QVERIFY(QTest::qWaitForWindowExposed(&other));
    QVERIFY(test::differingPixels(before, open.frame()) < 50);
    open.viewport.setParent(nullptr);
  }

  void nameTagFollowsTheHoveredPoint() {
    test::OpenView open(pbffd::test::cube(), cubePoints);
    Rename rename;
    rename.point = 2;
    rename.name = "Muzzle";
    QVERIFY(open.document.perform(rename));
    open.viewport.setHoveredPoint(2);
    open.frame();
    const auto* const tag = open.viewport.findChild<QWidget*>(QStringLiteral("nameTag"));
    QVERIFY(tag != nullptr && tag->isVisible());
    QCOMPARE(tag->property("text").toString(), QStringLiteral("Muzzle 2, interior"));
    open.viewport.setHoveredPoint(0);
    open.frame();
    QVERIFY(!tag->isVisible());
  }

  void boxesBesideThePointKeepOffWhatLiesOverTheView() {
    test::OpenView open(pbffd::test::cube(), cubePoints);
    open.viewport.setCovered(60, 50);
    const Camera camera = open.viewport.camera();
    const auto* const box = open.viewport.findChild<QWidget*>(QStringLiteral("readOut"));
    QVERIFY(box != nullptr);
    for (const double side : {-1.0, 1.0}) {
      Viewport::ReadOut readOut{QStringLiteral("X +0.350"), QStringLiteral("type a number"), {}, {}};
      readOut.anchor = camera.focus + side * 0.6 * camera.distance * (camera.up() - 2.0 * camera.right());
      open.viewport.setReadOut(readOut);
      QVERIFY(QRect(60, 50, 580, 430).contains(box->geometry()));
    }
  }

  void nameTagGoesWithItsLevel() {
    test::OpenView open(pbffd::test::cube(), cubePoints);
    QVERIFY(open.document.perform(SetLevels{2}));
    open.document.selection().setLevel(2);
    open.viewport.setHoveredPoint(2);
    open.frame();
    const auto* const tag = open.viewport.findChild<QWidget*>(QStringLiteral("nameTag"));
    QVERIFY(tag->isVisible());
    open.document.selection().setLevel(1);
    open.frame();
    QVERIFY(!tag->isVisible());
  }
};

const pbffd::test::Registration<ViewportTest> registration;

}  // namespace pbffd::ui

#include "viewport_test.moc"
