#pragma once

#include "core/base/types.h"

#include <QObject>
#include <QPointF>
#include <QTimer>

class QInputEvent;
class QKeyEvent;
class QMouseEvent;
class QNativeGestureEvent;
class QWheelEvent;

namespace pbffd::ui {

class ViewState;
class Viewport;

/// Moves the camera of a viewport: middle drag (or Alt and left) orbits about the point under the cursor,
/// with Shift it pans, with Ctrl it zooms; the wheel zooms to the cursor. An event filter on the viewport's
/// surface, behind those of tools.
class CameraController : public QObject {
  Q_OBJECT

 public:
  CameraController(Viewport& viewport, ViewState& view);

  bool eventFilter(QObject* watched, QEvent* event) override;

  /// Whether the camera is being dragged, or was turned by the wheel a moment ago.
  bool isMoving() const { return drag_ != Drag::none || wheelPause_.isActive(); }

 Q_SIGNALS:
  /// isMoving() no longer holds.
  void stopped();

 private:
  enum class Drag { none, orbit, pan, zoom };

  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  bool gesture(const QNativeGestureEvent& event);
  bool key(const QKeyEvent& event);
  void zoomAt(const QPointF& position, double factor);
  /// What lies under the cursor, or where its ray passes what the camera looks at.
  Vec3 pivotAt(const QPointF& position) const;

  Viewport& viewport_;
  ViewState& view_;
  Drag drag_ = Drag::none;
  Qt::MouseButton button_ = Qt::NoButton;
  QPointF last_;
  Vec3 pivot_ = Vec3::Zero();
  /// While the wheel turns over one place, what it zooms to stays.
  QTimer wheelPause_;
  QPointF wheelAt_;
};

}  // namespace pbffd::ui
