#include "ui/views/region_actor.h"

#include "ui/views/region_shape.h"

#include <algorithm>
#include <cmath>

namespace pbffd::ui {
namespace {

constexpr int pointsOfRing = 64;
constexpr int pointsOfRingAmongMany = 32;
constexpr float ringWidth = 1.0F;
constexpr float outlineWidth = 1.5F;

Stroke paintedIn(const Rgba& color, float width) {
  Stroke stroke;
  stroke.colorFrom = stroke.colorTo = color;
  stroke.widthFrom = stroke.widthTo = width;
  return stroke;
}

Rgba faded(Rgba color, double share) {
  color.back() = static_cast<Rgba::value_type>(color.back() * share);
  return color;
}

}  // namespace

RegionActor::RegionActor(vtkRenderer& renderer) : fills_(renderer), rings_(renderer), outlines_(renderer) {
  fills_.mapper().setDepth(PassMapper::DepthTest::always, false);
  rings_.mapper().setDepth(PassMapper::DepthTest::always, false);
  outlines_.mapper().setDepth(PassMapper::DepthTest::always, false);
}

void RegionActor::setColors(const Colors& colors) {
  colors_ = colors;
  drawRings();
}

void RegionActor::setPixelRatio(double ratio) {
  rings_.setPixelRatio(ratio);
  outlines_.setPixelRatio(ratio);
}

void RegionActor::setRegions(std::vector<Frame> regions) {
  regions_ = std::move(regions);
  drawRings();
}

void RegionActor::setLens(const Projection::Lens& lens) {
  drawOutlines(lens);
}

double RegionActor::shareOfFills() const {
  return std::min(
      1.0, static_cast<double>(mostInFull) / static_cast<double>(std::max<std::size_t>(regions_.size(), 1)));
}

double RegionActor::shareOfLines() const {
  return std::max(leastShareOfLines, std::sqrt(shareOfFills()));
}

void RegionActor::drawRings() {
  const bool areMany = regions_.size() > mostFilled;
  const Rgba color = faded(colors_.rings, shareOfLines());
  std::vector<Stroke> strokes;
  for (const Frame& region : regions_) {
    for (const auto& ring : regionRings(region, areMany ? pointsOfRingAmongMany : pointsOfRing)) {
      appendPolyline(strokes, ring, true, paintedIn(color, ringWidth));
    }
  }
  rings_.setStrokes(strokes);
}

void RegionActor::drawOutlines(const Projection::Lens& lens) {
  const bool areMany = regions_.size() > mostFilled;
  if (regions_.empty() || areMany) {
    if (hasOutlines_) {
      fills_.setFills({});
      outlines_.setStrokes({});
      hasOutlines_ = false;
    }
    return;
  }
  const Rgba fill = faded(colors_.fill, shareOfFills());
  const Rgba line = faded(colors_.outline, shareOfLines());
  std::vector<Stroke> strokes;
  std::vector<Fill> fills;
  for (const Frame& region : regions_) {
    const std::vector<Vec3> outline = regionOutline(region, lens, pointsOfRing);
    appendPolyline(strokes, outline, true, paintedIn(line, outlineWidth));
    for (std::size_t i = 2; i < outline.size(); ++i) {
      fills.push_back({{outline[0], outline[i - 1], outline[i]}, fill});
    }
  }
  fills_.setFills(fills);
  outlines_.setStrokes(strokes);
  hasOutlines_ = true;
}

}  // namespace pbffd::ui
