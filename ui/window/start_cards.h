#pragma once

#include <QAbstractButton>
#include <QFrame>
#include <QImage>

class QLabel;

namespace pbffd::ui {

class Theme;

/// A sample on the start page: its picture, name and number of triangles.
class SampleCard : public QAbstractButton {
  Q_OBJECT

 public:
  SampleCard(const Theme& theme, const QString& name, QWidget* parent = nullptr);
  void setPicture(const QImage& picture, int triangles);
  QSize sizeHint() const override { return {292, 198}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  const Theme& theme_;
  bool isPointedAt_ = false;  ///< by a pointer that moved: where it happens to be at the start says nothing
  QImage picture_;
  QString count_;
};

/// A file opened before: picture, name, folder, when, how many points. Grey where it is no longer there.
class RecentRow : public QAbstractButton {
  Q_OBJECT

 public:
  struct Content {
    QImage picture;
    QString path;
    QString when;
    int points = 0;
    bool isMissing = false;
  };
  RecentRow(const Theme& theme, const Content& content, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {300, 48}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  const Theme& theme_;
  Content content_;
};

/// Where files can be dropped; the whole window takes them, this shows it.
class DropArea : public QFrame {
  Q_OBJECT

 public:
  explicit DropArea(const Theme& theme, QWidget* parent = nullptr);
  void showDrag(bool isOver, const QString& reason);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const Theme& theme_;
  QLabel* title_;
  QLabel* detail_;
};

}  // namespace pbffd::ui
