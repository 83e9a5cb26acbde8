#pragma once

#include <QWidget>
#include <QtTest>

namespace pbffd::test {

/// Shows a window and gives it the keyboard focus. On a bare X server no window manager does that by itself.
inline bool showActive(QWidget& window) {
  window.show();
  if (!QTest::qWaitForWindowExposed(&window)) {
    return false;
  }
  window.activateWindow();
  return QTest::qWaitForWindowActive(&window);
}

}  // namespace pbffd::test
