#include "ui/window/point_selection.h"

#include "ui/document/document.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace pbffd::ui {
namespace {

PointsOfLevel selectionIn(const Document& document, const Project& project) {
  PointsOfLevel result;
  result.level = document.selection().level();
  const auto place = static_cast<std::size_t>(document.editLevel());
  if (!document.isOpen() || place >= project.controls.levels.size()) {
    return result;
  }
  std::unordered_map<PointId, const ControlPoint*> known;
  for (const ControlPoint& point : project.controls.levels[place]) {
    known[point.id] = &point;
  }
  for (const PointId id : document.selection().points()) {
    if (const auto found = known.find(id); found != known.end()) {
      result.points.push_back(found->second);
    }
  }
  result.isWhole = static_cast<Index>(result.points.size()) == project.controls.levels[place].size() &&
                   std::ranges::none_of(result.points, [](const ControlPoint* point) { return point->locked; });
  return result;
}

}  // namespace

PointsOfLevel shownSelection(const Document& document) {
  return selectionIn(document, document.shown());
}

PointsOfLevel committedSelection(const Document& document) {
  return selectionIn(document, document.committed());
}

int decimalsFor(double diagonal) {
  const double magnitude = std::floor(std::log10(std::max(diagonal, 1e-300)));
  return std::clamp(static_cast<int>(magnitude >= 0.0 ? std::min(3.0, 4.0 - magnitude) : 3.0 - magnitude), 0,
                    12);
}

double stepFor(double diagonal) {
  const double wanted = std::max(diagonal, 1e-300) / 1000.0;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  const double ratio = wanted / power;
  return power * (ratio < 1.5 ? 1.0 : ratio < 3.5 ? 2.0 : 5.0);
}

}  // namespace pbffd::ui
