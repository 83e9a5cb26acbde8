#include "ui/models/point_filter.h"

#include <QCoreApplication>

#include <algorithm>

namespace pbffd::ui {
namespace {

QString translated(const char* text) {
  return QCoreApplication::translate("PointFilter", text);
}

bool fits(const ControlPoint& point, const QString& word) {
  if (word.startsWith("kind:")) {
    return kindTitle(point.kind).startsWith(word.mid(5), Qt::CaseInsensitive);
  }
  if (word == "disabled") {
    return !point.enabled;
  }
  if (word == "locked") {
    return point.locked;
  }
  if (word == "moved") {
    return !(point.pose == point.rest);
  }
  return pointLabel(point).contains(word, Qt::CaseInsensitive) || QString::number(point.id) == word;
}

}  // namespace

QString kindTitle(PointKind kind) {
  switch (kind) {
    case PointKind::interior:
      return translated("Interior");
    case PointKind::exterior:
      return translated("Exterior");
    case PointKind::manual:
      return translated("Manual");
    case PointKind::merged:
      return translated("Merged");
    case PointKind::curve:
      break;
  }
  return translated("Curve");
}

QString kindIcon(PointKind kind) {
  static const char* const names[] = {"kind-interior", "kind-exterior", "kind-manual", "kind-merged",
                                      "kind-curve"};
  return names[static_cast<std::size_t>(kind)];
}

QString kindToken(PointKind kind) {
  static const char* const tokens[] = {"point.interior", "point.exterior", "point.manual", "point.merged",
                                       "point.curve"};
  return tokens[static_cast<std::size_t>(kind)];
}

QString pointLabel(const ControlPoint& point) {
  return point.name.empty() ? translated("Point %1").arg(point.id) : QString::fromStdString(point.name);
}

PointFilter::PointFilter(const QString& text) : words_(text.toLower().split(u' ', Qt::SkipEmptyParts)) {}

bool PointFilter::accepts(const ControlPoint& point) const {
  return std::all_of(words_.begin(), words_.end(), [&](const QString& word) { return fits(point, word); });
}

}  // namespace pbffd::ui
