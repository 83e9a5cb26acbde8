#pragma once

#include <QFrame>
#include <QList>

class QAction;

namespace pbffd::ui {

class Theme;

/// The tools, over the view at the top left: an icon each with its key in the corner.
class ToolRail : public QFrame {
  Q_OBJECT

 public:
  ToolRail(const Theme& theme, const QList<QAction*>& tools, QWidget* parent);
};

}  // namespace pbffd::ui
