#include "ui/window/menus.h"

#include "ui/controllers/actions.h"
#include "ui/window/document_files.h"
#include "ui/window/recent_files.h"
#include "ui/window/samples.h"

#include <QFileInfo>
#include <QMainWindow>
#include <QMenuBar>

namespace pbffd::ui {
namespace {

QMenu* makeSubmenu(QMenu& menu, const QString& title, const Actions& actions, ActionId first, ActionId last) {
  QMenu* submenu = menu.addMenu(title);
  for (int id = static_cast<int>(first); id <= static_cast<int>(last); ++id) {
    submenu->addAction(actions[static_cast<ActionId>(id)]);
  }
  return submenu;
}

void fillRecent(QMenu& menu, RecentFiles& recent, DocumentFiles& files) {
  menu.clear();
  for (const RecentFiles::Entry& entry : recent.entries()) {
    QAction* action = menu.addAction(QFileInfo(entry.path).fileName());
    action->setStatusTip(entry.path);
    action->setEnabled(QFileInfo::exists(entry.path));
    QObject::connect(action, &QAction::triggered, &files, [&files, path = entry.path] { files.open(path); });
  }
  menu.menuAction()->setEnabled(!menu.isEmpty());
}

void addFileMenus(QMenu& menu, const MenuSources& sources) {
  QAction* before = sources.actions[ActionId::save];
  auto* recent = new QMenu(QObject::tr("Open recent"), &menu);
  QObject::connect(
      &sources.recent, &RecentFiles::changed, recent,
      [recent, &list = sources.recent, &files = sources.files] { fillRecent(*recent, list, files); });
  fillRecent(*recent, sources.recent, sources.files);
  auto* samples = new QMenu(QObject::tr("Samples"), &menu);
  for (const Sample& sample : findSamples()) {
    QObject::connect(samples->addAction(sample.name), &QAction::triggered, &sources.files,
                     [&files = sources.files, path = sample.path] { files.open(path); });
  }
  samples->menuAction()->setVisible(!samples->isEmpty());
  // Before the separator that stands over Save.
  const qsizetype at = menu.actions().indexOf(before);
  QAction* separator = menu.actions().at(at - 1);
  menu.insertMenu(separator, recent);
  menu.insertMenu(separator, samples);
}

}  // namespace

void makeMenus(QMainWindow& window, const MenuSources& sources) {
  const Actions& actions = sources.actions;
  // The mnemonics leave Alt+H, Alt+B and Alt+G to actions.
  for (const char* title : {"&File", "&Edit", "&Select", "&Points", "&Deform", "&View", "&Window", "He&lp"}) {
    QMenu* menu = window.menuBar()->addMenu(QObject::tr(title));
    const QString name = QString(title).remove(u'&');
    actions.fill(*menu, name);
    menu->setToolTipsVisible(true);
    if (name == "File") {
      addFileMenus(*menu, sources);
    } else if (name == "Deform") {
      menu->addSeparator();
      makeSubmenu(*menu, QObject::tr("Edit level"), actions, ActionId::level1, ActionId::level9);
    } else if (name == "View") {
      QMenu* sides =
          makeSubmenu(*menu, QObject::tr("Look from"), actions, ActionId::viewFront, ActionId::viewBottom);
      menu->insertMenu(actions[ActionId::orthographic], sides);
      QMenu* hierarchy = makeSubmenu(*menu, QObject::tr("Hierarchy"), actions, ActionId::hierarchyNone,
                                     ActionId::hierarchyAll);
      menu->insertMenu(actions[ActionId::showGrid], hierarchy);
    } else if (name == "Window") {
      QMenu* themes =
          makeSubmenu(*menu, QObject::tr("Theme"), actions, ActionId::themeSystem, ActionId::themeLight);
      menu->insertMenu(actions[ActionId::resetLayout], themes);
    }
  }
}

}  // namespace pbffd::ui
