#include "ui/views/drag_detail.h"

#include "ui/document/document.h"
#include "ui/views/surface_store.h"

#include <utility>

namespace pbffd::ui {

DragDetail::DragDetail(Document& document, QObject* parent)
    : QObject(parent), document_(document), standIn_(this) {
  connect(&standIn_, &StandIn::ready, this, [this] { isNew_ = true; });
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
    pace_.forget();
  }
}

void DragDetail::prepare(MeshActor& actor, const SurfaceStore& surface, const Frame& frame) {
  followMesh(surface, actor);
  if (frame.size != frame_.size || frame.mode != frame_.mode) {
    pace_.forget();
  }
  hasMoved_ = frame.revision != frame_.revision;
  frame_ = frame;
  const bool isWanted = frame.isDragged && canSimplify();
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
  setSimplified(isWanted);
}

void DragDetail::drawn(double seconds) {
  if (mesh_ == nullptr || !FramePace::isLarge(mesh_->triangles().size())) {
    return;
  }
  if (isSimplified_) {
    pace_.standInDrawn(seconds, standIn_.triangleCount());
  } else {
    pace_.wholeDrawn(seconds + (hasMoved_ ? 1e-3 * document_.lastMilliseconds() : 0.0), hasMoved_);
  }
  if (pace_.isTooSlow() && !standIn_.isBuilding()) {
    const Index wanted = pace_.trianglesWanted(mesh_->triangles().size());
    // Frames differ a little; only what differs much is built again.
    if (!standIn_.isReady() || 4 * wanted < 3 * standIn_.triangleCount()) {
      standIn_.build(mesh_, wanted);
    }
  }
}

void DragDetail::setSimplified(bool isSimplified) {
  if (isSimplified_ != isSimplified) {
    isSimplified_ = isSimplified;
    Q_EMIT simplifiedChanged(isSimplified);
  }
}

}  // namespace pbffd::ui
