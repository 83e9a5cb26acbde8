#pragma once

#include "core/ffd/deform/deformation.h"
#include "core/project/edit.h"
#include "core/project/project_file.h"
#include "ui/document/edited_points.h"
#include "ui/document/selection.h"

#include <QDateTime>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QUndoStack>

#include <memory>
#include <optional>

namespace pbffd::ui {

class JobRunner;

/// How an edit enters the history.
struct EditOptions {
  /// Edits of the same number, one right after the other, are one entry (a slider scrub, a run of nudges);
  /// 0: never.
  int mergeKey = 0;
};

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
  /// The name of the file that was opened, mesh or project, whatever it was saved to since.
  const QString& openedName() const { return openedName_; }
  /// The name of the mesh's file.
  QString meshName() const;
  bool isModified() const { return !history_->isClean(); }
  /// Whether nothing was edited beyond placing points: another placement loses nothing.
  bool isPristine() const;

  /// Opens a mesh (and places points with `options`) or a project, off the UI thread. The open document stays
  /// until the new one is ready, and for good when it cannot be read or no points can be placed on it:
  /// `failed` then says why.
  void open(const QString& path, const PlacementOptions& options = {});
  void close();
  /// Returns whether it worked; `failed` says why not, and the file is then as it was.
  bool save(const QString& path, const ProjectExtras& extras);
  /// Off the UI thread; `informed` or `failed` tells the end of it.
  void exportMesh(const QString& path);
  /// What the project file held for the views.
  const ProjectExtras& extras() const { return extras_; }

  /// Applies an edit and makes it one undo entry. False, and `failed`, when it cannot be done.
  bool perform(const Edit& edit, const EditOptions& options = {});
  /// The same off the UI thread, for edits that may take long (place). Committed only if the document
  /// still holds the value it began from. A newer one replaces a running one.
  void performInBackground(const Edit& edit, const EditOptions& options = {});
  /// A number for EditOptions::mergeKey that no edit has used.
  int newMergeKey() { return ++lastMergeKey_; }
  void undo();
  void redo();
  /// Goes to a place in the history: 0 is its start.
  void goTo(int place);

  /// A gesture: each preview applies its edit to the committed project and is only shown; commitPreview
  /// makes the last one a single undo entry; cancelPreview drops it. Of several previews in one turn of the
  /// event loop the first and the last are applied. False when the edit cannot be done (what is shown then
  /// stays).
  bool preview(const Edit& edit);
  void commitPreview();
  void cancelPreview();
  bool isPreviewing() const { return preview_.has_value(); }

  /// The deformed mesh of `shown()`, up to date. Null when nothing is open or the weights are not there yet.
  const LiveDeformation* deformation() const { return deformation_.get(); }
  /// While `wait`, changes leave the normals of deformation() as they are: for a drag, when the view takes
  /// those that it needs itself. Not waiting any more brings them up to date.
  void setNormalsWait(bool wait);
  /// Of the last update of the deformation.
  double lastMilliseconds() const { return lastMilliseconds_; }
  Index lastMovedVertices() const { return lastMovedVertices_; }
  std::shared_ptr<const Parameterization> parameterization() const { return parameterization_; }
  /// The weights by which each level hangs on the next coarser one, as levelBindings() gives them.
  std::shared_ptr<const std::vector<PointWeights>> bindings() const;
  /// Of the last placement in this session; 0 before one.
  double lastPlacementSeconds() const { return lastPlacementSeconds_; }

 Q_SIGNALS:
  /// Another mesh or project is open, or none.
  void opened();
  /// What is shown differs in these parts from what was shown before.
  void changed(const ProjectChanges& what);
  /// The name or the modified mark changed.
  void titleChanged();
  void failed(const QString& message);
  /// Something that the user should know about what was just done.
  void remarked(const QString& message);
  /// What was done, for the record.
  void informed(const QString& message);
  void placed();
  /// What is shown is what the history holds again.
  void previewEnded();

 private:
  friend class ChangeProject;
  struct Opened;
  /// Made off the UI thread, for refreshDeformation() to find.
  struct ReadyDeformation {
    std::shared_ptr<const Parameterization> weights;
    std::unique_ptr<LiveDeformation> deformation;
  };

  static Opened read(const QString& path, const Progress& progress);
  static ReadyDeformation readyDeformation(const Project& project, EditWorkspace& workspace,
                                           const Progress& progress);
  void adopt(Opened& file);
  void setCommitted(const Project& project);
  void showCommitted();
  void show(const Project& before, bool measured);
  void refreshDeformation(bool measured);
  void push(const Edit& edit, const EditResult& result, const EditOptions& options);
  QStringList newRemarks(const QStringList& remarks, bool isComplete);
  bool applyPreview(const Edit& edit);
  bool flushPreview();
  bool dropPreview();
  void followSelection(const Project& before);
  void selectEdited();

  Project committed_;
  std::optional<Project> preview_;
  std::optional<Edit> previewEdit_;
  std::optional<Edit> waitingPreview_;  ///< of this turn of the event loop, not yet applied
  bool previewedThisTurn_ = false;
  std::optional<Project> shownBefore_;  ///< while the history moves: what was shown before it
  std::optional<EditedPoints> edited_;  ///< while the history moves: what to select after it
  quint64 revision_ = 0;                ///< grows with every committed value
  std::shared_ptr<EditWorkspace> workspace_;
  std::shared_ptr<const Parameterization> parameterization_;
  std::unique_ptr<LiveDeformation> deformation_;
  ReadyDeformation ready_;
  bool normalsWait_ = false;
  QUndoStack* history_;
  Selection* selection_;
  JobRunner* jobs_;
  QString path_;
  QString openedName_;
  QStringList placementRemarks_;  ///< of the last placement, here or undone
  ProjectExtras extras_;
  double lastMilliseconds_ = 0.0;
  Index lastMovedVertices_ = 0;
  double lastPlacementSeconds_ = 0.0;
  int lastMergeKey_ = 0;
};

}  // namespace pbffd::ui
