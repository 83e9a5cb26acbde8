#pragma once

#include "core/base/types.h"
#include "ui/views/camera.h"
#include "ui/views/gizmo.h"

#include <QImage>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace pbffd::ui {

class Document;
class Theme;
class ViewState;

/// What lies under the cursor.
struct SurfaceHit {
  Vec3 position;  ///< on the deformed mesh
  Index triangle;
};

/// The render view: the mesh, the control points, the regions and the gizmo of a document in one OpenGL
/// widget, drawn at most once per turn of the event loop, with the camera. It does not edit: mouse and key
/// events that are not the camera's go to the installed tool (an event filter on surface()).
class Viewport : public QWidget {
  Q_OBJECT

 public:
  Viewport(Document& document, ViewState& view, Theme& theme, QWidget* parent = nullptr);
  ~Viewport() override;

  /// The widget that gets mouse and key events; child widgets over the view have it as their parent.
  QWidget* surface() const;

  /// How far the view is covered from its left and from its upper edge, in logical pixels: framing leaves room
  /// above, and boxes beside the cursor keep off both.
  void setCovered(int left, int top);
  void frameAll();
  /// The selected points with their regions; everything when nothing is selected.
  void frameSelection();
  enum class Side { front, back, left, right, top, bottom };
  void lookFrom(Side side);
  const Camera& camera() const;
  void setCamera(const Camera& camera);
  /// Turns the camera about the middle of what it looks at, by degrees.
  void orbitBy(double yawDegrees, double pitchDegrees);

  /// What is on the screen, at the widget's size in device pixels.
  QImage picture();

  /// Of the widget in logical pixels, origin top left.
  Projection projection() const;
  /// Positions in widget coordinates. projected(): z is the depth, 0 to 1.
  Vec3 projected(const Vec3& world) const;
  PickRay rayThrough(const QPointF& position) const;
  std::optional<SurfaceHit> surfaceAt(const QPointF& position) const;
  /// The control points of the edit level that can be picked there: those whose disc the cursor is on,
  /// nearest to the eye first, then the others within 10 pixels by their distance on the screen.
  std::vector<PointId> pointsAt(const QPointF& position) const;
  /// Those within a box, hidden ones too.
  std::vector<PointId> pointsIn(const QRectF& box) const;
  /// The world length of one logical pixel at the depth of `world`.
  double pixelSizeAt(const Vec3& world) const;
  /// Unit vectors in mesh units.
  Vec3 viewDirection() const;
  Vec3 upDirection() const;
  Vec3 rightDirection() const;

  /// 0: none. The point under the cursor grows and shows its name.
  void setHoveredPoint(PointId point);
  PointId hoveredPoint() const;

  /// In mesh units; GizmoKind::none hides it.
  void setGizmo(const Gizmo& gizmo);
  GizmoPart gizmoPartAt(const QPointF& position) const;

  /// A dashed rectangle while points are boxed; an empty one hides it.
  void setRubberBand(const QRectF& box);
  /// A box beside `anchor` (mesh units): `value` in bold after a bar of colour, then `hint`. An empty value
  /// hides it.
  struct ReadOut {
    QString value;
    QString hint;
    QColor color;
    Vec3 anchor = Vec3::Zero();
  };
  void setReadOut(const ReadOut& readOut);

  /// Whether a coarse stand-in is drawn, because the whole mesh is too slow to be dragged.
  bool isSimplified() const;
  /// Whether one is ready to be drawn in the next drag.
  bool canSimplify() const;
  /// Seconds that a frame of a drag may take before a stand-in is drawn; by default 1/30.
  void setFrameBudget(double seconds);

  /// The distance between the lines of the ground grid.
  double gridSpacing() const;

 Q_SIGNALS:
  void cameraChanged();
  void rendered();
  void simplifiedChanged(bool isSimplified);
  /// Something that the user should know about how it is drawn.
  void remarked(const QString& message);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void connectSources();
  void prepareFrame();
  void requestFrame();
  void placeOverlays();

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pbffd::ui
