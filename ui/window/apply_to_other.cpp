#include "ui/window/apply_to_other.h"

#include "ui/controllers/actions.h"
#include "ui/document/document.h"
#include "ui/document/job_runner.h"
#include "ui/window/apply_dialog.h"
#include "ui/window/labels.h"

#include <QDir>
#include <QFileInfo>

#include <utility>

namespace pbffd::ui {
namespace {

QString joined(const std::vector<std::string>& remarks) {
  QStringList texts;
  for (const std::string& remark : remarks) {
    texts += QString::fromStdString(remark);
  }
  return texts.join(u' ');
}

}  // namespace

ApplyToOther::ApplyToOther(ApplyService service, Document& document, const Actions& actions, QWidget& window)
    : QObject(&window),
      service_(std::move(service)),
      document_(document),
      window_(window),
      folder_(QDir::homePath()) {
  QAction* action = actions[ActionId::applyToOther];
  action->setVisible(static_cast<bool>(service_));
  connect(action, &QAction::triggered, this, &ApplyToOther::ask);
}

void ApplyToOther::ask() {
  ApplyDialog dialog(service_, folder_, &window_);
  if (dialog.exec() == QDialog::Accepted) {
    folder_ = dialog.folder();
    start(dialog.request());
  }
}

void ApplyToOther::start(const ApplyService::Request& request) {
  const QString source = QString::fromStdU16String(request.source.filename().u16string());
  const QString target = QString::fromStdU16String(request.target.filename().u16string());
  const auto work = [document = &document_, apply = service_.apply, project = document_.committed(), request,
                     target](const Progress& progress) -> JobRunner::Deliver {
    const ApplyService::Report report = apply(project, request, progress);
    return [document, report, target] {
      Q_EMIT document->informed(
          report.pieces == 1
              ? tr("Wrote %1: %2 points.").arg(target, counted(report.points))
              : tr("Wrote %1: %2 points in %3 pieces.").arg(target, counted(report.points)).arg(report.pieces));
      if (!report.remarks.empty()) {
        Q_EMIT document->remarked(joined(report.remarks));
      }
    };
  };
  // A job of its own for each file to write: the next waits for it, and does not replace it.
  const QString key = "apply " + QString::fromStdU16String(request.target.u16string());
  document_.jobs().start({key, tr("Applying to %1").arg(source), work});
}

}  // namespace pbffd::ui
