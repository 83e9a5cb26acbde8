#pragma once

#include "core/ffd/deformation.h"
#include "core/project/edit.h"
#include "core/project/project_file.h"
#include "ui/document/selection.h"

#include <QDateTime>
#include <QObject>
#include <QString>
#include <QUndoStack>

#include <memory>
#include <optional>

namespace pbffd::ui {

class JobRunner;

/// The project that is open, its history, its selection and the deformed positions: everything that the
/// views show and nothing of how. Views never write; they ask for edits.
class Document : public QObject {
  Q_OBJECT

 public:
  explicit Document(QObject* parent = nullptr);
  ~Document() override;

  bool isOpen() const { return committed_.mesh != nullptr; }

  /// What is to be seen: the previewed project during a gesture, else the committed one.
  const Project& shown() const;
  /// What the history holds.
  const Project& committed() const { return committed_; }

  QUndoStack& history() { return *history_; }
  Selection& selection() { return *selection_; }
  const Selection& selection() const { return *selection_; }
  JobRunner& jobs() { return *jobs_; }

  /// The level of `selection()` as a place in ControlSet::levels.
  Index editLevel() const { return selection_->level() - 1; }

  /// Where the document was loaded from or saved to last; empty for a mesh that was never saved.
  const QString& path() const { return path_; }
  /// "cow.pbffd", or "cow.obj" for what was never saved as a project.
  QString displayName() const;
  bool isModified() const { return !history_->isClean(); }

  /// Opens a mesh (and places points with `options`) or a project, off the UI thread. The open document stays
  /// until the new one is ready, and for good when it fails: `failed` then says why.
  void open(const QString& path, const PlacementOptions& options = {});
  void close();
  /// Each returns whether it worked; `failed` says why not.
  bool save(const QString& path, const QByteArray& thumbnailPng);
  void exportMesh(const QString& path);

  /// Applies an edit and makes it one undo entry. False, and `failed`, when it cannot be done.
  bool perform(const Edit& edit);
  /// The same off the UI thread, for edits that may take long (place). Committed only if the document
  /// still holds the value it began from. A newer one replaces a running one.
  void performInBackground(const Edit& edit);

  /// A gesture: each preview applies its edit to the committed project and is only shown; commitPreview
  /// makes the last one a single undo entry; cancelPreview drops it. False when the edit cannot be done
  /// (what is shown then stays).
  bool preview(const Edit& edit);
  void commitPreview();
  void cancelPreview();
  bool isPreviewing() const { return preview_.has_value(); }

  /// The deformed mesh of `shown()`, up to date. Null when nothing is open or the weights are not there yet.
  const LiveDeformation* deformation() const { return deformation_.get(); }
  /// Of the last update of the deformation.
  double lastMilliseconds() const { return lastMilliseconds_; }
  Index lastMovedVertices() const { return lastMovedVertices_; }
  std::shared_ptr<const Parameterization> parameterization() const { return parameterization_; }

 Q_SIGNALS:
  /// Another mesh or project is open, or none.
  void opened();
  /// What is shown differs in these parts from what was shown before.
  void changed(const ProjectChanges& what);
  /// The name or the modified mark changed.
  void titleChanged();
  void failed(const QString& message);
  void remarked(const QString& message);

 private:
  friend class ChangeProject;
  struct Preview;

  void setCommitted(const Project& project);
  void show(const Project& before);
  void refreshDeformation();

  Project committed_;
  std::optional<Project> preview_;
  std::optional<Edit> previewEdit_;
  std::shared_ptr<EditWorkspace> workspace_;
  std::shared_ptr<const Parameterization> parameterization_;
  std::unique_ptr<LiveDeformation> deformation_;
  QUndoStack* history_;
  Selection* selection_;
  JobRunner* jobs_;
  QString path_;
  ProjectExtras extras_;
  double lastMilliseconds_ = 0.0;
  Index lastMovedVertices_ = 0;
};

}  // namespace pbffd::ui
