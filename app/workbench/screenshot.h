#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

namespace pbffd::ui {
class MainWindow;
}

namespace pbffd::workbench {

/// Writes a picture of the window once the file is open, its points are placed and the view is drawn (without
/// a file: once the samples have their pictures), then ends the program: status 0, or 1 with the reason on
/// standard error.
class Screenshot : public QObject {
  Q_OBJECT

 public:
  Screenshot(ui::MainWindow& window, QString path, bool waitsForFile);

 private:
  void take();
  void fail(const QString& reason);

  ui::MainWindow& window_;
  QString path_;
  QTimer settled_;
};

}  // namespace pbffd::workbench
