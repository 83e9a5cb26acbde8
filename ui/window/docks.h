#pragma once

#include <QByteArray>
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
  /// The places and sizes of the docks, for the user's settings; empty while they were never shown.
  QByteArray layout() const;
  /// Is given to the docks when they are shown first; what does not fit is ignored.
  void setFirstLayout(const QByteArray& layout) { firstLayout_ = layout; }
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
  bool wasShown_ = false;
  QByteArray firstLayout_;
  int unread_ = 0;
};

}  // namespace pbffd::ui
