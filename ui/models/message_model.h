#pragma once

#include <QAbstractListModel>
#include <QDateTime>

#include <vector>

namespace pbffd::ui {

enum class Severity { info, warning, error };

struct Message {
  Severity severity = Severity::info;
  QString text;
  QDateTime time = QDateTime::currentDateTime();
};

/// What the program said in this session, newest last.
class MessageModel : public QAbstractListModel {
  Q_OBJECT

 public:
  enum Role { severityRole = Qt::UserRole, timeRole };

  using QAbstractListModel::QAbstractListModel;

  void add(Severity severity, const QString& text);
  void clear();
  const Message& at(int row) const { return messages_[static_cast<std::size_t>(row)]; }
  /// All of them as plain text, a line each.
  QString toText() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

 private:
  std::vector<Message> messages_;
};

}  // namespace pbffd::ui
