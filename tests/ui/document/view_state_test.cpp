#include "ui/document/view_state.h"

#include "tests/support/test_main.h"

#include <QSignalSpy>
#include <QtTest>

namespace pbffd::test {

using namespace ui;

class ViewStateTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void comesBackFromJson();
  void brokenJsonIsIgnored();
  void hiddenPointsAreNotShown();
  void theSetsEyeHidesEveryPoint();
  void theEyesOfLevelsGoWithTheirNumbers();
};

void ViewStateTest::comesBackFromJson() {
  ViewState state;
  state.setDisplayMode(DisplayMode::seeThrough);
  state.setRegions(RegionDisplay::level);
  state.setHierarchy(HierarchyDisplay::all);
  state.setGridShown(false);
  state.setOrthographic(true);
  state.setMeshShown(false);
  state.setLevelShown(2, true);
  state.setPointsShown({17, PointId{1} << 40}, false);
  ViewState other;
  other.restore(state.toJson());
  QCOMPARE(other.toJson(), state.toJson());
  QVERIFY(other.displayMode() == DisplayMode::seeThrough);
  QVERIFY(other.hierarchy() == HierarchyDisplay::all);
  QVERIFY(other.isLevelShown(2) && !other.isLevelShown(1));
  QVERIFY(!other.isPointShown(PointId{1} << 40));
}

void ViewStateTest::brokenJsonIsIgnored() {
  ViewState state;
  const QByteArray before = state.toJson();
  for (const char* json :
       {"", "[", "[1,2]", R"({"mode":77,"grid":"yes","levels":5,"hierarchy":-3,"unknown":1})"}) {
    state.restore(json);
    QVERIFY(static_cast<int>(state.displayMode()) <= 2);
    QVERIFY(state.hierarchy() == HierarchyDisplay::none);
    QVERIFY(state.isGridShown());
  }
  state.restore("{}");
  QCOMPARE(state.regions(), RegionDisplay::selection);
}

void ViewStateTest::theEyesOfLevelsGoWithTheirNumbers() {
  ViewState state;
  state.setLevelShown(1, true);
  state.setLevelShown(2, true);
  QSignalSpy changed(&state, &ViewState::changed);
  state.renumberLevels(1);
  QVERIFY(!state.isLevelShown(1) && state.isLevelShown(2) && state.isLevelShown(3));
  QCOMPARE(changed.count(), 1);
  // The coarsest is gone, and its eye with it.
  state.renumberLevels(-2);
  QVERIFY(state.isLevelShown(1) && !state.isLevelShown(2));
  state.renumberLevels(1);
  QVERIFY(!state.isLevelShown(1) && state.isLevelShown(2));
  state.renumberLevels(0);
  QCOMPARE(changed.count(), 3);
}

void ViewStateTest::hiddenPointsAreNotShown() {
  ViewState state;
  QSignalSpy changed(&state, &ViewState::changed);
  state.setPointsShown({1, 2}, false);
  QVERIFY(!state.isPointShown(1) && state.isPointShown(3));
  state.setPointsShown({1, 2}, false);
  QCOMPARE(changed.count(), 1);
  state.showAllPoints();
  QVERIFY(state.isPointShown(1));
}

void ViewStateTest::theSetsEyeHidesEveryPoint() {
  ViewState state;
  state.setControlsShown(false);
  QVERIFY(!state.isPointShown(1));
  QVERIFY(state.isPointEyeOpen(1));
}

const Registration<ViewStateTest> registration;

}  // namespace pbffd::test

#include "view_state_test.moc"
