#pragma once

#include <QListView>

namespace pbffd::ui {

class MessageModel;
class Theme;

/// The messages of this session, wrapped, newest last.
class MessagesPanel : public QListView {
  Q_OBJECT

 public:
  MessagesPanel(MessageModel& messages, const Theme& theme, QWidget* parent = nullptr);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  MessageModel& messages_;
};

}  // namespace pbffd::ui
