#include "ui/document/edited_points.h"

#include <algorithm>
#include <unordered_set>

namespace pbffd::ui {
namespace {

std::vector<PointId> identifiersOf(const ControlSet& set, int level) {
  std::vector<PointId> ids;
  if (level >= 1 && level <= static_cast<int>(set.levels.size())) {
    for (const ControlPoint& point : set.levels[static_cast<std::size_t>(level - 1)]) {
      ids.push_back(point.id);
    }
  }
  return ids;
}

/// Those of `all` that are not in `known`.
std::vector<PointId> without(const std::vector<PointId>& all, const std::vector<PointId>& known) {
  const std::unordered_set<PointId> set(known.begin(), known.end());
  std::vector<PointId> rest;
  std::copy_if(all.begin(), all.end(), std::back_inserter(rest), [&](PointId id) { return !set.contains(id); });
  return rest;
}

template <class E>
concept NamesPoints = requires(const E& edit) {
  edit.where.points;
};
template <class E>
concept NamesOnePoint = requires(const E& edit) {
  edit.level;
  edit.point;
};

struct Finder {
  const Project& before;
  const Project& after;

  int levelOf(const std::optional<int>& level) const {
    return level.value_or(static_cast<int>(after.controls.levels.size()));
  }

  template <NamesPoints E>
  std::optional<EditedPoints> operator()(const E& edit) const {
    return EditedPoints{levelOf(edit.where.level), edit.where.points};
  }

  template <NamesOnePoint E>
  std::optional<EditedPoints> operator()(const E& edit) const {
    return EditedPoints{levelOf(edit.level), {edit.point}};
  }

  std::optional<EditedPoints> operator()(const Reset& edit) const {
    return edit.where ? std::optional(EditedPoints{levelOf(edit.where->level), edit.where->points})
                      : std::nullopt;
  }

  std::optional<EditedPoints> operator()(const Add& edit) const {
    const int level = levelOf(edit.level);
    return EditedPoints{level,
                        without(identifiersOf(after.controls, level), identifiersOf(before.controls, level))};
  }

  /// The points that were refined with those that came to them.
  std::optional<EditedPoints> operator()(const Refine& edit) const {
    const int level = levelOf(edit.where.level);
    EditedPoints all{level, edit.where.points};
    const auto fresh = without(identifiersOf(after.controls, level), identifiersOf(before.controls, level));
    all.points.insert(all.points.end(), fresh.begin(), fresh.end());
    return all;
  }

  std::optional<EditedPoints> operator()(const Group& group) const {
    std::optional<EditedPoints> all;
    for (const Edit& edit : group.edits) {
      const auto part = std::visit(*this, edit.value());
      if (!part || (all && all->level != part->level)) {
        continue;
      }
      if (!all) {
        all = EditedPoints{part->level, {}};
      }
      const auto fresh = without(part->points, all->points);
      all->points.insert(all->points.end(), fresh.begin(), fresh.end());
    }
    return all;
  }

  template <class E>
  std::optional<EditedPoints> operator()(const E&) const {
    return std::nullopt;
  }
};

}  // namespace

std::optional<EditedPoints> editedPoints(const Edit& edit, const Project& before, const Project& after) {
  return std::visit(Finder{before, after}, edit.value());
}

}  // namespace pbffd::ui
