#pragma once

#include <QFrame>
#include <QLabel>

namespace pbffd::ui {

/// A label in one of the style sheet's roles: label, quiet, caption, strong, heading, bad, key.
QLabel* makeLabel(const QString& text, const char* role, QWidget* parent = nullptr);

/// A thin line between things that lie beside each other.
QFrame* makeSeparator(QWidget* parent = nullptr);

/// Sets a property that the style sheet looks at.
void setStyleProperty(QWidget* widget, const char* name, const QVariant& value);

/// 2,903: figures as they are written everywhere on screen.
QString counted(qint64 number);

}  // namespace pbffd::ui
