#pragma once

#include "ui/document/apply_service.h"
#include "ui/document/document.h"
#include "ui/document/theme.h"
#include "ui/document/view_state.h"
#include "ui/models/message_model.h"

#include <QMainWindow>

#include <memory>

class QStackedWidget;

namespace pbffd::ui {

class Actions;
class Docks;
class DocumentFiles;
class ErrorBar;
class OptionsBar;
class PointCommands;
class RecentFiles;
class StartPage;
class StatusLine;
class ToolManager;
class ViewOverlays;
class Viewport;

/// The window of the workbench. It makes the parts and connects them; what they do is theirs.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  struct Options {
    Theme::Choice theme = Theme::Choice::system;
    /// Whether the user's settings (recent files, layout, theme) are read and written.
    bool remembers = true;
    /// What applies a project to other files.
    ApplyService apply = {};
  };
  explicit MainWindow(const Options& options);
  ~MainWindow() override;

  void openFile(const QString& path);

  Document& document() { return document_; }
  const Actions& actions() const { return *actions_; }
  DocumentFiles& files() { return *files_; }
  Viewport& viewport() { return *viewport_; }
  const StartPage& startPage() const { return *startPage_; }
  Docks& docks() { return *docks_; }
  ErrorBar& errorBar() { return *errorBar_; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void makeCentre();
  void connectDocument();
  void connectActions();
  void connectTools();
  void showPointMenu(const QPoint& position);
  void showOpened();
  void showTitle();
  void say(Severity severity, const QString& text);
  void arrangeErrorBar();
  void goToNextPane();
  void chooseTheme(Theme::Choice choice);
  void showAbout();
  void restoreLayout();
  void storeLayout();

  Options options_;
  Theme theme_;
  Document document_;
  ViewState view_;
  MessageModel messages_;
  std::unique_ptr<RecentFiles> recent_;
  std::unique_ptr<Actions> actions_;
  std::unique_ptr<PointCommands> commands_;
  DocumentFiles* files_ = nullptr;
  QStackedWidget* centre_ = nullptr;
  StartPage* startPage_ = nullptr;
  Viewport* viewport_ = nullptr;
  ToolManager* tools_ = nullptr;
  ViewOverlays* overlays_ = nullptr;
  ErrorBar* errorBar_ = nullptr;
  OptionsBar* optionsBar_ = nullptr;
  StatusLine* status_ = nullptr;
  Docks* docks_ = nullptr;
};

}  // namespace pbffd::ui
