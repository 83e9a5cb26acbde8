#include "ui/window/main_window.h"

#include "tests/support/test_main.h"
#include "tests/ui/window/open_window.h"
#include "ui/models/scene_model.h"
#include "ui/window/docks.h"
#include "ui/window/document_files.h"
#include "ui/window/error_bar.h"
#include "ui/window/scene_panel.h"
#include "ui/window/scene_tree.h"
#include "ui/window/start_page.h"
#include "ui/window/tool_rail.h"

#include <QDockWidget>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QThread>

namespace pbffd::test {

using ui::ActionId;
using ui::MainWindow;

/// Presses a button of the question about unsaved work when it comes.
void answerSaveQuestion(QMessageBox::StandardButton button) {
  QTimer::singleShot(0, qApp, [button] {
    auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (question == nullptr) {
      return answerSaveQuestion(button);
    }
    QTest::mouseClick(question->button(button), Qt::LeftButton);
  });
}

Move smallMove(const ui::Document& document) {
  return Move{{std::nullopt, firstPoints(document, 3)}, {Vec3(0, 0.2, 0)}, Follow::frames, {}};
}

class MainWindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void cleanup();

  void theStartPageGivesWayToTheDocks();
  void theStartPageFitsTheSmallestWindow();
  void panelsBeginBelowTheirTitles();
  void aBadFileShowsTheErrorBarAndNothingIsLost();
  void theErrorBarLeavesTheToolsFree();
  void theTitleTellsNameAndChange();
  void unsavedWorkIsAskedAbout();
  void actionsAreGreyedWithAReason();
  void undoSaysWhatItUndoes();
  void lettersActInTheViewAlone();
  void aMoveTakesTheKeysFromAnyPane();
  void escapeCancelsLongWork();
  void refineHereIsUndone();
  void treeAndSelectionAreOne();
  void theEditLevelIsAKey();
  void themesSwitchLive();
  void theStatusTellsWhenTheMeshIsSimplified();
  void panesAreReachedByF6();
  void docksHideAndComeBack();
  void dropsAreTakenOrRefused();
  void everyShortcutIsGivenOnce();
  void everyControlHasAName();
  void noSettingsAreTouched();

 private:
  std::unique_ptr<OpenWindow> open_;
  MainWindow& window() { return open_->window; }
  ui::Document& document() { return window().document(); }
  QAction& action(ActionId id) { return *window().actions()[id]; }
  bool openBar() { return open_->open(writeShape(open_->folder, cylinder())); }
};

void MainWindowTest::init() {
  open_ = std::make_unique<OpenWindow>();
  QVERIFY(open_->isReady);
}

void MainWindowTest::cleanup() {
  open_.reset();
}

void MainWindowTest::theStartPageGivesWayToTheDocks() {
  QVERIFY(window().findChild<ui::StartPage*>()->isVisible());
  QVERIFY(!window().docks().scene().isVisible());
  QCOMPARE(window().windowTitle(), QString("PB-FFD Workbench[*]"));
  QVERIFY(openBar());
  QVERIFY(!window().findChild<ui::StartPage*>()->isVisible());
  QVERIFY(window().viewport().isVisible());
  for (const char* dock : {"scene", "inspector", "placement", "history", "messages"}) {
    QVERIFY2(window().findChild<QDockWidget*>(dock)->isVisible(), dock);
  }
  QCOMPARE(document().shown().controls.finest().size(), 200);
  action(ActionId::closeDocument).trigger();
  QVERIFY(window().findChild<ui::StartPage*>()->isVisible());
  QVERIFY(!window().docks().scene().isVisible());
}

void MainWindowTest::theStartPageFitsTheSmallestWindow() {
  window().resize(window().minimumSize());
  auto* area = window().startPage().findChild<QScrollArea*>("startMain");
  QVERIFY(area != nullptr);
  QTRY_VERIFY(window().size() == window().minimumSize());
  QTRY_COMPARE(area->horizontalScrollBar()->maximum(), 0);
}

void MainWindowTest::panelsBeginBelowTheirTitles() {
  QVERIFY(openBar());
  for (const QDockWidget* dock : window().findChildren<QDockWidget*>()) {
    QVERIFY2(dock->widget()->y() > dock->titleBarWidget()->geometry().bottom(), qPrintable(dock->objectName()));
  }
}

void MainWindowTest::aBadFileShowsTheErrorBarAndNothingIsLost() {
  const QString bad = open_->folder.filePath("bad.obj");
  writeFileAtomically(bad.toStdString(), "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n");
  QVERIFY(open_->open(bad));
  QVERIFY(window().errorBar().isVisible());
  QVERIFY(window().errorBar().x() >= ui::StartPage::sideWidthOf(window().width()));
  QVERIFY(!document().isOpen());
  QVERIFY(openBar());
  QVERIFY(!window().errorBar().isVisible());
  QVERIFY(document().perform(smallMove(document())));
  const ControlSet controls = document().committed().controls;
  answerSaveQuestion(QMessageBox::Discard);
  QVERIFY(open_->open(bad));
  QVERIFY(window().errorBar().isVisible());
  QVERIFY(window().errorBar().severity() == ui::Severity::error);
  QVERIFY2(window().errorBar().text().contains("bad.obj"), qPrintable(window().errorBar().text()));
  QVERIFY(document().isModified());
  QVERIFY(document().committed().controls == controls);
}

void MainWindowTest::theErrorBarLeavesTheToolsFree() {
  QVERIFY(openBar());
  window().resize(1100, 700);
  QVERIFY(open_->open(open_->folder.filePath("missing.obj")));
  QCoreApplication::processEvents();
  const auto* bar = &window().errorBar();
  QVERIFY(bar->isVisible());
  const auto* tools = window().findChild<ui::ToolRail*>();
  const QRect covered(bar->mapTo(&window(), QPoint()), bar->size());
  QVERIFY(!covered.intersects(QRect(tools->mapTo(&window(), QPoint()), tools->size())));
  QVERIFY(window().viewport().geometry().width() >= bar->geometry().right());
}

void MainWindowTest::theTitleTellsNameAndChange() {
  QVERIFY(openBar());
  QVERIFY(window().windowTitle().startsWith("shape.obj"));
  QVERIFY(!window().isWindowModified());
  QVERIFY(document().perform(smallMove(document())));
  QVERIFY(window().isWindowModified());
  QVERIFY(window().windowTitle().contains("(changed)"));
  QVERIFY(window().files().saveTo(open_->folder.filePath("bar.pbffd")));
  QVERIFY(window().windowTitle().startsWith("bar.pbffd"));
  QVERIFY(!window().windowTitle().contains("(changed)"));
}

void MainWindowTest::unsavedWorkIsAskedAbout() {
  QVERIFY(openBar());
  QVERIFY(document().perform(smallMove(document())));
  answerSaveQuestion(QMessageBox::Cancel);
  QVERIFY(!window().close());
  QVERIFY(window().isVisible());
  answerSaveQuestion(QMessageBox::Discard);
  QVERIFY(window().close());
}

void MainWindowTest::actionsAreGreyedWithAReason() {
  for (const ActionId id : {ActionId::save, ActionId::selectAll, ActionId::frameAll, ActionId::toolMove}) {
    QVERIFY(!action(id).isEnabled());
    QVERIFY(action(id).toolTip().contains("Open a mesh"));
  }
  QVERIFY(openBar());
  QVERIFY(action(ActionId::selectAll).isEnabled());
  QVERIFY(!action(ActionId::disablePoints).isEnabled());
  QVERIFY(action(ActionId::disablePoints).statusTip().contains("Select"));
  action(ActionId::selectAll).trigger();
  QVERIFY(action(ActionId::disablePoints).isEnabled());
  QVERIFY(!action(ActionId::redo).isEnabled());
  QVERIFY(!action(ActionId::level4).isEnabled());
}

void MainWindowTest::undoSaysWhatItUndoes() {
  QVERIFY(openBar());
  QVERIFY(document().perform(smallMove(document())));
  QCOMPARE(action(ActionId::undo).text(), QString("Undo Move 3 points by 0, 0.2, 0"));
  open_->key(Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(action(ActionId::redo).text(), QString("Redo Move 3 points by 0, 0.2, 0"));
}

void MainWindowTest::lettersActInTheViewAlone() {
  QVERIFY(openBar());
  window().viewport().surface()->setFocus();
  QTest::keyClick(window().viewport().surface(), Qt::Key_G);
  QVERIFY(action(ActionId::toolMove).isChecked());
  QTest::keyClick(window().viewport().surface(), Qt::Key_Q);
  QVERIFY(action(ActionId::toolSelect).isChecked());
  open_->key(Qt::Key_F, Qt::ControlModifier);
  auto* filter = qobject_cast<QLineEdit*>(window().focusWidget());
  QVERIFY(filter != nullptr);
  QTest::keyClicks(filter, "g1");
  QCOMPARE(filter->text(), QString("g1"));
  QVERIFY(action(ActionId::toolSelect).isChecked());
  QCOMPARE(document().selection().level(), 3);
}

void MainWindowTest::aMoveTakesTheKeysFromAnyPane() {
  QVERIFY(openBar());
  document().selection().replace(firstPoints(document(), 4));
  // A new mesh begins with its number of points in the placement panel.
  QVERIFY(window().focusWidget() != window().viewport().surface());
  const Vec3 before = document().shown().controls.finest()[0].pose.center;
  for (const Qt::Key key : {Qt::Key_G, Qt::Key_Y, Qt::Key_1, Qt::Key_Return}) {
    QTest::keyClick(window().focusWidget(), key);
  }
  QCOMPARE(document().shown().controls.finest()[0].pose.center.y(), before.y() + 1.0);
  QCOMPARE(document().selection().level(), 3);
}

void MainWindowTest::escapeCancelsLongWork() {
  QVERIFY(openBar());
  document().selection().replace(firstPoints(document(), 3));
  const int steps = document().history().count();
  document().jobs().start({"edit", "Waiting", [](const Progress& progress) -> ui::JobRunner::Deliver {
                             for (;;) {
                               progress.throwIfCancelled();
                               QThread::msleep(5);
                             }
                           }});
  QVERIFY(document().jobs().isRunning());
  QTest::keyClick(window().viewport().surface(), Qt::Key_Escape);
  QTRY_VERIFY(!document().jobs().isRunning());
  QCOMPARE(document().selection().points().size(), std::size_t{3});
  QCOMPARE(document().history().count(), steps);
  QTest::keyClick(window().viewport().surface(), Qt::Key_Escape);
  QVERIFY(document().selection().points().empty());
}

void MainWindowTest::refineHereIsUndone() {
  QVERIFY(openBar());
  QVERIFY(!action(ActionId::refineHere).isEnabled());
  const auto points = firstPoints(document(), 4);
  document().selection().replace(points);
  action(ActionId::refineHere).trigger();
  QVERIFY(finishJobs(document()));
  QCOMPARE(document().shown().controls.finest().size(), 204);
  action(ActionId::undo).trigger();
  QCOMPARE(document().shown().controls.finest().size(), 200);
  QCOMPARE(document().selection().points(), points);
  // Those that were refined are selected with those that came.
  action(ActionId::redo).trigger();
  QCOMPARE(document().shown().controls.finest().size(), 204);
  QCOMPARE(document().selection().points().size(), std::size_t{8});
}

void MainWindowTest::treeAndSelectionAreOne() {
  QVERIFY(openBar());
  ui::SceneTree& tree = window().docks().scene().tree();
  auto& model = *static_cast<ui::SceneModel*>(tree.model());
  const auto points = firstPoints(document(), 3);
  document().selection().replace(points);
  QCOMPARE(tree.selectionModel()->selectedRows().size(), 3);
  const QModelIndex row = model.pointIndex(3, points[1]);
  tree.scrollTo(row);
  QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, tree.visualRect(row).center());
  QCOMPARE(document().selection().points(), std::vector<PointId>{points[1]});
  QTest::mouseClick(tree.viewport(), Qt::LeftButton, Qt::ControlModifier,
                    tree.visualRect(model.pointIndex(3, points[2])).center());
  QCOMPARE(document().selection().points(), std::vector<PointId>({points[1], points[2]}));
  // The tick beside a row does not select it.
  const QModelIndex tick = model.pointIndex(3, points[0]).siblingAtColumn(ui::SceneModel::tickColumn);
  QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, tree.visualRect(tick).center());
  QVERIFY(!document().shown().controls.finest()[0].enabled);
  QCOMPARE(document().selection().points().size(), std::size_t{2});
}

void MainWindowTest::theEditLevelIsAKey() {
  QVERIFY(openBar());
  QTest::keyClick(window().viewport().surface(), Qt::Key_1);
  QCOMPARE(document().selection().level(), 1);
  action(ActionId::selectAll).trigger();
  QCOMPARE(document().selection().points().size(), std::size_t{50});
  action(ActionId::selectChildren).trigger();
  QCOMPARE(document().selection().level(), 2);
  QCOMPARE(document().selection().points().size(), std::size_t{100});
  action(ActionId::levelDown).trigger();
  QCOMPARE(document().selection().level(), 3);
  QCOMPARE(document().selection().points().size(), std::size_t{200});
  action(ActionId::selectNone).trigger();
  action(ActionId::levelUp).trigger();
  QCOMPARE(document().selection().level(), 2);
}

void MainWindowTest::themesSwitchLive() {
  QVERIFY(openBar());
  action(ActionId::themeLight).trigger();
  const QColor light = window().grab().toImage().pixelColor(window().width() - 3, window().height() - 3);
  action(ActionId::themeDark).trigger();
  const QColor dark = window().grab().toImage().pixelColor(window().width() - 3, window().height() - 3);
  QVERIFY(light.lightness() > 200);
  QVERIFY(dark.lightness() < 60);
}

void MainWindowTest::theStatusTellsWhenTheMeshIsSimplified() {
  auto* label = window().findChild<QLabel*>("simplified");
  QVERIFY(label != nullptr && !label->isVisible());
  Q_EMIT window().viewport().simplifiedChanged(true);
  QTRY_VERIFY(label->isVisible());
  Q_EMIT window().viewport().simplifiedChanged(false);
  QTRY_VERIFY(!label->isVisible());
}

void MainWindowTest::panesAreReachedByF6() {
  QVERIFY(openBar());
  QSet<QWidget*> reached;
  for (int press = 0; press < 14; ++press) {
    open_->key(Qt::Key_F6);
    reached.insert(window().focusWidget());
  }
  QVERIFY(reached.contains(window().viewport().surface()));
  QVERIFY(reached.contains(&window().docks().scene().tree()));
  QVERIFY(reached.size() >= 6);
}

void MainWindowTest::docksHideAndComeBack() {
  QVERIFY(openBar());
  action(ActionId::showHistory).trigger();
  QVERIFY(!window().findChild<QDockWidget*>("history")->isVisible());
  action(ActionId::hideDocks).trigger();
  QVERIFY(!window().docks().scene().isVisible());
  action(ActionId::hideDocks).trigger();
  QVERIFY(window().docks().scene().isVisible());
  QVERIFY(!window().findChild<QDockWidget*>("history")->isVisible());
  action(ActionId::resetLayout).trigger();
  QVERIFY(window().findChild<QDockWidget*>("history")->isVisible());
  window().resize(1150, 800);
  QTest::qWait(50);
  QVERIFY(!window().tabifiedDockWidgets(window().findChild<QDockWidget*>("inspector")).isEmpty());
}

void MainWindowTest::dropsAreTakenOrRefused() {
  const QString path = writeShape(open_->folder, cylinder());
  QVERIFY(ui::DocumentFiles::reasonAgainst({path}).isEmpty());
  QVERIFY(!ui::DocumentFiles::reasonAgainst({path, path}).isEmpty());
  QVERIFY(!ui::DocumentFiles::reasonAgainst({open_->folder.path()}).isEmpty());
  QVERIFY(!ui::DocumentFiles::reasonAgainst({open_->folder.filePath("missing.obj")}).isEmpty());
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(path)});
  QDropEvent drop(QPointF(500, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  // The application hands drops on only to where a drag was seen to enter.
  static_cast<QObject&>(window()).event(&drop);
  QTRY_VERIFY_WITH_TIMEOUT(document().isOpen(), patience);
  QVERIFY(finishJobs(document()));
}

void MainWindowTest::everyShortcutIsGivenOnce() {
  QMap<QKeySequence, QString> owners;
  for (const QAction* each : window().actions().all()) {
    for (const QKeySequence& key : each->shortcuts()) {
      QVERIFY2(!key.isEmpty(), qPrintable(each->text()));
      QVERIFY2(!owners.contains(key), qPrintable(each->text() + " and " + owners[key]));
      owners[key] = each->text();
    }
  }
}

void MainWindowTest::everyControlHasAName() {
  QVERIFY(openBar());
  document().selection().replace(firstPoints(document(), 1));
  QTest::qWait(50);
  for (QWidget* widget : window().findChildren<QWidget*>()) {
    const bool isControl = (widget->focusPolicy() & Qt::TabFocus) && widget->isVisible();
    if (!isControl || widget->objectName().startsWith("qt_")) {
      continue;
    }
    const auto* button = qobject_cast<QAbstractButton*>(widget);
    const bool isNamed =
        !widget->accessibleName().isEmpty() || (button != nullptr && !button->text().isEmpty());
    QVERIFY2(isNamed || widget == window().viewport().surface(), widget->metaObject()->className());
  }
}

void MainWindowTest::noSettingsAreTouched() {
  QVERIFY(openBar());
  QVERIFY(window().close());
  QVERIFY(QSettings().allKeys().isEmpty());
}

const Registration<MainWindowTest> registration;

}  // namespace pbffd::test

#include "main_window_test.moc"
