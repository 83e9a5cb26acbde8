#include "ui/window/labels.h"

#include <QLocale>
#include <QStyle>
#include <QVariant>

namespace pbffd::ui {

QLabel* makeLabel(const QString& text, const char* role, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setProperty("role", role);
  return label;
}

QFrame* makeSeparator(QWidget* parent) {
  auto* line = new QFrame(parent);
  line->setProperty("role", "separator");
  line->setFixedSize(1, 22);
  return line;
}

void setStyleProperty(QWidget* widget, const char* name, const QVariant& value) {
  if (widget->property(name) == value) {
    return;
  }
  widget->setProperty(name, value);
  widget->style()->unpolish(widget);
  widget->style()->polish(widget);
}

QString counted(qint64 number) {
  return QLocale(QLocale::English).toString(number);
}

}  // namespace pbffd::ui
