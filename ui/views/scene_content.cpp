#include "ui/views/scene_content.h"

#include "ui/views/grid_actor.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pbffd::ui {
namespace {

constexpr float idleSize = 9.0F;
constexpr float largestSize = 15.0F;
constexpr float selectedExtra = 1.0F;
constexpr float hoveredExtra = 2.0F;
constexpr float dotSize = 5.0F;
constexpr float idleOpacity = 0.95F;
constexpr float lockedOpacity = 0.5F;
constexpr float dotOpacity = 0.4F;
/// The grid reaches three diagonals from the middle.
constexpr double groundInDiagonals = 3.2;
constexpr double roomAroundPoints = 1.2;

QString tokenOf(PointKind kind) {
  switch (kind) {
    case PointKind::interior:
      return QStringLiteral("point.interior");
    case PointKind::exterior:
      return QStringLiteral("point.exterior");
    case PointKind::manual:
      return QStringLiteral("point.manual");
    case PointKind::merged:
      return QStringLiteral("point.merged");
    case PointKind::curve:
      break;
  }
  return QStringLiteral("point.curve");
}

Frame relativeTo(Frame frame, const Vec3& origin) {
  frame.center -= origin;
  return frame;
}

}  // namespace

SceneContent::SceneContent(const Document& document, const ViewState& view, const Theme& theme)
    : document_(document), view_(view), theme_(theme) {}

void SceneContent::setHoveredPoint(PointId point) {
  if (hovered_ != point) {
    hovered_ = point;
    invalidate(points);
  }
}

void SceneContent::documentChanged() {
  const RestMesh* const before = surface_.mesh().get();
  hasOtherBuffers_ |= surface_.choose(document_.shown().mesh, document_.deformation());
  hasOtherMesh_ |= surface_.mesh().get() != before;
}

bool SceneContent::bringUpToDate(Scene& scene) {
  documentChanged();
  updateSurface(scene);
  if ((stale_ & colors) != 0) {
    updateColors(scene);
  }
  if ((stale_ & display) != 0) {
    updateDisplay(scene);
  }
  if ((stale_ & points) != 0) {
    updatePoints(scene);
    updateHierarchy(scene);
  }
  if ((stale_ & regions) != 0) {
    updateRegions(scene);
  }
  stale_ = 0;
  return std::exchange(hasOtherMesh_, false);
}

void SceneContent::updateSurface(Scene& scene) {
  surfaceRevision_ += hasOtherBuffers_ || (stale_ & positions) != 0 ? 1 : 0;
  if (std::exchange(hasOtherBuffers_, false)) {
    scene.mesh().setMesh(surface_.mesh(), surface_.buffers());
    if (hasOtherMesh_) {
      scene.ghost().clear();
      hasGhost_ = false;
    }
    invalidate(everything);
  } else if ((stale_ & positions) != 0) {
    scene.mesh().positionsChanged();
  }
}

void SceneContent::updateColors(Scene& scene) {
  const auto token = [&](const char* name) { return rgba(theme_.color(QString::fromLatin1(name))); };
  scene.setBackground({token("view.bottom"), token("view.top")});
  scene.mesh().setColors({token("mesh"), token("mesh.edges"), token("mesh.see_through")});
  scene.ghost().setColor(token("ghost"));
  scene.regions().setColors({token("region.fill"), token("region.rings"), token("region.outline")});
  scene.hierarchy().setColors({token("hierarchy"), token("halo")});
  scene.points().setColors({token("halo"), token("select"), token("point.active")});
  GizmoActor::Colors gizmo;
  gizmo.axes = {token("axis.x"), token("axis.y"), token("axis.z")};
  gizmo.halo = token("halo");
  gizmo.highlight = theme_.isDark() ? Rgba{1, 1, 1, 1} : Rgba{0, 0, 0, 1};
  gizmo.highlightShare = theme_.isDark() ? 0.45F : 0.25F;
  gizmo.center = theme_.isDark() ? Rgba{1, 1, 1, 1} : token("point.manual");
  scene.gizmo().setColors(gizmo);
  invalidate(display | points);
}

void SceneContent::updateDisplay(Scene& scene) {
  const bool isSeeThrough = view_.displayMode() == DisplayMode::seeThrough;
  scene.mesh().setMode(view_.displayMode());
  scene.mesh().setVisible(view_.isMeshShown());
  if (view_.isGhostShown() && !hasGhost_ && surface_.mesh() != nullptr) {
    scene.ghost().setMesh(*surface_.mesh(), origin(), *surface_.buffers().triangles);
    hasGhost_ = true;
  }
  scene.ghost().setVisible(view_.isGhostShown());
  scene.setPeeling(isSeeThrough && view_.isMeshShown());
  updateGrid(scene);
}

void SceneContent::updateGrid(Scene& scene) {
  const bool isShown =
      view_.isGridShown() && view_.displayMode() != DisplayMode::seeThrough && surface_.mesh() != nullptr;
  if (!isShown) {
    scene.grid().setVisible(false);
    return;
  }
  const Grid grid =
      makeGrid(surface_.mesh()->bounds(), origin(),
               {rgba(theme_.color(QStringLiteral("grid"))), rgba(theme_.color(QStringLiteral("axis.x"))),
                rgba(theme_.color(QStringLiteral("axis.z")))});
  gridSpacing_ = grid.spacing;
  scene.grid().setStrokes(grid.strokes);
}

const Level* SceneContent::editLevel() const {
  const auto& levels = document_.shown().controls.levels;
  const Index place = document_.editLevel();
  const bool exists = document_.isOpen() && place >= 0 && place < static_cast<Index>(levels.size());
  return exists ? &levels[place] : nullptr;
}

bool SceneContent::isLevelDrawn(Index level) const {
  return level == document_.editLevel() || view_.isLevelShown(level + 1);
}

PointSprite SceneContent::spriteOf(const ControlPoint& point, int coarseness) const {
  PointSprite sprite;
  sprite.position = point.pose.center - origin();
  sprite.shape = point.kind;
  sprite.size = std::min(idleSize + 2.0F * static_cast<float>(coarseness), largestSize);
  sprite.color = rgba(theme_.color(tokenOf(point.kind)));
  sprite.opacity = point.locked ? lockedOpacity : idleOpacity;
  if (!point.enabled) {
    sprite.isHollow = true;
    sprite.color = rgba(theme_.color(QStringLiteral("disabled")));
  }
  if (selected_.count(point.id) != 0) {
    const bool isActive = point.id == document_.selection().active();
    sprite.color = point.enabled ? rgba(theme_.color(QStringLiteral("select"))) : sprite.color;
    sprite.size += selectedExtra;
    sprite.marks = PointSprite::selected | (isActive ? PointSprite::active : 0);
    sprite.opacity = 1.0F;
    sprite.isOnTop = true;
  } else if (point.id == hovered_ && !point.locked) {
    sprite.size += hoveredExtra;
    sprite.marks = PointSprite::hovered;
    sprite.opacity = 1.0F;
    sprite.isOnTop = true;
  }
  return sprite;
}

PointSprite SceneContent::dotOf(const ControlPoint& point) const {
  PointSprite dot;
  dot.position = point.pose.center - origin();
  dot.color = rgba(theme_.color(tokenOf(point.kind)));
  dot.size = dotSize;
  dot.opacity = dotOpacity;
  return dot;
}

void SceneContent::updatePoints(Scene& scene) {
  const std::vector<PointId>& selection = document_.selection().points();
  selected_ = std::set<PointId>(selection.begin(), selection.end());
  std::vector<PointSprite> sprites;
  const auto& levels = document_.shown().controls.levels;
  const int levelCount = static_cast<int>(levels.size());
  for (int l = 0; document_.isOpen() && l < levelCount; ++l) {
    const bool isEdited = &levels[l] == editLevel();
    if (!isLevelDrawn(l)) {
      continue;
    }
    for (const ControlPoint& point : levels[l]) {
      if (view_.isPointShown(point.id)) {
        sprites.push_back(isEdited ? spriteOf(point, levelCount - 1 - l) : dotOf(point));
      }
    }
  }
  // What is on top lies in this order: the active point last.
  std::stable_sort(sprites.begin(), sprites.end(),
                   [](const PointSprite& a, const PointSprite& b) { return a.marks < b.marks; });
  scene.points().setSprites(sprites);
}

void SceneContent::updateRegions(Scene& scene) {
  std::vector<Frame> frames;
  const Level* const level = editLevel();
  const bool areAll = view_.regions() == RegionDisplay::level;
  if (level != nullptr && view_.regions() != RegionDisplay::none) {
    const std::vector<PointId>& selection = document_.selection().points();
    const std::set<PointId> selected(selection.begin(), selection.end());
    for (const ControlPoint& point : *level) {
      const bool isWanted = areAll || selected.count(point.id) != 0;
      if (isWanted && point.enabled && view_.isPointShown(point.id)) {
        frames.push_back(relativeTo(point.pose, origin()));
      }
    }
  }
  scene.regions().setRegions(std::move(frames));
}

/// Those that were asked for, and without asking those of a coarser point under the cursor.
std::vector<HierarchyLink> SceneContent::shownLinks() const {
  const ControlSet& set = document_.shown().controls;
  const int level = document_.selection().level();
  if (view_.hierarchy() == HierarchyDisplay::all) {
    return hierarchyLinks(set);
  }
  std::vector<PointId> wanted;
  if (view_.hierarchy() == HierarchyDisplay::selection) {
    wanted = document_.selection().points();
  }
  if (hovered_ != 0 && level < static_cast<int>(set.levels.size())) {
    wanted.push_back(hovered_);
  }
  return hierarchyLinks(set, level, wanted);
}

void SceneContent::updateHierarchy(Scene& scene) {
  std::vector<HierarchyActor::Link> drawn;
  if (document_.isOpen()) {
    const ControlSet& set = document_.shown().controls;
    for (const HierarchyLink& link : shownLinks()) {
      const ControlPoint& parent = set.levels[static_cast<std::size_t>(link.level)][link.parent];
      const ControlPoint& child = set.levels[static_cast<std::size_t>(link.level) + 1][link.child];
      if (view_.isPointShown(parent.id) && view_.isPointShown(child.id)) {
        drawn.push_back({parent.pose.center - origin(), child.pose.center - origin(), isLevelDrawn(link.level),
                         isLevelDrawn(link.level + 1)});
      }
    }
  }
  scene.hierarchy().setLinks(std::move(drawn));
}

Extent SceneContent::extent() const {
  Extent extent;
  if (surface_.mesh() == nullptr) {
    return extent;
  }
  const Bounds& bounds = surface_.mesh()->bounds();
  extent.center = bounds.center();
  double farthest = 0.5 * bounds.diagonal();
  for (const Level& level : document_.shown().controls.levels) {
    for (const ControlPoint& point : level) {
      const double reach = point.pose.axes.colwise().norm().maxCoeff();
      farthest = std::max(farthest, (point.pose.center - extent.center).norm() + reach);
    }
  }
  extent.radius = std::max(roomAroundPoints * farthest, 1e-6 * (1.0 + extent.center.norm()));
  extent.groundRadius = std::max(groundInDiagonals * std::sqrt(2.0) * bounds.diagonal(), extent.radius);
  return extent;
}

std::vector<PickablePoint> SceneContent::pickablePoints() const {
  std::vector<PickablePoint> pickable;
  if (const Level* const level = editLevel()) {
    for (const ControlPoint& point : *level) {
      if (!point.locked && view_.isPointShown(point.id)) {
        pickable.push_back({point.id, point.pose.center});
      }
    }
  }
  return pickable;
}

}  // namespace pbffd::ui
