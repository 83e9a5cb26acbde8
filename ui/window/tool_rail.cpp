#include "ui/window/tool_rail.h"

#include "ui/document/icons.h"
#include "ui/document/theme.h"

#include <QAction>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

namespace pbffd::ui {
namespace {

constexpr int railWidth = 44;
constexpr int buttonSize = 34;
constexpr int symbolSize = 20;

class RailButton : public QToolButton {
 public:
  RailButton(const Theme& theme, QAction& action)
      : theme_(theme), iconName_(action.property("iconName").toString()) {
    setProperty("role", "rail");
    setDefaultAction(&action);
    setFixedSize(buttonSize, buttonSize);
    setAccessibleName(action.objectName());
  }

 protected:
  /// The ground by the style sheet, the icon and the key over it.
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QString token = !isEnabled() ? "disabled" : isChecked() ? "accent.text" : "text";
    if (isChecked() || underMouse()) {
      painter.setPen(Qt::NoPen);
      painter.setBrush(theme_.color(isChecked() ? "accent" : "hover"));
      painter.drawRoundedRect(rect(), 6, 6);
    }
    if (hasFocus()) {
      painter.setPen(QPen(theme_.color(isChecked() ? "text" : "accent"), 2));
      painter.setBrush(Qt::NoBrush);
      painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);
    }
    const QRectF icon((width() - symbolSize) / 2.0 - 1, (height() - symbolSize) / 2.0 - 1, symbolSize,
                      symbolSize);
    drawIcon(painter, icon, iconName_, theme_.color(token));
    QFont font = Theme::font(9, QFont::Bold);
    painter.setFont(font);
    painter.setPen(theme_.color(isChecked() ? "accent.text" : "text.3"));
    painter.drawText(rect().adjusted(0, 0, -3, -2), Qt::AlignRight | Qt::AlignBottom,
                     defaultAction()->shortcut().toString());
  }

 private:
  const Theme& theme_;
  QString iconName_;
};

}  // namespace

ToolRail::ToolRail(const Theme& theme, const QList<QAction*>& tools, QWidget* parent) : QFrame(parent) {
  setProperty("role", "overlay");
  setAccessibleName(tr("Tools"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 5, 4, 5);
  column->setSpacing(3);
  for (QAction* tool : tools) {
    column->addWidget(new RailButton(theme, *tool), 0, Qt::AlignHCenter);
  }
  setFixedWidth(railWidth);
  adjustSize();
}

}  // namespace pbffd::ui
