#include "core/project/archive.h"
#include "core/project/project_file.h"
#include "core/project/shape.h"
#include "tests/support/test_main.h"
#include "tests/ui/window/open_window.h"
#include "ui/document/hierarchy_links.h"
#include "ui/models/scene_model.h"
#include "ui/window/docks.h"
#include "ui/window/error_bar.h"
#include "ui/window/scene_panel.h"
#include "ui/window/scene_tree.h"

namespace pbffd::test {

using ui::ActionId;

/// Levels in the real window: chosen by keys, edited, added and removed.
class LevelEditingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void cleanup();

  void figuresChooseTheLevelInViewAndTree();
  void aLevelWithoutAKeyTicksNone();
  void theHierarchyIsAKey();
  void pointsOfACoarseLevelAreEditedAndUndone();
  void pointsAreAddedToTheEditLevel();
  void levelsAreAddedAndRemoved();
  void whatIsSetOnOtherLevelsStaysWhenLevelsComeAndGo();
  void whatLevelsDoNotAllowIsSaidAndChangesNothing();
  void projectsWhoseLevelsDoNotFitAreRefused();
  void bindingsThatContradictThePosesAreMendedAndSaid();
  void aWholeLevelTakesTheShapeAlong();
  void aWholeLevelGoesBackToRestWithTheMaster();

 private:
  std::unique_ptr<OpenWindow> open_;
  ui::Document& document() { return open_->window.document(); }
  QWidget& surface() { return *open_->window.viewport().surface(); }
  const std::vector<Level>& levels() { return document().shown().controls.levels; }
  Points positions() {
    EditWorkspace workspace;
    return deformedShape(document().shown(), workspace.weights).positions;
  }
  void trigger(ActionId id) { open_->window.actions()[id]->trigger(); }
  bool isRefused(ActionId id, const QString& reason);
  QString changedProject(const std::string& from, const std::string& to);
};

void LevelEditingTest::init() {
  open_ = std::make_unique<OpenWindow>();
  QVERIFY(open_->isReady);
  QVERIFY(open_->open(writeShape(open_->folder, cylinder())));
  QCOMPARE(levels().size(), std::size_t{3});
}

void LevelEditingTest::cleanup() {
  open_.reset();
}

/// Whether an action does nothing but show an error bar that says why.
bool LevelEditingTest::isRefused(ActionId id, const QString& reason) {
  ui::ErrorBar& bar = open_->window.errorBar();
  bar.hide();
  const ControlSet before = document().shown().controls;
  const int entries = document().history().count();
  trigger(id);
  return finishJobs(document()) && bar.isVisible() && document().shown().controls == before &&
         document().history().count() == entries && bar.severity() == ui::Severity::error &&
         bar.text().contains(reason);
}

void LevelEditingTest::figuresChooseTheLevelInViewAndTree() {
  for (const int level : {1, 2, 3}) {
    QTest::keyClick(&surface(), static_cast<Qt::Key>(Qt::Key_0 + level));
    QCOMPARE(document().selection().level(), level);
  }
  ui::SceneTree& tree = open_->window.docks().scene().tree();
  tree.setFocus();
  for (const int level : {2, 1, 3}) {
    QTest::keyClick(&tree, static_cast<Qt::Key>(Qt::Key_0 + level));
    QCOMPARE(document().selection().level(), level);
  }
  QVERIFY(open_->window.actions()[ActionId::level3]->isChecked());
  QVERIFY(!open_->window.actions()[ActionId::level1]->isChecked());
  // There is no fourth one.
  QTest::keyClick(&surface(), Qt::Key_4);
  QCOMPARE(document().selection().level(), 3);
}

void LevelEditingTest::aLevelWithoutAKeyTicksNone() {
  Place place;
  place.options.points = 600;
  place.options.levels = 10;
  QVERIFY(document().perform(place));
  QCOMPARE(levels().size(), std::size_t{10});
  document().selection().setLevel(10);
  for (int number = 0; number < 9; ++number) {
    const auto id = static_cast<ActionId>(static_cast<int>(ActionId::level1) + number);
    QVERIFY(!open_->window.actions()[id]->isChecked());
  }
  document().selection().setLevel(2);
  QVERIFY(open_->window.actions()[ActionId::level2]->isChecked());
}

void LevelEditingTest::theHierarchyIsAKey() {
  QAction& ofSelection = *open_->window.actions()[ActionId::hierarchySelection];
  QTest::keyClick(&surface(), Qt::Key_T);
  QVERIFY(ofSelection.isChecked());
  QTest::keyClick(&surface(), Qt::Key_T, Qt::ShiftModifier);
  QVERIFY(open_->window.actions()[ActionId::hierarchyAll]->isChecked());
  QTest::keyClick(&surface(), Qt::Key_T, Qt::ShiftModifier);
  QVERIFY(open_->window.actions()[ActionId::hierarchyNone]->isChecked());
}

void LevelEditingTest::pointsOfACoarseLevelAreEditedAndUndone() {
  const ControlSet before = document().shown().controls;
  QTest::keyClick(&surface(), Qt::Key_1);
  const PointId chosen = levels()[0][3].id;
  document().selection().replace({chosen});
  trigger(ActionId::disablePoints);
  QVERIFY(!levels()[0][3].enabled);
  trigger(ActionId::enablePoints);
  QVERIFY(levels()[0][3].enabled);
  trigger(ActionId::removePoints);
  QCOMPARE(levels()[0].size(), before.levels[0].size() - 1);
  QVERIFY(!levels()[0].find(chosen));
  Frame larger = before.levels[0][2].rest;
  larger.axes *= 1.5;
  QVERIFY(document().perform(SetRegion{1, before.levels[0][2].id, larger}));
  for (int step = 0; step < 4; ++step) {
    trigger(ActionId::undo);
  }
  QVERIFY(document().shown().controls == before);
}

void LevelEditingTest::pointsAreAddedToTheEditLevel() {
  const ControlSet before = document().shown().controls;
  surface().setFocus();
  QTest::keyClick(&surface(), Qt::Key_2);
  QTest::keyClick(&surface(), Qt::Key_A);
  QVERIFY(open_->window.actions()[ActionId::toolAdd]->isChecked());
  QTest::mouseClick(&surface(), Qt::LeftButton, {}, surface().rect().center());
  QCOMPARE(levels()[1].size(), before.levels[1].size() + 1);
  QCOMPARE(levels()[2].size(), before.levels[2].size());
  const ControlPoint& added = levels()[1][levels()[1].size() - 1];
  QVERIFY(added.kind == PointKind::manual);
  QCOMPARE(document().selection().points(), std::vector<PointId>{added.id});
  trigger(ActionId::undo);
  QVERIFY(document().shown().controls == before);
}

void LevelEditingTest::levelsAreAddedAndRemoved() {
  const auto points = firstPoints(document(), 3);
  document().selection().replace(points);
  trigger(ActionId::addCoarserLevel);
  QVERIFY(finishJobs(document()));
  QCOMPARE(levels().size(), std::size_t{4});
  QCOMPARE(levels()[0].size(), 25);
  // The finest level is another number now, and still the one that is edited.
  QCOMPARE(document().selection().level(), 4);
  QCOMPARE(document().selection().points(), points);
  QVERIFY(open_->window.actions()[ActionId::level4]->isEnabled());
  trigger(ActionId::removeCoarsestLevel);
  QVERIFY(finishJobs(document()));
  trigger(ActionId::removeCoarsestLevel);
  QVERIFY(finishJobs(document()));
  QCOMPARE(levels().size(), std::size_t{2});
  QCOMPARE(document().selection().points(), points);
  for (int step = 0; step < 3; ++step) {
    trigger(ActionId::undo);
  }
  QCOMPARE(levels().size(), std::size_t{3});
}

void LevelEditingTest::whatIsSetOnOtherLevelsStaysWhenLevelsComeAndGo() {
  ui::SceneTree& tree = open_->window.docks().scene().tree();
  auto& model = *static_cast<ui::SceneModel*>(tree.model());
  const auto eyeOf = [&](int level) {
    return model.levelIndex(level).siblingAtColumn(ui::SceneModel::eyeColumn);
  };
  const PointId named = levels()[1][4].id;
  QVERIFY(document().perform(Rename{2, named, "Shoulder"}));
  QVERIFY(document().perform(Strength{{2, {named}}, 2.0}));
  QVERIFY(model.setData(eyeOf(2), Qt::Checked, Qt::CheckStateRole));
  tree.expand(model.levelIndex(2));
  for (const ActionId id : {ActionId::addCoarserLevel, ActionId::removeCoarsestLevel, ActionId::undo}) {
    trigger(id);
    QVERIFY(finishJobs(document()));
    const int level = static_cast<int>(levels().size()) - 1;
    const ControlPoint& point = levels()[static_cast<std::size_t>(level - 1)][4];
    QCOMPARE(point.id, named);
    QCOMPARE(point.name, std::string("Shoulder"));
    QCOMPARE(point.strength, 2.0);
    for (int other = 1; other <= level; ++other) {
      QCOMPARE(eyeOf(other).data(Qt::CheckStateRole).toInt() == Qt::Checked, other == level);
      QCOMPARE(tree.isExpanded(model.levelIndex(other)), other == level);
    }
  }
}

void LevelEditingTest::whatLevelsDoNotAllowIsSaidAndChangesNothing() {
  QTest::keyClick(&surface(), Qt::Key_1);
  trigger(ActionId::selectAll);
  QVERIFY(isRefused(ActionId::removePoints, "without a point"));
  QVERIFY(document().perform(SetLevels{1}));
  QVERIFY(isRefused(ActionId::removeCoarsestLevel, "at least one"));
  QVERIFY(document().perform(SetLevels{8}));
  QVERIFY(isRefused(ActionId::addCoarserLevel, "allow at most 8 levels"));
}

/// Saves the project with the first of these texts in its document replaced; returns the path.
QString LevelEditingTest::changedProject(const std::string& from, const std::string& to) {
  const QString path = open_->folder.filePath("changed.pbffd");
  saveProject(path.toStdString(), document().committed());
  Archive archive = readArchive(path.toStdString());
  std::string& text = archive.members[0].bytes;
  text.replace(text.find(from), from.size(), to);
  writeArchive(path.toStdString(), archive);
  return path;
}

void LevelEditingTest::projectsWhoseLevelsDoNotFitAreRefused() {
  const ControlSet before = document().shown().controls;
  const int entries = document().history().count();
  ui::ErrorBar& bar = open_->window.errorBar();
  bar.hide();
  QVERIFY(open_->open(changedProject("\"binding\"", "\"bending\"")));
  QVERIFY(bar.isVisible());
  QCOMPARE(bar.severity(), ui::Severity::error);
  QVERIFY2(bar.text().contains("the levels do not fit together"), qPrintable(bar.text()));
  QVERIFY2(bar.text().contains("changed.pbffd"), qPrintable(bar.text()));
  QVERIFY(document().shown().controls == before);
  QCOMPARE(document().history().count(), entries);
}

void LevelEditingTest::bindingsThatContradictThePosesAreMendedAndSaid() {
  const ControlSet before = document().shown().controls;
  ui::ErrorBar& bar = open_->window.errorBar();
  bar.hide();
  QVERIFY(open_->open(changedProject("\"local\":[[1.0,0.0,0.0,0.0]", "\"local\":[[1.0,0.0,0.0,5.0]")));
  QVERIFY(bar.isVisible());
  QVERIFY2(bar.text().contains("The levels did not fit together: 1 point"), qPrintable(bar.text()));
  QVERIFY(document().shown().controls == before);
}

void LevelEditingTest::aWholeLevelTakesTheShapeAlong() {
  const Points before = positions();
  for (const Qt::Key level : {Qt::Key_1, Qt::Key_2, Qt::Key_3}) {
    surface().setFocus();
    QTest::keyClick(&surface(), level);
    trigger(ActionId::selectAll);
    QTest::keyClicks(&surface(), "gx0.5");
    QTest::keyClick(&surface(), Qt::Key_Return);
    const Points moved = positions();
    QVERIFY((moved.rowwise() - Eigen::RowVector3d(0.5, 0, 0) - before).cwiseAbs().maxCoeff() < 1e-12);
    trigger(ActionId::undo);
  }
}

void LevelEditingTest::aWholeLevelGoesBackToRestWithTheMaster() {
  const Points rest = positions();
  for (const Qt::Key level : {Qt::Key_1, Qt::Key_2, Qt::Key_3}) {
    surface().setFocus();
    QTest::keyClick(&surface(), level);
    trigger(ActionId::selectAll);
    QTest::keyClicks(&surface(), "gx0.5");
    QTest::keyClick(&surface(), Qt::Key_Return);
    QVERIFY((positions() - rest).cwiseAbs().maxCoeff() > 0.4);
    const int entries = document().history().count();
    QTest::keyClick(&surface(), Qt::Key_G, Qt::AltModifier);
    QCOMPARE(document().history().count(), entries + 1);
    QVERIFY((positions() - rest).cwiseAbs().maxCoeff() < 1e-12);
    const Master& master = document().shown().controls.master;
    QVERIFY(master.pose == master.rest);
    // Nothing is left to do.
    QTest::keyClick(&surface(), Qt::Key_G, Qt::AltModifier);
    QCOMPARE(document().history().count(), entries + 1);
  }
}

const Registration<LevelEditingTest> registration;

}  // namespace pbffd::test

#include "level_editing_test.moc"
