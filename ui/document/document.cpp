#include "ui/document/document.h"

#include "core/base/error.h"
#include "ui/document/change_project.h"
#include "ui/document/edited_points.h"
#include "ui/document/job_runner.h"

#include <QElapsedTimer>
#include <QFileInfo>

#include <algorithm>
#include <iterator>
#include <unordered_set>
#include <utility>

namespace pbffd::ui {
namespace {

constexpr int historyLimit = 500;

bool isAsPlaced(const ControlPoint& point) {
  return point.kind != PointKind::manual && point.kind != PointKind::curve && point.enabled && !point.locked &&
         point.name.empty() && point.strength == 1.0 && point.pose == point.rest;
}

bool holdsPlacement(const Edit& edit) {
  if (const auto* group = std::get_if<Group>(&edit.value())) {
    return std::any_of(group->edits.begin(), group->edits.end(), holdsPlacement);
  }
  return std::holds_alternative<Place>(edit.value());
}

}  // namespace

Document::Document(QObject* parent)
    : QObject(parent),
      workspace_(std::make_shared<EditWorkspace>()),
      history_(new QUndoStack(this)),
      selection_(new Selection(this)),
      jobs_(new JobRunner(this)) {
  history_->setUndoLimit(historyLimit);
  connect(history_, &QUndoStack::indexChanged, this, &Document::showCommitted);
  connect(history_, &QUndoStack::cleanChanged, this, &Document::titleChanged);
  connect(jobs_, &JobRunner::failed, this, &Document::failed);
}

Document::~Document() {
  // The worker may still read what this object holds.
  delete jobs_;
  disconnect(history_, nullptr, this, nullptr);
}

const Project& Document::shown() const {
  return preview_ ? *preview_ : committed_;
}

QString Document::meshName() const {
  return isOpen() ? QString::fromStdString(committed_.mesh->mesh().source.name) : QString();
}

QString Document::displayName() const {
  return path_.isEmpty() ? meshName() : QFileInfo(path_).fileName();
}

bool Document::isPristine() const {
  for (const Level& level : committed_.controls.levels) {
    for (const ControlPoint& point : level) {
      if (!isAsPlaced(point)) {
        return false;
      }
    }
  }
  return true;
}

void Document::close() {
  jobs_->cancel();
  cancelPreview();
  committed_ = {};
  ++revision_;
  shownBefore_.reset();
  deformation_.reset();
  parameterization_.reset();
  workspace_ = std::make_shared<EditWorkspace>();
  path_.clear();
  openedName_.clear();
  extras_ = {};
  history_->clear();
  selection_->reset(1);
  Q_EMIT opened();
  Q_EMIT titleChanged();
}

bool Document::perform(const Edit& edit, const EditOptions& options) {
  cancelPreview();
  try {
    if (holdsPlacement(edit)) {
      // Both would use what is kept of the placement.
      jobs_->stop();
    }
    push(edit, apply(committed_, edit, *workspace_), options);
    return true;
  } catch (const Error& error) {
    Q_EMIT failed(QString::fromUtf8(error.what()));
    return false;
  }
}

void Document::push(const Edit& edit, const EditResult& result, const EditOptions& options) {
  history_->push(new ChangeProject(*this, {committed_, result.project, edit, options.mergeKey}));
  QStringList remarks;
  for (const std::string& remark : result.remarks) {
    remarks += QString::fromStdString(remark);
  }
  const auto* place = std::get_if<Place>(&edit.value());
  const bool isComplete = place != nullptr && committed_.controls.finest().size() >= place->options.points;
  if (place != nullptr) {
    remarks = newRemarks(remarks, isComplete);
  }
  if (remarks.isEmpty()) {
    return;
  }
  // A placement tells how it took the surface; it matters when it fell short. A gesture shows what it moved and
  // what stayed.
  const bool isGesture =
      std::holds_alternative<Move>(edit.value()) || std::holds_alternative<Transform>(edit.value());
  if (isComplete || isGesture) {
    Q_EMIT informed(remarks.join(u' '));
  } else {
    Q_EMIT remarked(remarks.join(u' '));
  }
}

/// Without what the placement before said already, unless that leaves nothing to say of one that fell short.
QStringList Document::newRemarks(const QStringList& remarks, bool isComplete) {
  const QStringList before = std::exchange(placementRemarks_, remarks);
  QStringList fresh;
  std::copy_if(remarks.begin(), remarks.end(), std::back_inserter(fresh),
               [&](const QString& remark) { return !before.contains(remark); });
  return fresh.isEmpty() && !isComplete ? remarks : fresh;
}

void Document::undo() {
  cancelPreview();
  history_->undo();
}

void Document::redo() {
  cancelPreview();
  history_->redo();
}

void Document::goTo(int place) {
  cancelPreview();
  history_->setIndex(place);
}

bool Document::preview(const Edit& edit) {
  if (!isOpen()) {
    return false;
  }
  if (previewedThisTurn_) {
    waitingPreview_ = edit;
    return true;
  }
  previewedThisTurn_ = true;
  QMetaObject::invokeMethod(
      this,
      [this] {
        previewedThisTurn_ = false;
        flushPreview();
      },
      Qt::QueuedConnection);
  return applyPreview(edit);
}

bool Document::applyPreview(const Edit& edit) {
  try {
    QElapsedTimer timer;
    timer.start();
    EditResult result = apply(committed_, edit, *workspace_);
    const Project before = shown();
    preview_ = std::move(result.project);
    previewEdit_ = edit;
    show(before, true);
    lastMilliseconds_ = 1e-6 * static_cast<double>(timer.nsecsElapsed());
    return true;
  } catch (const Error&) {
    return false;
  }
}

bool Document::flushPreview() {
  const std::optional<Edit> waiting = std::exchange(waitingPreview_, std::nullopt);
  return !waiting || applyPreview(*waiting);
}

void Document::commitPreview() {
  flushPreview();
  if (!preview_) {
    return;
  }
  const EditResult result{*preview_, {}};
  push(*previewEdit_, result, {});
}

void Document::cancelPreview() {
  const Project before = shown();
  if (dropPreview()) {
    // Going back is no deformation of which the figures would tell.
    lastMovedVertices_ = 0;
    lastMilliseconds_ = 0.0;
    show(before, false);
    Q_EMIT previewEnded();
  }
}

/// Returns whether there was one.
bool Document::dropPreview() {
  waitingPreview_.reset();
  previewEdit_.reset();
  const bool wasPreviewing = preview_.has_value();
  preview_.reset();
  return wasPreviewing;
}

void Document::setCommitted(const Project& project) {
  if (!shownBefore_) {
    shownBefore_ = shown();
  }
  const bool wasPreviewing = dropPreview();
  committed_ = project;
  ++revision_;
  if (wasPreviewing) {
    Q_EMIT previewEnded();
  }
}

void Document::showCommitted() {
  if (shownBefore_) {
    const Project before = *std::exchange(shownBefore_, std::nullopt);
    show(before, true);
    selectEdited();
  }
}

void Document::show(const Project& before, bool measured) {
  const ProjectChanges what = changesBetween(before, shown());
  if (!what.any()) {
    return;
  }
  if (what.mesh || what.structure || what.rest || what.poses) {
    refreshDeformation(measured);
  }
  if (what.structure) {
    followSelection(before);
  }
  Q_EMIT changed(what);
}

void Document::refreshDeformation(bool measured) {
  const Project& project = shown();
  QElapsedTimer timer;
  timer.start();
  const auto weights = workspace_->weights.parameterization(project.mesh, project.controls);
  if (!deformation_ || weights != parameterization_) {
    parameterization_ = weights;
    deformation_ = ready_.weights == weights ? std::move(ready_.deformation)
                                             : std::make_unique<LiveDeformation>(project.mesh, weights);
    measured = false;
  }
  ready_ = {};
  const Index moved = deformation_->updatePositions(mapsOf(project.controls, project.controls.finest()));
  if (!normalsWait_) {
    deformation_->updateNormals();
  }
  if (measured) {
    lastMovedVertices_ = moved;
    lastMilliseconds_ = 1e-6 * static_cast<double>(timer.nsecsElapsed());
  }
}

void Document::setNormalsWait(bool wait) {
  normalsWait_ = wait;
  if (!wait && deformation_) {
    deformation_->updateNormals();
  }
}

std::shared_ptr<const std::vector<PointWeights>> Document::bindings() const {
  return isOpen() ? workspace_->weights.bindings(shown().mesh, shown().controls) : nullptr;
}

/// After an undo or redo: what it changed is selected.
void Document::selectEdited() {
  const auto edited = std::exchange(edited_, std::nullopt);
  const auto& levels = committed_.controls.levels;
  if (!edited || edited->level < 1 || edited->level > static_cast<int>(levels.size())) {
    return;
  }
  std::unordered_set<PointId> existing;
  for (const ControlPoint& point : levels[static_cast<std::size_t>(edited->level - 1)]) {
    existing.insert(point.id);
  }
  std::vector<PointId> points = edited->points;
  std::erase_if(points, [&](PointId id) { return !existing.contains(id); });
  selection_->setLevel(edited->level);
  selection_->replace(std::move(points));
}

/// After a change of structure: points that are gone are not selected, and who edited the finest level still
/// does.
void Document::followSelection(const Project& before) {
  const auto& levels = shown().controls.levels;
  // Levels come and go at the coarse end, where their numbers begin.
  selection_->renumberLevels(static_cast<int>(levels.size()) - static_cast<int>(before.controls.levels.size()));
  std::vector<std::unordered_set<PointId>> existing(levels.size());
  for (std::size_t l = 0; l < levels.size(); ++l) {
    for (const ControlPoint& point : levels[l]) {
      existing[l].insert(point.id);
    }
  }
  selection_->keepOnly([&](int level, PointId point) {
    return level >= 1 && level <= static_cast<int>(existing.size()) &&
           existing[static_cast<std::size_t>(level - 1)].contains(point);
  });
  selection_->setLevel(std::min(selection_->level(), static_cast<int>(levels.size())));
}

}  // namespace pbffd::ui
