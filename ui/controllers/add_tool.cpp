#include "ui/controllers/add_tool.h"

#include "ui/document/document.h"
#include "ui/document/theme.h"

#include <cmath>
#include <utility>

namespace pbffd::ui {
namespace {

constexpr double dragThreshold = 4.0;

}  // namespace

AddTool::AddTool(const ToolContext& context, QObject* parent) : Tool(parent), context_(context) {}

QString AddTool::hint() const {
  return isBusy() ? tr("Drag sets the radius  [Esc] cancels")
                  : tr("Click the surface to add a point to level %1  Drag to size it")
                        .arg(context_.document.selection().level());
}

void AddTool::deactivate() {
  cancel();
  context_.viewport.surface()->unsetCursor();
}

void AddTool::cancel() {
  if (std::exchange(place_, std::nullopt)) {
    context_.viewport.setReadOut({});
    Q_EMIT hintChanged(hint());
  }
}

double AddTool::radiusAt(const QPointF& position) const {
  const double pixels = std::hypot(position.x() - pressedAt_.x(), position.y() - pressedAt_.y());
  return pixels < dragThreshold ? 0.0 : pixels * context_.viewport.pixelSizeAt(*place_);
}

void AddTool::showRadius(double radius) {
  Viewport::ReadOut readOut;
  if (radius > 0.0) {
    readOut = {tr("Radius %1").arg(radius, 0, 'g', 4), {}, context_.theme.color("select"), *place_};
  }
  context_.viewport.setReadOut(readOut);
}

bool AddTool::mousePress(const QMouseEvent& event) {
  if (event.button() == Qt::RightButton && isBusy()) {
    cancel();
    return true;
  }
  if (event.button() != Qt::LeftButton || event.modifiers().testFlag(Qt::AltModifier)) {
    return false;
  }
  if (const auto hit = context_.viewport.surfaceAt(event.position())) {
    place_ = hit->position;
    pressedAt_ = event.position();
    Q_EMIT hintChanged(hint());
  }
  return true;
}

bool AddTool::mouseMove(const QMouseEvent& event) {
  if (isBusy()) {
    showRadius(radiusAt(event.position()));
    return true;
  }
  const bool isOnSurface = context_.viewport.surfaceAt(event.position()).has_value();
  context_.viewport.surface()->setCursor(isOnSurface ? Qt::CrossCursor : Qt::ForbiddenCursor);
  return false;
}

bool AddTool::mouseRelease(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || !isBusy()) {
    return event.button() == Qt::LeftButton;
  }
  add(radiusAt(event.position()));
  return true;
}

void AddTool::add(double radius) {
  Add edit;
  edit.level = context_.document.selection().level();
  edit.rest = {*place_, radius * Mat3::Identity()};
  edit.defaultAxes = radius == 0.0;
  edit.posed = true;
  const PointId added = context_.document.committed().nextId;
  cancel();
  if (context_.document.perform(edit)) {
    context_.document.selection().replace({added});
  }
}

bool AddTool::keyPress(const QKeyEvent& event) {
  if (event.key() != Qt::Key_Escape || !isBusy()) {
    return isBusy();
  }
  cancel();
  return true;
}

}  // namespace pbffd::ui
