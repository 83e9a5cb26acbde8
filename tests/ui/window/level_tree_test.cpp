#include "tests/support/test_main.h"
#include "tests/ui/window/open_window.h"
#include "ui/document/hierarchy_links.h"
#include "ui/models/scene_model.h"
#include "ui/window/docks.h"
#include "ui/window/scene_panel.h"
#include "ui/window/scene_tree.h"

namespace pbffd::test {

using ui::ActionId;

/// Levels in the scene tree of the real window.
class LevelTreeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void cleanup();

  void aDoubleClickInTheTreeChoosesTheLevel();
  void rowsOfOneLevelAreSelectedAtATime();
  void parentsAndChildrenAreSelected();
  void relativesThatAreLockedOrHiddenAreNotSelected();
  void theTreeFollowsTheEditLevel();

 private:
  std::unique_ptr<OpenWindow> open_;
  ui::Document& document() { return open_->window.document(); }
  QWidget& surface() { return *open_->window.viewport().surface(); }
  const std::vector<Level>& levels() { return document().shown().controls.levels; }
  void trigger(ActionId id) { open_->window.actions()[id]->trigger(); }
};

void LevelTreeTest::init() {
  open_ = std::make_unique<OpenWindow>();
  QVERIFY(open_->isReady);
  QVERIFY(open_->open(writeShape(open_->folder, cylinder())));
  QCOMPARE(levels().size(), std::size_t{3});
}

void LevelTreeTest::cleanup() {
  open_.reset();
}

void LevelTreeTest::aDoubleClickInTheTreeChoosesTheLevel() {
  ui::SceneTree& tree = open_->window.docks().scene().tree();
  const auto& model = *static_cast<ui::SceneModel*>(tree.model());
  const QPoint at = tree.visualRect(model.levelIndex(1)).center();
  QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, at);
  QTest::mouseDClick(tree.viewport(), Qt::LeftButton, {}, at);
  QCOMPARE(document().selection().level(), 1);
  QVERIFY(model.levelIndex(1).data(ui::SceneModel::isEditLevelRole).toBool());
}

void LevelTreeTest::rowsOfOneLevelAreSelectedAtATime() {
  ui::SceneTree& tree = open_->window.docks().scene().tree();
  const auto& model = *static_cast<ui::SceneModel*>(tree.model());
  const auto row = [&](int level, int at) {
    return model.index(at, 0, model.index(0, 0, model.levelIndex(level)));
  };
  const auto id = [&](int level, int at) {
    return row(level, at).data(ui::SceneModel::pointRole).toLongLong();
  };
  const auto click = [&](const QModelIndex& index, Qt::KeyboardModifiers modifiers) {
    tree.scrollTo(index);
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, modifiers, tree.visualRect(index).center());
  };
  tree.expandAll();
  click(row(1, 2), {});
  click(row(1, 4), Qt::ControlModifier);
  click(row(2, 3), Qt::ControlModifier);
  QCOMPARE(document().selection().level(), 2);
  QCOMPARE(document().selection().points(), std::vector<PointId>{id(2, 3)});
  QCOMPARE(tree.selectionModel()->selectedRows(), QModelIndexList{row(2, 3)});
  // A range comes in the order of its rows, and the row that was clicked is the active point.
  click(row(2, 9), Qt::ShiftModifier);
  std::vector<PointId> range;
  for (int at = 3; at <= 9; ++at) {
    range.push_back(id(2, at));
  }
  QCOMPARE(document().selection().points(), range);
  // A range from another level takes what it holds of the level clicked.
  click(row(1, 1), Qt::ShiftModifier);
  QCOMPARE(document().selection().level(), 1);
  const auto selected = tree.selectionModel()->selectedRows();
  QCOMPARE(static_cast<std::size_t>(selected.size()), document().selection().points().size());
  for (const QModelIndex& one : selected) {
    QCOMPARE(one.data(ui::SceneModel::levelRole).toInt(), 1);
  }
}

void LevelTreeTest::parentsAndChildrenAreSelected() {
  document().selection().setLevel(2);
  const PointId chosen = levels()[1][7].id;
  document().selection().replace({chosen});
  trigger(ActionId::selectChildren);
  QCOMPARE(document().selection().level(), 3);
  QCOMPARE(document().selection().points(), levels()[1][7].mergedFrom);
  trigger(ActionId::selectParents);
  QCOMPARE(document().selection().level(), 2);
  QCOMPARE(document().selection().points(), std::vector<PointId>{chosen});
  trigger(ActionId::selectParents);
  QCOMPARE(document().selection().level(), 1);
  QCOMPARE(document().selection().points(), ui::parentsOf(document().shown().controls, 2, {chosen}));
}

void LevelTreeTest::relativesThatAreLockedOrHiddenAreNotSelected() {
  document().selection().setLevel(2);
  const auto merged = std::find_if(levels()[1].begin(), levels()[1].end(),
                                   [](const ControlPoint& point) { return point.mergedFrom.size() >= 2; });
  QVERIFY(merged != levels()[1].end());
  const PointId chosen = merged->id;
  const std::vector<PointId> children = merged->mergedFrom;
  QVERIFY(document().perform(Lock{{3, {children[0]}}, true}));
  document().selection().replace({chosen});
  trigger(ActionId::selectChildren);
  QCOMPARE(document().selection().points(), std::vector<PointId>(children.begin() + 1, children.end()));
  // None is left: the level changes and keeps the selection that it has.
  trigger(ActionId::hidePoints);
  document().selection().setLevel(2);
  document().selection().replace({chosen});
  document().selection().setLevel(3);
  PointId other = 0;
  for (const ControlPoint& point : levels()[2]) {
    if (std::find(children.begin(), children.end(), point.id) == children.end()) {
      other = point.id;
    }
  }
  document().selection().replace({other});
  document().selection().setLevel(2);
  trigger(ActionId::levelDown);
  QCOMPARE(document().selection().level(), 3);
  QCOMPARE(document().selection().points(), std::vector<PointId>{other});
}

void LevelTreeTest::theTreeFollowsTheEditLevel() {
  ui::SceneTree& tree = open_->window.docks().scene().tree();
  const auto& model = *static_cast<ui::SceneModel*>(tree.model());
  QVERIFY(tree.isExpanded(model.levelIndex(3)));
  surface().setFocus();
  QTest::keyClick(&surface(), Qt::Key_1);
  QVERIFY(tree.isExpanded(model.levelIndex(1)));
  QVERIFY(!tree.isExpanded(model.levelIndex(3)));
  const QModelIndex merged = model.index(0, 0, model.levelIndex(1));
  QVERIFY(!tree.isExpanded(merged));
  document().selection().replace({levels()[0][3].id});
  QVERIFY(tree.isExpanded(merged));
  // What the user opened stays open.
  tree.expand(model.levelIndex(2));
  QTest::keyClick(&surface(), Qt::Key_3);
  QVERIFY(!tree.isExpanded(model.levelIndex(1)));
  QVERIFY(!tree.isExpanded(model.index(0, 0, model.levelIndex(1))));
  QVERIFY(tree.isExpanded(model.levelIndex(2)));
  QVERIFY(tree.isExpanded(model.levelIndex(3)));
}

const Registration<LevelTreeTest> registration;

}  // namespace pbffd::test

#include "level_tree_test.moc"
