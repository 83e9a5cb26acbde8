#pragma once

#include <QImage>
#include <QObject>

class QWidget;

namespace pbffd::ui {

class Actions;
class Document;
class RecentFiles;
class Theme;
class ViewState;

/// Opening, saving, exporting: the file choosers, the question before unsaved work is lost, the list of
/// recent files.
class DocumentFiles : public QObject {
  Q_OBJECT

 public:
  struct Sources {
    Document& document;
    ViewState& view;
    const Theme& theme;
    RecentFiles& recent;
  };
  DocumentFiles(const Sources& sources, const Actions& actions, QWidget& window);

  /// Asks about unsaved work first. The open document stays when the new one cannot be read.
  void open(const QString& path);
  bool save();
  bool saveAs();
  bool saveTo(const QString& path);
  /// Whether what is open may be left: asks when it is changed.
  bool mayLeave();

  /// Why these files cannot be opened by a drop; empty when they can.
  static QString reasonAgainst(const QStringList& paths);

 Q_SIGNALS:
  void pictureAsked(const QString& path);

 private:
  void connectActions(const Actions& actions);
  void chooseMesh();
  void chooseProject();
  void exportMesh();
  void exportPicture();
  void runEdits();
  void saveEdits();
  void remember();
  QImage thumbnail(const QSize& size) const;
  QString suggestedPath(const QString& ending) const;

  Sources sources_;
  Document& document_;
  QWidget& window_;
  QString folder_;
  QString openedPath_;  ///< of the mesh or project that was opened last
};

}  // namespace pbffd::ui
