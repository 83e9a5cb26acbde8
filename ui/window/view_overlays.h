#pragma once

#include <QObject>

class QFrame;
class QLabel;

namespace pbffd::ui {

class Actions;
class Document;
class Theme;
class ToolRail;
class ViewState;
class Viewport;

/// The widgets that lie over the view: tools at the top left, what the view shows beside them, the view bar
/// at the top right.
class ViewOverlays : public QObject {
  Q_OBJECT

 public:
  struct Sources {
    const Actions& actions;
    Document& document;
    ViewState& view;
    const Theme& theme;
  };
  ViewOverlays(Viewport& viewport, const Sources& sources, QObject* parent = nullptr);

  /// Where in the view the tools end.
  int toolsRight() const;

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  QFrame* makeViewBar(QWidget& surface);
  void showLabel();
  void fitLabel();
  void arrange();

  Sources sources_;
  Viewport& viewport_;
  QWidget& surface_;
  ToolRail* rail_;
  QFrame* viewBar_;
  QLabel* label_;
  QString projection_;
  QString detail_;  ///< what is said after it where there is room
};

}  // namespace pbffd::ui
