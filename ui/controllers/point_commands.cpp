#include "ui/controllers/point_commands.h"

#include "ui/controllers/actions.h"
#include "ui/document/document.h"
#include "ui/document/hierarchy_links.h"
#include "ui/document/view_state.h"

#include <algorithm>
#include <functional>
#include <unordered_set>

namespace pbffd::ui {

PointCommands::PointCommands(Actions& actions, Document& document, ViewState& view, QObject* parent)
    : QObject(parent), document_(document), view_(view) {
  connectSelection(actions);
  connectEdits(actions);
  connectView(actions);
}

const Level& PointCommands::level() const {
  return document_.shown().controls.levels[static_cast<std::size_t>(document_.editLevel())];
}

PointSelection PointCommands::selected() const {
  return {document_.selection().level(), document_.selection().points()};
}

bool PointCommands::canBeSelected(const ControlPoint& point) const {
  return !point.locked && view_.isPointShown(point.id);
}

void PointCommands::selectWhere(const std::function<bool(const ControlPoint&)>& fits) {
  std::vector<PointId> points;
  for (const ControlPoint& point : level()) {
    if (canBeSelected(point) && fits(point)) {
      points.push_back(point.id);
    }
  }
  document_.selection().replace(std::move(points));
}

void PointCommands::connectSelection(Actions& actions) {
  Selection& selection = document_.selection();
  const auto on = [&](ActionId id, auto&& does) { connect(actions[id], &QAction::triggered, this, does); };
  on(ActionId::selectAll, [this] { selectWhere([](const ControlPoint&) { return true; }); });
  on(ActionId::selectNone, [&selection] { selection.clear(); });
  on(ActionId::selectInverse, [this, &selection] {
    const std::unordered_set<PointId> present(selection.points().begin(), selection.points().end());
    selectWhere([&](const ControlPoint& point) { return !present.contains(point.id); });
  });
  on(ActionId::selectMoved,
     [this] { selectWhere([](const ControlPoint& point) { return !(point.pose == point.rest); }); });
  on(ActionId::selectDisabled,
     [this] { selectWhere([](const ControlPoint& point) { return !point.enabled; }); });
  on(ActionId::selectChildren, [this] { selectRelated(1); });
  on(ActionId::selectParents, [this] { selectRelated(-1); });
  on(ActionId::levelUp, [this] { moveLevel(-1); });
  on(ActionId::levelDown, [this] { moveLevel(1); });
  on(ActionId::nextPoint, [this] { step(1); });
  on(ActionId::previousPoint, [this] { step(-1); });
  for (int number = 1; number <= 9; ++number) {
    on(static_cast<ActionId>(static_cast<int>(ActionId::level1) + number - 1),
       [&selection, number] { selection.setLevel(number); });
  }
}

void PointCommands::connectEdits(Actions& actions) {
  const auto on = [&](ActionId id, auto&& does) { connect(actions[id], &QAction::triggered, this, does); };
  on(ActionId::removePoints, [this] { document_.perform(Remove{selected()}); });
  on(ActionId::enablePoints, [this] { document_.perform(Enable{selected(), true}); });
  on(ActionId::disablePoints, [this] { document_.perform(Enable{selected(), false}); });
  on(ActionId::lockPoints, [this] { document_.perform(Lock{selected(), true}); });
  on(ActionId::unlockPoints, [this] { document_.perform(Lock{selected(), false}); });
  on(ActionId::resetAll, [this] { document_.perform(Reset{}); });
  // Many points of a large mesh take a while.
  on(ActionId::refineHere, [this] { document_.performInBackground(Refine{selected()}); });
  // Levels over many points take a while too. Those that there are stay as they are.
  const auto changeLevels = [this](int by) {
    const auto count = static_cast<int>(document_.committed().controls.levels.size());
    document_.performInBackground(SetLevels{count + by, true});
  };
  on(ActionId::addCoarserLevel, [changeLevels] { changeLevels(1); });
  on(ActionId::removeCoarsestLevel, [changeLevels] { changeLevels(-1); });
  on(ActionId::poseToRest, [this] { poseToRest(); });
}

void PointCommands::connectView(Actions& actions) {
  const auto on = [&](ActionId id, auto&& does) { connect(actions[id], &QAction::triggered, this, does); };
  on(ActionId::hidePoints, [this] { view_.setPointsShown(document_.selection().points(), false); });
  on(ActionId::showAllPoints, [this] { view_.showAllPoints(); });
  on(ActionId::showOnlySelected, [this] {
    std::vector<PointId> others;
    for (const ControlPoint& point : level()) {
      if (!document_.selection().contains(point.id)) {
        others.push_back(point.id);
      }
    }
    view_.setPointsShown(others, false);
  });
  on(ActionId::displayShaded, [this] { view_.setDisplayMode(DisplayMode::shaded); });
  on(ActionId::displayWire, [this] { view_.setDisplayMode(DisplayMode::wire); });
  on(ActionId::displaySeeThrough, [this] { view_.setDisplayMode(DisplayMode::seeThrough); });
  on(ActionId::showGhost, [this] { view_.setGhostShown(!view_.isGhostShown()); });
  on(ActionId::showGrid, [this] { view_.setGridShown(!view_.isGridShown()); });
  on(ActionId::showRegions, [this] {
    const bool all = view_.regions() == RegionDisplay::level;
    view_.setRegions(all ? RegionDisplay::selection : RegionDisplay::level);
  });
  on(ActionId::hierarchyNone, [this] { view_.setHierarchy(HierarchyDisplay::none); });
  // A key that shows it also takes it away.
  const auto switchTo = [this](HierarchyDisplay wanted) {
    view_.setHierarchy(view_.hierarchy() == wanted ? HierarchyDisplay::none : wanted);
  };
  on(ActionId::hierarchySelection, [switchTo] { switchTo(HierarchyDisplay::selection); });
  on(ActionId::hierarchyAll, [switchTo] { switchTo(HierarchyDisplay::all); });
  on(ActionId::orthographic, [this] { view_.setOrthographic(!view_.isOrthographic()); });
}

/// The selection comes along: as its children on a finer level, its parents on a coarser one.
void PointCommands::moveLevel(int by) {
  if (!document_.selection().isEmpty()) {
    selectRelated(by);
    return;
  }
  const int levels = static_cast<int>(document_.shown().controls.levels.size());
  document_.selection().setLevel(std::clamp(document_.selection().level() + by, 1, levels));
}

/// Children (1) or parents (-1) of the selected points; the edit level changes with the selection. Where none
/// can be selected the level keeps what was selected on it.
void PointCommands::selectRelated(int levelStep) {
  const ControlSet& set = document_.shown().controls;
  Selection& selection = document_.selection();
  const int target = selection.level() + levelStep;
  if (target < 1 || target > static_cast<int>(set.levels.size())) {
    return;
  }
  std::vector<PointId> related = levelStep > 0 ? childrenOf(set, selection.level(), selection.points())
                                               : parentsOf(set, selection.level(), selection.points());
  selection.setLevel(target);
  std::unordered_set<PointId> free;
  for (const ControlPoint& point : level()) {
    if (canBeSelected(point)) {
      free.insert(point.id);
    }
  }
  std::erase_if(related, [&](PointId id) { return !free.contains(id); });
  if (!related.empty()) {
    selection.replace(std::move(related));
  }
}

/// Goes through the points in the order of their level, around at the end.
void PointCommands::step(int by) {
  std::vector<PointId> ids;
  for (const ControlPoint& point : level()) {
    if (canBeSelected(point)) {
      ids.push_back(point.id);
    }
  }
  if (ids.empty()) {
    return;
  }
  const auto found = std::find(ids.begin(), ids.end(), document_.selection().active());
  const auto count = static_cast<std::ptrdiff_t>(ids.size());
  const std::ptrdiff_t at = found == ids.end() ? (by > 0 ? -1 : count) : found - ids.begin();
  document_.selection().replace({ids[static_cast<std::size_t>((at + by + count) % count)]});
}

/// Of a whole level with the master, which went along when it was moved as one.
void PointCommands::poseToRest() {
  const auto isAtRest = [](const auto& one) { return one.pose == one.rest; };
  const PointSelection where = selected();
  const std::unordered_set<PointId> chosen(where.points.begin(), where.points.end());
  const bool isWholeLevel = static_cast<Index>(chosen.size()) == level().size();
  const bool isMasterAway = isWholeLevel && !isAtRest(document_.shown().controls.master);
  const bool areAtRest = std::all_of(level().begin(), level().end(), [&](const ControlPoint& point) {
    return !chosen.contains(point.id) || isAtRest(point);
  });
  if (!chosen.empty() && (isMasterAway || !areAtRest)) {
    document_.perform(Reset{where, isWholeLevel});
  }
}

}  // namespace pbffd::ui
