#pragma once

#include <QWidget>

class QHBoxLayout;

namespace pbffd::ui {

/// What the mouse and the keys do, in a row. Where it is too narrow hints are left out whole: the first, which
/// says what is going on, and the last, which says how to leave it, go last.
class HintRow : public QWidget {
  Q_OBJECT

 public:
  explicit HintRow(QWidget* parent = nullptr);

  /// Keys stand in square brackets, two blanks part the hints: "Moving along Y  [Shift] precise  [Esc] cancel".
  void setHint(const QString& hint);
  QString hint() const { return hint_; }
  /// Makes the labels again: they keep the looks of the theme that they were made in.
  void rebuild();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeHint(const QString& text, bool isFirst);
  void leaveOut();

  QString hint_;
  QHBoxLayout* row_;
  QList<QWidget*> hints_;
};

}  // namespace pbffd::ui
