#pragma once

#include "ui/models/message_model.h"

#include <QFrame>
#include <QTimer>

class QLabel;

namespace pbffd::ui {

class Theme;

/// A warning or an error over the top of the view. Warnings go after 8 s unless hovered or focused; errors
/// stay until they are closed.
class ErrorBar : public QFrame {
  Q_OBJECT

 public:
  ErrorBar(const Theme& theme, QWidget* parent);

  void show(Severity severity, const QString& text);
  QString text() const;
  Severity severity() const { return severity_; }

 Q_SIGNALS:
  void sizeChanged();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void maybeClose();

  const Theme& theme_;
  Severity severity_ = Severity::warning;
  QLabel* text_;
  QTimer timer_;
};

}  // namespace pbffd::ui
