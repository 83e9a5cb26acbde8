#include "app/workbench/screenshot.h"

#include "ui/document/document.h"
#include "ui/document/job_runner.h"
#include "ui/views/viewport.h"
#include "ui/window/main_window.h"
#include "ui/window/start_page.h"

#include <QApplication>
#include <QPixmap>

#include <cstdio>

namespace pbffd::workbench {
namespace {

/// Without a change for so long the window is taken as finished.
constexpr int settledMilliseconds = 400;

}  // namespace

Screenshot::Screenshot(ui::MainWindow& window, QString path, bool waitsForFile)
    : window_(window), path_(std::move(path)) {
  ui::Document& document = window.document();
  settled_.setSingleShot(true);
  settled_.setInterval(settledMilliseconds);
  connect(&settled_, &QTimer::timeout, this, &Screenshot::take);
  connect(&document, &ui::Document::failed, this, &Screenshot::fail);
  connect(&document.jobs(), &ui::JobRunner::finished, &settled_, qOverload<>(&QTimer::start));
  connect(&window.viewport(), &ui::Viewport::rendered, this, [this] {
    if (settled_.isActive()) {
      settled_.start();
    }
  });
  if (waitsForFile) {
    return;
  }
  const ui::StartPage& page = window.startPage();
  connect(&page, &ui::StartPage::pictured, &settled_, qOverload<>(&QTimer::start));
  if (page.isPictured()) {
    settled_.start();
  }
}

void Screenshot::take() {
  const QPixmap picture = window_.grab();
  if (!picture.save(path_)) {
    return fail(QString("Could not write %1. Give another folder, and an ending like .png.").arg(path_));
  }
  QApplication::exit(0);
}

void Screenshot::fail(const QString& reason) {
  std::fprintf(stderr, "%s\n", qUtf8Printable(reason));
  QApplication::exit(1);
}

}  // namespace pbffd::workbench
