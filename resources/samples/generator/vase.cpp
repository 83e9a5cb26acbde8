#include "resources/samples/generator/sample.h"
#include "resources/samples/generator/surface_details.h"

#include <array>
#include <cmath>
#include <numbers>

namespace pbffd::samples {
namespace {

constexpr int around = 112;
constexpr int along = 50;

/// Places (radius, height) that the vase's outline passes through, from the middle of the bottom to the lip.
constexpr std::array<std::array<double, 2>, 10> outline{{{0.0, 0.0},
                                                         {0.36, 0.0},
                                                         {0.46, 0.07},
                                                         {0.66, 0.42},
                                                         {0.74, 0.80},
                                                         {0.60, 1.22},
                                                         {0.37, 1.58},
                                                         {0.34, 1.80},
                                                         {0.46, 2.02},
                                                         {0.68, 2.16}}};

/// The outline at t from 0 to 1, as a Catmull-Rom spline.
Eigen::Vector2d outlineAt(double t) {
  const int spans = static_cast<int>(outline.size()) - 1;
  const int span = std::min(static_cast<int>(t * spans), spans - 1);
  const double s = t * spans - span;
  const auto place = [&](int i) {
    const auto& p = outline[std::clamp(i, 0, spans)];
    return Eigen::Vector2d(p[0], p[1]);
  };
  const Eigen::Vector2d a = place(span - 1);
  const Eigen::Vector2d b = place(span);
  const Eigen::Vector2d c = place(span + 1);
  const Eigen::Vector2d d = place(span + 2);
  return 0.5 * (2.0 * b + (c - a) * s + (2.0 * a - 5.0 * b + 4.0 * c - d) * s * s +
                (3.0 * b - a - 3.0 * c + d) * s * s * s);
}

/// Flutes that grow from the foot upwards and turn a little about the axis.
Vec3 pointAt(int ring, int segment) {
  const double t = static_cast<double>(ring) / along;
  const Eigen::Vector2d place = outlineAt(t);
  const double angle = 2.0 * std::numbers::pi * segment / around;
  const double depth = 0.055 * std::pow(std::clamp((t - 0.15) / 0.85, 0.0, 1.0), 1.5);
  const double radius = place.x() * (1.0 + depth * std::cos(8.0 * angle + 2.2 * place.y()));
  return {radius * std::sin(angle), place.y(), radius * std::cos(angle)};
}

}  // namespace

Sample makeVase() {
  Sample sample;
  sample.name = "vase";
  sample.about = "A fluted vase: an open surface without thickness";
  sample.isClosed = false;
  // Vertex 0 is the middle of the bottom; ring r, segment s follow.
  const auto vertexAt = [](int ring, int segment) {
    return ring == 0 ? 0 : 1 + (ring - 1) * around + segment % around;
  };
  sample.positions.resize(1 + along * around, 3);
  for (int r = 0; r <= along; ++r) {
    for (int s = 0; s < around; ++s) {
      sample.positions.row(vertexAt(r, s)) = pointAt(r, s);
    }
  }
  // Texture coordinates run once around, so that ring r has one row more than segments.
  sample.textures.resize((along + 1) * (around + 1), 2);
  for (int r = 0; r <= along; ++r) {
    for (int s = 0; s <= around; ++s) {
      sample.textures.row(r * (around + 1) + s) << static_cast<double>(s) / around,
          static_cast<double>(r) / along;
    }
  }
  for (int r = 0; r < along; ++r) {
    for (int s = 0; s < around; ++s) {
      std::vector<std::array<int, 2>> corners{{r, s}, {r, s + 1}, {r + 1, s + 1}, {r + 1, s}};
      if (r == 0) {
        corners.erase(corners.begin());
      }
      std::vector<Index> face;
      for (const auto& [ring, segment] : corners) {
        face.push_back(vertexAt(ring, segment));
        sample.textureOfCorner.push_back(ring * (around + 1) + segment);
      }
      sample.faces.add(face);
    }
  }
  addCreasedNormals(sample, 180.0);
  addSingleGroup(sample);
  return sample;
}

}  // namespace pbffd::samples
