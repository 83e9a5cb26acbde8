#include "ui/views/drag_detail.h"

#include "ui/document/document.h"
#include "ui/views/surface_store.h"

#include <utility>

namespace pbffd::ui {

namespace {

/// Frames differ a little; only what differs by more is built again. A finer one can wait: by more.
constexpr double muchFewer = 0.75;
constexpr double manyMore = 2.0;

}  // namespace

DragDetail::DragDetail(Document& document, QObject* parent, StandIn::Coarsen coarsen)
    : QObject(parent), document_(document), standIn_(this, std::move(coarsen)) {
  connect(&standIn_, &StandIn::ready, this, [this] { isNew_ = true; });
  connect(&standIn_, &StandIn::failed, this, &DragDetail::standInFailed);
}

void DragDetail::setFrameBudget(double seconds) {
  pace_ = FramePace(seconds);
}

void DragDetail::followMesh(const SurfaceStore& surface, MeshActor& actor) {
  if (surface.mesh() != mesh_) {
    mesh_ = surface.mesh();
    standIn_.clear();
    actor.setStandIn({});
    isNew_ = false;
    waitsForDrag_ = false;
    hasTold_ = false;
    pace_.forget();
  }
}

void DragDetail::prepare(MeshActor& actor, const SurfaceStore& surface, const Frame& frame) {
  followMesh(surface, actor);
  if (frame.size != frame_.size || frame.mode != frame_.mode) {
    pace_.forget();
  }
  waitsForDrag_ = waitsForDrag_ && (frame_.isDragged || !frame.isDragged);
  hasMoved_ = frame.revision != frame_.revision;
  frame_ = frame;
  const bool isWanted = frame.isDragged && canSimplify();
  isStoodIn_ = isWanted;
  if (isNew_ || (isWanted && followed_ != frame.revision)) {
    standIn_.follow(*surface.buffers().positions);
    followed_ = frame.revision;
    if (std::exchange(isNew_, false)) {
      actor.setStandIn(standIn_.buffers());
    } else {
      actor.standInMoved();
    }
  }
  // The normals of millions of vertices would take longer than all else.
  document_.setNormalsWait(isWanted);
  actor.showStandIn(isWanted);
  const bool isPlain = frame.isDragged && pace_.isTooSlow();
  actor.setEdgesWanted(!isPlain);
  setSimplified(isPlain);
}

bool DragDetail::isMeasuring() const {
  const bool isLarge = mesh_ != nullptr && FramePace::isLarge(mesh_->triangles().size());
  return isLarge || (mesh_ != nullptr && (frame_.isDragged || pace_.isTooSlow()));
}

void DragDetail::drawn(double seconds) {
  if (!isMeasuring()) {
    return;
  }
  if (isStoodIn_) {
    pace_.standInDrawn(seconds, standIn_.triangleCount());
  } else if (!isSimplified_) {
    pace_.wholeDrawn(seconds + (hasMoved_ ? 1e-3 * document_.lastMilliseconds() : 0.0), hasMoved_);
  }
  const bool isLarge = FramePace::isLarge(mesh_->triangles().size());
  if (isLarge && pace_.isTooSlow() && !standIn_.isBuilding() && !waitsForDrag_) {
    buildWhatIsWanted();
  }
}

/// By what was allowed: how many triangles there are then is the mesh's matter.
void DragDetail::buildWhatIsWanted() {
  const Index wanted = pace_.trianglesWanted(mesh_->triangles().size());
  const Index allowed = standIn_.trianglesAllowed();
  if (wanted < muchFewer * allowed || wanted > manyMore * allowed) {
    standIn_.build(mesh_, wanted);
  }
}

void DragDetail::standInFailed(const QString& message) {
  waitsForDrag_ = true;
  if (!std::exchange(hasTold_, true)) {
    Q_EMIT failed(tr("No coarse mesh could be made to be drawn while dragging; dragging may be slow. %1")
                      .arg(message));
  }
}

void DragDetail::setSimplified(bool isSimplified) {
  if (isSimplified_ != isSimplified) {
    isSimplified_ = isSimplified;
    Q_EMIT simplifiedChanged(isSimplified);
  }
}

}  // namespace pbffd::ui
