#include "ui/controllers/select_tool.h"

#include "ui/controllers/gesture_subject.h"
#include "ui/controllers/move_gesture.h"
#include "ui/document/document.h"
#include "ui/document/theme.h"
#include "ui/views/viewport.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pbffd::ui {
namespace {

constexpr double dragThreshold = 4.0;
constexpr double samePlace = 3.0;

double distanceBetween(const QPointF& a, const QPointF& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

bool isConfirmation(int key) {
  return key == Qt::Key_Return || key == Qt::Key_Enter;
}

}  // namespace

SelectTool::SelectTool(const ToolContext& context, QObject* parent) : Tool(parent), context_(context) {}

SelectTool::~SelectTool() = default;

bool SelectTool::isBusy() const {
  return state_ == State::boxing || state_ == State::dragging || state_ == State::modal;
}

QString SelectTool::idleHint() const {
  return tr("Click selects  [Shift] adds  Drag boxes");
}

QString SelectTool::hint() const {
  if (gesture_ != nullptr) {
    return QStringLiteral("%1  %2").arg(gesture_->title(), gesture_->keyHints());
  }
  if (state_ == State::boxing) {
    return tr("Selecting in the box  [Shift] adds  [Ctrl] removes  [Esc] cancel");
  }
  if (clickedPoints_.size() > 1) {
    return tr("%1 of %2 here, click again for the next  %3")
        .arg(clickedPlace_ + 1)
        .arg(clickedPoints_.size())
        .arg(idleHint());
  }
  return idleHint();
}

void SelectTool::publishHint() {
  Q_EMIT hintChanged(hint());
}

void SelectTool::deactivate() {
  cancel();
  context_.viewport.setHoveredPoint(0);
  context_.viewport.surface()->unsetCursor();
}

std::optional<GestureSubject> SelectTool::subject() const {
  return selectedSubject(context_.document, context_.options, context_.viewport.camera().axes());
}

std::unique_ptr<TransformGesture> SelectTool::gestureAt(const QPointF& position) {
  const std::vector<PointId> points = context_.viewport.pointsAt(position);
  Selection& selection = context_.document.selection();
  const bool isOnSelected =
      std::any_of(points.begin(), points.end(), [&](PointId id) { return selection.contains(id); });
  if (points.empty()) {
    return nullptr;
  }
  if (!isOnSelected) {
    // Dragging a point that is not selected selects it on the way.
    selection.replace({points.front()});
    changedSelection_ = true;
  }
  const auto moved = subject();
  return moved ? std::make_unique<MoveGesture>(*moved, AxisLock{}, position) : nullptr;
}

std::unique_ptr<TransformGesture> SelectTool::modalGesture(const QPointF& position) {
  const auto moved = subject();
  return moved ? std::make_unique<MoveGesture>(*moved, AxisLock{}, position) : nullptr;
}

bool SelectTool::mousePress(const QMouseEvent& event) {
  cursor_ = event.position();
  if (state_ == State::modal && event.button() == Qt::LeftButton) {
    confirm();
    return true;
  }
  if (event.button() == Qt::RightButton && state_ != State::idle) {
    cancel();
    return true;
  }
  if (event.button() != Qt::LeftButton || event.modifiers().testFlag(Qt::AltModifier)) {
    return false;
  }
  if (state_ == State::idle && context_.document.isOpen()) {
    state_ = State::pressed;
    pressedAt_ = event.position();
  }
  return true;
}

bool SelectTool::mouseMove(const QMouseEvent& event) {
  cursor_ = event.position();
  switch (state_) {
    case State::idle:
      hover(cursor_);
      return false;
    case State::pressed:
      if (distanceBetween(cursor_, pressedAt_) >= dragThreshold) {
        beginDrag();
        follow(cursor_, event.modifiers());
      }
      return true;
    default:
      follow(cursor_, event.modifiers());
      return true;
  }
}

bool SelectTool::mouseRelease(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) {
    return false;
  }
  switch (state_) {
    case State::pressed:
      state_ = State::idle;
      click(event.position(), event.modifiers());
      break;
    case State::boxing:
      state_ = State::idle;
      selectBox(event.modifiers());
      break;
    case State::dragging:
      follow(event.position(), event.modifiers());
      confirm();
      break;
    default:
      break;
  }
  return true;
}

void SelectTool::click(const QPointF& position, Qt::KeyboardModifiers modifiers) {
  Selection& selection = context_.document.selection();
  const std::vector<PointId> points = context_.viewport.pointsAt(position);
  if (points.empty() && isOnGizmo(position)) {
    return;
  }
  const bool isAgain =
      !points.empty() && points == clickedPoints_ && distanceBetween(position, clickedAt_) <= samePlace;
  clickedPlace_ = isAgain ? (clickedPlace_ + 1) % points.size() : 0;
  clickedPoints_ = points;
  clickedAt_ = position;
  if (points.empty()) {
    if (!modifiers.testFlag(Qt::ShiftModifier)) {
      selection.clear();
    }
  } else if (modifiers.testFlag(Qt::ShiftModifier)) {
    selection.toggle(points.front());
    clickedPoints_.clear();
  } else {
    selection.replace({points[clickedPlace_]});
  }
  hover(position);
  publishHint();
}

void SelectTool::selectBox(Qt::KeyboardModifiers modifiers) {
  context_.viewport.setRubberBand({});
  Selection& selection = context_.document.selection();
  const std::vector<PointId> points = context_.viewport.pointsIn(QRectF(pressedAt_, cursor_).normalized());
  if (modifiers.testFlag(Qt::ShiftModifier)) {
    selection.add(points);
  } else if (modifiers.testFlag(Qt::ControlModifier)) {
    selection.remove(points);
  } else {
    selection.replace(points);
  }
  publishHint();
}

void SelectTool::beginDrag() {
  clickedPoints_.clear();
  selectedBefore_ = context_.document.selection().points();
  changedSelection_ = false;
  gesture_ = gestureAt(pressedAt_);
  state_ = gesture_ != nullptr ? State::dragging : State::boxing;
  context_.viewport.setHoveredPoint(0);
  publishHint();
}

bool SelectTool::startModal(const QPointF& cursor) {
  if (state_ != State::idle) {
    return false;
  }
  gesture_ = modalGesture(cursor);
  if (gesture_ == nullptr) {
    return false;
  }
  changedSelection_ = false;
  clickedPoints_.clear();
  cursor_ = cursor;
  state_ = State::modal;
  context_.viewport.setHoveredPoint(0);
  showGesture();
  return true;
}

void SelectTool::follow(const QPointF& position, Qt::KeyboardModifiers modifiers) {
  if (state_ == State::boxing) {
    context_.viewport.setRubberBand(QRectF(pressedAt_, position).normalized());
    return;
  }
  if (gesture_ == nullptr) {
    return;
  }
  const bool snaps = context_.options.snaps() != modifiers.testFlag(Qt::ControlModifier);
  gesture_->moveTo(context_.viewport.projection(), {position, modifiers.testFlag(Qt::ShiftModifier), snaps});
  context_.document.preview(gesture_->edit());
  showGesture();
}

void SelectTool::showGesture() {
  const Gizmo gizmo = gesture_->gizmo(context_.viewport.projection());
  context_.viewport.setGizmo(gizmo);
  const auto axis = axisOf(gizmo.dragged);
  const bool hasColor = axis.has_value() && !isPlane(gizmo.dragged);
  const QColor color =
      hasColor ? context_.theme.color(QStringLiteral("axis.") + axisLetter(*axis).toLower()) : QColor();
  const Vec3 anchor = hasColor && gizmo.kind == GizmoKind::move
                          ? GizmoShape(gizmo, context_.viewport.projection()).axisEnd(*axis)
                          : gizmo.center;
  context_.viewport.setReadOut({gesture_->readOut(), gesture_->readOutHint(), color, anchor});
  publishHint();
}

void SelectTool::confirm() {
  // Idle from here on: what the document announces must not end the gesture a second time.
  state_ = State::idle;
  const std::unique_ptr<TransformGesture> gesture = std::move(gesture_);
  Document& document = context_.document;
  if (!gesture->isIdentity() && document.preview(gesture->edit())) {
    document.commitPreview();
  } else {
    document.cancelPreview();
  }
  finishGesture();
}

void SelectTool::cancel() {
  if (state_ == State::idle) {
    return;
  }
  state_ = State::idle;
  context_.viewport.setRubberBand({});
  if (gesture_ != nullptr) {
    context_.document.cancelPreview();
    if (changedSelection_) {
      context_.document.selection().replace(selectedBefore_);
    }
  }
  finishGesture();
}

void SelectTool::finishGesture() {
  gesture_.reset();
  context_.viewport.setReadOut({});
  context_.viewport.setGizmo({});
  gestureEnded();
  publishHint();
}

bool SelectTool::gestureKey(const QKeyEvent& event) {
  const Projection projection = context_.viewport.projection();
  const int key = event.key();
  if (key == Qt::Key_X || key == Qt::Key_Y || key == Qt::Key_Z) {
    const int axis = key == Qt::Key_X ? 0 : key == Qt::Key_Y ? 1 : 2;
    gesture_->pressAxis(projection, axis, event.modifiers().testFlag(Qt::ShiftModifier));
  } else if (key == Qt::Key_Backspace) {
    gesture_->erase(projection);
  } else if (key == Qt::Key_Tab || key == Qt::Key_Backtab) {
    gesture_->nextNumber();
  } else if (!event.text().isEmpty() && NumberEntry::accepts(event.text().front())) {
    gesture_->type(projection, event.text().front());
  } else {
    follow(cursor_, event.modifiers());
    return false;
  }
  context_.document.preview(gesture_->edit());
  showGesture();
  return true;
}

bool SelectTool::keyPress(const QKeyEvent& event) {
  if (event.key() == Qt::Key_Escape) {
    if (state_ == State::idle) {
      return false;
    }
    cancel();
    return true;
  }
  if (gesture_ == nullptr) {
    return false;
  }
  if (isConfirmation(event.key())) {
    confirm();
    return true;
  }
  gestureKey(event);
  // All keys belong to the gesture while it goes on.
  return true;
}

bool SelectTool::keyRelease(const QKeyEvent& event) {
  if (gesture_ == nullptr) {
    return false;
  }
  if (event.key() == Qt::Key_Shift || event.key() == Qt::Key_Control) {
    follow(cursor_, event.modifiers());
  }
  return true;
}

void SelectTool::showHovered(const QPointF& position) {
  const std::vector<PointId> points = context_.viewport.pointsAt(position);
  context_.viewport.setHoveredPoint(points.empty() ? 0 : points.front());
  context_.viewport.surface()->setCursor(points.empty() ? Qt::ArrowCursor : Qt::PointingHandCursor);
}

void SelectTool::hover(const QPointF& position) {
  showHovered(position);
}

void SelectTool::cursorLeft() {
  if (state_ == State::idle) {
    context_.viewport.setHoveredPoint(0);
  }
}

}  // namespace pbffd::ui
