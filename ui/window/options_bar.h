#pragma once

#include <QToolBar>

class QHBoxLayout;
class QLabel;

namespace pbffd::ui {

class Actions;
class Document;
class Segments;
class Theme;

/// The bar under the menus: undo and redo, the tool and its options, the edit level at the right end.
class OptionsBar : public QToolBar {
  Q_OBJECT

 public:
  OptionsBar(const Actions& actions, Document& document, const Theme& theme, QWidget* parent = nullptr);

  void setTool(const QString& name, const QString& icon);
  /// Takes the place of the former tool's options.
  void setToolOptions(QWidget* options);
  Segments& levelSwitch() const { return *levels_; }

 private:
  void showLevels();

  Document& document_;
  const Theme& theme_;
  QLabel* toolIcon_;
  QLabel* toolName_;
  QString iconName_;
  QHBoxLayout* optionsRow_;
  QWidget* options_ = nullptr;
  QLabel* levelLabel_;
  Segments* levels_;
};

}  // namespace pbffd::ui
