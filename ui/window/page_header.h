#pragma once

#include <QFrame>

class QLabel;

namespace pbffd::ui {

class Theme;

/// The head of an inspector page: a tile with an icon, what it is, and a line about it.
class PageHeader : public QFrame {
  Q_OBJECT

 public:
  PageHeader(const Theme& theme, QWidget* parent = nullptr);

  struct Content {
    QString icon;
    QString iconToken;
    QString groundToken;
    QString title;
    QString detail;
  };
  void show(const Content& content);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const Theme& theme_;
  Content content_;
  QLabel* title_;
  QLabel* detail_;
};

}  // namespace pbffd::ui
