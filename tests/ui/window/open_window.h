#pragma once

#include "tests/support/shown_window.h"
#include "tests/ui/document/opened.h"
#include "ui/controllers/actions.h"
#include "ui/views/viewport.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QTimer>
#include <QtTest>

namespace pbffd::test {

/// The real window, which keeps no settings, and a folder for its files.
struct OpenWindow {
  explicit OpenWindow(const ui::MainWindow::Options& options = {ui::Theme::Choice::dark, false, {}})
      : window(options) {
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    window.resize(1400, 900);
    isReady = showActive(window);
  }

  bool open(const QString& path) {
    window.openFile(path);
    return finishJobs(window.document());
  }

  /// Answers the file chooser that the next action opens.
  static void answerFileDialog(const QString& path) {
    QTimer::singleShot(0, qApp, [path] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) {
        return answerFileDialog(path);
      }
      // Its button waits until the list of the folder has been read, which takes a while.
      dialog->findChild<QLineEdit*>("fileNameEdit")->setText(path);
      QMetaObject::invokeMethod(dialog, "accept");
    });
  }

  void key(Qt::Key which, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(&window, which, modifiers); }

  QPoint placeOf(PointId id) {
    const Level& level = window.document().shown().controls.finest();
    const Vec3 at = window.viewport().projected(level[*level.find(id)].pose.center);
    return {qRound(at.x()), qRound(at.y())};
  }

  QTemporaryDir folder;
  ui::MainWindow window;
  bool isReady = false;
};

}  // namespace pbffd::test
