#pragma once

#include "ui/controllers/tool.h"
#include "ui/controllers/transform_gesture.h"
#include "ui/controllers/transform_options.h"

#include <QPointF>

#include <memory>
#include <optional>
#include <vector>

namespace pbffd::ui {

class Document;
class Theme;
class Viewport;

/// What tools work on.
struct ToolContext {
  Document& document;
  Viewport& viewport;
  const Theme& theme;
  const TransformOptions& options;
};

/// Selects points by click and box, and moves selected points in the view plane. What the tools that
/// transform points build on: they put a gizmo in front of it.
class SelectTool : public Tool {
  Q_OBJECT

 public:
  explicit SelectTool(const ToolContext& context, QObject* parent = nullptr);
  ~SelectTool() override;

  ToolId id() const override { return ToolId::select; }
  QString name() const override { return tr("Select"); }
  QString iconName() const override { return QStringLiteral("select"); }
  QString hint() const override;

  void deactivate() override;
  bool mousePress(const QMouseEvent& event) override;
  bool mouseMove(const QMouseEvent& event) override;
  bool mouseRelease(const QMouseEvent& event) override;
  bool keyPress(const QKeyEvent& event) override;
  bool keyRelease(const QKeyEvent& event) override;
  void cursorLeft() override;
  bool isBusy() const override;
  void cancel() override;

  /// Starts a gesture that follows the mouse with no button held. False without points that can move.
  bool startModal(const QPointF& cursor);

 protected:
  const ToolContext& context() const { return context_; }

  /// The gesture that a press there would start if it turns into a drag; none for a box or a click.
  virtual std::unique_ptr<TransformGesture> gestureAt(const QPointF& position);
  /// The gesture of the tool's key.
  virtual std::unique_ptr<TransformGesture> modalGesture(const QPointF& position);
  virtual void hover(const QPointF& position);
  virtual QString idleHint() const;
  virtual void gestureEnded() {}
  /// Clicks there are not meant for what lies behind.
  virtual bool isOnGizmo(const QPointF&) const { return false; }

  /// The selected points that can be moved, and the axes to move them along; none when there are none.
  std::optional<GestureSubject> subject() const;
  void publishHint();
  void showHovered(const QPointF& position);

 private:
  enum class State { idle, pressed, boxing, dragging, modal };

  void click(const QPointF& position, Qt::KeyboardModifiers modifiers);
  void selectBox(Qt::KeyboardModifiers modifiers);
  void beginDrag();
  void follow(const QPointF& position, Qt::KeyboardModifiers modifiers);
  void showGesture();
  void confirm();
  void finishGesture();
  bool gestureKey(const QKeyEvent& event);

  ToolContext context_;
  State state_ = State::idle;
  QPointF pressedAt_;
  QPointF cursor_;
  std::unique_ptr<TransformGesture> gesture_;
  std::vector<PointId> selectedBefore_;
  bool changedSelection_ = false;
  /// The last click, so that another in its place takes the next point behind.
  QPointF clickedAt_;
  std::vector<PointId> clickedPoints_;
  std::size_t clickedPlace_ = 0;
};

}  // namespace pbffd::ui
