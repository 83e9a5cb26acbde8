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

SceneModel::SceneModel(Document& document, ViewState& view, QObject* parent)
    : QAbstractItemModel(parent), document_(document), switches_(document, view, rows_) {
  connect(&document, &Document::opened, this, &SceneModel::reset);
  connect(&document, &Document::changed, this, &SceneModel::update);
  connect(&document.selection(), &Selection::levelChanged, this, &SceneModel::findRelatives);
  connect(&document.selection(), &Selection::changed, this, &SceneModel::findRelatives);
  connect(&view, &ViewState::changed, this, &SceneModel::refreshAll);
  reset();
}

const ControlSet& SceneModel::controls() const {
  return document_.shown().controls;
}

void SceneModel::reset() {
  beginResetModel();
  rows_ = document_.isOpen() ? SceneRows(controls(), filter_) : SceneRows();
  relatives_ = document_.isOpen() ? SceneRelatives(controls(), document_.selection()) : SceneRelatives();
  endResetModel();
}

void SceneModel::findRelatives() {
  if (document_.isOpen()) {
    relatives_ = SceneRelatives(controls(), document_.selection());
    refreshAll();
  }
}

void SceneModel::setFilter(const QString& text) {
  filter_ = PointFilter(text);
  reset();
}

void SceneModel::update(const ProjectChanges& what) {
  if (what.mesh || what.structure || (isFiltered() && !document_.isPreviewing())) {
    reset();
  } else if (what.rest || what.attributes) {
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
  return rows_.pointsBelow(placeOf(index), controls());
}

QString SceneModel::nameOf(const Place& place) const {
  switch (place.row) {
    case Row::mesh:
      return document_.meshName();
    case Row::controls:
      return tr("Control set");
    case Row::level: {
      const int last = rows_.levelCount() - 1;
      // Where parents or children are counted there is no room for both.
      const QString suffix = last == 0 || relationOf(place) != Relation::none ? QString()
                             : place.level == 0                               ? tr(" (coarsest)")
                             : place.level == last                            ? tr(" (finest)")
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

Relation SceneModel::relationOf(const Place& place) const {
  switch (place.row) {
    case Row::point:
      return relatives_.of(place.level, pointAt(place).id);
    case Row::group:
      return relatives_.count(place.level, place.kind) > 0 ? relatives_.onLevel(place.level) : Relation::none;
    case Row::level:
      return relatives_.onLevel(place.level);
    default:
      return Relation::none;
  }
}

QString SceneModel::relativesBelow(const Place& place) const {
  const Relation relation = relationOf(place);
  if (relation == Relation::none) {
    return {};
  }
  const int count =
      place.row == Row::level ? relatives_.count(place.level) : relatives_.count(place.level, place.kind);
  return relation == Relation::parent ? (count == 1 ? tr("1 parent") : tr("%1 parents").arg(number(count)))
                                      : (count == 1 ? tr("1 child") : tr("%1 children").arg(number(count)));
}

QString SceneModel::detailOf(const Place& place) const {
  if (place.row != Row::point) {
    return relativesBelow(place);
  }
  QStringList words;
  if (!pointAt(place).name.empty()) {
    words += QString::number(pointAt(place).id);
  }
  if (const Relation relation = relationOf(place); relation != Relation::none) {
    words += relation == Relation::parent ? tr("parent") : tr("child");
  }
  return words.join(", ");
}

QVariant SceneModel::checkOf(const Place& place, int column) const {
  const auto state = [](bool on) { return QVariant(on ? Qt::Checked : Qt::Unchecked); };
  switch (column) {
    case eyeColumn:
      // The level that is edited is always drawn.
      return place.row == Row::level && place.level == document_.editLevel()
                 ? QVariant()
                 : state(switches_.isShown(place));
    case lockColumn:
      return state(switches_.isLocked(place));
    case tickColumn:
      return place.row == Row::point ? state(switches_.isEnabled(place)) : QVariant();
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
      return detailOf(place);
    case isEditLevelRole:
      return place.row == Row::level && place.level == document_.editLevel();
    case isDimRole:
      return place.row == Row::point && !pointAt(place).enabled;
    case relationRole:
      return static_cast<int>(relationOf(place));
    default:
      return {};
  }
}

bool SceneModel::setSwitch(const Place& place, int column, bool on) {
  switch (column) {
    case eyeColumn:
      switches_.setShown(place, on);
      return true;
    case lockColumn:
      return switches_.setLocked(place, on);
    case tickColumn:
      return switches_.setEnabled(place, on);
    default:
      return false;
  }
}

bool SceneModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid()) {
    return false;
  }
  const Place place = placeOf(index);
  if (role == Qt::CheckStateRole) {
    return data(index, role).isValid() && setSwitch(place, index.column(), value.toInt() == Qt::Checked);
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
