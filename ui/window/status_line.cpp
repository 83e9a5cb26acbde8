#include "ui/window/status_line.h"

#include "ui/document/document.h"
#include "ui/document/job_runner.h"
#include "ui/document/theme.h"
#include "ui/window/hint_row.h"
#include "ui/window/labels.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>

namespace pbffd::ui {
namespace {

/// A job is shown when it lasts longer.
constexpr int showAfterMilliseconds = 300;
constexpr double timeLeftAfterSeconds = 3.0;

}  // namespace

StatusLine::StatusLine(Document& document, const Theme& theme, QWidget* parent)
    : QStatusBar(parent),
      document_(document),
      hints_(new HintRow),
      progress_(makeProgress()),
      simplified_(makeLabel(tr("Simplified while dragging"), "label")),
      selection_(makeLabel({}, "label")),
      vertices_(makeLabel({}, "label")),
      milliseconds_(makeLabel({}, "label")) {
  setSizeGripEnabled(false);
  addWidget(hints_, 1);
  addWidget(progress_, 1);
  progress_->hide();
  for (QLabel* label : {simplified_, selection_, vertices_, milliseconds_}) {
    label->setContentsMargins(8, 0, 8, 0);
    addPermanentWidget(label);
  }
  simplified_->setObjectName("simplified");
  milliseconds_->setObjectName("milliseconds");
  simplified_->setToolTip(tr("Drawing the whole mesh takes too long for a drag; it is back when you let go"));
  simplified_->hide();
  milliseconds_->setToolTip(tr("The last deformation"));
  showTimer_.setSingleShot(true);
  showTimer_.setInterval(showAfterMilliseconds);
  connect(&showTimer_, &QTimer::timeout, this, [this] {
    hints_->hide();
    progress_->show();
  });
  connectJobs();
  connect(&document, &Document::opened, this, &StatusLine::showFigures);
  connect(&document, &Document::changed, this, &StatusLine::showFigures);
  connect(&document.selection(), &Selection::changed, this, &StatusLine::showFigures);
  connect(&theme, &Theme::changed, hints_, &HintRow::rebuild);
  showFigures();
}

QWidget* StatusLine::makeProgress() {
  auto* widget = new QWidget;
  stage_ = makeLabel({}, "strong");
  bar_ = new QProgressBar;
  bar_->setTextVisible(false);
  bar_->setFixedWidth(220);
  bar_->setAccessibleName(tr("Progress"));
  timeLeft_ = makeLabel({}, "label");
  cancel_ = new QPushButton(tr("Cancel"));
  cancel_->setProperty("role", "link");
  cancel_->setToolTip(tr("Stops this; everything stays as it was"));
  auto* row = new QHBoxLayout(widget);
  row->setContentsMargins(12, 0, 0, 0);
  row->setSpacing(10);
  row->addWidget(stage_);
  row->addWidget(bar_);
  row->addWidget(timeLeft_);
  row->addWidget(cancel_);
  row->addStretch();
  return widget;
}

void StatusLine::connectJobs() {
  JobRunner& jobs = document_.jobs();
  connect(cancel_, &QPushButton::clicked, &jobs, qOverload<>(&JobRunner::cancel));
  connect(&jobs, &JobRunner::started, this, [this](const QString& title) {
    showProgress(title, -1.0);
    if (!progress_->isVisible()) {
      showTimer_.start();
    }
  });
  connect(&jobs, &JobRunner::progressed, this, &StatusLine::showProgress);
  connect(&jobs, &JobRunner::finished, this, [this] {
    showTimer_.stop();
    progress_->hide();
    hints_->show();
  });
}

void StatusLine::showProgress(const QString& stage, double share) {
  const bool isKnown = share >= 0.0;
  // It would repaint at once, and with it whatever waits for the next frame: the view of a large mesh.
  bar_->setUpdatesEnabled(false);
  bar_->setRange(0, isKnown ? 1000 : 0);
  bar_->setValue(isKnown ? static_cast<int>(share * 1000.0) : 0);
  bar_->setUpdatesEnabled(true);
  stage_->setText(isKnown ? tr("%1 %2 %").arg(stage).arg(static_cast<int>(share * 100.0)) : stage);
  const double spent = document_.jobs().runningSeconds();
  const bool canTell = isKnown && share > 0.05 && spent > timeLeftAfterSeconds;
  timeLeft_->setText(canTell ? tr("%1 s left").arg(static_cast<int>(spent * (1.0 - share) / share) + 1)
                             : QString());
}

void StatusLine::setHint(const QString& hint) {
  hints_->setHint(hint);
}

QString StatusLine::hint() const {
  return hints_->hint();
}

void StatusLine::setSimplified(bool isSimplified) {
  simplified_->setVisible(isSimplified);
}

void StatusLine::showFigures() {
  const bool isOpen = document_.isOpen();
  selection_->setVisible(isOpen);
  vertices_->setVisible(isOpen);
  if (!isOpen) {
    milliseconds_->hide();
    return;
  }
  const auto& levels = document_.shown().controls.levels;
  const auto place = static_cast<std::size_t>(document_.editLevel());
  const Index all = place < levels.size() ? levels[place].size() : 0;
  selection_->setText(
      tr("%1 of %2 points")
          .arg(counted(static_cast<qint64>(document_.selection().points().size())), counted(all)));
  const Index moved = document_.lastMovedVertices();
  vertices_->setText(moved > 0 ? tr("%1 vertices move").arg(counted(moved))
                               : tr("%1 vertices").arg(counted(document_.shown().mesh->vertexCount())));
  const double spent = document_.lastMilliseconds();
  milliseconds_->setVisible(spent > 0.0);
  milliseconds_->setText(tr("%1 ms").arg(QString::number(spent, 'f', spent < 10.0 ? 1 : 0)));
}

}  // namespace pbffd::ui
