#include "ui/window/shortcuts_dialog.h"

#include "ui/controllers/actions.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace pbffd::ui {
namespace {

constexpr int idRole = Qt::UserRole;

QString keysText(const QAction& action) {
  QStringList keys;
  for (const QKeySequence& key : action.shortcuts()) {
    keys += key.toString(QKeySequence::NativeText);
  }
  return keys.join(",  ");
}

}  // namespace

ShortcutsDialog::ShortcutsDialog(const Actions& actions, QWidget* parent)
    : QDialog(parent), actions_(actions), filter_(new QLineEdit), list_(new QTreeWidget) {
  setWindowTitle(tr("Actions and shortcuts"));
  resize(560, 560);
  filter_->setPlaceholderText(tr("Find an action"));
  filter_->setClearButtonEnabled(true);
  filter_->installEventFilter(this);
  list_->setColumnCount(3);
  list_->setHeaderLabels({tr("Action"), tr("Menu"), tr("Keys")});
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  list_->setAccessibleName(tr("Actions"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(filter_);
  column->addWidget(list_);
  fill();
  connect(filter_, &QLineEdit::textChanged, this, &ShortcutsDialog::narrow);
  connect(list_, &QTreeWidget::itemActivated, this, &ShortcutsDialog::runCurrent);
}

void ShortcutsDialog::fill() {
  for (int id = 0; id < static_cast<int>(ActionId::count_); ++id) {
    const QAction& action = *actions_[static_cast<ActionId>(id)];
    if (!action.isVisible()) {
      continue;
    }
    auto* item = new QTreeWidgetItem(
        list_, {action.text().remove("..."), Actions::menuOf(static_cast<ActionId>(id)), keysText(action)});
    item->setData(0, idRole, id);
    item->setDisabled(!action.isEnabled());
    item->setToolTip(0, actions_.reasonAgainst(static_cast<ActionId>(id)));
  }
  list_->setCurrentItem(list_->topLevelItem(0));
}

void ShortcutsDialog::narrow(const QString& text) {
  QTreeWidgetItem* first = nullptr;
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = list_->topLevelItem(i);
    const bool fits =
        item->text(0).contains(text, Qt::CaseInsensitive) || item->text(2).contains(text, Qt::CaseInsensitive);
    item->setHidden(!fits);
    if (fits && first == nullptr && !item->isDisabled()) {
      first = item;
    }
  }
  list_->setCurrentItem(first);
}

void ShortcutsDialog::runCurrent() {
  const QTreeWidgetItem* item = list_->currentItem();
  if (item == nullptr || item->isHidden() || item->isDisabled()) {
    return;
  }
  QAction* action = actions_[static_cast<ActionId>(item->data(0, idRole).toInt())];
  accept();
  action->trigger();
}

bool ShortcutsDialog::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
      runCurrent();
      return true;
    }
    if (key->key() == Qt::Key_Down || key->key() == Qt::Key_Up) {
      list_->setFocus();
      return true;
    }
  }
  return QDialog::eventFilter(object, event);
}

}  // namespace pbffd::ui
