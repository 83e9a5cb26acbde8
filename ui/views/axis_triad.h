#pragma once

#include "core/base/types.h"

#include <QWidget>

#include <vector>

namespace pbffd::ui {

class Theme;

/// The three axes as the camera sees them, in a corner of the view; a click on an end looks along it.
class AxisTriad : public QWidget {
  Q_OBJECT

 public:
  AxisTriad(const Theme& theme, QWidget* parent);

  /// Columns right, up, backward of the camera.
  void setAxes(const Mat3& cameraAxes);

 Q_SIGNALS:
  /// Look from that end of axis 0, 1 or 2.
  void sideChosen(int axis, bool positive);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  struct End {
    int axis;
    bool isPositive;
    QPointF at;
    double depth;  ///< towards the eye
  };
  /// From back to front.
  std::vector<End> ends() const;
  const End* endAt(const std::vector<End>& all, const QPointF& position) const;
  void paintEnd(QPainter& painter, const End& end) const;

  const Theme& theme_;
  Mat3 cameraAxes_ = Mat3::Identity();
  int hoveredAxis_ = -1;
  bool hoveredPositive_ = false;
};

}  // namespace pbffd::ui
