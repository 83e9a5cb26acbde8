#include "ui/window/thumbnail.h"

#include "core/mesh/normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace pbffd::ui {
namespace {

constexpr int supersampling = 2;
constexpr double margin = 0.08;  ///< of the picture, at each side
constexpr double toRadians = std::numbers::pi / 180.0;
constexpr double azimuth = 32.0 * toRadians;
constexpr double elevation = 16.0 * toRadians;

/// A light that turns with the camera: elevation, azimuth, strength (palette, section 2).
struct Light {
  Vec3 direction;
  double strength;
};

Light lightFrom(double up, double right, double strength) {
  const double e = up * toRadians;
  const double a = right * toRadians;
  return {Vec3(std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)), strength};
}

const std::array<Light, 4>& lights() {
  static const std::array<Light, 4> all{lightFrom(42, -38, 0.85), lightFrom(-18, 48, 0.32),
                                        lightFrom(22, 165, 0.35), lightFrom(0, 0, 0.12)};
  return all;
}

QRgb shade(Vec3 normal) {
  const double length = normal.norm();
  normal = length > 0.0 ? Vec3(normal / length) : Vec3::UnitZ();
  if (normal.z() < 0.0) {
    normal = -normal;
  }
  double bright = 0.16;
  double gleam = 0.0;
  for (const Light& light : lights()) {
    bright += 0.9 * light.strength * std::max(0.0, normal.dot(light.direction));
    const Vec3 half = (light.direction + Vec3::UnitZ()).normalized();
    gleam += 0.12 * light.strength * std::pow(std::max(0.0, normal.dot(half)), 28.0);
  }
  const auto channel = [&](double base) {
    return static_cast<int>(std::clamp(base * bright + 255.0 * gleam, 0.0, 255.0));
  };
  return qRgb(channel(0xbd), channel(0xb8), channel(0xb0));
}

/// A picture with a depth for each pixel.
class Canvas {
 public:
  explicit Canvas(const QSize& size)
      : image_(size, QImage::Format_ARGB32),
        depth_(static_cast<std::size_t>(size.width()) * static_cast<std::size_t>(size.height()), -1e300) {
    image_.fill(Qt::transparent);
  }

  /// Corners in pixels with the depth towards the eye in z; a normal for each.
  void fill(const std::array<Vec3, 3>& corners, const std::array<Vec3, 3>& normals) {
    const double area = cross(corners[0], corners[1], corners[2]);
    if (std::abs(area) < 1e-12) {
      return;
    }
    const auto [left, right] = std::minmax({corners[0].x(), corners[1].x(), corners[2].x()});
    const auto [top, bottom] = std::minmax({corners[0].y(), corners[1].y(), corners[2].y()});
    for (int y = std::max(0, static_cast<int>(top)); y <= std::min(image_.height() - 1.0, bottom); ++y) {
      for (int x = std::max(0, static_cast<int>(left)); x <= std::min(image_.width() - 1.0, right); ++x) {
        const Vec3 at(x + 0.5, y + 0.5, 0.0);
        const double a = cross(corners[1], corners[2], at) / area;
        const double b = cross(corners[2], corners[0], at) / area;
        const double c = 1.0 - a - b;
        if (a >= 0.0 && b >= 0.0 && c >= 0.0) {
          const double depth = a * corners[0].z() + b * corners[1].z() + c * corners[2].z();
          put(x, y, depth, a * normals[0] + b * normals[1] + c * normals[2]);
        }
      }
    }
  }

  const QImage& image() const { return image_; }

 private:
  static double cross(const Vec3& a, const Vec3& b, const Vec3& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  }

  void put(int x, int y, double depth, const Vec3& normal) {
    double& present = depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width()) +
                             static_cast<std::size_t>(x)];
    if (depth > present) {
      present = depth;
      reinterpret_cast<QRgb*>(image_.scanLine(y))[x] = shade(normal);
    }
  }

  QImage image_;
  std::vector<double> depth_;
};

/// World to camera: x right, y up, z towards the eye.
Mat3 cameraRotation() {
  Mat3 turn;
  turn << std::cos(azimuth), 0, -std::sin(azimuth), 0, 1, 0, std::sin(azimuth), 0, std::cos(azimuth);
  Mat3 tilt;
  tilt << 1, 0, 0, 0, std::cos(elevation), -std::sin(elevation), 0, std::sin(elevation), std::cos(elevation);
  return tilt * turn;
}

}  // namespace

QImage renderThumbnail(const Points& positions, const Triangles& triangles, const QSize& size) {
  Canvas canvas(size * supersampling);
  if (triangles.size() == 0) {
    return canvas.image().scaled(size);
  }
  const Mat3 rotation = cameraRotation();
  const Points seen = positions * rotation.transpose();
  const Points normals = vertexNormals(positions, triangles) * rotation.transpose();
  const Bounds bounds = boundsOf(seen);
  const Vec3 extent = bounds.high - bounds.low;
  const double width = size.width() * supersampling;
  const double height = size.height() * supersampling;
  const double scale = (1.0 - 2.0 * margin) *
                       std::min(width / std::max(extent.x(), 1e-300), height / std::max(extent.y(), 1e-300));
  for (std::size_t t = 0; t < static_cast<std::size_t>(triangles.size()); ++t) {
    std::array<Vec3, 3> corners;
    std::array<Vec3, 3> cornerNormals;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index vertex = triangles.vertices()[3 * t + k];
      const Vec3 offset = scale * (seen.row(vertex).transpose() - bounds.center());
      corners[k] = Vec3(0.5 * width + offset.x(), 0.5 * height - offset.y(), offset.z());
      cornerNormals[k] = normals.row(vertex).transpose();
    }
    canvas.fill(corners, cornerNormals);
  }
  return canvas.image().scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

}  // namespace pbffd::ui
