#pragma once

#include "ui/views/frame_pace.h"
#include "ui/views/stand_in.h"

#include <QObject>
#include <QSize>

namespace pbffd::ui {

class Document;
class SurfaceStore;

/// While something is dragged, lets a coarse stand-in be drawn in place of a large mesh that cannot be drawn 30
/// times a second, by the times that frames took. At rest the whole mesh is drawn.
class DragDetail : public QObject {
  Q_OBJECT

 public:
  explicit DragDetail(Document& document, QObject* parent = nullptr);

  /// Seconds that a frame may take in a drag. For tests: 0 is always too slow.
  void setFrameBudget(double seconds);

  struct Frame {
    bool isDragged = false;  ///< the mesh or the camera
    unsigned revision = 0;   ///< another one where the mesh's positions or buffers are others
    DisplayMode mode = DisplayMode::wire;
    QSize size;
  };
  /// Before a frame: which of the two the actor draws.
  void prepare(MeshActor& actor, const SurfaceStore& surface, const Frame& frame);
  /// After it.
  void drawn(double seconds);

  bool isSimplified() const { return isSimplified_; }
  bool canSimplify() const { return standIn_.isReady() && pace_.isTooSlow(); }

 Q_SIGNALS:
  void simplifiedChanged(bool isSimplified);

 private:
  void followMesh(const SurfaceStore& surface, MeshActor& actor);
  void setSimplified(bool isSimplified);

  Document& document_;
  FramePace pace_;
  StandIn standIn_;
  std::shared_ptr<const RestMesh> mesh_;
  Frame frame_;
  bool hasMoved_ = false;  ///< since the frame before
  bool isNew_ = false;     ///< the actor does not know this stand-in yet
  unsigned followed_ = 0;  ///< the revision that the stand-in's positions are of
  bool isSimplified_ = false;
};

}  // namespace pbffd::ui
