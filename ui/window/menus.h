#pragma once

class QMainWindow;

namespace pbffd::ui {

class Actions;
class DocumentFiles;
class RecentFiles;

/// Fills the window's menu bar from the table of actions.
struct MenuSources {
  const Actions& actions;
  RecentFiles& recent;
  DocumentFiles& files;
};
void makeMenus(QMainWindow& window, const MenuSources& sources);

}  // namespace pbffd::ui
