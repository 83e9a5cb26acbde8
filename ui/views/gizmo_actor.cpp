#include "ui/views/gizmo_actor.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace pbffd::ui {
namespace {

constexpr float lineWidth = 3.0F;
constexpr float highlightedWidth = 4.5F;
constexpr double cubePixels = 11.0;
/// In lengths of the gizmo: across the view from wherever the gizmo is.
constexpr double guideLength = 40.0;
constexpr float backOfRing = 0.28F;
constexpr std::array<GizmoPart, 3> axisParts{GizmoPart::axisX, GizmoPart::axisY, GizmoPart::axisZ};
constexpr std::array<GizmoPart, 3> planeParts{GizmoPart::planeX, GizmoPart::planeY, GizmoPart::planeZ};

Stroke lineBetween(const Vec3& from, const Vec3& to, const Rgba& color, float width) {
  Stroke stroke;
  stroke.from = from;
  stroke.to = to;
  stroke.colorFrom = stroke.colorTo = color;
  stroke.widthFrom = stroke.widthTo = width;
  return stroke;
}

Stroke discAt(const Vec3& center, const Rgba& color, float width) {
  Stroke stroke = lineBetween(center, center, color, width);
  stroke.cap = Stroke::Cap::round;
  return stroke;
}

bool isShown(const Gizmo& gizmo, GizmoPart part) {
  return gizmo.dragged == GizmoPart::none || gizmo.dragged == part;
}

}  // namespace

GizmoActor::GizmoActor(vtkRenderer& renderer) : fills_(renderer), strokes_(renderer) {
  fills_.mapper().setDepth(PassMapper::DepthTest::always, false);
  strokes_.mapper().setDepth(PassMapper::DepthTest::always, false);
}

GizmoActor::Look GizmoActor::lookOf(const Gizmo& gizmo, GizmoPart part) const {
  const auto axis = axisOf(part);
  Look look{axis ? colors_.axes[*axis] : colors_.center, lineWidth};
  if (gizmo.dragged == part || (gizmo.dragged == GizmoPart::none && gizmo.hovered == part)) {
    look.color = mixed(look.color, colors_.highlight, colors_.highlightShare);
    look.width = highlightedWidth;
  }
  return look;
}

void GizmoActor::addAxis(Parts& parts, const Gizmo& gizmo, const GizmoShape& shape, int axis) const {
  if (!shape.isAxisSeen(axis) || !isShown(gizmo, axisParts[axis])) {
    return;
  }
  const Look look = lookOf(gizmo, axisParts[axis]);
  const Vec3 end = shape.axisEnd(axis);
  const Vec3 back = -shape.pixel() * gizmo.axes.col(axis);
  const bool isArrow = gizmo.kind == GizmoKind::move;
  const double headLength = isArrow ? GizmoSizes::head : cubePixels;
  const Vec3 neck = end + headLength * back;
  const Rgba halo = withAlpha(colors_.halo, 0.55F);
  const auto headWidth = static_cast<float>(isArrow ? GizmoSizes::head : cubePixels);
  parts.strokes.push_back(lineBetween(gizmo.center, neck, halo, look.width + 1.6F));
  parts.strokes.push_back(lineBetween(gizmo.center, neck, look.color, look.width));
  Stroke head = lineBetween(neck, end, look.color, headWidth);
  head.widthTo = isArrow ? 0.0F : headWidth;
  parts.strokes.push_back(head);
}

void GizmoActor::addPlane(Parts& parts, const Gizmo& gizmo, const GizmoShape& shape, int normal) const {
  if (!shape.isPlaneSeen(normal) || !isShown(gizmo, planeParts[normal])) {
    return;
  }
  const Look look = lookOf(gizmo, planeParts[normal]);
  const auto corners = shape.planeCorners(normal);
  const bool isHighlighted = look.width > lineWidth;
  const Rgba fill = withAlpha(look.color, isHighlighted ? 0.55F : 0.28F);
  parts.fills.push_back({{corners[0], corners[1], corners[2]}, fill});
  parts.fills.push_back({{corners[0], corners[2], corners[3]}, fill});
  appendPolyline(
      parts.strokes, {corners.begin(), corners.end()}, true,
      lineBetween(corners[0], corners[1], withAlpha(look.color, 0.85F), isHighlighted ? 2.0F : 1.2F));
}

void GizmoActor::addRing(Parts& parts, const Gizmo& gizmo, const GizmoShape& shape, int axis) const {
  const bool isOuter = axis == 3;
  const GizmoPart part = isOuter ? GizmoPart::view : axisParts[axis];
  if (!isShown(gizmo, part)) {
    return;
  }
  Look look = lookOf(gizmo, part);
  if (isOuter && look.width == lineWidth) {
    look = {withAlpha(look.color, 0.6F), 1.6F};
  }
  const std::vector<Vec3> points = shape.ring(axis);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool isFront = isOuter || gizmo.dragged == part || shape.isInFront(points[i]);
    Stroke stroke = lineBetween(points[i], points[(i + 1) % points.size()], look.color, look.width);
    if (!isFront) {
      stroke.colorFrom[3] *= backOfRing;
      stroke.colorTo[3] *= backOfRing;
      stroke.widthFrom = stroke.widthTo = 1.5F;
    }
    stroke.cap = Stroke::Cap::joined;
    parts.strokes.push_back(stroke);
  }
}

void GizmoActor::addCenter(Parts& parts, const Gizmo& gizmo, const GizmoShape& shape) const {
  const Look look = lookOf(gizmo, GizmoPart::center);
  const bool isHighlighted = look.width > lineWidth;
  const auto size = static_cast<float>(GizmoSizes::freeCenter) + (isHighlighted ? 2.0F : 0.0F);
  if (gizmo.kind == GizmoKind::scale) {
    // A square that faces the eye: a flat line as long as wide.
    const Vec3 half = 0.5 * size * shape.pixel() * gizmo.axes.col(0).unitOrthogonal();
    parts.strokes.push_back(discAt(gizmo.center, colors_.halo, size + 3.0F));
    parts.strokes.push_back(lineBetween(gizmo.center - half, gizmo.center + half, colors_.center, size));
    return;
  }
  parts.strokes.push_back(discAt(gizmo.center, colors_.halo, size + 3.2F));
  parts.strokes.push_back(discAt(gizmo.center, colors_.center, size));
}

void GizmoActor::addGuides(Parts& parts, const Gizmo& gizmo, const GizmoShape& shape) const {
  const auto axis = axisOf(gizmo.dragged);
  if (!axis || (gizmo.kind == GizmoKind::rotate && gizmo.pie)) {
    return;
  }
  const double reach = guideLength * GizmoSizes::length * shape.pixel();
  for (int i = 0; i < 3; ++i) {
    if (isPlane(gizmo.dragged) == (i == *axis)) {
      continue;
    }
    const Vec3 along = reach * gizmo.axes.col(i);
    Stroke guide =
        lineBetween(gizmo.center - along, gizmo.center + along, withAlpha(colors_.axes[i], 0.6F), 1.2F);
    guide.dash = 5.0F;
    guide.gap = 5.0F;
    parts.strokes.push_back(guide);
  }
}

void GizmoActor::addPie(Parts& parts, const Gizmo& gizmo, const GizmoShape& shape) const {
  const Gizmo::Pie& pie = *gizmo.pie;
  const auto axis = axisOf(gizmo.dragged);
  const Rgba color = axis ? colors_.axes[*axis] : colors_.center;
  const double radius =
      (gizmo.dragged == GizmoPart::view ? GizmoSizes::length : GizmoSizes::ring) * shape.pixel();
  const double whole = 2.0 * std::numbers::pi;
  const double shown = std::clamp(pie.radians, -whole, whole);
  const int pieces = std::max(2, static_cast<int>(std::ceil(std::abs(shown) / 0.06)));
  const auto at = [&](double angle) {
    return Vec3(gizmo.center + radius * (Eigen::AngleAxisd(angle, pie.normal) * pie.start));
  };
  for (int i = 0; i < pieces; ++i) {
    parts.fills.push_back(
        {{gizmo.center, at(shown * i / pieces), at(shown * (i + 1) / pieces)}, withAlpha(color, 0.2F)});
  }
  parts.strokes.push_back(lineBetween(gizmo.center, at(0.0), withAlpha(color, 0.7F), 1.5F));
  parts.strokes.push_back(lineBetween(gizmo.center, at(pie.radians), color, 2.0F));
}

void GizmoActor::draw(const Gizmo& gizmo, const Projection& projection) {
  Parts parts;
  if (gizmo.kind != GizmoKind::none && !projection.isBehindEye(gizmo.center)) {
    const GizmoShape shape(gizmo, projection);
    addGuides(parts, gizmo, shape);
    // Painter's order: what is farther first.
    std::array<int, 3> order{0, 1, 2};
    const Vec3 eyeward = projection.lens().toWorld.col(2);
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return gizmo.axes.col(a).dot(eyeward) < gizmo.axes.col(b).dot(eyeward); });
    for (const int axis : order) {
      if (gizmo.kind == GizmoKind::rotate) {
        addRing(parts, gizmo, shape, axis);
      } else {
        addAxis(parts, gizmo, shape, axis);
      }
      if (gizmo.kind == GizmoKind::move) {
        addPlane(parts, gizmo, shape, axis);
      }
    }
    if (gizmo.kind == GizmoKind::rotate) {
      addRing(parts, gizmo, shape, 3);
      if (gizmo.pie) {
        addPie(parts, gizmo, shape);
      }
    } else {
      addCenter(parts, gizmo, shape);
    }
  }
  fills_.setFills(parts.fills);
  strokes_.setStrokes(parts.strokes);
}

}  // namespace pbffd::ui
