#include "ui/controllers/tool_manager.h"

#include "ui/controllers/add_tool.h"
#include "ui/controllers/transform_tool.h"
#include "ui/document/document.h"
#include "ui/document/job_runner.h"
#include "ui/views/viewport.h"

namespace pbffd::ui {

ToolManager::ToolManager(Document& document, Viewport& viewport, const Theme& theme, QObject* parent)
    : QObject(parent), document_(document), viewport_(viewport) {
  const ToolContext context{document, viewport, theme, options_};
  tools_[ToolId::select] = std::make_unique<SelectTool>(context);
  tools_[ToolId::move] = std::make_unique<TransformTool>(context, GizmoKind::move);
  tools_[ToolId::rotate] = std::make_unique<TransformTool>(context, GizmoKind::rotate);
  tools_[ToolId::scale] = std::make_unique<TransformTool>(context, GizmoKind::scale);
  tools_[ToolId::add] = std::make_unique<AddTool>(context);
  for (const auto& [id, tool] : tools_) {
    connect(tool.get(), &Tool::hintChanged, this, [this, changed = tool.get()](const QString& hint) {
      if (changed == active_) {
        Q_EMIT hintChanged(hint);
      }
    });
  }
  active_ = tools_[ToolId::select].get();
  // What is dragged must not be pulled away from under the gesture.
  connect(&document, &Document::opened, this, &ToolManager::cancel);
  connect(&document.selection(), &Selection::levelChanged, this, &ToolManager::cancel);
  connect(&document.history(), &QUndoStack::indexChanged, this, &ToolManager::cancel);
  cursor_ = viewport.surface()->rect().center();
  viewport.surface()->installEventFilter(this);
}

ToolManager::~ToolManager() {
  // The viewport may be gone by now: its surface has then forgotten this filter itself.
  tools_.clear();
}

void ToolManager::setActive(ToolId id) {
  Tool* const next = tools_.at(id).get();
  if (next == active_) {
    return;
  }
  active_->deactivate();
  active_ = next;
  active_->activate();
  Q_EMIT activeChanged(id);
  Q_EMIT hintChanged(active_->hint());
}

void ToolManager::trigger(ToolId id) {
  active_->cancel();
  setActive(id);
  auto* const transforming = dynamic_cast<TransformTool*>(active_);
  if (transforming != nullptr && transforming->startModal(cursor_)) {
    // The keys that follow (an axis, a number, Enter) are the gesture's, wherever the focus was.
    viewport_.surface()->setFocus(Qt::ShortcutFocusReason);
  }
}

bool ToolManager::filterKey(QKeyEvent& event) {
  if (active_->keyPress(event)) {
    return true;
  }
  const bool isPlain = (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
  if (!isPlain) {
    return false;
  }
  switch (event.key()) {
    case Qt::Key_Escape:
      if (document_.jobs().isRunning()) {
        return false;  // The window takes it, and cancels.
      }
      if (active_->id() != ToolId::select) {
        setActive(ToolId::select);
      } else {
        document_.selection().clear();
      }
      return true;
    case Qt::Key_Q:
      trigger(ToolId::select);
      return true;
    case Qt::Key_G:
      trigger(ToolId::move);
      return true;
    case Qt::Key_R:
      trigger(ToolId::rotate);
      return true;
    case Qt::Key_S:
      trigger(ToolId::scale);
      return true;
    case Qt::Key_A:
      trigger(ToolId::add);
      return true;
    default:
      return false;
  }
}

/// Whoever goes on elsewhere in the window has left the gesture, and its keys would go there.
void ToolManager::loseFocus(Qt::FocusReason reason) {
  if (reason != Qt::ActiveWindowFocusReason && reason != Qt::PopupFocusReason) {
    cancel();
  }
}

bool ToolManager::eventFilter(QObject*, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick: {
      const auto& mouse = *static_cast<QMouseEvent*>(event);
      cursor_ = mouse.position();
      const bool isUsed = active_->mousePress(mouse);
      if (!isUsed && mouse.button() == Qt::RightButton) {
        Q_EMIT menuRequested(mouse.position().toPoint());
        return true;
      }
      return isUsed;
    }
    case QEvent::MouseMove:
      cursor_ = static_cast<QMouseEvent*>(event)->position();
      return active_->mouseMove(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
      return active_->mouseRelease(*static_cast<QMouseEvent*>(event));
    case QEvent::ShortcutOverride:
      // During a gesture no letter and no figure is a shortcut of the window.
      event->setAccepted(active_->isBusy());
      return active_->isBusy();
    case QEvent::KeyPress:
      return filterKey(*static_cast<QKeyEvent*>(event));
    case QEvent::KeyRelease:
      return active_->keyRelease(*static_cast<QKeyEvent*>(event));
    case QEvent::FocusOut:
      loseFocus(static_cast<QFocusEvent*>(event)->reason());
      return false;
    case QEvent::Leave:
      active_->cursorLeft();
      return false;
    default:
      return false;
  }
}

}  // namespace pbffd::ui
