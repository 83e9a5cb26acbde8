#pragma once

#include "core/ffd/control_point.h"

#include <QColor>
#include <QWidget>

namespace pbffd::ui {

class Theme;

/// A box over the view, in the colours of overlays, that never takes the mouse.
class OverlayBox : public QWidget {
  Q_OBJECT

 public:
  OverlayBox(const Theme& theme, QWidget* parent);

  /// Shows the box beside a place of the view, on the side where there is room.
  void placeBeside(const QPointF& at, const QRect& room);

 protected:
  const Theme& theme() const { return theme_; }
  void paintBackground(QPainter& painter) const;

 private:
  const Theme& theme_;
};

/// The name and kind of the point under the cursor: "Muzzle 44, interior".
class NameTag : public OverlayBox {
  Q_OBJECT
  Q_PROPERTY(QString text READ text)

 public:
  using OverlayBox::OverlayBox;
  void setPoint(const ControlPoint& point);
  const QString& text() const { return text_; }
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString text_;
};

/// What a drag amounts to, beside the gizmo: "Y +0.350  type a number".
class ReadOutBox : public OverlayBox {
  Q_OBJECT
  Q_PROPERTY(QString value READ value)

 public:
  using OverlayBox::OverlayBox;
  /// An empty value hides the box. Without a valid colour there is no bar.
  void setText(const QString& value, const QString& hint, const QColor& bar);
  const QString& value() const { return value_; }
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QFont valueFont() const;

  QString value_;
  QString hint_;
  QColor bar_;
};

/// The dashed rectangle of a box selection.
class RubberBand : public QWidget {
  Q_OBJECT

 public:
  RubberBand(const Theme& theme, QWidget* parent);
  void setBox(const QRectF& box);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const Theme& theme_;
};

/// "Muzzle 44": its own name and number, or "Point 44" without a name.
QString pointTitle(const ControlPoint& point);
/// "interior".
QString kindName(PointKind kind);

}  // namespace pbffd::ui
