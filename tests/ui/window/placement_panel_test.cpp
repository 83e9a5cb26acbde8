#include "ui/window/placement_panel.h"

#include "tests/support/shown_window.h"
#include "tests/support/test_main.h"
#include "tests/ui/document/opened.h"
#include "ui/document/job_runner.h"
#include "ui/document/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QtTest>

#include <algorithm>

namespace pbffd::test {

class PlacementPanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void cleanup();

  void showsTheOptionsOfTheProject();
  void theSliderPlacesAnewWhileNothingIsEdited();
  void afterAnEditOnlyTheButtonPlaces();
  void undoTakesTheNumbersBack();
  void aCancelledPlacementLeavesTheNumbersThatAreTrue();
  void withoutPointsTheLevelsAreThoseOfTheNextPlacement();
  void figuresAreSeenWhole();
  void levelsThatCameAreShown();
  void regionsCanBeEllipsoids();

 private:
  QTemporaryDir folder_;
  std::unique_ptr<ui::Theme> theme_;
  std::unique_ptr<ui::Document> document_;
  std::unique_ptr<ui::PlacementPanel> panel_;
};

void PlacementPanelTest::init() {
  theme_ = std::make_unique<ui::Theme>();
  document_ = std::make_unique<ui::Document>();
  panel_ = std::make_unique<ui::PlacementPanel>(*document_, *theme_);
  panel_->resize(308, 400);
  QVERIFY(showActive(*panel_));
  QVERIFY(openShape(*document_, folder_));
}

void PlacementPanelTest::cleanup() {
  panel_.reset();
  document_.reset();
  theme_.reset();
}

void PlacementPanelTest::showsTheOptionsOfTheProject() {
  QVERIFY(panel_->options() == fewPoints());
}

void PlacementPanelTest::theSliderPlacesAnewWhileNothingIsEdited() {
  QSlider* slider = panel_->pointsSlider();
  slider->setFocus();
  for (int press = 0; press < 5; ++press) {
    QTest::keyClick(slider, Qt::Key_Right);
  }
  const int wanted = panel_->options().points;
  QVERIFY(wanted > 40);
  QVERIFY(finishJobs(*document_));
  QCOMPARE(document_->shown().controls.finest().size(), wanted);
  // One entry beside the first placement.
  QCOMPARE(document_->history().count(), 2);
  QCOMPARE(panel_->options().points, wanted);
}

void PlacementPanelTest::afterAnEditOnlyTheButtonPlaces() {
  QVERIFY(document_->perform(
      Move{{std::nullopt, firstPoints(*document_, 2)}, {Vec3(0, 0.2, 0)}, Follow::none, {}}));
  QVERIFY(panel_->findChild<QCheckBox*>()->isVisible());
  QTest::keyClick(panel_->pointsSlider(), Qt::Key_PageUp);
  QVERIFY(!document_->jobs().isRunning());
  QCOMPARE(document_->shown().controls.finest().size(), 40);
  const int wanted = panel_->options().points;
  panel_->placeAgain();
  QVERIFY(finishJobs(*document_));
  QCOMPARE(document_->shown().controls.finest().size(), wanted);
  // The edits were kept: something is still moved.
  QVERIFY(!document_->isPristine());
}

void PlacementPanelTest::undoTakesTheNumbersBack() {
  QTest::keyClick(panel_->pointsSlider(), Qt::Key_PageUp);
  QVERIFY(finishJobs(*document_));
  document_->undo();
  QCOMPARE(panel_->options().points, 40);
}

void PlacementPanelTest::aCancelledPlacementLeavesTheNumbersThatAreTrue() {
  QTest::keyClick(panel_->pointsSlider(), Qt::Key_PageUp);
  QVERIFY(document_->jobs().isRunning("place"));
  QTest::keyClick(panel_->pointsSlider(), Qt::Key_PageUp);  // this one waits for the other
  QVERIFY(panel_->options().points > 40);
  document_->jobs().cancel();
  QVERIFY(finishJobs(*document_));
  QCOMPARE(document_->history().count(), 1);
  QCOMPARE(document_->shown().controls.finest().size(), 40);
  QCOMPARE(panel_->options().points, 40);
}

void PlacementPanelTest::withoutPointsTheLevelsAreThoseOfTheNextPlacement() {
  document_->open(writeShape(folder_, cylinder(), "other.obj"), PlacementOptions{});
  QSignalSpy opened(document_.get(), &ui::Document::opened);
  QVERIFY(opened.wait(patience));
  document_->jobs().cancel();
  QVERIFY(finishJobs(*document_));
  QVERIFY(document_->committed().controls.finest().empty());
  QCOMPARE(panel_->options().levels, PlacementOptions{}.levels);
}

void PlacementPanelTest::figuresAreSeenWhole() {
  QVERIFY(document_->perform(
      Move{{std::nullopt, firstPoints(*document_, 2)}, {Vec3(0, 0.2, 0)}, Follow::none, {}}));
  const auto* figures = panel_->findChild<QLabel*>("placementFigures");
  QVERIFY(figures->text().endsWith(" s"));
  QCoreApplication::processEvents();
  QVERIFY(figures->width() >= figures->sizeHint().width());
  QVERIFY(figures->mapTo(panel_->viewport(), figures->rect().topRight()).x() < panel_->viewport()->width());
  QVERIFY(panel_->widget()->width() <= panel_->viewport()->width());
}

void PlacementPanelTest::levelsThatCameAreShown() {
  QVERIFY(document_->perform(SetLevels{4}));
  QCOMPARE(panel_->options().levels, 4);
  document_->undo();
  QCOMPARE(panel_->options().levels, 2);
}

void PlacementPanelTest::regionsCanBeEllipsoids() {
  QComboBox* regions = nullptr;
  for (QComboBox* each : panel_->findChildren<QComboBox*>()) {
    regions = each->accessibleName() == "Shape of the regions" ? each : regions;
  }
  QVERIFY(regions != nullptr);
  const auto isSphere = [](const ControlPoint& point) {
    const Eigen::RowVector3d lengths = point.rest.axes.colwise().norm();
    return lengths.maxCoeff() - lengths.minCoeff() < 1e-9 * lengths.maxCoeff();
  };
  const auto areSpheres = [&](const Level& level) { return std::all_of(level.begin(), level.end(), isSphere); };
  QVERIFY(areSpheres(document_->shown().controls.levels[0]));
  regions->setCurrentIndex(1);
  Q_EMIT regions->activated(1);
  QVERIFY(finishJobs(*document_));
  QVERIFY(document_->committed().placement.regions == RegionShape::ellipsoid);
  // Those of merged points too.
  QVERIFY(!areSpheres(document_->shown().controls.levels[0]));
}

const Registration<PlacementPanelTest> registration;

}  // namespace pbffd::test

#include "placement_panel_test.moc"
