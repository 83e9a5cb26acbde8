#pragma once

#include <QDockWidget>

class QLabel;
class QToolButton;

namespace pbffd::ui {

class Theme;

/// A dock with the workbench's own title bar: name, a quiet note, a menu where there is one, float, close.
class Dock : public QDockWidget {
  Q_OBJECT

 public:
  struct Look {
    QString title;
    QString name;            ///< for the saved layout
    bool hasButtons = true;  ///< float and close; else only a menu
    QMenu* menu = nullptr;   ///< behind three dots
  };
  Dock(const Theme& theme, const Look& look, QWidget* content);

  void setNote(const QString& note);
  /// A number after the title: what is unread.
  void setBadge(int number);

 private:
  QWidget* makeTitleBar(const Theme& theme, const Look& look);

  QString title_;
  QLabel* titleLabel_ = nullptr;
  QLabel* note_ = nullptr;
};

/// A small button without a frame that shows an icon.
QToolButton* makeIconButton(const Theme& theme, const QString& icon, const QString& toolTip, int size = 24);

}  // namespace pbffd::ui
