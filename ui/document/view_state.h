#pragma once

#include "core/base/types.h"

#include <QByteArray>
#include <QObject>

#include <set>
#include <vector>

namespace pbffd::ui {

enum class DisplayMode { shaded, wire, seeThrough };
enum class RegionDisplay { none, selection, level };
/// Lines from merged points to what they stand for.
enum class HierarchyDisplay { none, selection, all };

/// How the document is looked at: never undoable, saved with the project beside it.
class ViewState : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  DisplayMode displayMode() const { return displayMode_; }
  void setDisplayMode(DisplayMode mode);
  RegionDisplay regions() const { return regions_; }
  void setRegions(RegionDisplay regions);
  HierarchyDisplay hierarchy() const { return hierarchy_; }
  void setHierarchy(HierarchyDisplay hierarchy);
  bool isGridShown() const { return gridShown_; }
  void setGridShown(bool shown);
  bool isGhostShown() const { return ghostShown_; }
  void setGhostShown(bool shown);
  bool areNamesShown() const { return namesShown_; }
  void setNamesShown(bool shown);
  bool isOrthographic() const { return orthographic_; }
  void setOrthographic(bool orthographic);

  /// The mesh's eye in the tree.
  bool isMeshShown() const { return meshShown_; }
  void setMeshShown(bool shown);
  /// The control set's eye: without it no point is drawn.
  bool areControlsShown() const { return controlsShown_; }
  void setControlsShown(bool shown);
  /// A level's eye: its points are drawn while another level is edited. 1 is the coarsest.
  bool isLevelShown(int level) const { return shownLevels_.count(level) != 0; }
  void setLevelShown(int level, bool shown);
  /// The numbers of all levels change by this: coarser ones came (above 0) or went.
  void renumberLevels(int by);
  /// A point's own eye, and whether it is drawn at all.
  bool isPointEyeOpen(PointId point) const { return hiddenPoints_.count(point) == 0; }
  bool isPointShown(PointId point) const { return controlsShown_ && isPointEyeOpen(point); }
  void setPointsShown(const std::vector<PointId>& points, bool shown);
  void showAllPoints();
  void reset();

  /// For the project file's "view" object; restore() ignores what it does not know or what is malformed.
  QByteArray toJson() const;
  void restore(const QByteArray& json);

 Q_SIGNALS:
  void changed();

 private:
  DisplayMode displayMode_ = DisplayMode::wire;
  RegionDisplay regions_ = RegionDisplay::selection;
  HierarchyDisplay hierarchy_ = HierarchyDisplay::none;
  bool gridShown_ = true;
  bool ghostShown_ = false;
  bool namesShown_ = false;
  bool orthographic_ = false;
  bool meshShown_ = true;
  bool controlsShown_ = true;
  std::set<int> shownLevels_;
  std::set<PointId> hiddenPoints_;
};

}  // namespace pbffd::ui
