#pragma once

#include "core/project/edit.h"

#include <QObject>

#include <functional>

namespace pbffd::ui {

class Actions;
class Document;
class ViewState;

/// Carries out the actions that select, show and edit control points.
class PointCommands : public QObject {
  Q_OBJECT

 public:
  PointCommands(Actions& actions, Document& document, ViewState& view, QObject* parent = nullptr);

 private:
  void connectSelection(Actions& actions);
  void connectEdits(Actions& actions);
  void connectView(Actions& actions);

  const Level& level() const;
  PointSelection selected() const;
  bool canBeSelected(const ControlPoint& point) const;
  void selectWhere(const std::function<bool(const ControlPoint&)>& fits);
  void selectRelated(int levelStep);
  void step(int by);
  void moveLevel(int by);
  void poseToRest();

  Document& document_;
  ViewState& view_;
};

}  // namespace pbffd::ui
