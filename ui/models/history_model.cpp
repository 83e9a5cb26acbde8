#include "ui/models/history_model.h"

#include "ui/document/change_project.h"
#include "ui/document/document.h"

#include <QUndoStack>

namespace pbffd::ui {
namespace {

const ChangeProject* stepOf(const QUndoStack& history, int row) {
  return row >= 1 && row <= history.count() ? static_cast<const ChangeProject*>(history.command(row - 1))
                                            : nullptr;
}

struct IconOf {
  QString operator()(const Place&) const { return "place"; }
  QString operator()(const Move&) const { return "move"; }
  QString operator()(const Transform& edit) const { return edit.degrees != 0.0 ? "rotate" : "scale"; }
  QString operator()(const SetPose&) const { return "move"; }
  QString operator()(const SetRegion&) const { return "region"; }
  QString operator()(const Add&) const { return "add"; }
  QString operator()(const Remove&) const { return "remove"; }
  QString operator()(const Refine&) const { return "refine"; }
  QString operator()(const Enable& edit) const { return edit.enabled ? "eye" : "eye-off"; }
  QString operator()(const Lock& edit) const { return edit.locked ? "lock" : "unlock"; }
  QString operator()(const Rename&) const { return "rename"; }
  QString operator()(const SetLevels&) const { return "controls"; }
  QString operator()(const Reset&) const { return "undo"; }
  QString operator()(const Group& group) const {
    return group.edits.empty() ? QString("controls") : std::visit(*this, group.edits.front().value());
  }
  template <class E>
  QString operator()(const E&) const {
    return "kernel";
  }
};

}  // namespace

HistoryModel::HistoryModel(Document& document, QObject* parent)
    : QAbstractListModel(parent), document_(document), history_(document.history()) {
  connect(&history_, &QUndoStack::indexChanged, this, &HistoryModel::synchronize);
  connect(&history_, &QUndoStack::cleanChanged, this, &HistoryModel::synchronize);
  connect(&document, &Document::opened, this, &HistoryModel::synchronize);
  connect(&document, &Document::titleChanged, this, &HistoryModel::synchronize);
  synchronize();
}

int HistoryModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : rows_;
}

int HistoryModel::stepCount() const {
  return history_.count();
}

int HistoryModel::currentRow() const {
  return history_.index();
}

void HistoryModel::synchronize() {
  const int rows = document_.isOpen() ? history_.count() + 1 : 0;
  if (rows > rows_) {
    beginInsertRows({}, rows_, rows - 1);
    rows_ = rows;
    endInsertRows();
  } else if (rows < rows_) {
    beginRemoveRows({}, rows, rows_ - 1);
    rows_ = rows;
    endRemoveRows();
  }
  if (rows_ > 0) {
    Q_EMIT dataChanged(index(0), index(rows_ - 1));
    Q_EMIT currentRowChanged(currentRow());
  }
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rows_) {
    return {};
  }
  const int row = index.row();
  const ChangeProject* step = stepOf(history_, row);
  switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole:
      return step != nullptr ? step->text() : tr("Open %1").arg(document_.openedName());
    case iconRole:
      return step != nullptr ? std::visit(IconOf(), step->edit().value()) : QString("mesh");
    case timeRole:
      return step != nullptr ? step->time().toString("HH:mm") : QString();
    case isCurrentRole:
      return row == history_.index();
    case isFutureRole:
      return row > history_.index();
    case isSavedRole:
      return row == history_.cleanIndex() && !document_.path().isEmpty();
    default:
      return {};
  }
}

QString HistoryModel::editJson(int row) const {
  const ChangeProject* step = stepOf(history_, row);
  return step != nullptr ? step->editJson() : QString();
}

QString HistoryModel::editsJson() const {
  QStringList lines;
  for (int row = 1; row <= history_.index(); ++row) {
    lines += "  " + editJson(row);
  }
  return "[\n" + lines.join(",\n") + "\n]\n";
}

}  // namespace pbffd::ui
