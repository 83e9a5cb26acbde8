#include "ui/document/view_state.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace pbffd::ui {
namespace {

/// Sets `member` and tells whether it differs now.
template <class Value>
bool assign(Value& member, const Value& value) {
  if (member == value) {
    return false;
  }
  member = value;
  return true;
}

}  // namespace

void ViewState::setDisplayMode(DisplayMode mode) {
  if (assign(displayMode_, mode)) {
    Q_EMIT changed();
  }
}

void ViewState::setRegions(RegionDisplay regions) {
  if (assign(regions_, regions)) {
    Q_EMIT changed();
  }
}

void ViewState::setHierarchy(HierarchyDisplay hierarchy) {
  if (assign(hierarchy_, hierarchy)) {
    Q_EMIT changed();
  }
}

void ViewState::setGridShown(bool shown) {
  if (assign(gridShown_, shown)) {
    Q_EMIT changed();
  }
}

void ViewState::setGhostShown(bool shown) {
  if (assign(ghostShown_, shown)) {
    Q_EMIT changed();
  }
}

void ViewState::setNamesShown(bool shown) {
  if (assign(namesShown_, shown)) {
    Q_EMIT changed();
  }
}

void ViewState::setOrthographic(bool orthographic) {
  if (assign(orthographic_, orthographic)) {
    Q_EMIT changed();
  }
}

void ViewState::setMeshShown(bool shown) {
  if (assign(meshShown_, shown)) {
    Q_EMIT changed();
  }
}

void ViewState::setControlsShown(bool shown) {
  if (assign(controlsShown_, shown)) {
    Q_EMIT changed();
  }
}

void ViewState::setLevelShown(int level, bool shown) {
  if (isLevelShown(level) == shown) {
    return;
  }
  if (shown) {
    shownLevels_.insert(level);
  } else {
    shownLevels_.erase(level);
  }
  Q_EMIT changed();
}

void ViewState::renumberLevels(int by) {
  std::set<int> renumbered;
  for (const int level : shownLevels_) {
    if (level + by >= 1) {
      renumbered.insert(level + by);
    }
  }
  if (renumbered != shownLevels_) {
    shownLevels_ = std::move(renumbered);
    Q_EMIT changed();
  }
}

void ViewState::setPointsShown(const std::vector<PointId>& points, bool shown) {
  const std::size_t before = hiddenPoints_.size();
  for (const PointId point : points) {
    if (shown) {
      hiddenPoints_.erase(point);
    } else {
      hiddenPoints_.insert(point);
    }
  }
  if (hiddenPoints_.size() != before) {
    Q_EMIT changed();
  }
}

void ViewState::showAllPoints() {
  if (!hiddenPoints_.empty() || !controlsShown_) {
    hiddenPoints_.clear();
    controlsShown_ = true;
    Q_EMIT changed();
  }
}

void ViewState::reset() {
  meshShown_ = true;
  controlsShown_ = true;
  ghostShown_ = false;
  orthographic_ = false;
  shownLevels_.clear();
  hiddenPoints_.clear();
  Q_EMIT changed();
}

QByteArray ViewState::toJson() const {
  QJsonObject object;
  object["mode"] = static_cast<int>(displayMode_);
  object["regions"] = static_cast<int>(regions_);
  object["hierarchy"] = static_cast<int>(hierarchy_);
  object["grid"] = gridShown_;
  object["names"] = namesShown_;
  object["orthographic"] = orthographic_;
  object["mesh"] = meshShown_;
  object["controls"] = controlsShown_;
  QJsonArray levels;
  for (const int level : shownLevels_) {
    levels.append(level);
  }
  object["levels"] = levels;
  QJsonArray hidden;
  for (const PointId point : hiddenPoints_) {
    hidden.append(static_cast<qint64>(point));
  }
  object["hidden"] = hidden;
  return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

void ViewState::restore(const QByteArray& json) {
  const QJsonObject object = QJsonDocument::fromJson(json).object();
  displayMode_ =
      static_cast<DisplayMode>(std::clamp(object["mode"].toInt(static_cast<int>(displayMode_)), 0, 2));
  regions_ = static_cast<RegionDisplay>(std::clamp(object["regions"].toInt(static_cast<int>(regions_)), 0, 2));
  hierarchy_ =
      static_cast<HierarchyDisplay>(std::clamp(object["hierarchy"].toInt(static_cast<int>(hierarchy_)), 0, 2));
  gridShown_ = object["grid"].toBool(gridShown_);
  namesShown_ = object["names"].toBool(namesShown_);
  orthographic_ = object["orthographic"].toBool(orthographic_);
  meshShown_ = object["mesh"].toBool(true);
  controlsShown_ = object["controls"].toBool(true);
  shownLevels_.clear();
  for (const auto& level : object["levels"].toArray()) {
    shownLevels_.insert(level.toInt());
  }
  hiddenPoints_.clear();
  for (const auto& point : object["hidden"].toArray()) {
    hiddenPoints_.insert(point.toInteger());
  }
  Q_EMIT changed();
}

}  // namespace pbffd::ui
