#pragma once

#include "ui/document/document.h"
#include "ui/document/hierarchy_links.h"
#include "ui/document/theme.h"
#include "ui/document/view_state.h"
#include "ui/views/picking.h"
#include "ui/views/scene.h"
#include "ui/views/surface_store.h"

#include <set>
#include <vector>

namespace pbffd::ui {

/// Brings what the actors draw in line with the document, the selection, the view state and the theme: of
/// what was said to have changed since the last time, and nothing else.
class SceneContent {
 public:
  SceneContent(const Document& document, const ViewState& view, const Theme& theme);

  enum Part : unsigned {
    positions = 1U,
    points = 2U,
    regions = 4U,
    colors = 8U,
    display = 16U,
    everything = 31U
  };
  void invalidate(unsigned parts) { stale_ |= parts; }
  /// To be called whenever the document shows something else: buffers that are gone are let go at once.
  void documentChanged();

  void setHoveredPoint(PointId point);
  PointId hoveredPoint() const { return hovered_; }

  /// Returns whether the document shows another mesh than at the last call.
  bool bringUpToDate(Scene& scene);

  /// What view space is relative to, in mesh units.
  const Vec3& origin() const { return surface_.origin(); }
  const SurfaceStore& surface() const { return surface_; }
  /// Another number whenever the surface's buffers, or what is in them, are others.
  unsigned surfaceRevision() const { return surfaceRevision_; }
  /// In mesh units.
  Extent extent() const;
  /// The points of the edit level that can be picked, in mesh units.
  std::vector<PickablePoint> pickablePoints() const;
  double gridSpacing() const { return gridSpacing_; }

 private:
  void updateSurface(Scene& scene);
  void updateColors(Scene& scene);
  void updateDisplay(Scene& scene);
  void updatePoints(Scene& scene);
  void updateRegions(Scene& scene);
  void updateHierarchy(Scene& scene);
  void updateGrid(Scene& scene);
  std::vector<HierarchyLink> shownLinks() const;
  PointSprite spriteOf(const ControlPoint& point, int coarseness) const;
  PointSprite dotOf(const ControlPoint& point) const;
  const Level* editLevel() const;
  /// Whether the points of a level (from 0) are drawn, in full or as dots.
  bool isLevelDrawn(Index level) const;

  const Document& document_;
  const ViewState& view_;
  const Theme& theme_;
  SurfaceStore surface_;
  unsigned stale_ = everything;
  unsigned surfaceRevision_ = 0;
  bool hasOtherBuffers_ = true;
  bool hasOtherMesh_ = true;
  bool hasGhost_ = false;  ///< made when it is first seen
  PointId hovered_ = 0;
  std::set<PointId> selected_;
  double gridSpacing_ = 0.0;
};

}  // namespace pbffd::ui
