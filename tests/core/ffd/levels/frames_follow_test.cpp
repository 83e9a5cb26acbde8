#include "core/ffd/levels/frames_follow.h"
#include "core/base/parallel.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <QtTest>

#include <numeric>
#include <random>

namespace pbffd {

class FramesFollowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aTurnOfAllIsFoundExactly() {
    const Level level = cloud(60);
    const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
    for (const Mat3& found : rotationsUnder(level, makeMap(turn, Vec3(1, 2, 3)))) {
      // What is added against degenerate neighbourhoods draws it a little towards no turn.
      QVERIFY((found - turn).norm() < 0.02);
      QVERIFY((found.transpose() * found - Mat3::Identity()).norm() < 1e-13);
      QVERIFY(found.determinant() > 0.0);
    }
  }

  void aShiftOfAllTurnsNothing() {
    const Level level = cloud(30);
    const std::vector<Vec3> shifts(30, Vec3(0.1, 0.7, -0.3));
    for (const Mat3& found : followingRotations(level, allOf(level), shifts)) {
      QVERIFY(found == Mat3::Identity());
    }
  }

  void fewerThanThreeMovedNeighboursTurnNothing() {
    const Level level = cloud(30);
    const std::vector<Vec3> shifts{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    for (const Mat3& found : followingRotations(level, {0, 1, 2}, shifts)) {
      QVERIFY(found == Mat3::Identity());
    }
  }

  void onALineTheLeastRotationIsTaken() {
    Level level;
    for (int i = 0; i < 12; ++i) {
      level.append(pointAt(i + 1, Vec3(0.1 * i, 0, 0)));
    }
    const Mat3 turn = Eigen::AngleAxisd(0.4, Vec3::UnitZ()).toRotationMatrix();
    for (const Mat3& found : rotationsUnder(level, makeMap(turn, Vec3::Zero()))) {
      const Eigen::AngleAxisd angle(found);
      // No turn about the line itself: the axis is at right angles to it.
      QVERIFY(std::abs(angle.angle() - 0.4) < 0.02);
      QVERIFY(std::abs(angle.axis().x()) < 1e-9);
    }
  }

  void reflectionsGiveRotations() {
    const Level level = cloud(40);
    for (const Mat3& found : rotationsUnder(level, makeMap(Mat3(Vec3(-1, 1, 1).asDiagonal()), Vec3::Zero()))) {
      QVERIFY(std::abs(found.determinant() - 1.0) < 1e-12);
    }
  }

  void coincidentPointsTurnNothing() {
    Level level;
    for (int i = 0; i < 6; ++i) {
      level.append(pointAt(i + 1, Vec3::Zero()));
    }
    const std::vector<Vec3> shifts{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(),
                                   Vec3::Zero(),  Vec3::Ones(),  Vec3::UnitX()};
    for (const Mat3& found : followingRotations(level, allOf(level), shifts)) {
      QVERIFY(found == Mat3::Identity());
    }
  }

  void resultDoesNotDependOnThreads() {
    const Level level = cloud(2000);
    const Mat3 turn = Eigen::AngleAxisd(0.9, Vec3::UnitY()).toRotationMatrix();
    const auto many = rotationsUnder(level, makeMap(turn, Vec3::Zero()));
    const ThreadLimit one(1);
    QVERIFY(many == rotationsUnder(level, makeMap(turn, Vec3::Zero())));
  }

 private:
  static ControlPoint pointAt(PointId id, const Vec3& center) {
    ControlPoint point;
    point.id = id;
    point.rest.center = center;
    point.pose = point.rest;
    return point;
  }

  static Level cloud(int count) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    Level level;
    for (int i = 0; i < count; ++i) {
      const double x = place(random);
      const double y = place(random);
      level.append(pointAt(i + 1, Vec3(x, y, place(random))));
    }
    return level;
  }

  static std::vector<Index> allOf(const Level& level) {
    std::vector<Index> places(level.size());
    std::iota(places.begin(), places.end(), 0);
    return places;
  }

  static std::vector<Mat3> rotationsUnder(const Level& level, const AffineMap& map) {
    std::vector<Vec3> shifts;
    for (const ControlPoint& point : level) {
      shifts.push_back(applyMap(map, point.pose.center) - point.pose.center);
    }
    return followingRotations(level, allOf(level), shifts);
  }
};

const test::Registration<FramesFollowTest> registration;

}  // namespace pbffd

#include "frames_follow_test.moc"
