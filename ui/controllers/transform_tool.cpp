#include "ui/controllers/transform_tool.h"

#include "ui/controllers/move_gesture.h"
#include "ui/controllers/rotate_gesture.h"
#include "ui/controllers/scale_gesture.h"
#include "ui/document/document.h"
#include "ui/views/viewport.h"

namespace pbffd::ui {

TransformTool::TransformTool(const ToolContext& context, GizmoKind kind, QObject* parent)
    : SelectTool(context, parent), kind_(kind) {
  const auto follow = [this] {
    if (isActive_ && !isBusy()) {
      placeGizmo();
    }
  };
  connect(&context.document, &Document::changed, this, follow);
  connect(&context.document, &Document::opened, this, follow);
  connect(&context.document.selection(), &Selection::changed, this, follow);
  connect(&context.document.selection(), &Selection::levelChanged, this, follow);
  connect(&context.options, &TransformOptions::changed, this, follow);
  connect(&context.viewport, &Viewport::cameraChanged, this, [this, follow] {
    if (this->context().options.axes() == AxesChoice::view) {
      follow();
    }
  });
}

ToolId TransformTool::id() const {
  return kind_ == GizmoKind::rotate ? ToolId::rotate : kind_ == GizmoKind::scale ? ToolId::scale : ToolId::move;
}

QString TransformTool::name() const {
  return kind_ == GizmoKind::rotate ? tr("Rotate") : kind_ == GizmoKind::scale ? tr("Scale") : tr("Move");
}

QString TransformTool::iconName() const {
  return kind_ == GizmoKind::rotate  ? QStringLiteral("rotate")
         : kind_ == GizmoKind::scale ? QStringLiteral("scale")
                                     : QStringLiteral("move");
}

QString TransformTool::idleHint() const {
  if (!subject()) {
    return tr("Click a point to select it  Drag boxes");
  }
  switch (kind_) {
    case GizmoKind::rotate:
      return tr("Drag a ring  [R] rotates with the mouse");
    case GizmoKind::scale:
      return tr("Drag a cube  [S] scales with the mouse");
    default:
      return tr("Drag an arrow or a point  [G] moves with the mouse");
  }
}

void TransformTool::activate() {
  isActive_ = true;
  placeGizmo();
}

void TransformTool::deactivate() {
  SelectTool::deactivate();
  isActive_ = false;
  hovered_ = GizmoPart::none;
  context().viewport.setGizmo({});
}

void TransformTool::cursorLeft() {
  SelectTool::cursorLeft();
  if (!isBusy() && hovered_ != GizmoPart::none) {
    hovered_ = GizmoPart::none;
    placeGizmo();
  }
}

void TransformTool::gestureEnded() {
  if (isActive_) {
    placeGizmo();
  }
}

void TransformTool::placeGizmo() {
  Gizmo gizmo;
  if (const auto chosen = subject()) {
    gizmo.kind = kind_;
    gizmo.center = chosen->pivot;
    gizmo.axes = chosen->gizmoAxes;
    gizmo.hovered = hovered_;
  }
  context().viewport.setGizmo(gizmo);
  publishHint();
}

std::unique_ptr<TransformGesture> TransformTool::gestureOf(GizmoPart part, const QPointF& position) const {
  const auto chosen = subject();
  if (!chosen) {
    return nullptr;
  }
  switch (kind_) {
    case GizmoKind::rotate:
      return std::make_unique<RotateGesture>(
          *chosen, lockOf(part), position,
          part == GizmoPart::ball ? RotateGesture::Manner::ball : RotateGesture::Manner::ring);
    case GizmoKind::scale:
      return std::make_unique<ScaleGesture>(*chosen, lockOf(part), position);
    default:
      return std::make_unique<MoveGesture>(*chosen, lockOf(part), position);
  }
}

std::unique_ptr<TransformGesture> TransformTool::gestureAt(const QPointF& position) {
  const GizmoPart part = context().viewport.gizmoPartAt(position);
  if (part == GizmoPart::none) {
    return SelectTool::gestureAt(position);
  }
  return gestureOf(part, position);
}

bool TransformTool::isOnGizmo(const QPointF& position) const {
  const GizmoPart part = context().viewport.gizmoPartAt(position);
  return part != GizmoPart::none && part != GizmoPart::ball;
}

std::unique_ptr<TransformGesture> TransformTool::modalGesture(const QPointF& position) {
  return gestureOf(GizmoPart::none, position);
}

void TransformTool::hover(const QPointF& position) {
  const GizmoPart part = context().viewport.gizmoPartAt(position);
  if (part != hovered_) {
    hovered_ = part;
    placeGizmo();
  }
  // The ball covers points, which one may want to click.
  if (part == GizmoPart::none || part == GizmoPart::ball) {
    showHovered(position);
    return;
  }
  context().viewport.setHoveredPoint(0);
  context().viewport.surface()->setCursor(Qt::SizeAllCursor);
}

}  // namespace pbffd::ui
