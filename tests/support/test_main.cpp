#include "tests/support/test_main.h"

#include <QtTest>

#ifdef PBFFD_GUI_TESTS
#include <QApplication>
#include <QStandardPaths>
#include <QSurfaceFormat>
#endif

#include <cstdio>
#include <utility>
#include <vector>

namespace pbffd::test {
namespace {

struct Entry {
  QByteArray className;  ///< without its namespace
  Registry::Factory factory;
};

/// Filled by static objects of other files, so it is made when first asked for.
std::vector<Entry>& entries() {
  static std::vector<Entry> list;
  return list;
}

}  // namespace

void Registry::add(const char* className, Factory factory) {
  QByteArray name(className);
  entries().push_back({name.mid(name.lastIndexOf(':') + 1), std::move(factory)});
}

}  // namespace pbffd::test

/// --class NAME runs that test class alone; everything else goes to QtTest.
int main(int argc, char** argv) {
#ifdef PBFFD_GUI_TESTS
  // Debian's GLEW speaks GLX only, and the off-screen platform has no OpenGL widgets.
  qputenv("QT_QPA_PLATFORM", "xcb");
  qputenv("QT_XCB_GL_INTEGRATION", "xcb_glx");
  QSurfaceFormat surface;
  surface.setVersion(3, 2);
  surface.setProfile(QSurfaceFormat::CoreProfile);
  surface.setSamples(0);
  QSurfaceFormat::setDefaultFormat(surface);
  QStandardPaths::setTestModeEnabled(true);
  QApplication application(argc, argv);
#else
  QCoreApplication application(argc, argv);
#endif
  QStringList arguments = application.arguments();
  QByteArray only;
  if (const qsizetype at = arguments.indexOf("--class"); at >= 0 && at + 1 < arguments.size()) {
    only = arguments.at(at + 1).toUtf8();
    arguments.remove(at, 2);
  }
  int failures = 0;
  int ran = 0;
  for (const auto& entry : pbffd::test::entries()) {
    if (only.isEmpty() || only == entry.className) {
      failures += QTest::qExec(entry.factory().get(), arguments);
      ++ran;
    }
  }
  if (ran == 0) {
    std::fprintf(stderr, "No test class is called %s.\n", only.constData());
    return 1;
  }
  return failures == 0 ? 0 : 1;
}
