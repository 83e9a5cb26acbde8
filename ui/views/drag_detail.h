#pragma once

#include "ui/views/frame_pace.h"
#include "ui/views/stand_in.h"

#include <QObject>
#include <QSize>

namespace pbffd::ui {

class Document;
class SurfaceStore;

/// While something is dragged that cannot be drawn 30 times a second, by the times that frames took, lets edges
/// go, and a coarse stand-in be drawn in place of a large mesh. At rest the whole mesh is drawn.
class DragDetail : public QObject {
  Q_OBJECT

 public:
  explicit DragDetail(Document& document, QObject* parent = nullptr,
                      StandIn::Coarsen coarsen = coarseMesh);

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
  /// Whether drawn() has use for how long the frame takes. Of a mesh that is not large: in drags, and after one
  /// that was too slow.
  bool isMeasuring() const;
  /// After a frame that was measured.
  void drawn(double seconds);

  /// Less is drawn than at rest: no edges, and where there is one the stand-in.
  bool isSimplified() const { return isSimplified_; }
  bool isStoodIn() const { return isStoodIn_; }
  bool canSimplify() const { return standIn_.isReady() && pace_.isTooSlow(); }
  const StandIn& standIn() const { return standIn_; }

 Q_SIGNALS:
  void simplifiedChanged(bool isSimplified);
  /// There will be no stand-in for this mesh, or none better; said once a mesh.
  void failed(const QString& message);

 private:
  void followMesh(const SurfaceStore& surface, MeshActor& actor);
  void setSimplified(bool isSimplified);
  void standInFailed(const QString& message);
  void buildWhatIsWanted();

  Document& document_;
  FramePace pace_;
  StandIn standIn_;
  std::shared_ptr<const RestMesh> mesh_;
  Frame frame_;
  bool hasMoved_ = false;  ///< since the frame before
  bool isNew_ = false;     ///< the actor does not know this stand-in yet
  unsigned followed_ = 0;  ///< the revision that the stand-in's positions are of
  bool isSimplified_ = false;
  bool isStoodIn_ = false;
  bool waitsForDrag_ = false;  ///< it failed, and is tried again when something is dragged
  bool hasTold_ = false;
};

}  // namespace pbffd::ui
