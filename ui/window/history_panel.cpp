#include "ui/window/history_panel.h"

#include "ui/document/document.h"
#include "ui/document/theme.h"
#include "ui/models/history_delegate.h"
#include "ui/models/history_model.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>

namespace pbffd::ui {

HistoryPanel::HistoryPanel(Document& document, const Theme& theme, QWidget* parent)
    : QListView(parent), document_(document), model_(new HistoryModel(document, this)) {
  setAccessibleName(tr("History"));
  setModel(model_);
  setItemDelegate(new HistoryDelegate(theme, this));
  setUniformItemSizes(true);
  setMouseTracking(true);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(this, &QListView::clicked, this, [this](const QModelIndex& index) { document_.goTo(index.row()); });
  connect(this, &QListView::activated, this, [this](const QModelIndex& index) { document_.goTo(index.row()); });
  connect(model_, &HistoryModel::currentRowChanged, this, &HistoryPanel::follow);
  connect(&theme, &Theme::changed, viewport(), qOverload<>(&QWidget::update));
}

void HistoryPanel::follow() {
  scrollTo(model_->index(model_->currentRow()));
  const int steps = model_->stepCount();
  Q_EMIT noteChanged(steps == 1 ? tr("1 step") : tr("%1 steps").arg(steps));
}

void HistoryPanel::contextMenuEvent(QContextMenuEvent* event) {
  const QModelIndex index = indexAt(event->pos());
  const QString json = index.isValid() ? model_->editJson(index.row()) : QString();
  if (!index.isValid()) {
    return;
  }
  QMenu menu(this);
  menu.addAction(tr("Go to this state"), this, [this, index] { document_.goTo(index.row()); });
  QAction* copy =
      menu.addAction(tr("Copy as edit"), this, [json] { QApplication::clipboard()->setText(json); });
  copy->setEnabled(!json.isEmpty());
  menu.exec(event->globalPos());
}

}  // namespace pbffd::ui
