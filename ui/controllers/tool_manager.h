#pragma once

#include "ui/controllers/tool.h"
#include "ui/controllers/transform_options.h"

#include <QPointF>

#include <map>
#include <memory>

namespace pbffd::ui {

class Document;
class Theme;
class ViewState;
class Viewport;

/// Holds the tools of a viewport, one of them active, and passes it the mouse and the keys that reach the
/// view.
class ToolManager : public QObject {
  Q_OBJECT

 public:
  ToolManager(Document& document, Viewport& viewport, const Theme& theme, QObject* parent = nullptr);
  ~ToolManager() override;

  const Tool& active() const { return *active_; }
  const Tool& tool(ToolId id) const { return *tools_.at(id); }
  void setActive(ToolId id);
  /// What a tool's key does: makes it active, and with points selected starts moving, rotating or scaling them
  /// with the mouse, no button held.
  void trigger(ToolId id);

  TransformOptions& options() { return options_; }
  bool isBusy() const { return active_->isBusy(); }
  /// Drops the gesture that is going on, exactly.
  void cancel() { active_->cancel(); }

  bool eventFilter(QObject* watched, QEvent* event) override;

 Q_SIGNALS:
  void activeChanged(ToolId id);
  /// See Tool::hint.
  void hintChanged(const QString& hint);
  /// Right click that ends no gesture: a context menu belongs there. `position` in the view's coordinates.
  void menuRequested(const QPoint& position);

 private:
  bool filterKey(QKeyEvent& event);
  void loseFocus(Qt::FocusReason reason);

  Document& document_;
  Viewport& viewport_;
  TransformOptions options_;
  std::map<ToolId, std::unique_ptr<Tool>> tools_;
  Tool* active_ = nullptr;
  QPointF cursor_;
};

}  // namespace pbffd::ui
