#pragma once

#include <QListView>

namespace pbffd::ui {

class Document;
class HistoryModel;
class Theme;

/// The history as a list: a click goes to that state, the row's menu copies it as an edit.
class HistoryPanel : public QListView {
  Q_OBJECT

 public:
  HistoryPanel(Document& document, const Theme& theme, QWidget* parent = nullptr);

  const HistoryModel& steps() const { return *model_; }

 Q_SIGNALS:
  void noteChanged(const QString& note);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void follow();

  Document& document_;
  HistoryModel* model_;
};

}  // namespace pbffd::ui
