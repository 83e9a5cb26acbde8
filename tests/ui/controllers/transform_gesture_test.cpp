#include "tests/support/test_main.h"
#include "ui/controllers/gesture_subject.h"
#include "ui/controllers/move_gesture.h"
#include "ui/controllers/rotate_gesture.h"
#include "ui/controllers/scale_gesture.h"

#include <QtTest>

#include <Eigen/Geometry>
#include <cmath>
#include <variant>

namespace pbffd::ui {

class TransformGestureTest : public QObject {
  Q_OBJECT

  /// Looks along -z at the origin; at its depth a unit is `unit()` pixels.
  static Projection front() {
    Camera camera;
    camera.distance = 10.0;
    return camera.projection(800, 600, {Vec3::Zero(), 2.0, 6.0});
  }
  static double unit() { return 1.0 / front().pixelSizeAt(Vec3::Zero()); }
  static QPointF at(double x, double y) { return {400 + unit() * x, 300 - unit() * y}; }
  static GestureSubject subject() {
    GestureSubject subject;
    subject.points = {3, 8};
    subject.size = 10.0;
    subject.localAxes = Eigen::AngleAxisd(M_PI / 2, Vec3::UnitZ()).toRotationMatrix();
    return subject;
  }
  static void typeText(TransformGesture& gesture, const QString& text) {
    for (const QChar character : text) {
      gesture.type(front(), character);
    }
  }

  /// Whether the master goes along with an edit.
  static bool movesMaster(const Edit& edit) {
    if (const auto* move = std::get_if<Move>(&edit.value())) {
      return move->spread.master;
    }
    return std::get<Transform>(edit.value()).spread.master;
  }

 private Q_SLOTS:
  void theMasterGoesAlongWithAWholeLevel() {
    for (const bool isWhole : {false, true}) {
      GestureSubject whole = subject();
      whole.isWholeLevel = isWhole;
      QCOMPARE(movesMaster(MoveGesture(whole, {}, at(0, 0)).edit()), isWhole);
      QCOMPARE(movesMaster(RotateGesture(whole, {}, at(0, 0), RotateGesture::Manner::ring).edit()), isWhole);
      QCOMPARE(movesMaster(ScaleGesture(whole, {}, at(0, 0)).edit()), isWhole);
      // Turned each about its own centre, the points are under no one map.
      whole.eachItsOwn = true;
      QVERIFY(!movesMaster(RotateGesture(whole, {}, at(0, 0), RotateGesture::Manner::ring).edit()));
      QVERIFY(!movesMaster(ScaleGesture(whole, {}, at(0, 0)).edit()));
    }
  }

  void freeMoveStaysInTheViewPlane() {
    MoveGesture move(subject(), {}, at(0.2, 0.1));
    move.moveTo(front(), {at(1.2, -0.4)});
    QVERIFY((move.shift() - Vec3(1, -0.5, 0)).norm() < 1e-9);
    const Edit edit = move.edit();
    const auto& asMove = std::get<Move>(edit.value());
    QCOMPARE(asMove.where.points, (std::vector<PointId>{3, 8}));
    QCOMPARE(asMove.by.size(), std::size_t(1));
  }

  void axisMoveStaysOnTheAxis() {
    MoveGesture move(subject(), lockOf(GizmoPart::axisY), at(0, 0.3));
    move.moveTo(front(), {at(2.0, 1.0)});
    QVERIFY((move.shift() - Vec3(0, 0.7, 0)).norm() < 1e-9);
    QCOMPARE(move.readOut(), QStringLiteral("Y +0.700"));
    QCOMPARE(move.title(), QStringLiteral("Moving along Y"));
  }

  void axisKeysChangeTheAxisOfTheSameDrag() {
    MoveGesture move(subject(), {}, at(0, 0));
    move.moveTo(front(), {at(1, 0.5)});
    move.pressAxis(front(), 0, false);
    QVERIFY((move.shift() - Vec3(1, 0, 0)).norm() < 1e-9);
    // The local x axis is the world's y axis.
    move.pressAxis(front(), 0, false);
    QVERIFY((move.shift() - Vec3(0, 0.5, 0)).norm() < 1e-9);
    move.pressAxis(front(), 0, false);
    QVERIFY((move.shift() - Vec3(1, 0.5, 0)).norm() < 1e-9);
    move.pressAxis(front(), 2, true);
    QVERIFY((move.shift() - Vec3(1, 0.5, 0)).norm() < 1e-9);
  }

  void typedNumbersAreExact() {
    MoveGesture move(subject(), {}, at(0, 0));
    move.moveTo(front(), {at(1, 0.5)});
    move.pressAxis(front(), 0, false);
    typeText(move, "1.2*3");
    QCOMPARE(move.shift(), Vec3(1.2 * 3, 0, 0));
    QCOMPARE(move.readOut(), QStringLiteral("X 1.2*3|"));
    QCOMPARE(move.readOutHint(), QStringLiteral("= 3.6"));
    // The mouse no longer counts, until all is erased.
    move.moveTo(front(), {at(2, 2)});
    QCOMPARE(move.shift(), Vec3(1.2 * 3, 0, 0));
    for (int i = 0; i < 5; ++i) {
      move.erase(front());
    }
    QVERIFY((move.shift() - Vec3(2, 0, 0)).norm() < 1e-9);
  }

  void tabTypesTheNextNumber() {
    MoveGesture move(subject(), {}, at(0, 0));
    typeText(move, "1");
    move.nextNumber();
    typeText(move, "-2");
    move.nextNumber();
    typeText(move, ".5");
    QCOMPARE(move.shift(), Vec3(1, -2, 0.5));
  }

  void planeTakesTwoNumbers() {
    MoveGesture move(subject(), {}, at(0, 0));
    move.pressAxis(front(), 1, true);
    typeText(move, "3");
    move.nextNumber();
    typeText(move, "4");
    QCOMPARE(move.shift(), Vec3(3, 0, 4));
  }

  void shiftIsOneTenthFromWhereItIsPressed() {
    MoveGesture move(subject(), lockOf(GizmoPart::axisX), at(0, 0));
    move.moveTo(front(), {at(1, 0)});
    move.moveTo(front(), {at(2, 0), true});
    QVERIFY((move.shift() - Vec3(1.1, 0, 0)).norm() < 1e-9);
  }

  void snappedMovesAreWholeSteps() {
    MoveGesture move(subject(), lockOf(GizmoPart::axisX), at(0, 0));
    move.moveTo(front(), {at(0.338, 0), false, true});
    QVERIFY((move.shift() - Vec3(0.3, 0, 0)).norm() < 1e-12);
  }

  void axisTowardsTheEyeDoesNotMove() {
    MoveGesture move(subject(), lockOf(GizmoPart::axisZ), at(0, 0));
    move.moveTo(front(), {at(3, 3)});
    QVERIFY(move.isIdentity());
  }

  void ringIsFollowedRoundAndRound() {
    RotateGesture rotate(subject(), lockOf(GizmoPart::axisZ), at(1, 0));
    for (int step = 1; step <= 40; ++step) {
      const double angle = step * M_PI / 16;
      rotate.moveTo(front(), {at(std::cos(angle), std::sin(angle))});
    }
    QVERIFY(std::abs(rotate.degrees() - 450.0) < 1e-6);
    QCOMPARE(rotate.title(), QStringLiteral("Rotating about Z"));
    const Edit edit = rotate.edit();
    const auto& transform = std::get<Transform>(edit.value());
    QCOMPARE(transform.rotationAxis, Vec3(Vec3::UnitZ()));
    QCOMPARE(transform.pivot.value(), Vec3(Vec3::Zero()));
  }

  void rotationSnapsToFiveDegreesOrOne() {
    RotateGesture rotate(subject(), {}, at(1, 0));
    const double angle = 12.7 * M_PI / 180;
    rotate.moveTo(front(), {at(std::cos(angle), std::sin(angle)), false, true});
    QCOMPARE(rotate.degrees(), 15.0);
    typeText(rotate, "-30");
    QCOMPARE(rotate.degrees(), -30.0);
  }

  void ringSeenFromItsEdgeIsDraggedAlong() {
    RotateGesture rotate(subject(), lockOf(GizmoPart::axisY), at(0, 0));
    rotate.moveTo(front(), {at(0, 0) + QPointF(GizmoSizes::ring, 0)});
    QVERIFY(std::abs(rotate.degrees() - 180.0 / M_PI) < 1e-6);
  }

  void ballTurnsTowardsTheCursor() {
    RotateGesture rotate(subject(), {}, at(0, 0), RotateGesture::Manner::ball);
    rotate.moveTo(front(), {at(0, 0) + QPointF(30, 0)});
    // What faces the eye moves to the right.
    const Vec3 turned = Eigen::AngleAxisd(rotate.degrees() * M_PI / 180, rotate.axis()) * Vec3(Vec3::UnitZ());
    QVERIFY(turned.x() > 0.1 && std::abs(turned.y()) < 1e-12);
  }

  void scaleFollowsTheDistanceFromThePivot() {
    ScaleGesture scale(subject(), {}, at(1, 0));
    scale.moveTo(front(), {at(1.5, 0)});
    QVERIFY(std::abs(scale.factor() - 1.5) < 1e-9);
    QCOMPARE(scale.readOut(), QStringLiteral("150 %"));
    scale.moveTo(front(), {at(-3, 0)});
    QCOMPARE(scale.factor(), 0.01);
    typeText(scale, "0");
    QCOMPARE(scale.factor(), 0.01);
  }

  void scaleActsAlongTheLockedAxes() {
    ScaleGesture scale(subject(), lockOf(GizmoPart::axisY), at(0, 1));
    typeText(scale, "2");
    Edit edit = scale.edit();
    QCOMPARE(std::get<Transform>(edit.value()).scale, Vec3(1, 2, 1));
    scale.pressAxis(front(), 1, true);
    edit = scale.edit();
    QCOMPARE(std::get<Transform>(edit.value()).scale, Vec3(2, 1, 2));
  }

  void untouchedGesturesChangeNothing() {
    QVERIFY(MoveGesture(subject(), {}, at(0, 0)).isIdentity());
    QVERIFY(RotateGesture(subject(), {}, at(1, 0)).isIdentity());
    QVERIFY(ScaleGesture(subject(), {}, at(1, 0)).isIdentity());
  }

  void medianIsTakenOfEachCoordinate() {
    QCOMPARE(medianOf({Vec3(0, 5, 1), Vec3(10, 1, 2), Vec3(1, 3, 9)}), Vec3(1, 3, 2));
    QCOMPARE(medianOf({Vec3(0, 5, 1), Vec3(10, 1, 2)}), Vec3(5, 3, 1.5));
  }

  void directionsLeaveStretchAside() {
    const Mat3 turn = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    const Mat3 stretched = turn * Vec3(2, 0.5, 7).asDiagonal();
    QVERIFY((directionsOf(stretched) - turn).norm() < 1e-12);
    QVERIFY(std::abs(directionsOf(-stretched).determinant() - 1.0) < 1e-12);
  }

  void lengthsHaveSensibleDecimals() {
    QCOMPARE(lengthText(0.35, 10.4), QStringLiteral("+0.350"));
    QCOMPARE(lengthText(-12.34, 900.0), QStringLiteral("\u221212.34"));
    QCOMPARE(lengthText(0.00012, 0.01), QStringLiteral("+0.00012"));
    QCOMPARE(lengthText(-1e-9, 10.4), QStringLiteral("+0.000"));
  }
};

const pbffd::test::Registration<TransformGestureTest> registration;

}  // namespace pbffd::ui

#include "transform_gesture_test.moc"
