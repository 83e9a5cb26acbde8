#include "ui/models/history_model.h"

#include "core/project/edit_json.h"
#include "tests/support/test_main.h"
#include "tests/ui/document/opened.h"

#include <QAbstractItemModelTester>
#include <QtTest>

namespace pbffd::test {

using ui::HistoryModel;

class HistoryModelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void rowsFollowTheHistory();
  void undoneStepsAreFutureUntilCut();
  void theSavedStateIsMarked();
  void stepsCopyAsEdits();
  void theStepsAreAFileOfEdits();
};

Move someMove(const ui::Document& document) {
  return Move{{std::nullopt, firstPoints(document, 2)}, {Vec3(0, 0.35, 0)}, Follow::none, {}};
}

void HistoryModelTest::rowsFollowTheHistory() {
  const QTemporaryDir folder;
  ui::Document document;
  HistoryModel model(document);
  new QAbstractItemModelTester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest, &model);
  QCOMPARE(model.rowCount(), 0);
  QVERIFY(openShape(document, folder));
  QCOMPARE(model.rowCount(), 2);
  QCOMPARE(model.index(0).data().toString(), QString("Open shape.obj"));
  QVERIFY(model.index(1).data().toString().startsWith("Place 40 points"));
  QVERIFY(document.perform(someMove(document)));
  QCOMPARE(model.index(2).data().toString(), QString("Move 2 points by 0, 0.35, 0"));
  QCOMPARE(model.index(2).data(HistoryModel::iconRole).toString(), QString("move"));
  QVERIFY(model.index(2).data(HistoryModel::isCurrentRole).toBool());
  QCOMPARE(model.stepCount(), 2);
}

void HistoryModelTest::undoneStepsAreFutureUntilCut() {
  const QTemporaryDir folder;
  ui::Document document;
  HistoryModel model(document);
  QVERIFY(openShape(document, folder));
  QVERIFY(document.perform(someMove(document)));
  QVERIFY(document.perform(someMove(document)));
  document.goTo(1);
  QCOMPARE(model.rowCount(), 4);
  QVERIFY(model.index(2).data(HistoryModel::isFutureRole).toBool());
  QVERIFY(!model.index(1).data(HistoryModel::isFutureRole).toBool());
  QVERIFY(document.perform(someMove(document)));
  QCOMPARE(model.rowCount(), 3);
}

void HistoryModelTest::theSavedStateIsMarked() {
  const QTemporaryDir folder;
  ui::Document document;
  HistoryModel model(document);
  QVERIFY(openShape(document, folder));
  QVERIFY(!model.index(1).data(HistoryModel::isSavedRole).toBool());
  QVERIFY(document.perform(someMove(document)));
  QVERIFY(document.save(folder.filePath("a.pbffd"), {}));
  QVERIFY(model.index(2).data(HistoryModel::isSavedRole).toBool());
  QCOMPARE(model.index(0).data().toString(), QString("Open shape.obj"));
  document.undo();
  QVERIFY(model.index(2).data(HistoryModel::isSavedRole).toBool());
  QVERIFY(!model.index(1).data(HistoryModel::isSavedRole).toBool());
}

void HistoryModelTest::stepsCopyAsEdits() {
  const QTemporaryDir folder;
  ui::Document document;
  HistoryModel model(document);
  QVERIFY(openShape(document, folder));
  QVERIFY(document.perform(someMove(document)));
  QVERIFY(model.editJson(0).isEmpty());
  QCOMPARE(model.editJson(2).toStdString(), toJson(someMove(document)));
}

void HistoryModelTest::theStepsAreAFileOfEdits() {
  const QTemporaryDir folder;
  ui::Document document;
  HistoryModel model(document);
  QVERIFY(openShape(document, folder));
  QVERIFY(document.perform(someMove(document)));
  QVERIFY(document.perform(SetMaster{0.25, MasterMode::constant}));
  document.undo();
  const auto edits = parseEdits(model.editsJson().toStdString(), "steps.json");
  QCOMPARE(edits.size(), std::size_t{2});
  // From the bare mesh they lead to the very same project.
  EditWorkspace workspace;
  Project project = projectOf(document.committed().mesh);
  for (const Edit& edit : edits) {
    project = apply(project, edit, workspace).project;
  }
  QVERIFY(project.controls == document.committed().controls);
}

const Registration<HistoryModelTest> registration;

}  // namespace pbffd::test

#include "history_model_test.moc"
