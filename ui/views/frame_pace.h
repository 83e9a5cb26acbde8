#pragma once

#include "core/base/types.h"

#include <array>

namespace pbffd::ui {

/// Judges from how long frames took whether a mesh can be dragged as it is, and how few triangles a stand-in
/// for it may have.
class FramePace {
 public:
  /// `secondsAllowed` for a frame of a drag: 30 a second by default.
  explicit FramePace(double secondsAllowed = 1.0 / 30.0) : secondsAllowed_(secondsAllowed) {}

  /// Another mesh, another size of the view, another way to draw: what was measured says nothing any more.
  void forget();

  /// A frame with the whole mesh; `moved`: its vertices had moved since the frame before, so that they went to
  /// the graphics card again.
  void wholeDrawn(double seconds, bool moved);
  /// A frame with a stand-in of that many triangles.
  void standInDrawn(double seconds, Index triangles);

  /// By the faster of the last two frames of a kind: a single slow one (the first, a busy machine) says
  /// nothing.
  bool isTooSlow() const;

  /// Whether a mesh of that many has enough for a stand-in to save something: what else is in a frame takes its
  /// time too.
  static bool isLarge(Index all);

  /// Of a large mesh of that many. At most half as many as a stand-in had that was too slow as well, until the
  /// whole mesh takes much less time than it took then.
  Index trianglesWanted(Index all) const;

 private:
  /// The faster of the last two; 0 before there are two.
  class LastTwo {
   public:
    void add(double seconds) { seconds_ = {seconds_[1], seconds}; }
    double faster() const { return seconds_[0] < seconds_[1] ? seconds_[0] : seconds_[1]; }

   private:
    std::array<double, 2> seconds_{0.0, 0.0};
  };

  /// Of a frame with the whole mesh, by the slower kind.
  double wholeSeconds() const;

  double secondsAllowed_;
  LastTwo still_;
  LastTwo moving_;
  LastTwo stoodIn_;
  Index standInTriangles_ = 0;
  Index tooMany_ = 0;  ///< triangles of the last stand-in that was too slow; 0: none was
  double wholeThen_ = 0.0;
};

}  // namespace pbffd::ui
