#pragma once

#include <QStatusBar>
#include <QTimer>

class QLabel;
class QProgressBar;
class QPushButton;

namespace pbffd::ui {

class Document;
class HintRow;
class Theme;

/// The status bar: hints of the tool at the left, or the progress of a long job with Cancel; the selection,
/// the vertices that moved and the time that took at the right.
class StatusLine : public QStatusBar {
  Q_OBJECT

 public:
  StatusLine(Document& document, const Theme& theme, QWidget* parent = nullptr);

  /// Keys stand in square brackets: "Moving along Y  [Shift] precise  [Esc] cancel".
  void setHint(const QString& hint);
  QString hint() const;
  /// Says that a coarse mesh stands in for the true one.
  void setSimplified(bool isSimplified);

 private:
  QWidget* makeProgress();
  void connectJobs();
  void showProgress(const QString& stage, double share);
  void showFigures();

  Document& document_;
  HintRow* hints_;
  QWidget* progress_;
  QLabel* stage_;
  QProgressBar* bar_;
  QLabel* timeLeft_;
  QPushButton* cancel_;
  QLabel* simplified_;
  QLabel* selection_;
  QLabel* vertices_;
  QLabel* milliseconds_;
  QTimer showTimer_;
};

}  // namespace pbffd::ui
