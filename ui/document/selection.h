#pragma once

#include "core/base/types.h"

#include <QObject>

#include <functional>
#include <map>
#include <vector>

namespace pbffd::ui {

/// The selected control points, one list for each level, in the order in which they were selected; the
/// last one is the active point. The one selection that tree, view and inspector share.
class Selection : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Of the edit level. 1 is the coarsest.
  const std::vector<PointId>& points() const;
  bool isEmpty() const { return points().empty(); }
  bool contains(PointId point) const;
  /// 0 when nothing is selected.
  PointId active() const;

  int level() const { return level_; }
  /// Each level keeps its own selection.
  void setLevel(int level);

  void replace(std::vector<PointId> points);
  void add(const std::vector<PointId>& points);
  void remove(const std::vector<PointId>& points);
  void toggle(PointId point);
  void clear();

  /// Forgets points that are gone: `existing(level, point)` tells.
  void keepOnly(const std::function<bool(int level, PointId point)>& existing);
  /// The numbers of all levels change by this: coarser ones came (above 0) or went.
  void renumberLevels(int by);
  /// Forgets everything (another document).
  void reset(int level);

 Q_SIGNALS:
  void changed();
  void levelChanged(int level);
  void levelsRenumbered(int by);

 private:
  std::map<int, std::vector<PointId>> pointsOfLevel_;
  int level_ = 1;
};

}  // namespace pbffd::ui
