#pragma once

#include "core/project/project.h"
#include "ui/models/scene_relatives.h"
#include "ui/models/scene_rows.h"
#include "ui/models/scene_switches.h"

#include <QAbstractItemModel>
#include <QItemSelection>

namespace pbffd::ui {

class Document;
class ViewState;

/// The scene tree: the mesh, the control set with its levels, groups by kind, and points. Drawn from the
/// core's values by identifiers; nothing is copied but the places of the rows.
class SceneModel : public QAbstractItemModel {
  Q_OBJECT

 public:
  enum Column { nameColumn, countColumn, eyeColumn, lockColumn, tickColumn, columnCount_ };
  using Row = SceneRow;
  enum Role {
    rowRole = Qt::UserRole,  ///< Row, as int
    levelRole,               ///< 1 is the coarsest; 0 for rows above the levels
    pointRole,               ///< PointId, 0 for others
    kindRole,                ///< PointKind, as int; -1 for others
    detailRole,  ///< drawn quietly after the name: a named point's number, what it is to the selection
    isEditLevelRole,
    isDimRole,     ///< a disabled point
    relationRole,  ///< Relation, as int: of a point, or of points below a group or level
  };

  SceneModel(Document& document, ViewState& view, QObject* parent = nullptr);

  void setFilter(const QString& text);
  bool isFiltered() const { return !filter_.isEmpty(); }

  QModelIndex controlsIndex() const { return index(1, 0); }
  QModelIndex levelIndex(int level) const { return index(level - 1, 0, controlsIndex()); }
  /// Invalid where the filter hides the point.
  QModelIndex pointIndex(int level, PointId point) const;
  /// The rows of these points of a level, as few ranges as possible.
  QItemSelection rowsOf(int level, const std::vector<PointId>& points) const;
  /// The points below an index (a point's own, all of a group, a level or the set), with their level; only
  /// those that the filter shows.
  std::vector<PointId> pointsBelow(const QModelIndex& index) const;

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  /// Eye, lock and tick by Qt::CheckStateRole, a point's name by Qt::EditRole.
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 private:
  using Place = ScenePlace;

  Place placeOf(const QModelIndex& index) const;
  const ControlPoint& pointAt(const Place& place) const;
  const ControlSet& controls() const;
  QString nameOf(const Place& place) const;
  QString countOf(const Place& place) const;
  QString detailOf(const Place& place) const;
  /// "2 parents", of a level or a group.
  QString relativesBelow(const Place& place) const;
  Relation relationOf(const Place& place) const;
  QVariant checkOf(const Place& place, int column) const;
  bool setSwitch(const Place& place, int column, bool on);
  void reset();
  void update(const ProjectChanges& what);
  void refreshAll();
  void findRelatives();

  Document& document_;
  PointFilter filter_;
  SceneRows rows_;
  SceneRelatives relatives_;
  SceneSwitches switches_;
};

}  // namespace pbffd::ui
