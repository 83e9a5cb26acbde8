#include "ui/window/docks.h"

#include "ui/controllers/actions.h"
#include "ui/models/message_model.h"
#include "ui/window/dock.h"
#include "ui/window/history_panel.h"
#include "ui/window/inspector_panel.h"
#include "ui/window/messages_panel.h"
#include "ui/window/placement_panel.h"
#include "ui/window/scene_panel.h"
#include "ui/window/scene_tree.h"

#include <QApplication>
#include <QClipboard>
#include <QMainWindow>
#include <QMenu>
#include <algorithm>
#include <utility>

namespace pbffd::ui {
namespace {

constexpr int leftWidth = 268;
constexpr int rightWidth = 308;
constexpr int bottomHeight = 150;
/// Of the menu, options and status bars.
constexpr int chromeHeight = 100;
constexpr int narrowBelow = 1280;
/// Raised when docks change, so that an old layout is not laid over new ones.
constexpr int layoutVersion = 1;

enum Place : std::size_t { scenePlace, inspectorPlace, placementPlace, historyPlace, messagesPlace };

ActionId actionOf(std::size_t place) {
  return static_cast<ActionId>(static_cast<std::size_t>(ActionId::showScene) + place);
}

}  // namespace

Docks::Docks(QMainWindow& window, const Sources& sources)
    : QObject(&window),
      window_(window),
      sources_(sources),
      scene_(new ScenePanel(sources.document, sources.view, sources.theme)),
      inspector_(new InspectorPanel(sources.document, sources.theme)),
      placement_(new PlacementPanel(sources.document, sources.theme)),
      history_(new HistoryPanel(sources.document, sources.theme)),
      messagesPanel_(new MessagesPanel(sources.messages, sources.theme)) {
  auto* historyMenu = new QMenu(&window);
  historyMenu->addAction(sources.actions[ActionId::saveEdits]);
  historyMenu->addAction(sources.actions[ActionId::runEdits]);
  auto* messagesMenu = new QMenu(&window);
  messagesMenu->addAction(tr("Copy all"), this, [&messages = sources.messages] {
    QApplication::clipboard()->setText(messages.toText());
  });
  messagesMenu->addAction(tr("Clear"), &sources.messages, &MessageModel::clear);

  const Theme& theme = sources.theme;
  docks_ = {new Dock(theme, {tr("Scene"), "scene"}, scene_),
            new Dock(theme, {tr("Inspector"), "inspector"}, inspector_),
            new Dock(theme, {tr("Placement"), "placement"}, placement_),
            new Dock(theme, {tr("History"), "history", false, historyMenu}, history_),
            new Dock(theme, {tr("Messages"), "messages", false, messagesMenu}, messagesPanel_)};
  scene_->setMinimumWidth(200);
  inspector_->setMinimumWidth(280);
  placement_->setMinimumWidth(280);
  history_->setMinimumSize(180, 64);
  messagesPanel_->setMinimumSize(180, 64);
  window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  connect(history_, &HistoryPanel::noteChanged, docks_[historyPlace], &Dock::setNote);
  connect(&sources.messages, &QAbstractItemModel::rowsInserted, this, &Docks::countUnread);
  connect(docks_[messagesPlace], &QDockWidget::visibilityChanged, this, [this](bool visible) {
    if (visible) {
      unread_ = 0;
      docks_[messagesPlace]->setBadge(0);
    }
  });
  connectActions();
  resetLayout();
}

void Docks::connectActions() {
  for (std::size_t place = 0; place < docks_.size(); ++place) {
    QAction* action = sources_.actions[actionOf(place)];
    Dock* dock = docks_[place];
    connect(action, &QAction::triggered, dock, [dock](bool on) {
      dock->setVisible(on);
      if (on) {
        dock->raise();
      }
    });
    connect(dock->toggleViewAction(), &QAction::toggled, action, &QAction::setChecked);
    action->setChecked(!dock->isHidden());
  }
  connect(sources_.actions[ActionId::hideDocks], &QAction::triggered, this, &Docks::hideAll);
  connect(sources_.actions[ActionId::resetLayout], &QAction::triggered, this, &Docks::resetLayout);
}

void Docks::resetLayout() {
  for (Dock* dock : docks_) {
    dock->setFloating(false);
    window_.removeDockWidget(dock);
  }
  window_.addDockWidget(Qt::LeftDockWidgetArea, docks_[scenePlace]);
  window_.addDockWidget(Qt::RightDockWidgetArea, docks_[inspectorPlace]);
  window_.addDockWidget(Qt::RightDockWidgetArea, docks_[placementPlace]);
  window_.addDockWidget(Qt::BottomDockWidgetArea, docks_[historyPlace]);
  window_.splitDockWidget(docks_[historyPlace], docks_[messagesPlace], Qt::Horizontal);
  for (Dock* dock : docks_) {
    dock->show();
  }
  isNarrow_ = false;
  hidden_.clear();
  sources_.actions[ActionId::hideDocks]->setChecked(false);
  fitTo(window_.width());
  giveSizes();
}

QByteArray Docks::layout() const {
  return wasShown_ && isShown_ ? window_.saveState(layoutVersion) : QByteArray();
}

/// The sizes of the design; what the window has more goes to the view and the inspector.
void Docks::giveSizes() {
  window_.resizeDocks({docks_[scenePlace], docks_[inspectorPlace]}, {leftWidth, rightWidth}, Qt::Horizontal);
  window_.resizeDocks({docks_[historyPlace]}, {bottomHeight}, Qt::Vertical);
  const int between = window_.width() - leftWidth - rightWidth;
  window_.resizeDocks({docks_[historyPlace], docks_[messagesPlace]}, {between * 45 / 100, between * 55 / 100},
                      Qt::Horizontal);
  if (!isNarrow_) {
    // All of the placement panel without a scroll bar, as long as its page of more is folded.
    const int placementHeight = docks_[placementPlace]->titleBarWidget()->sizeHint().height() +
                                placement_->widget()->sizeHint().height();
    const int rest = std::max(200, window_.height() - chromeHeight - placementHeight);
    window_.resizeDocks({docks_[inspectorPlace], docks_[placementPlace]}, {rest, placementHeight},
                        Qt::Vertical);
  }
}

void Docks::fitTo(int width) {
  const bool isNarrow = width < narrowBelow;
  if (isNarrow == isNarrow_ || !isShown_) {
    return;
  }
  isNarrow_ = isNarrow;
  if (isNarrow) {
    window_.tabifyDockWidget(docks_[inspectorPlace], docks_[placementPlace]);
    docks_[inspectorPlace]->raise();
  } else {
    window_.splitDockWidget(docks_[inspectorPlace], docks_[placementPlace], Qt::Vertical);
  }
}

void Docks::setShown(bool shown) {
  if (shown == isShown_) {
    return;
  }
  isShown_ = shown;
  hideAll(!shown);
  sources_.actions[ActionId::hideDocks]->setChecked(false);
  if (shown && !std::exchange(wasShown_, true)) {
    if (!window_.restoreState(firstLayout_, layoutVersion)) {
      // Sizes hold once the docks are laid out.
      QMetaObject::invokeMethod(this, &Docks::giveSizes, Qt::QueuedConnection);
    }
  }
}

void Docks::hideAll(bool hidden) {
  if (hidden) {
    hidden_.clear();
    for (Dock* dock : docks_) {
      if (!dock->isHidden()) {
        hidden_.push_back(dock);
        dock->hide();
      }
    }
    return;
  }
  for (Dock* dock : std::exchange(hidden_, {})) {
    dock->show();
  }
}

void Docks::countUnread() {
  if (!messagesPanel_->isVisible()) {
    docks_[messagesPlace]->setBadge(++unread_);
  }
}

std::vector<QWidget*> Docks::panes() const {
  std::vector<QWidget*> shown;
  const std::vector<QWidget*> all{&scene_->tree(), inspector_, placement_, history_, messagesPanel_};
  for (QWidget* pane : all) {
    if (pane->isVisible()) {
      shown.push_back(pane);
    }
  }
  return shown;
}

}  // namespace pbffd::ui
