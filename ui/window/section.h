#pragma once

#include <QFrame>

class QHBoxLayout;
class QPushButton;
class QVBoxLayout;

namespace pbffd::ui {

class Theme;

/// A part of the inspector under a heading that folds it.
class Section : public QFrame {
  Q_OBJECT

 public:
  Section(const Theme& theme, const QString& title, QWidget* parent = nullptr);

  /// Where the content goes.
  QVBoxLayout* body() const { return body_; }
  /// To the right in the heading.
  void addToHeading(QWidget* widget);
  void setFolded(bool folded);

 private:
  QPushButton* heading_;
  QHBoxLayout* headingRow_;
  QWidget* content_;
  QVBoxLayout* body_;
  const Theme& theme_;
};

/// A row of a section: a label of the width that all rows share, and fields.
QHBoxLayout* labelledRow(const QString& label, const QList<QWidget*>& fields);

}  // namespace pbffd::ui
