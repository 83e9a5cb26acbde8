#pragma once

#include <QObject>

#include <vector>

class QMainWindow;

namespace pbffd::ui {

class Actions;
class Dock;
class Document;
class HistoryPanel;
class InspectorPanel;
class MessageModel;
class PlacementPanel;
class ScenePanel;
class Theme;
class ViewState;

/// The docks of the main window, their places, and the actions that show and hide them.
class Docks : public QObject {
  Q_OBJECT

 public:
  struct Sources {
    const Actions& actions;
    Document& document;
    ViewState& view;
    const Theme& theme;
    MessageModel& messages;
  };
  Docks(QMainWindow& window, const Sources& sources);

  ScenePanel& scene() const { return *scene_; }
  InspectorPanel& inspector() const { return *inspector_; }
  PlacementPanel& placement() const { return *placement_; }

  void resetLayout();
  /// While nothing is open there are no docks; those that were shown come back.
  void setShown(bool shown);
  bool areShown() const { return isShown_; }
  /// Below 1280 pixels the placement lies behind the inspector.
  void fitTo(int width);
  /// The panels in the order in which F6 goes through them, without those that are hidden.
  std::vector<QWidget*> panes() const;

 private:
  void connectActions();
  void giveSizes();
  void hideAll(bool hidden);
  void countUnread();

  QMainWindow& window_;
  Sources sources_;
  ScenePanel* scene_;
  InspectorPanel* inspector_;
  PlacementPanel* placement_;
  HistoryPanel* history_;
  QWidget* messagesPanel_;
  std::vector<Dock*> docks_;  ///< scene, inspector, placement, history, messages
  std::vector<Dock*> hidden_;
  bool isShown_ = true;
  bool isNarrow_ = false;
  bool hasSizes_ = false;
  int unread_ = 0;
};

}  // namespace pbffd::ui
