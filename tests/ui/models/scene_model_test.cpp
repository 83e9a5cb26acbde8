#include "ui/models/scene_model.h"

#include "tests/support/test_main.h"
#include "tests/ui/document/opened.h"
#include "ui/document/view_state.h"

#include <QAbstractItemModelTester>
#include <QtTest>

namespace pbffd::test {

using ui::SceneModel;
using ui::ViewState;

class SceneModelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void cleanup();

  void nothingOpenHasNoRows();
  void rowsAreMeshSetLevelsKindsPoints();
  void everyPointHasItsRow();
  void theFilterLeavesWhatFits();
  void eyesChangeTheViewOnly();
  void tickAndLockAreUndoable();
  void renameIsUndoable();
  void theEditLevelIsMarked();
  void parentsAndChildrenOfTheSelectionAreMarked();
  void selectionBecomesFewRanges();
  void aChangeOfTheViewIsFewSignalsWithManyPoints();

 private:
  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<ui::Document> document_;
  std::unique_ptr<ViewState> view_;
  std::unique_ptr<SceneModel> model_;
};

void SceneModelTest::init() {
  folder_ = std::make_unique<QTemporaryDir>();
  document_ = std::make_unique<ui::Document>();
  view_ = std::make_unique<ViewState>();
  model_ = std::make_unique<SceneModel>(*document_, *view_);
  new QAbstractItemModelTester(model_.get(), QAbstractItemModelTester::FailureReportingMode::QtTest,
                               model_.get());
}

void SceneModelTest::cleanup() {
  model_.reset();
  view_.reset();
  document_.reset();
  folder_.reset();
}

void SceneModelTest::nothingOpenHasNoRows() {
  QCOMPARE(model_->rowCount(), 0);
}

void SceneModelTest::rowsAreMeshSetLevelsKindsPoints() {
  QVERIFY(openShape(*document_, *folder_));
  QCOMPARE(model_->rowCount(), 2);
  QCOMPARE(model_->index(0, 0).data().toString(), QString("shape.obj"));
  QVERIFY(model_->index(0, SceneModel::countColumn).data().toString().endsWith("tri."));
  QCOMPARE(model_->rowCount(model_->controlsIndex()), 2);
  QCOMPARE(model_->levelIndex(1).data().toString(), QString("Level 1 (coarsest)"));
  QCOMPARE(model_->levelIndex(2).data().toString(), QString("Level 2 (finest)"));
  QCOMPARE(model_->levelIndex(2).siblingAtColumn(SceneModel::countColumn).data().toString(), QString("40"));
  const QModelIndex group = model_->index(0, 0, model_->levelIndex(2));
  QCOMPARE(group.data().toString(), QString("Interior"));
  QVERIFY(model_->index(0, 0, group).data().toString().startsWith("Point "));
  QVERIFY(!model_->index(0, 0).siblingAtColumn(SceneModel::tickColumn).data(Qt::CheckStateRole).isValid());
}

void SceneModelTest::everyPointHasItsRow() {
  QVERIFY(openShape(*document_, *folder_));
  const auto& levels = document_->shown().controls.levels;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    int rows = 0;
    const QModelIndex levelRow = model_->levelIndex(static_cast<int>(l) + 1);
    for (int group = 0; group < model_->rowCount(levelRow); ++group) {
      rows += model_->rowCount(model_->index(group, 0, levelRow));
    }
    QCOMPARE(rows, levels[l].size());
    for (const ControlPoint& point : levels[l]) {
      const QModelIndex index = model_->pointIndex(static_cast<int>(l) + 1, point.id);
      QVERIFY(index.isValid());
      QCOMPARE(index.data(SceneModel::pointRole).toLongLong(), point.id);
      QCOMPARE(index.parent().parent(), levelRow);
    }
  }
}

void SceneModelTest::theFilterLeavesWhatFits() {
  QVERIFY(openShape(*document_, *folder_));
  const PointId point = firstPoints(*document_, 1).front();
  QVERIFY(document_->perform(Rename{std::nullopt, point, "Elbow"}));
  model_->setFilter("elb");
  QCOMPARE(model_->rowCount(model_->levelIndex(2)), 1);
  QCOMPARE(model_->pointsBelow(model_->levelIndex(2)), std::vector<PointId>{point});
  QVERIFY(!model_->pointIndex(2, firstPoints(*document_, 2).back()).isValid());
  model_->setFilter("kind:exterior");
  QCOMPARE(model_->index(0, 0, model_->levelIndex(2)).data().toString(), QString("Exterior"));
  model_->setFilter("moved");
  QCOMPARE(model_->rowCount(model_->levelIndex(2)), 0);
  QVERIFY(document_->perform(Move{{std::nullopt, {point}}, {Vec3(0, 0.1, 0)}, Follow::none, {}}));
  QCOMPARE(model_->pointsBelow(model_->levelIndex(2)), std::vector<PointId>{point});
  model_->setFilter("");
  QCOMPARE(model_->pointsBelow(model_->levelIndex(2)).size(), std::size_t{40});
}

void SceneModelTest::eyesChangeTheViewOnly() {
  QVERIFY(openShape(*document_, *folder_));
  const auto eye = [&](const QModelIndex& row) { return row.siblingAtColumn(SceneModel::eyeColumn); };
  const QModelIndex point = model_->pointIndex(2, firstPoints(*document_, 1).front());
  QVERIFY(model_->setData(eye(point), Qt::Unchecked, Qt::CheckStateRole));
  QVERIFY(!view_->isPointShown(firstPoints(*document_, 1).front()));
  QCOMPARE(eye(point).data(Qt::CheckStateRole).toInt(), static_cast<int>(Qt::Unchecked));
  QVERIFY(model_->setData(eye(model_->index(0, 0)), Qt::Unchecked, Qt::CheckStateRole));
  QVERIFY(!view_->isMeshShown());
  QVERIFY(model_->setData(eye(model_->levelIndex(1)), Qt::Checked, Qt::CheckStateRole));
  QVERIFY(view_->isLevelShown(1));
  QCOMPARE(document_->history().count(), 1);
}

void SceneModelTest::tickAndLockAreUndoable() {
  QVERIFY(openShape(*document_, *folder_));
  const PointId id = firstPoints(*document_, 1).front();
  const QModelIndex point = model_->pointIndex(2, id);
  QVERIFY(model_->setData(point.siblingAtColumn(SceneModel::tickColumn), Qt::Unchecked, Qt::CheckStateRole));
  QVERIFY(!document_->shown().controls.finest()[0].enabled);
  QVERIFY(model_->pointIndex(2, id).data(SceneModel::isDimRole).toBool());
  QVERIFY(model_->setData(model_->controlsIndex().siblingAtColumn(SceneModel::lockColumn), Qt::Checked,
                          Qt::CheckStateRole));
  QVERIFY(document_->shown().controls.finest()[20].locked);
  QCOMPARE(document_->history().count(), 3);
  document_->undo();
  document_->undo();
  QVERIFY(document_->isPristine());
  // The mesh is locked from the start and stays so.
  QVERIFY(!model_->setData(model_->index(0, SceneModel::lockColumn), Qt::Unchecked, Qt::CheckStateRole));
}

void SceneModelTest::renameIsUndoable() {
  QVERIFY(openShape(*document_, *folder_));
  const PointId id = firstPoints(*document_, 1).front();
  QVERIFY(model_->setData(model_->pointIndex(2, id), " Elbow ", Qt::EditRole));
  QCOMPARE(model_->pointIndex(2, id).data().toString(), QString("Elbow"));
  QCOMPARE(model_->pointIndex(2, id).data(SceneModel::detailRole).toString(), QString::number(id));
  document_->undo();
  QCOMPARE(model_->pointIndex(2, id).data().toString(), QString("Point %1").arg(id));
  // The same name again is no edit.
  QVERIFY(model_->setData(model_->pointIndex(2, id), "", Qt::EditRole));
  QVERIFY(document_->history().canRedo());
}

void SceneModelTest::theEditLevelIsMarked() {
  QVERIFY(openShape(*document_, *folder_));
  QVERIFY(model_->levelIndex(2).data(SceneModel::isEditLevelRole).toBool());
  document_->selection().setLevel(1);
  QVERIFY(model_->levelIndex(1).data(SceneModel::isEditLevelRole).toBool());
  QVERIFY(!model_->levelIndex(2).data(SceneModel::isEditLevelRole).toBool());
  // It is always drawn: it has no eye, and no switch that does nothing.
  const QModelIndex eye = model_->levelIndex(1).siblingAtColumn(SceneModel::eyeColumn);
  QVERIFY(!eye.data(Qt::CheckStateRole).isValid());
  QVERIFY(!model_->setData(eye, Qt::Unchecked, Qt::CheckStateRole));
  const QModelIndex other = model_->levelIndex(2).siblingAtColumn(SceneModel::eyeColumn);
  QCOMPARE(other.data(Qt::CheckStateRole).toInt(), static_cast<int>(Qt::Unchecked));
}

void SceneModelTest::parentsAndChildrenOfTheSelectionAreMarked() {
  QVERIFY(openShape(*document_, *folder_));
  QVERIFY(document_->perform(SetLevels{3}));
  const auto& levels = document_->shown().controls.levels;
  const ControlPoint& middle = levels[1][0];
  document_->selection().setLevel(2);
  document_->selection().replace({middle.id});
  const auto relation = [&](const QModelIndex& index) {
    return static_cast<ui::Relation>(index.data(SceneModel::relationRole).toInt());
  };
  std::size_t children = 0;
  for (const ControlPoint& point : levels[2]) {
    const bool isChild =
        std::find(middle.mergedFrom.begin(), middle.mergedFrom.end(), point.id) != middle.mergedFrom.end();
    const QModelIndex row = model_->pointIndex(3, point.id);
    QCOMPARE(relation(row), isChild ? ui::Relation::child : ui::Relation::none);
    QCOMPARE(row.data(SceneModel::detailRole).toString(), isChild ? QString("child") : QString());
    children += isChild ? 1 : 0;
  }
  QCOMPARE(children, middle.mergedFrom.size());
  int parents = 0;
  for (const ControlPoint& point : levels[0]) {
    parents += relation(model_->pointIndex(1, point.id)) == ui::Relation::parent ? 1 : 0;
  }
  QCOMPARE(parents, 1);
  // The rows above tell it too, for they may be closed.
  QCOMPARE(relation(model_->levelIndex(1)), ui::Relation::parent);
  const QModelIndex group = model_->index(0, 0, model_->levelIndex(1));
  QCOMPARE(group.data(SceneModel::detailRole).toString(), QString("1 parent"));
  QCOMPARE(model_->levelIndex(1).data(SceneModel::detailRole).toString(), QString("1 parent"));
  QVERIFY(model_->levelIndex(3).data(SceneModel::detailRole).toString().contains("child"));
  QVERIFY(model_->levelIndex(2).data(SceneModel::detailRole).toString().isEmpty());
  document_->selection().clear();
  QCOMPARE(relation(model_->levelIndex(1)), ui::Relation::none);
}

void SceneModelTest::selectionBecomesFewRanges() {
  QVERIFY(openShape(*document_, *folder_));
  const QModelIndex group = model_->index(0, 0, model_->levelIndex(2));
  std::vector<PointId> points = model_->pointsBelow(group);
  QCOMPARE(model_->rowsOf(2, points).size(), 1);
  points.erase(points.begin() + 3);
  QCOMPARE(model_->rowsOf(2, points).size(), 2);
  QCOMPARE(model_->rowsOf(2, {987654}).size(), 0);
}

void SceneModelTest::aChangeOfTheViewIsFewSignalsWithManyPoints() {
  QVERIFY(openShape(*document_, *folder_));
  Group many;
  for (int i = 0; i < 2000; ++i) {
    Frame rest;
    rest.center = Vec3(0.002 * i, 0, 0);
    rest.axes *= 0.02;
    Add one;
    one.rest = rest;
    many.edits.push_back(one);
  }
  QVERIFY(document_->perform(many));
  QCOMPARE(model_->pointsBelow(model_->levelIndex(2)).size(), std::size_t{2040});
  // One range for each parent, not one for each row: a view asks again only for the rows that are seen.
  QSignalSpy refreshed(model_.get(), &ui::SceneModel::dataChanged);
  view_->setGridShown(!view_->isGridShown());
  QVERIFY(!refreshed.isEmpty());
  QVERIFY(refreshed.size() <= 8);
}

const Registration<SceneModelTest> registration;

}  // namespace pbffd::test

#include "scene_model_test.moc"
