#pragma once

#include "core/project/edit.h"
#include "ui/controllers/select_tool.h"
#include "ui/views/viewport.h"

namespace pbffd::ui {

/// Adds control points to the edit level: a click on the surface puts one there with a region as placement
/// would make it, a drag from there sets the region's radius. The new point is selected.
class AddTool : public Tool {
  Q_OBJECT

 public:
  explicit AddTool(const ToolContext& context, QObject* parent = nullptr);

  ToolId id() const override { return ToolId::add; }
  QString name() const override { return tr("Add"); }
  QString iconName() const override { return QStringLiteral("add"); }
  QString hint() const override;

  void deactivate() override;
  bool mousePress(const QMouseEvent& event) override;
  bool mouseMove(const QMouseEvent& event) override;
  bool mouseRelease(const QMouseEvent& event) override;
  bool keyPress(const QKeyEvent& event) override;
  bool keyRelease(const QKeyEvent&) override { return false; }
  bool isBusy() const override { return place_.has_value(); }
  void cancel() override;

 private:
  /// In mesh units; 0 until the press has become a drag.
  double radiusAt(const QPointF& position) const;
  void add(double radius);
  void showRadius(double radius);

  ToolContext context_;
  std::optional<Vec3> place_;  ///< on the surface, while the button is held
  QPointF pressedAt_;
};

}  // namespace pbffd::ui
