#include "ui/window/main_window.h"

#include "ui/controllers/actions.h"
#include "ui/controllers/point_commands.h"
#include "ui/controllers/tool_manager.h"
#include "ui/document/job_runner.h"
#include "ui/views/viewport.h"
#include "ui/window/apply_to_other.h"
#include "ui/window/docks.h"
#include "ui/window/document_files.h"
#include "ui/window/error_bar.h"
#include "ui/window/inspector_panel.h"
#include "ui/window/menus.h"
#include "ui/window/options_bar.h"
#include "ui/window/placement_panel.h"
#include "ui/window/recent_files.h"
#include "ui/window/scene_panel.h"
#include "ui/window/scene_tree.h"
#include "ui/window/shortcuts_dialog.h"
#include "ui/window/start_page.h"
#include "ui/window/status_line.h"
#include "ui/window/transform_bar.h"
#include "ui/window/view_overlays.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QSlider>
#include <QStackedWidget>

namespace pbffd::ui {
namespace {

constexpr int errorBarTop = 60;
constexpr int errorBarMostWidth = 720;
constexpr int errorBarGap = 12;

QStringList pathsOf(const QMimeData* data) {
  QStringList paths;
  for (const QUrl& url : data->urls()) {
    paths += url.toLocalFile();
  }
  return paths;
}

}  // namespace

MainWindow::MainWindow(const Options& options)
    : options_(options),
      recent_(std::make_unique<RecentFiles>(options.remembers)),
      actions_(std::make_unique<Actions>(document_, view_, theme_)),
      commands_(std::make_unique<PointCommands>(*actions_, document_, view_)) {
  setMinimumSize(1100, 700);
  resize(1600, 1000);
  setAcceptDrops(true);
  setDockNestingEnabled(true);
  setAnimated(false);  // each step of it would be a frame
  setContextMenuPolicy(Qt::NoContextMenu);
  chooseTheme(options.theme);
  files_ = new DocumentFiles({document_, view_, theme_, *recent_}, *actions_, *this);
  new ApplyToOther(options.apply, document_, *actions_, *this);
  makeMenus(*this, {*actions_, *recent_, *files_});
  optionsBar_ = new OptionsBar(*actions_, document_, theme_);
  addToolBar(Qt::TopToolBarArea, optionsBar_);
  status_ = new StatusLine(document_, theme_);
  setStatusBar(status_);
  makeCentre();
  docks_ = new Docks(*this, {*actions_, document_, view_, theme_, messages_});
  actions_->addLetterKeysTo(*viewport_);
  actions_->addLetterKeysTo(docks_->scene().tree());
  // The window holds the others, so that their keys work wherever the focus is.
  addActions({actions_->all().begin(), actions_->all().end()});
  connectDocument();
  connectActions();
  connectTools();
  showOpened();
  restoreLayout();
}

MainWindow::~MainWindow() {
  // What looks at the document, the theme and the view goes before them; a gesture that is going on is dropped.
  delete tools_;
  delete takeCentralWidget();
  delete docks_;
  qDeleteAll(findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly));
  delete optionsBar_;
  delete status_;
}

void MainWindow::makeCentre() {
  centre_ = new QStackedWidget;
  viewport_ = new Viewport(document_, view_, theme_);
  startPage_ = new StartPage(*actions_, *recent_, theme_);
  centre_->addWidget(startPage_);
  centre_->addWidget(viewport_);
  setCentralWidget(centre_);
  overlays_ = new ViewOverlays(*viewport_, {*actions_, document_, view_, theme_}, viewport_);
  errorBar_ = new ErrorBar(theme_, centre_);
  centre_->installEventFilter(this);
  // Not in the middle of a frame, which is when it is decided.
  connect(viewport_, &Viewport::simplifiedChanged, status_, &StatusLine::setSimplified, Qt::QueuedConnection);
  connect(
      viewport_, &Viewport::remarked, this, [this](const QString& text) { say(Severity::info, text); },
      Qt::QueuedConnection);
  connect(errorBar_, &ErrorBar::sizeChanged, this, &MainWindow::arrangeErrorBar);
  connect(startPage_, &StartPage::openAsked, this, &MainWindow::openFile);
}

void MainWindow::connectDocument() {
  connect(&document_, &Document::opened, this, &MainWindow::showOpened);
  connect(&document_.selection(), &Selection::levelsRenumbered, &view_, &ViewState::renumberLevels);
  connect(&document_, &Document::titleChanged, this, &MainWindow::showTitle);
  connect(&document_, &Document::failed, this, [this](const QString& text) { say(Severity::error, text); });
  connect(&document_, &Document::remarked, this, [this](const QString& text) { say(Severity::warning, text); });
  connect(&document_, &Document::informed, this, [this](const QString& text) { say(Severity::info, text); });
  connect(&document_.jobs(), &JobRunner::cancelled, this,
          [this](const QString& title) { say(Severity::info, tr("%1: cancelled.").arg(title)); });
}

void MainWindow::connectActions() {
  const auto on = [&](ActionId id, auto&& does) { connect((*actions_)[id], &QAction::triggered, this, does); };
  on(ActionId::quit, [this] { close(); });
  // In the middle of a drag, undo takes back the drag.
  on(ActionId::undo, [this] { tools_->isBusy() ? tools_->cancel() : document_.undo(); });
  on(ActionId::redo, [this] { tools_->isBusy() ? tools_->cancel() : document_.redo(); });
  on(ActionId::rename, [this] { docks_->scene().tree().renameCurrent(); });
  on(ActionId::find, [this] { docks_->scene().startFilter(); });
  on(ActionId::placeAgain, [this] { docks_->placement().placeAgain(); });
  on(ActionId::frameAll, [this] { viewport_->frameAll(); });
  on(ActionId::frameSelection, [this] { viewport_->frameSelection(); });
  using Side = Viewport::Side;
  const std::pair<ActionId, Side> sides[] = {
      {ActionId::viewFront, Side::front}, {ActionId::viewBack, Side::back},
      {ActionId::viewLeft, Side::left},   {ActionId::viewRight, Side::right},
      {ActionId::viewTop, Side::top},     {ActionId::viewBottom, Side::bottom}};
  for (const auto& [id, side] : sides) {
    on(id, [this, seen = side] { viewport_->lookFrom(seen); });
  }
  on(ActionId::fullScreen, [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
  on(ActionId::nextPane, [this] { goToNextPane(); });
  on(ActionId::themeSystem, [this] { chooseTheme(Theme::Choice::system); });
  on(ActionId::themeDark, [this] { chooseTheme(Theme::Choice::dark); });
  on(ActionId::themeLight, [this] { chooseTheme(Theme::Choice::light); });
  const auto showActions = [this] { ShortcutsDialog(*actions_, this).exec(); };
  on(ActionId::shortcuts, showActions);
  on(ActionId::findAction, showActions);
  on(ActionId::about, [this] { showAbout(); });
  connect(&docks_->inspector(), &InspectorPanel::backToRestAsked, (*actions_)[ActionId::poseToRest],
          &QAction::trigger);
  connect(files_, &DocumentFiles::pictureAsked, this, [this](const QString& path) {
    if (viewport_->picture().save(path)) {
      say(Severity::info, tr("Saved the picture %1.").arg(QFileInfo(path).fileName()));
    } else {
      say(Severity::error,
          tr("Could not write the picture %1. Choose another folder or free some space.").arg(path));
    }
  });
  connect(&docks_->scene().tree(), &SceneTree::menuAsked, this, &MainWindow::showPointMenu);
}

void MainWindow::connectTools() {
  tools_ = new ToolManager(document_, *viewport_, theme_, this);
  auto* options = new TransformBar(tools_->options(), *(*actions_)[ActionId::snap], this);
  options->hide();
  const auto actionOf = [this](ToolId id) {
    return actions_->all()[static_cast<std::size_t>(ActionId::toolSelect) + static_cast<std::size_t>(id)];
  };
  for (const ToolId id : {ToolId::select, ToolId::move, ToolId::rotate, ToolId::scale, ToolId::add}) {
    connect(actionOf(id), &QAction::triggered, tools_, [this, id] { tools_->trigger(id); });
  }
  const auto showTool = [this, options, actionOf](ToolId id) {
    const Tool& tool = tools_->tool(id);
    actionOf(id)->setChecked(true);
    optionsBar_->setTool(tool.name(), tool.iconName());
    optionsBar_->setToolOptions(id == ToolId::select || id == ToolId::add ? nullptr : options);
  };
  connect(tools_, &ToolManager::activeChanged, this, showTool);
  connect(tools_, &ToolManager::hintChanged, status_, &StatusLine::setHint);
  connect(tools_, &ToolManager::menuRequested, this,
          [this](const QPoint& position) { showPointMenu(viewport_->surface()->mapToGlobal(position)); });
  showTool(tools_->active().id());
}

void MainWindow::showPointMenu(const QPoint& position) {
  QMenu menu;
  menu.addAction((*actions_)[ActionId::rename]);
  menu.addSeparator();
  actions_->fill(menu, "Points");
  menu.exec(position);
}

void MainWindow::openFile(const QString& path) {
  files_->open(path);
}

void MainWindow::showOpened() {
  const bool isOpen = document_.isOpen();
  if (isOpen) {
    view_.reset();
    view_.restore(QByteArray::fromStdString(document_.extras().viewJson));
    errorBar_->hide();
  }
  if (tools_->isBusy()) {
    tools_->cancel();
  }
  centre_->setCurrentWidget(isOpen ? static_cast<QWidget*>(viewport_) : startPage_);
  optionsBar_->setVisible(isOpen);
  docks_->setShown(isOpen);
  if (isOpen) {
    docks_->fitTo(width());
    viewport_->frameAll();
    status_->setHint(tools_->active().hint());
    // A new mesh begins with its number of points; a project with its view.
    if (document_.path().isEmpty()) {
      docks_->placement().pointsSlider()->setFocus();
    } else {
      viewport_->surface()->setFocus();
    }
  } else {
    startPage_->setFocus();
    status_->setHint(tr("Nothing open  [Tab] next  [Enter] open what is marked"));
  }
  showTitle();
}

void MainWindow::showTitle() {
  const QString program = tr("PB-FFD Workbench");
  const bool isChanged = document_.isOpen() && document_.isModified();
  setWindowTitle(document_.isOpen()
                     ? QString("%1[*]%2 — %3")
                           .arg(document_.displayName(), isChanged ? tr(" (changed)") : QString(), program)
                     : program + "[*]");
  setWindowModified(isChanged);
}

void MainWindow::say(Severity severity, const QString& text) {
  messages_.add(severity, text);
  if (severity != Severity::info) {
    errorBar_->show(severity, text);
  }
}

void MainWindow::arrangeErrorBar() {
  // Beside the tools and below the view bar, or beside the title and the buttons of the start page: what has to
  // be done next may need them.
  const bool isOpen = document_.isOpen();
  const int left = (isOpen ? overlays_->toolsRight() : StartPage::sideWidthOf(centre_->width())) + errorBarGap;
  const int room = centre_->width() - left - errorBarGap;
  const int width = std::min(errorBarMostWidth, room);
  errorBar_->setFixedWidth(width);
  errorBar_->setFixedHeight(std::max(38, errorBar_->heightForWidth(width)));
  const int middle = isOpen ? (centre_->width() - width) / 2 : left + (room - width) / 2;
  errorBar_->move(std::max(left, middle), isOpen ? errorBarTop : errorBarGap);
}

void MainWindow::goToNextPane() {
  std::vector<QWidget*> panes = docks_->panes();
  if (centre_->currentWidget() == viewport_) {
    panes.insert(panes.begin() + (panes.empty() ? 0 : 1), viewport_->surface());
    panes.insert(panes.begin(), optionsBar_);
  } else {
    panes.insert(panes.begin(), startPage_);
  }
  std::size_t next = 0;
  for (std::size_t i = 0; i < panes.size(); ++i) {
    if (panes[i] == focusWidget() || panes[i]->isAncestorOf(focusWidget())) {
      next = (i + 1) % panes.size();
    }
  }
  QWidget* pane = panes[next];
  if (pane->focusPolicy() != Qt::NoFocus || pane->focusProxy() != nullptr) {
    return pane->setFocus(Qt::ShortcutFocusReason);
  }
  // A pane that takes no focus itself gives it to the first of its fields that does.
  for (QWidget* child : pane->findChildren<QWidget*>()) {
    if ((child->focusPolicy() & Qt::TabFocus) && child->isVisible() && child->isEnabled()) {
      return child->setFocus(Qt::ShortcutFocusReason);
    }
  }
}

void MainWindow::chooseTheme(Theme::Choice choice) {
  theme_.choose(choice);
  const auto first = static_cast<std::size_t>(ActionId::themeSystem);
  actions_->all()[first + static_cast<std::size_t>(choice)]->setChecked(true);
  if (options_.remembers) {
    QSettings().setValue("theme", static_cast<int>(choice));
  }
}

void MainWindow::showAbout() {
  QMessageBox::about(this, tr("About PB-FFD Workbench"),
                     tr("<b>PB-FFD Workbench %1</b><p>Reshape any mesh with a cloud of control points.</p>"
                        "<p>After K. T. McDonnell and H. Qin, <i>PB-FFD: A point-based technique for free-form "
                        "deformation</i>, Journal of Graphics Tools 12(3), 2007.</p>")
                         .arg(PBFFD_VERSION));
}

void MainWindow::restoreLayout() {
  if (!options_.remembers) {
    return;
  }
  const QSettings settings;
  restoreGeometry(settings.value("geometry").toByteArray());
  docks_->setFirstLayout(settings.value("layout").toByteArray());
}

void MainWindow::storeLayout() {
  if (options_.remembers) {
    QSettings settings;
    settings.setValue("geometry", saveGeometry());
    if (const QByteArray layout = docks_->layout(); !layout.isEmpty()) {
      settings.setValue("layout", layout);
    }
  }
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!files_->mayLeave()) {
    return event->ignore();
  }
  storeLayout();
  document_.jobs().cancel();
  event->accept();
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  if (docks_ != nullptr) {
    docks_->fitTo(width());
  }
}

/// What no other pane had a use for.
void MainWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && document_.jobs().isRunning()) {
    document_.jobs().cancel();
  } else {
    QMainWindow::keyPressEvent(event);
  }
}

bool MainWindow::eventFilter(QObject* object, QEvent* event) {
  if (object == centre_ && event->type() == QEvent::Resize) {
    arrangeErrorBar();
  }
  return QMainWindow::eventFilter(object, event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!event->mimeData()->hasUrls()) {
    return;
  }
  const QString reason = DocumentFiles::reasonAgainst(pathsOf(event->mimeData()));
  startPage_->showDrag(true, reason);
  // Refused files are let in all the same, so that the reason can be seen; the drop then does nothing.
  status_->showMessage(reason);
  event->setDropAction(reason.isEmpty() ? Qt::CopyAction : Qt::IgnoreAction);
  event->accept();
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent*) {
  startPage_->showDrag(false, {});
  status_->clearMessage();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QStringList paths = pathsOf(event->mimeData());
  startPage_->showDrag(false, {});
  status_->clearMessage();
  if (DocumentFiles::reasonAgainst(paths).isEmpty()) {
    event->acceptProposedAction();
    // After the drag has ended, for the question about unsaved work may come.
    QMetaObject::invokeMethod(
        this, [this, path = paths.front()] { openFile(path); }, Qt::QueuedConnection);
  }
}

}  // namespace pbffd::ui
