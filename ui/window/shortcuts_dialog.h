#pragma once

#include <QDialog>

class QLineEdit;
class QTreeWidget;

namespace pbffd::ui {

class Actions;

/// All actions with their keys; typing narrows the list, Enter carries the marked one out ("Find action").
class ShortcutsDialog : public QDialog {
  Q_OBJECT

 public:
  ShortcutsDialog(const Actions& actions, QWidget* parent);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void fill();
  void narrow(const QString& text);
  void runCurrent();

  const Actions& actions_;
  QLineEdit* filter_;
  QTreeWidget* list_;
};

}  // namespace pbffd::ui
