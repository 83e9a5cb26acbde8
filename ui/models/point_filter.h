#pragma once

#include "core/ffd/control_point.h"

#include <QString>
#include <QStringList>

namespace pbffd::ui {

/// The English name of a kind, as the tree and the filter say it: "Interior".
QString kindTitle(PointKind kind);

/// The icon of a kind's glyph and the token of its colour.
QString kindIcon(PointKind kind);
QString kindToken(PointKind kind);

/// What a point is called on screen: its name, else "Point 74".
QString pointLabel(const ControlPoint& point);

/// The filter field of the scene tree: words that all have to fit. `kind:exterior`, `disabled`, `locked` and
/// `moved` ask for what they say; any other word is part of the name or the number itself.
class PointFilter {
 public:
  PointFilter() = default;
  explicit PointFilter(const QString& text);

  bool isEmpty() const { return words_.isEmpty(); }
  bool accepts(const ControlPoint& point) const;

 private:
  QStringList words_;
};

}  // namespace pbffd::ui
