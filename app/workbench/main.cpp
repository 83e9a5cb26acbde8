#ifdef PBFFD_APPLY
#include "app/workbench/apply_service.h"
#endif
#include "app/workbench/options.h"
#include "app/workbench/screenshot.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QIcon>
#include <QSettings>
#include <QSurfaceFormat>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>

namespace {

using namespace pbffd;

/// What Qt has to know before there is an application.
void prepareGraphics() {
  // GLEW, as Debian builds it for VTK, speaks GLX only: a Wayland session runs through XWayland.
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) {
    qputenv("QT_QPA_PLATFORM", "xcb");
  }
  if (!qEnvironmentVariableIsSet("QT_XCB_GL_INTEGRATION")) {
    qputenv("QT_XCB_GL_INTEGRATION", "xcb_glx");
  }
  QSurfaceFormat surface;
  surface.setVersion(3, 2);
  surface.setProfile(QSurfaceFormat::CoreProfile);
  surface.setSamples(0);
  QSurfaceFormat::setDefaultFormat(surface);
}

ui::MainWindow::Options windowOptions(const workbench::Options& options) {
  const bool remembers = options.screenshot.isEmpty();
  ui::Theme::Choice theme = options.theme;
  if (remembers && !options.hasTheme) {
    theme = static_cast<ui::Theme::Choice>(std::clamp(QSettings().value("theme", 0).toInt(), 0, 2));
  }
#ifdef PBFFD_APPLY
  return {theme, remembers, workbench::applyService()};
#else
  return {theme, remembers};
#endif
}

int run(QApplication& application, const workbench::Options& options) {
  ui::MainWindow window(windowOptions(options));
  application.setWindowIcon(QIcon(":/icons/pbffd-workbench.svg"));
  if (options.hasSize || !options.screenshot.isEmpty()) {
    window.setMinimumSize(options.size.boundedTo(window.minimumSize()));
    window.resize(options.size);
  }
  std::unique_ptr<workbench::Screenshot> screenshot;
  if (!options.screenshot.isEmpty()) {
    screenshot = std::make_unique<workbench::Screenshot>(window, options.screenshot, !options.file.isEmpty());
  }
  window.show();
  if (!options.file.isEmpty()) {
    window.openFile(options.file);
  }
  return application.exec();
}

}  // namespace

int main(int argc, char** argv) {
  QStringList arguments;
  for (int i = 1; i < argc; ++i) {
    arguments += QString::fromLocal8Bit(argv[i]);
  }
  try {
    const workbench::Options options = workbench::parseOptions(arguments);
    if (options.wantsHelp) {
      std::fputs(qPrintable(workbench::usage()), stdout);
      return 0;
    }
    if (options.wantsVersion) {
      std::puts("pbffd-workbench " PBFFD_VERSION);
      return 0;
    }
    prepareGraphics();
    QApplication application(argc, argv);
    QApplication::setOrganizationName("pbffd");
    QApplication::setApplicationName("pbffd-workbench");
    QApplication::setApplicationDisplayName({});
    QApplication::setApplicationVersion(PBFFD_VERSION);
    QGuiApplication::setDesktopFileName("pbffd-workbench");
    return run(application, options);
  } catch (const workbench::UsageError& error) {
    std::fprintf(stderr, "%s\n\n%s", error.what(), qPrintable(workbench::usage()));
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
