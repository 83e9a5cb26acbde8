#include "ui/models/scene_model.h"

#include "ui/document/document.h"
#include "ui/document/view_state.h"

#include <QLocale>

#include <algorithm>

namespace pbffd::ui {
namespace {

// An index carries what its parent is: 0 for the two top rows, else the kind of parent in the lowest bits,
// the level (from 0) and the kind of point above.
enum Parent : quintptr { noParent = 0, controlsParent = 1, levelParent = 2, groupParent = 3 };

quintptr packed(Parent parent, int level = 0, int kind = 0) {
  return static_cast<quintptr>(parent) | static_cast<quintptr>(level) << 2 | static_cast<quintptr>(kind) << 16;
}

Parent parentOf(quintptr id) {
  return static_cast<Parent>(id & 3);
}
int levelOf(quintptr id) {
  return static_cast<int>(id >> 2 & 0x3fff);
}
PointKind kindOf(quintptr id) {
  return static_cast<PointKind>(id >> 16);
}

QString number(Index value) {
  return QLocale(QLocale::English).toString(value);
}

}  // namespace

/// What a row stands for. level counts from 0.
struct SceneModel::Place {
  Row row = Row::mesh;
  int level = -1;
  PointKind kind = PointKind::interior;
  Index point = -1;  ///< its place in the level
};

SceneModel::SceneModel(Document& document, ViewState& view, QObject* parent)
    : QAbstractItemModel(parent), document_(document), view_(view) {
  connect(&document, &Document::opened, this, &SceneModel::reset);
  connect(&document, &Document::changed, this, &SceneModel::update);
  connect(&document.selection(), &Selection::levelChanged, this, &SceneModel::refreshAll);
  connect(&view, &ViewState::changed, this, &SceneModel::refreshAll);
  reset();
}

const ControlSet& SceneModel::controls() const {
  return document_.shown().controls;
}

void SceneModel::reset() {
  beginResetModel();
  rows_ = document_.isOpen() ? SceneRows(controls(), filter_) : SceneRows();
  endResetModel();
}

void SceneModel::setFilter(const QString& text) {
  filter_ = PointFilter(text);
  reset();
}

void SceneModel::update(const ProjectChanges& what) {
  if (what.mesh || what.structure || (isFiltered() && !document_.isPreviewing())) {
    reset();
  } else if (what.rest || what.attributes || what.poses) {
    refreshAll();
  }
}

/// Views ask again only for the rows that they show, so naming all costs little.
void SceneModel::refreshAll() {
  if (!document_.isOpen()) {
    return;
  }
  const auto refresh = [&](const QModelIndex& parent) {
    if (const int rows = rowCount(parent); rows > 0) {
      Q_EMIT dataChanged(index(0, 0, parent), index(rows - 1, columnCount_ - 1, parent));
    }
  };
  refresh({});
  refresh(controlsIndex());
  for (int level = 0; level < rows_.levelCount(); ++level) {
    const QModelIndex levelRow = levelIndex(level + 1);
    refresh(levelRow);
    for (int group = 0; group < rows_.groupCount(level); ++group) {
      refresh(index(group, 0, levelRow));
    }
  }
}

QModelIndex SceneModel::index(int row, int column, const QModelIndex& parent) const {
  if (row < 0 || column < 0 || column >= columnCount_ || row >= rowCount(parent)) {
    return {};
  }
  if (!parent.isValid()) {
    return createIndex(row, column, packed(noParent));
  }
  const Place place = placeOf(parent);
  switch (place.row) {
    case Row::controls:
      return createIndex(row, column, packed(controlsParent));
    case Row::level:
      return createIndex(row, column, packed(levelParent, place.level));
    case Row::group:
      return createIndex(row, column, packed(groupParent, place.level, static_cast<int>(place.kind)));
    default:
      return {};
  }
}

QModelIndex SceneModel::parent(const QModelIndex& child) const {
  const quintptr id = child.internalId();
  switch (parentOf(id)) {
    case controlsParent:
      return createIndex(1, 0, packed(noParent));
    case levelParent:
      return createIndex(levelOf(id), 0, packed(controlsParent));
    case groupParent:
      return createIndex(rows_.rowOfGroup(levelOf(id), kindOf(id)), 0, packed(levelParent, levelOf(id)));
    default:
      return {};
  }
}

SceneModel::Place SceneModel::placeOf(const QModelIndex& index) const {
  const quintptr id = index.internalId();
  Place place;
  switch (parentOf(id)) {
    case noParent:
      place.row = index.row() == 0 ? Row::mesh : Row::controls;
      break;
    case controlsParent:
      place.row = Row::level;
      place.level = index.row();
      break;
    case levelParent:
      place.row = Row::group;
      place.level = levelOf(id);
      place.kind = rows_.kindOfGroup(place.level, index.row());
      break;
    case groupParent:
      place.row = Row::point;
      place.level = levelOf(id);
      place.kind = kindOf(id);
      place.point = rows_.places(place.level, place.kind)[static_cast<std::size_t>(index.row())];
      break;
  }
  return place;
}

const ControlPoint& SceneModel::pointAt(const Place& place) const {
  return controls().levels[static_cast<std::size_t>(place.level)][place.point];
}

int SceneModel::rowCount(const QModelIndex& parent) const {
  if (!document_.isOpen() || parent.column() > 0) {
    return 0;
  }
  if (!parent.isValid()) {
    return 2;
  }
  const Place place = placeOf(parent);
  switch (place.row) {
    case Row::controls:
      return rows_.levelCount();
    case Row::level:
      return rows_.groupCount(place.level);
    case Row::group:
      return static_cast<int>(rows_.places(place.level, place.kind).size());
    default:
      return 0;
  }
}

int SceneModel::columnCount(const QModelIndex&) const {
  return columnCount_;
}

QModelIndex SceneModel::pointIndex(int level, PointId point) const {
  const SceneRows::Spot spot = rows_.find(level - 1, point);
  if (spot.row < 0) {
    return {};
  }
  return createIndex(spot.row, 0, packed(groupParent, level - 1, static_cast<int>(spot.kind)));
}

QItemSelection SceneModel::rowsOf(int level, const std::vector<PointId>& points) const {
  std::array<std::vector<int>, SceneRows::kindCount> rows;
  for (const PointId point : points) {
    if (const SceneRows::Spot spot = rows_.find(level - 1, point); spot.row >= 0) {
      rows[static_cast<std::size_t>(spot.kind)].push_back(spot.row);
    }
  }
  QItemSelection selection;
  for (std::size_t kind = 0; kind < rows.size(); ++kind) {
    std::sort(rows[kind].begin(), rows[kind].end());
    const quintptr id = packed(groupParent, level - 1, static_cast<int>(kind));
    for (std::size_t first = 0; first < rows[kind].size();) {
      std::size_t last = first;
      while (last + 1 < rows[kind].size() && rows[kind][last + 1] == rows[kind][last] + 1) {
        ++last;
      }
      selection.append(QItemSelectionRange(createIndex(rows[kind][first], 0, id),
                                           createIndex(rows[kind][last], columnCount_ - 1, id)));
      first = last + 1;
    }
  }
  return selection;
}

std::vector<PointId> SceneModel::pointsBelow(const QModelIndex& index) const {
  const Place place = placeOf(index);
  std::vector<PointId> points;
  if (place.row == Row::point) {
    return {pointAt(place).id};
  }
  const auto addLevel = [&](int level, int onlyKind) {
    for (int kind = 0; kind < SceneRows::kindCount; ++kind) {
      if (onlyKind < 0 || kind == onlyKind) {
        for (const Index at : rows_.places(level, static_cast<PointKind>(kind))) {
          points.push_back(controls().levels[static_cast<std::size_t>(level)][at].id);
        }
      }
    }
  };
  if (place.row == Row::controls) {
    for (int level = 0; level < rows_.levelCount(); ++level) {
      addLevel(level, -1);
    }
  } else if (place.row != Row::mesh) {
    addLevel(place.level, place.row == Row::group ? static_cast<int>(place.kind) : -1);
  }
  return points;
}

QString SceneModel::nameOf(const Place& place) const {
  switch (place.row) {
    case Row::mesh:
      return document_.meshName();
    case Row::controls:
      return tr("Control set");
    case Row::level: {
      const int last = rows_.levelCount() - 1;
      const QString suffix = last == 0             ? QString()
                             : place.level == 0    ? tr(" (coarsest)")
                             : place.level == last ? tr(" (finest)")
                                                   : QString();
      return tr("Level %1").arg(place.level + 1) + suffix;
    }
    case Row::group:
      return kindTitle(place.kind);
    case Row::point:
      break;
  }
  return pointLabel(pointAt(place));
}

QString SceneModel::countOf(const Place& place) const {
  switch (place.row) {
    case Row::mesh:
      return tr("%1 tri.").arg(number(document_.shown().mesh->triangles().size()));
    case Row::level:
      return number(controls().levels[static_cast<std::size_t>(place.level)].size());
    case Row::group:
      return number(static_cast<Index>(rows_.places(place.level, place.kind).size()));
    default:
      return {};
  }
}

bool SceneModel::isShown(const Place& place) const {
  switch (place.row) {
    case Row::mesh:
      return view_.isMeshShown();
    case Row::controls:
      return view_.areControlsShown();
    case Row::level:
      return place.level == document_.editLevel() || view_.isLevelShown(place.level + 1);
    case Row::group: {
      const auto& places = rows_.places(place.level, place.kind);
      const Level& level = controls().levels[static_cast<std::size_t>(place.level)];
      return std::any_of(places.begin(), places.end(),
                         [&](Index at) { return view_.isPointEyeOpen(level[at].id); });
    }
    case Row::point:
      break;
  }
  return view_.isPointEyeOpen(pointAt(place).id);
}

bool SceneModel::isLocked(const Place& place) const {
  if (place.row == Row::mesh) {
    return true;
  }
  if (place.row == Row::point) {
    return pointAt(place).locked;
  }
  const auto allLocked = [&](int level, int onlyKind) {
    for (const ControlPoint& point : controls().levels[static_cast<std::size_t>(level)]) {
      if (!point.locked && (onlyKind < 0 || static_cast<int>(point.kind) == onlyKind)) {
        return false;
      }
    }
    return !controls().levels[static_cast<std::size_t>(level)].empty();
  };
  if (place.row != Row::controls) {
    return allLocked(place.level, place.row == Row::group ? static_cast<int>(place.kind) : -1);
  }
  for (int level = 0; level < rows_.levelCount(); ++level) {
    if (!allLocked(level, -1)) {
      return false;
    }
  }
  return rows_.levelCount() > 0;
}

QVariant SceneModel::checkOf(const Place& place, int column) const {
  const auto state = [](bool on) { return QVariant(on ? Qt::Checked : Qt::Unchecked); };
  switch (column) {
    case eyeColumn:
      return state(isShown(place));
    case lockColumn:
      return state(isLocked(place));
    case tickColumn:
      return place.row == Row::point ? state(pointAt(place).enabled) : QVariant();
    default:
      return {};
  }
}

QVariant SceneModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) {
    return {};
  }
  const Place place = placeOf(index);
  switch (role) {
    case Qt::DisplayRole:
      return index.column() == nameColumn    ? nameOf(place)
             : index.column() == countColumn ? countOf(place)
                                             : QVariant();
    case Qt::EditRole:
      return place.row == Row::point ? QString::fromStdString(pointAt(place).name) : QVariant();
    case Qt::CheckStateRole:
      return checkOf(place, index.column());
    case rowRole:
      return static_cast<int>(place.row);
    case levelRole:
      return place.level + 1;
    case pointRole:
      return place.row == Row::point ? static_cast<qint64>(pointAt(place).id) : qint64{0};
    case kindRole:
      return place.row == Row::point || place.row == Row::group ? static_cast<int>(place.kind) : -1;
    case detailRole:
      return place.row == Row::point && !pointAt(place).name.empty() ? QString::number(pointAt(place).id)
                                                                     : QString();
    case isEditLevelRole:
      return place.row == Row::level && place.level == document_.editLevel();
    case isDimRole:
      return place.row == Row::point && !pointAt(place).enabled;
    default:
      return {};
  }
}

void SceneModel::setShown(const Place& place, const QModelIndex& index, bool shown) {
  switch (place.row) {
    case Row::mesh:
      return view_.setMeshShown(shown);
    case Row::controls:
      return view_.setControlsShown(shown);
    case Row::level:
      return view_.setLevelShown(place.level + 1, shown);
    default:
      return view_.setPointsShown(pointsBelow(index), shown);
  }
}

bool SceneModel::lockBelow(const QModelIndex& index, bool locked) {
  const Place place = placeOf(index);
  if (place.row == Row::mesh) {
    return false;
  }
  if (place.row != Row::controls) {
    return document_.perform(Lock{{place.level + 1, pointsBelow(index)}, locked});
  }
  Group all;
  all.text = locked ? tr("Lock all points").toStdString() : tr("Unlock all points").toStdString();
  for (int level = 1; level <= rows_.levelCount(); ++level) {
    if (const auto points = pointsBelow(levelIndex(level)); !points.empty()) {
      all.edits.push_back(Lock{{level, points}, locked});
    }
  }
  return !all.edits.empty() && document_.perform(all);
}

bool SceneModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid()) {
    return false;
  }
  const Place place = placeOf(index);
  if (role == Qt::CheckStateRole) {
    const bool on = value.toInt() == Qt::Checked;
    switch (index.column()) {
      case eyeColumn:
        setShown(place, index, on);
        return true;
      case lockColumn:
        return lockBelow(index, on);
      case tickColumn:
        return place.row == Row::point && document_.perform(Enable{{place.level + 1, {pointAt(place).id}}, on});
      default:
        return false;
    }
  }
  if (role != Qt::EditRole || place.row != Row::point || index.column() != nameColumn) {
    return false;
  }
  const std::string name = value.toString().trimmed().toStdString();
  return name == pointAt(place).name || document_.perform(Rename{place.level + 1, pointAt(place).id, name});
}

Qt::ItemFlags SceneModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) {
    return Qt::NoItemFlags;
  }
  const Place place = placeOf(index);
  Qt::ItemFlags flags = Qt::ItemIsEnabled;
  if (place.row == Row::point) {
    flags |= Qt::ItemIsSelectable;
    if (index.column() == nameColumn) {
      flags |= Qt::ItemIsEditable;
    }
  }
  return flags;
}

}  // namespace pbffd::ui
