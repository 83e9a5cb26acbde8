#pragma once

#include "ui/controllers/select_tool.h"

namespace pbffd::ui {

/// Moves, rotates or scales the selected points by a gizmo; beside the gizmo it selects.
class TransformTool : public SelectTool {
  Q_OBJECT

 public:
  TransformTool(const ToolContext& context, GizmoKind kind, QObject* parent = nullptr);

  ToolId id() const override;
  QString name() const override;
  QString iconName() const override;

  void activate() override;
  void deactivate() override;
  void cursorLeft() override;

 protected:
  std::unique_ptr<TransformGesture> gestureAt(const QPointF& position) override;
  std::unique_ptr<TransformGesture> modalGesture(const QPointF& position) override;
  void hover(const QPointF& position) override;
  QString idleHint() const override;
  void gestureEnded() override;
  bool isOnGizmo(const QPointF& position) const override;

 private:
  std::unique_ptr<TransformGesture> gestureOf(GizmoPart part, const QPointF& position) const;
  /// Puts the gizmo where the selection is now.
  void placeGizmo();

  GizmoKind kind_;
  GizmoPart hovered_ = GizmoPart::none;
  bool isActive_ = false;
};

}  // namespace pbffd::ui
