#pragma once

#include <QAbstractListModel>

class QUndoStack;

namespace pbffd::ui {

class Document;

/// The history as rows: the opened file first, then one row an undo entry. Row n is the state after n steps.
class HistoryModel : public QAbstractListModel {
  Q_OBJECT

 public:
  enum Role {
    iconRole = Qt::UserRole,  ///< the name of the icon
    timeRole,                 ///< "10:05", empty for the first row
    isCurrentRole,
    isFutureRole,  ///< undone: still there until the next edit
    isSavedRole,
  };

  explicit HistoryModel(Document& document, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

  int currentRow() const;
  int stepCount() const;
  /// The entry as the edit that `pbffd edit` reads; empty for the first row.
  QString editJson(int row) const;
  /// All steps up to the present state as a JSON array.
  QString editsJson() const;

 Q_SIGNALS:
  void currentRowChanged(int row);

 private:
  void synchronize();

  Document& document_;
  const QUndoStack& history_;
  int rows_ = 0;
};

}  // namespace pbffd::ui
