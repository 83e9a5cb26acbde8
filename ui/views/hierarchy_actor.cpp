#include "ui/views/hierarchy_actor.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pbffd::ui {
namespace {

constexpr float parentWidth = 2.0F;
constexpr float childWidth = 1.0F;
constexpr float parentKnot = 6.0F;
constexpr float childKnot = 4.0F;
/// On either side of a line or a knot together.
constexpr float haloWidth = 1.6F;
constexpr float haloOpacity = 0.5F;

Stroke between(const Vec3& from, const Vec3& to) {
  Stroke stroke;
  stroke.from = from;
  stroke.to = to;
  stroke.widthFrom = parentWidth;
  stroke.widthTo = childWidth;
  return stroke;
}

Stroke knotAt(const Vec3& place, float width) {
  Stroke stroke = between(place, place);
  stroke.widthFrom = stroke.widthTo = width;
  stroke.cap = Stroke::Cap::round;
  return stroke;
}

void paint(Stroke& stroke, Rgba color, double opacity) {
  color.back() = static_cast<Rgba::value_type>(color.back() * opacity);
  stroke.colorFrom = stroke.colorTo = color;
}

}  // namespace

HierarchyActor::HierarchyActor(vtkRenderer& renderer) : hidden_(renderer), visible_(renderer) {
  hidden_.mapper().setDepth(PassMapper::DepthTest::behind, false);
  hidden_.setOpacity(hiddenShare);
}

void HierarchyActor::setColors(const Colors& colors) {
  colors_ = colors;
  draw();
}

void HierarchyActor::setPixelRatio(double ratio) {
  hidden_.setPixelRatio(ratio);
  visible_.setPixelRatio(ratio);
}

void HierarchyActor::setLinks(std::vector<Link> links) {
  if (links.empty() && links_.empty()) {
    return;
  }
  links_ = std::move(links);
  draw();
}

std::vector<Stroke> HierarchyActor::strokes() const {
  std::vector<Stroke> lines;
  std::vector<Stroke> knots;
  for (const Link& link : links_) {
    lines.push_back(between(link.parent, link.child));
    if (!link.hasParentGlyph) {
      knots.push_back(knotAt(link.parent, parentKnot));
    }
    if (!link.hasChildGlyph) {
      knots.push_back(knotAt(link.child, childKnot));
    }
  }
  lines.insert(lines.end(), knots.begin(), knots.end());
  const double crowd = static_cast<double>(std::max(links_.size(), mostInFull));
  const double share = std::max(leastShare, std::sqrt(static_cast<double>(mostInFull) / crowd));
  std::vector<Stroke> all = lines;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    all[i].widthFrom += haloWidth;
    all[i].widthTo += haloWidth;
    paint(all[i], colors_.halo, share * haloOpacity);
    paint(lines[i], colors_.line, share);
  }
  all.insert(all.end(), lines.begin(), lines.end());
  return all;
}

void HierarchyActor::draw() {
  const std::vector<Stroke> drawn = strokes();
  hidden_.setStrokes(drawn);
  visible_.setStrokes(drawn);
}

}  // namespace pbffd::ui
