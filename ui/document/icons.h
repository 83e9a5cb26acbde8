#pragma once

#include <QIcon>
#include <QString>

namespace pbffd::ui {

class Theme;

/// An icon of resources/icons in the colours of the theme, which it follows when the theme changes. The
/// theme must live longer than the icon.
struct IconColors {
  QString normal = "text";
  QString checked = "accent";
};
QIcon makeIcon(const Theme& theme, const QString& name, const IconColors& colors = {});

/// Draws the icon into `rect` in `color`: for delegates and painted widgets.
void drawIcon(QPainter& painter, const QRectF& rect, const QString& name, const QColor& color);

}  // namespace pbffd::ui
