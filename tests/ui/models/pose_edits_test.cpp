#include "ui/models/pose_edits.h"

#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd::test {

using namespace ui;
using Kind = NumberInput::Kind;

class PoseEditsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();

  void theMedianMovesToWhatWasTyped();
  void factorsActOnEachPoint();
  void offsetsCountFromRest();
  void anglesComeBack();
  void theTypedAngleIsReached();
  void regionsScaleAlongOneAxisOrAll();
  void differentValuesAreMixed();
  void theMasterGoesAlongWithAWholeLevel();

 private:
  const Level& level(const Project& project) const { return project.controls.finest(); }
  PointsOfLevel all(const Project& project) const;
  Project after(const std::optional<Edit>& edit) const;

  Project project_;
};

void PoseEditsTest::initTestCase() {
  project_ = projectOf(std::make_shared<const RestMesh>(cylinder()));
  for (int i = 0; i < 3; ++i) {
    ControlPoint point;
    point.id = i + 1;
    point.rest.center = Vec3(1.0 + i, 0.5, 0);
    point.rest.axes *= 1.0 + 0.5 * i;
    point.pose = point.rest;
    project_.controls.levels[0].append(point);
  }
  project_.nextId = 4;
}

PointsOfLevel PoseEditsTest::all(const Project& project) const {
  PointsOfLevel selection;
  for (const ControlPoint& point : level(project)) {
    selection.points.push_back(&point);
  }
  return selection;
}

Project PoseEditsTest::after(const std::optional<Edit>& edit) const {
  EditWorkspace workspace;
  return apply(project_, *edit, workspace).project;
}

void PoseEditsTest::theMedianMovesToWhatWasTyped() {
  const Project moved = after(positionEdit(all(project_), 0, {Kind::set, 5.0}));
  QCOMPARE(level(moved)[0].pose.center.x(), 4.0);
  QCOMPARE(level(moved)[1].pose.center.x(), 5.0);
  QCOMPARE(level(moved)[2].pose.center.x(), 6.0);
  QCOMPARE(level(moved)[1].pose.center.y(), 0.5);
}

void PoseEditsTest::factorsActOnEachPoint() {
  const Project moved = after(positionEdit(all(project_), 0, {Kind::multiply, 2.0}));
  QCOMPARE(level(moved)[0].pose.center.x(), 2.0);
  QCOMPARE(level(moved)[2].pose.center.x(), 6.0);
}

void PoseEditsTest::offsetsCountFromRest() {
  const Project moved = after(offsetEdit(all(project_), 1, {Kind::set, 0.25}));
  for (const ControlPoint& point : level(moved)) {
    QCOMPARE(point.pose.center.y(), 0.75);
  }
}

void PoseEditsTest::anglesComeBack() {
  ControlPoint point = level(project_)[0];
  const Vec3 angles(20, -35, 110);
  point.pose.axes = 1.7 * rotationFromAngles(angles) * point.rest.axes;
  QVERIFY((rotationAngles(point) - angles).norm() < 1e-9);
  point.pose.axes = rotationFromAngles(Vec3(0, 90, 30)) * point.rest.axes;
  const Mat3 again = rotationFromAngles(rotationAngles(point));
  QVERIFY((again - rotationFromAngles(Vec3(0, 90, 30))).norm() < 1e-6);
}

void PoseEditsTest::theTypedAngleIsReached() {
  const auto edit = rotationEdit(all(project_), 2, {Kind::set, 30.0});
  QVERIFY(std::holds_alternative<Group>(*edit));
  const Project turned = after(edit);
  for (const ControlPoint& point : level(turned)) {
    QVERIFY((rotationAngles(point) - Vec3(0, 0, 30)).norm() < 1e-9);
    QVERIFY((point.pose.center - point.rest.center).norm() < 1e-12);
  }
}

void PoseEditsTest::regionsScaleAlongOneAxisOrAll() {
  const Project one = after(regionEdit(all(project_), 1, {Kind::set, 0.75}, false));
  const Project three = after(regionEdit(all(project_), 1, {Kind::set, 0.75}, true));
  for (Index i = 0; i < 3; ++i) {
    QVERIFY(std::abs(level(one)[i].rest.axes.col(1).norm() - 0.75) < 1e-12);
    QCOMPARE(level(one)[i].rest.axes.col(0).norm(), 1.0 + 0.5 * i);
    QVERIFY(std::abs(level(three)[i].rest.axes.col(2).norm() - 0.75) < 1e-12);
  }
}

void PoseEditsTest::differentValuesAreMixed() {
  QVERIFY(!shared({1.0, 1.0, 1.0}).isMixed);
  QVERIFY(shared({1.0, 1.1}).isMixed);
  QCOMPARE(shared({3.0, 1.0, 2.0}).middle, 2.0);
  QCOMPARE(shared({1.0, 2.0}).middle, 1.5);
}

void PoseEditsTest::theMasterGoesAlongWithAWholeLevel() {
  PointsOfLevel selection = all(project_);
  const auto movesMaster = [&](const NumberInput& input) {
    return std::get<Move>(positionEdit(selection, 0, input)->value()).spread.master;
  };
  QVERIFY(!movesMaster({Kind::set, 5.0}));
  selection.isWhole = true;
  QVERIFY(movesMaster({Kind::set, 5.0}));
  QVERIFY(movesMaster({Kind::add, 1.0}));
  // Points that are multiplied one by one are not moved alike.
  QVERIFY(!movesMaster({Kind::multiply, 2.0}));
}

const Registration<PoseEditsTest> registration;

}  // namespace pbffd::test

#include "pose_edits_test.moc"
