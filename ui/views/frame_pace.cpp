#include "ui/views/frame_pace.h"

#include <algorithm>
#include <cmath>

namespace pbffd::ui {
namespace {

/// A stand-in is to take this share of the time allowed; the rest is for all else in a frame.
constexpr double standInShare = 0.5;
/// Fewer are no faster, only uglier; and a stand-in of more than half of the mesh saves too little.
constexpr double fewestTriangles = 50000.0;
constexpr double largestShare = 0.5;
/// Frames that take less than this share of what they took: the machine was busy then.
constexpr double muchLess = 0.5;

}  // namespace

void FramePace::forget() {
  *this = FramePace(secondsAllowed_);
}

void FramePace::wholeDrawn(double seconds, bool moved) {
  (moved ? moving_ : still_).add(seconds);
}

void FramePace::standInDrawn(double seconds, Index triangles) {
  if (triangles != standInTriangles_) {
    standInTriangles_ = triangles;
    stoodIn_ = {};
  }
  stoodIn_.add(seconds);
  if (stoodIn_.faster() > secondsAllowed_) {
    tooMany_ = triangles;
    wholeThen_ = wholeSeconds();
  }
}

double FramePace::wholeSeconds() const {
  return std::max(still_.faster(), moving_.faster());
}

bool FramePace::isTooSlow() const {
  return wholeSeconds() > secondsAllowed_;
}

bool FramePace::isLarge(Index all) {
  return largestShare * all > fewestTriangles;
}

Index FramePace::trianglesWanted(Index all) const {
  const double whole = wholeSeconds();
  double wanted = largestShare * all;
  if (whole > 0.0) {
    wanted = std::min(wanted, standInShare * secondsAllowed_ / whole * all);
  }
  if (tooMany_ > 0 && whole > muchLess * wholeThen_) {
    wanted = std::min(wanted, 0.5 * tooMany_);
  }
  return static_cast<Index>(std::min(std::max(wanted, fewestTriangles), largestShare * all));
}

}  // namespace pbffd::ui
