#pragma once

#include "core/base/types.h"

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

/// A ray through a pixel: origin and unit direction in mesh units.
struct PickRay {
  Vec3 origin;
  Vec3 direction;
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

  void frameAll();
  void frameSelection();
  enum class Side { front, back, left, right, top, bottom };
  void lookFrom(Side side);

  /// What is on the screen, at the widget's size in device pixels.
  QImage picture();

  /// Positions in widget coordinates (logical pixels, origin top left). projected(): z is the depth, 0 to 1.
  Vec3 projected(const Vec3& world) const;
  PickRay rayThrough(const QPointF& position) const;
  std::optional<SurfaceHit> surfaceAt(const QPointF& position) const;
  /// The control points of the edit level that can be picked there, nearest to the eye first.
  std::vector<PointId> pointsAt(const QPointF& position) const;
  std::vector<PointId> pointsIn(const QRectF& box) const;
  /// The world length of one logical pixel at the depth of `world`.
  double pixelSizeAt(const Vec3& world) const;
  /// Unit vectors in mesh units.
  Vec3 viewDirection() const;
  Vec3 upDirection() const;
  Vec3 rightDirection() const;

  void setHoveredPoint(PointId point);

 Q_SIGNALS:
  void cameraChanged();
  void rendered();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pbffd::ui
