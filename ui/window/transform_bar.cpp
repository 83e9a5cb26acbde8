#include "ui/window/transform_bar.h"

#include "ui/controllers/transform_options.h"
#include "ui/window/labels.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>

namespace pbffd::ui {
namespace {

QComboBox* makeChoice(const QStringList& items, const QString& name) {
  auto* combo = new QComboBox;
  combo->addItems(items);
  combo->setAccessibleName(name);
  combo->setFocusPolicy(Qt::TabFocus);
  return combo;
}

}  // namespace

TransformBar::TransformBar(TransformOptions& options, QAction& snap, QWidget* parent) : QWidget(parent) {
  QComboBox* axes = makeChoice({tr("Global"), tr("Local"), tr("View")}, tr("Axes"));
  QComboBox* pivot = makeChoice({tr("Median"), tr("Active point"), tr("Each its own")}, tr("Pivot"));
  auto* snapButton = new QToolButton;
  snapButton->setDefaultAction(&snap);
  snapButton->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  snapButton->setFixedHeight(26);
  snapButton->setIconSize({16, 16});
  setStyleProperty(snapButton, "role", "boxed");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  row->addWidget(makeLabel(tr("Axes"), "label"));
  row->addWidget(axes);
  row->addWidget(makeLabel(tr("Pivot"), "label"));
  row->addWidget(pivot);
  row->addWidget(snapButton);
  const auto show = [axes, pivot, &snap, &options] {
    axes->setCurrentIndex(static_cast<int>(options.axes()));
    pivot->setCurrentIndex(static_cast<int>(options.pivot()));
    snap.setChecked(options.snaps());
  };
  connect(axes, &QComboBox::activated, this,
          [&options](int index) { options.setAxes(static_cast<AxesChoice>(index)); });
  connect(pivot, &QComboBox::activated, this,
          [&options](int index) { options.setPivot(static_cast<PivotChoice>(index)); });
  connect(&snap, &QAction::toggled, this, [&options](bool on) { options.setSnaps(on); });
  connect(&options, &TransformOptions::changed, this, show);
  show();
}

}  // namespace pbffd::ui
