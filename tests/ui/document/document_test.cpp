#include "ui/document/document.h"

#include "tests/support/test_main.h"
#include "tests/ui/document/opened.h"
#include "ui/document/change_project.h"

#include <QtTest>

namespace pbffd::test {
namespace {

using ui::Document;

Move moveBy(const std::vector<PointId>& points, const Vec3& by) {
  return Move{{std::nullopt, points}, {by}, Follow::none, {}};
}

bool same(const Project& a, const Project& b) {
  return !changesBetween(a, b).any();
}

}  // namespace

class DocumentTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void cleanup();

  void aMeshOpensAtOnceAndPointsFollow();
  void openingAMeshLeavesNothingToSave();
  void undoAndRedoRestoreTheVeryValues();
  void undoSelectsWhatItChanged();
  void aPreviewIsShownButNotInTheHistory();
  void aCommittedPreviewIsOneEntry();
  void aCancelledPreviewLeavesNoTrace();
  void theLastPreviewOfATurnIsShown();
  void anImpossiblePreviewChangesNothing();
  void anImpossibleEditFailsAndChangesNothing();
  void editsOfOneRunAreOneEntry();
  void placementsOfOneScrubAreOneEntry();
  void howTheSurfaceWasTakenIsToldWhereItIsNews();
  void goingThroughTheHistoryAnnouncesOnce();
  void aResultForAnotherStateIsDropped();
  void cancelledPlacementChangesNothing();
  void aFileThatCannotBeReadLeavesTheDocument();
  void savedAndLoadedProjectsAreEqual();
  void aFailedSaveLeavesTheDocumentChanged();
  void anUnmovedMeshExportsByteForByte();
  void anUnknownEndingIsRefused();
  void theDeformationFollowsEachEdit();
  void editedMeansMoreThanPlaced();
  void closingForgetsEverything();

 private:
  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<Document> document_;
};

void DocumentTest::init() {
  folder_ = std::make_unique<QTemporaryDir>();
  document_ = std::make_unique<Document>();
}

void DocumentTest::cleanup() {
  document_.reset();
  folder_.reset();
}

void DocumentTest::aMeshOpensAtOnceAndPointsFollow() {
  std::vector<Index> sizes;
  connect(document_.get(), &Document::opened, this, [&] {
    sizes.push_back(document_->shown().controls.finest().size());
    QVERIFY(document_->deformation() != nullptr);
  });
  QVERIFY(openShape(*document_, *folder_));
  QCOMPARE(sizes, std::vector<Index>{0});
  QCOMPARE(document_->shown().controls.finest().size(), 40);
  QCOMPARE(document_->shown().controls.levels.size(), std::size_t{2});
  QCOMPARE(document_->selection().level(), 2);
  QCOMPARE(document_->displayName(), QString("shape.obj"));
}

void DocumentTest::openingAMeshLeavesNothingToSave() {
  QVERIFY(openShape(*document_, *folder_));
  QVERIFY(!document_->isModified());
  QVERIFY(document_->isPristine());
  QCOMPARE(document_->history().count(), 1);
}

void DocumentTest::undoAndRedoRestoreTheVeryValues() {
  QVERIFY(openShape(*document_, *folder_));
  const Project before = document_->committed();
  QVERIFY(document_->perform(moveBy(firstPoints(*document_, 3), Vec3(0, 0.25, 0))));
  const Project after = document_->committed();
  QVERIFY(!same(before, after));
  QVERIFY(document_->isModified());
  document_->undo();
  QVERIFY(same(document_->shown(), before));
  QVERIFY(!document_->isModified());
  document_->redo();
  QVERIFY(same(document_->shown(), after));
}

void DocumentTest::undoSelectsWhatItChanged() {
  QVERIFY(openShape(*document_, *folder_));
  const auto points = firstPoints(*document_, 2);
  QVERIFY(document_->perform(moveBy(points, Vec3(0, 0.25, 0))));
  document_->selection().setLevel(1);
  document_->undo();
  QCOMPARE(document_->selection().level(), 2);
  QCOMPARE(document_->selection().points(), points);
  document_->selection().clear();
  document_->redo();
  QCOMPARE(document_->selection().points(), points);
}

void DocumentTest::aPreviewIsShownButNotInTheHistory() {
  QVERIFY(openShape(*document_, *folder_));
  const Project before = document_->committed();
  QSignalSpy changed(document_.get(), &Document::changed);
  QVERIFY(document_->preview(moveBy(firstPoints(*document_, 1), Vec3(0.1, 0, 0))));
  QVERIFY(document_->isPreviewing());
  QCOMPARE(changed.count(), 1);
  QVERIFY(!same(document_->shown(), before));
  QVERIFY(same(document_->committed(), before));
  QCOMPARE(document_->history().count(), 1);
}

void DocumentTest::aCommittedPreviewIsOneEntry() {
  QVERIFY(openShape(*document_, *folder_));
  const auto points = firstPoints(*document_, 1);
  for (int step = 1; step <= 5; ++step) {
    QVERIFY(document_->preview(moveBy(points, Vec3(0.1 * step, 0, 0))));
    QCoreApplication::processEvents();
  }
  const Project last = document_->shown();
  document_->commitPreview();
  QVERIFY(!document_->isPreviewing());
  QCOMPARE(document_->history().count(), 2);
  QVERIFY(same(document_->committed(), last));
}

void DocumentTest::aCancelledPreviewLeavesNoTrace() {
  QVERIFY(openShape(*document_, *folder_));
  const Project before = document_->committed();
  const std::vector<float> positions = document_->deformation()->positions();
  QVERIFY(document_->preview(moveBy(firstPoints(*document_, 3), Vec3(0, 0.3, 0))));
  QVERIFY(document_->deformation()->positions() != positions);
  document_->cancelPreview();
  QVERIFY(same(document_->shown(), before));
  QVERIFY(document_->deformation()->positions() == positions);
  QCOMPARE(document_->history().count(), 1);
  QVERIFY(!document_->isModified());
  QCOMPARE(document_->lastMovedVertices(), 0);
}

void DocumentTest::theLastPreviewOfATurnIsShown() {
  QVERIFY(openShape(*document_, *folder_));
  const auto points = firstPoints(*document_, 1);
  const double start = document_->shown().controls.finest()[0].pose.center.x();
  QSignalSpy changed(document_.get(), &Document::changed);
  for (int step = 1; step <= 10; ++step) {
    QVERIFY(document_->preview(moveBy(points, Vec3(0.125 * step, 0, 0))));
  }
  QCoreApplication::processEvents();
  QCOMPARE(changed.count(), 2);
  QCOMPARE(document_->shown().controls.finest()[0].pose.center.x(), start + 1.25);
}

void DocumentTest::anImpossiblePreviewChangesNothing() {
  QVERIFY(openShape(*document_, *folder_));
  QVERIFY(document_->preview(moveBy(firstPoints(*document_, 1), Vec3(0.1, 0, 0))));
  QCoreApplication::processEvents();
  const Project shown = document_->shown();
  QVERIFY(!document_->preview(moveBy({987654}, Vec3(0.1, 0, 0))));
  QVERIFY(same(document_->shown(), shown));
}

void DocumentTest::anImpossibleEditFailsAndChangesNothing() {
  QVERIFY(openShape(*document_, *folder_));
  const Project before = document_->committed();
  QSignalSpy failed(document_.get(), &Document::failed);
  QVERIFY(!document_->perform(moveBy({987654}, Vec3(0.1, 0, 0))));
  QCOMPARE(failed.count(), 1);
  QVERIFY(failed.first().first().toString().contains("987654"));
  QVERIFY(same(document_->committed(), before));
  QCOMPARE(document_->history().count(), 1);
}

void DocumentTest::editsOfOneRunAreOneEntry() {
  QVERIFY(openShape(*document_, *folder_));
  const Project before = document_->committed();
  const auto points = firstPoints(*document_, 2);
  const int run = document_->newMergeKey();
  for (int step = 0; step < 4; ++step) {
    QVERIFY(document_->perform(moveBy(points, Vec3(0.1, 0, 0)), {run}));
  }
  QCOMPARE(document_->history().count(), 2);
  // The entry as an edit does the same as the run did.
  const auto* step = static_cast<const ui::ChangeProject*>(document_->history().command(1));
  EditWorkspace workspace;
  QVERIFY(same(apply(before, step->edit(), workspace).project, document_->committed()));
  document_->undo();
  QVERIFY(same(document_->committed(), before));
  QVERIFY(document_->perform(moveBy(points, Vec3(0.1, 0, 0)), {document_->newMergeKey()}));
  QVERIFY(document_->perform(moveBy(points, Vec3(0.1, 0, 0)), {document_->newMergeKey()}));
  QCOMPARE(document_->history().count(), 3);
}

void DocumentTest::placementsOfOneScrubAreOneEntry() {
  QVERIFY(openShape(*document_, *folder_));
  const int scrub = document_->newMergeKey();
  for (const int points : {20, 30, 25}) {
    document_->performInBackground(Place{fewPoints(points), false, std::nullopt}, {scrub});
    QVERIFY(finishJobs(*document_));
  }
  QCOMPARE(document_->history().count(), 2);
  QCOMPARE(document_->shown().controls.finest().size(), 25);
  document_->undo();
  QCOMPARE(document_->shown().controls.finest().size(), 40);
}

void DocumentTest::howTheSurfaceWasTakenIsToldWhereItIsNews() {
  QStringList told;
  connect(document_.get(), &Document::informed, this, [&](const QString& text) {
    if (text.contains("taken as")) {
      told += text;
    }
  });
  QVERIFY(openShape(*document_, *folder_));
  QCOMPARE(told.size(), 1);
  QVERIFY(document_->perform(Place{fewPoints(30), false, {}}));
  QVERIFY(document_->perform(Place{fewPoints(50), false, {}}));
  QCOMPARE(told.size(), 1);
  PlacementOptions open = fewPoints(50);
  open.surface = Surface::open;
  QVERIFY(document_->perform(Place{open, false, {}}));
  QCOMPARE(told.size(), 2);
  QVERIFY(told.last().contains("open"));
  QVERIFY(openShape(*document_, *folder_));
  QCOMPARE(told.size(), 3);
}

void DocumentTest::goingThroughTheHistoryAnnouncesOnce() {
  QVERIFY(openShape(*document_, *folder_));
  const Project start = document_->committed();
  const auto points = firstPoints(*document_, 1);
  for (int step = 0; step < 5; ++step) {
    QVERIFY(document_->perform(moveBy(points, Vec3(0.1, 0, 0))));
  }
  QSignalSpy changed(document_.get(), &Document::changed);
  document_->goTo(1);
  QCOMPARE(changed.count(), 1);
  QVERIFY(same(document_->shown(), start));
}

void DocumentTest::aResultForAnotherStateIsDropped() {
  QVERIFY(openShape(*document_, *folder_));
  QSignalSpy remarked(document_.get(), &Document::remarked);
  document_->performInBackground(Place{fewPoints(30), false, std::nullopt});
  QVERIFY(document_->perform(moveBy(firstPoints(*document_, 1), Vec3(0.1, 0, 0))));
  const Project edited = document_->committed();
  QVERIFY(finishJobs(*document_));
  QVERIFY(same(document_->committed(), edited));
  QCOMPARE(remarked.count(), 1);
}

void DocumentTest::cancelledPlacementChangesNothing() {
  QVERIFY(openShape(*document_, *folder_));
  const Project before = document_->committed();
  document_->performInBackground(Place{fewPoints(30), false, std::nullopt});
  document_->jobs().cancel();
  QVERIFY(finishJobs(*document_));
  QVERIFY(same(document_->committed(), before));
  QCOMPARE(document_->history().count(), 1);
}

void DocumentTest::aFileThatCannotBeReadLeavesTheDocument() {
  QVERIFY(openShape(*document_, *folder_));
  const Project before = document_->committed();
  const QString bad = folder_->filePath("bad.obj");
  writeFileAtomically(bad.toStdString(), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  const QString line = folder_->filePath("line.obj");
  writeFileAtomically(line.toStdString(), "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  const QString faceless = folder_->filePath("faceless.obj");
  writeFileAtomically(faceless.toStdString(), "v 0 0 0\nv 1 0 0\nv 2 1 0\n");
  for (const QString& path :
       {bad, line, faceless, folder_->filePath("missing.obj"), folder_->filePath("missing.pbffd")}) {
    QSignalSpy failed(document_.get(), &Document::failed);
    document_->open(path);
    QVERIFY(finishJobs(*document_));
    QCOMPARE(failed.count(), 1);
    QVERIFY(failed.first().first().toString().contains(QFileInfo(path).fileName()));
    QVERIFY(same(document_->shown(), before));
    QCOMPARE(document_->displayName(), QString("shape.obj"));
  }
}

void DocumentTest::savedAndLoadedProjectsAreEqual() {
  QVERIFY(openShape(*document_, *folder_));
  QVERIFY(document_->perform(moveBy(firstPoints(*document_, 3), Vec3(0.1, 0.2, 0.3))));
  const QString path = folder_->filePath("saved.pbffd");
  QVERIFY(document_->save(path, {"", R"({"grid":false})"}));
  QVERIFY(!document_->isModified());
  QCOMPARE(document_->displayName(), QString("saved.pbffd"));
  const ControlSet controls = document_->committed().controls;

  Document second;
  second.open(path);
  QVERIFY(finishJobs(second));
  QVERIFY(second.isOpen());
  QVERIFY(second.committed().controls == controls);
  QVERIFY(second.committed().mesh->positions() == document_->committed().mesh->positions());
  QVERIFY(!second.isModified());
  QVERIFY(second.extras().viewJson.find("grid") != std::string::npos);
  QCOMPARE(second.history().count(), 0);
}

void DocumentTest::aFailedSaveLeavesTheDocumentChanged() {
  QVERIFY(openShape(*document_, *folder_));
  QVERIFY(document_->perform(moveBy(firstPoints(*document_, 1), Vec3(0.1, 0, 0))));
  QSignalSpy failed(document_.get(), &Document::failed);
  QVERIFY(!document_->save(folder_->filePath("no/such/folder/x.pbffd"), {}));
  QCOMPARE(failed.count(), 1);
  QVERIFY(document_->isModified());
  QVERIFY(document_->path().isEmpty());
}

void DocumentTest::anUnmovedMeshExportsByteForByte() {
  QVERIFY(openShape(*document_, *folder_));
  const QString path = folder_->filePath("out.obj");
  document_->exportMesh(path);
  QVERIFY(finishJobs(*document_));
  QCOMPARE(readFile(path.toStdString()), readFile(folder_->filePath("shape.obj").toStdString()));
}

void DocumentTest::anUnknownEndingIsRefused() {
  QVERIFY(openShape(*document_, *folder_));
  QSignalSpy failed(document_.get(), &Document::failed);
  document_->exportMesh(folder_->filePath("out.xyz"));
  QVERIFY(finishJobs(*document_));
  QCOMPARE(failed.count(), 1);
  QVERIFY(!QFileInfo::exists(folder_->filePath("out.xyz")));
}

void DocumentTest::theDeformationFollowsEachEdit() {
  QVERIFY(openShape(*document_, *folder_));
  const std::vector<float> rest = document_->deformation()->positions();
  QVERIFY(document_->perform(moveBy(firstPoints(*document_, 3), Vec3(0, 0.3, 0))));
  QVERIFY(document_->deformation()->positions() != rest);
  QVERIFY(document_->lastMovedVertices() > 0);
  document_->undo();
  QVERIFY(document_->deformation()->positions() == rest);
  // Disabled points leave the weights, and come back with them.
  QVERIFY(document_->perform(Enable{{std::nullopt, firstPoints(*document_, 3)}, false}));
  QVERIFY(document_->perform(moveBy({document_->shown().controls.finest()[10].id}, Vec3(0, 0.3, 0))));
  QVERIFY(document_->deformation()->positions() != rest);
  document_->goTo(1);
  QVERIFY(document_->deformation()->positions() == rest);
}

void DocumentTest::editedMeansMoreThanPlaced() {
  QVERIFY(openShape(*document_, *folder_));
  QVERIFY(document_->perform(SetMaster{0.5, MasterMode::constant}));
  QVERIFY(document_->isPristine());
  QVERIFY(document_->perform(Rename{std::nullopt, firstPoints(*document_, 1).front(), "Elbow"}));
  QVERIFY(!document_->isPristine());
  document_->undo();
  QVERIFY(document_->isPristine());
  QVERIFY(document_->perform(moveBy(firstPoints(*document_, 1), Vec3(0.1, 0, 0))));
  QVERIFY(!document_->isPristine());
}

void DocumentTest::closingForgetsEverything() {
  QVERIFY(openShape(*document_, *folder_));
  document_->selection().replace(firstPoints(*document_, 2));
  QSignalSpy opened(document_.get(), &Document::opened);
  document_->close();
  QCOMPARE(opened.count(), 1);
  QVERIFY(!document_->isOpen());
  QVERIFY(document_->selection().isEmpty());
  QCOMPARE(document_->history().count(), 0);
  QVERIFY(document_->deformation() == nullptr);
}

const Registration<DocumentTest> registration;

}  // namespace pbffd::test

#include "document_test.moc"
