#pragma once

#include "ui/models/scene_rows.h"

namespace pbffd::ui {

class Document;
class ViewState;

/// The eye, the lock and the tick of a row of the scene tree. An eye is view state; lock and tick are edits.
class SceneSwitches {
 public:
  SceneSwitches(Document& document, ViewState& view, const SceneRows& rows)
      : document_(document), view_(view), rows_(rows) {}

  bool isShown(const ScenePlace& place) const;
  void setShown(const ScenePlace& place, bool shown);

  /// The mesh is locked from the start: its vertices are never edited one by one.
  bool isLocked(const ScenePlace& place) const;
  /// Whether it could be done.
  bool setLocked(const ScenePlace& place, bool locked);

  bool isEnabled(const ScenePlace& place) const;
  bool setEnabled(const ScenePlace& place, bool enabled);

 private:
  const Level& level(int place) const;
  bool isAllLocked(int level, const PointKind* kind) const;

  Document& document_;
  ViewState& view_;
  const SceneRows& rows_;
};

}  // namespace pbffd::ui
