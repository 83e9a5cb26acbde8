#include "ui/models/message_model.h"

#include <QStringList>

namespace pbffd::ui {
namespace {

constexpr int mostMessages = 500;

}  // namespace

void MessageModel::add(Severity severity, const QString& text) {
  if (rowCount() == mostMessages) {
    beginRemoveRows({}, 0, 0);
    messages_.erase(messages_.begin());
    endRemoveRows();
  }
  beginInsertRows({}, rowCount(), rowCount());
  messages_.push_back({severity, text, QDateTime::currentDateTime()});
  endInsertRows();
}

void MessageModel::clear() {
  beginResetModel();
  messages_.clear();
  endResetModel();
}

QString MessageModel::toText() const {
  QStringList lines;
  for (const Message& message : messages_) {
    lines += message.time.toString("HH:mm:ss") + "  " + message.text;
  }
  return lines.join(u'\n');
}

int MessageModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(messages_.size());
}

QVariant MessageModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) {
    return {};
  }
  const Message& message = at(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return message.text;
    case severityRole:
      return static_cast<int>(message.severity);
    case timeRole:
      return message.time.toString("HH:mm");
    default:
      return {};
  }
}

}  // namespace pbffd::ui
