#include "resources/samples/generator/sample.h"
#include "resources/samples/generator/solid_mesh.h"

#include <array>

namespace pbffd::samples {
namespace {

// In decimetres: a left hand, fingers up, palm towards x.

const Vec3 throughPalm{1, 0, 0};

Limb palm() {
  return {"body",
          {{{0.00, 0.62, 0.22}, {0.00, 0.10, 0.14}, 0.26, 0.26, 0.52, throughPalm},
           {{0.00, 0.60, -0.20}, {0.00, 0.12, -0.12}, 0.25, 0.26, 0.52, throughPalm},
           {{0.06, 0.28, 0.20}, {0.05, 0.02, 0.12}, 0.17, 0.15},
           {{0.03, 0.30, -0.24}, {0.03, 0.02, -0.12}, 0.14, 0.15},
           {{0.00, 0.00, 0.00}, {0.00, -0.55, 0.00}, 0.27, 0.25, 0.72, throughPalm}},
          0.14,
          0.07};
}

struct Finger {
  const char* name;
  Vec3 knuckle;
  Vec3 direction;
  std::array<double, 3> lengths;
  double radius;
};

/// Three bones, each bent a little further towards the palm.
Limb finger(const Finger& finger) {
  Limb limb{finger.name, {}, 0.03, 0.06};
  Vec3 at = finger.knuckle;
  Vec3 direction = finger.direction.normalized();
  double radius = finger.radius;
  for (const double length : finger.lengths) {
    const Vec3 next = at + length * direction;
    const double nextRadius = 0.92 * radius;
    limb.bones.push_back({at, next, radius, nextRadius});
    at = next;
    radius = nextRadius;
    direction = (direction + 0.14 * throughPalm).normalized();
  }
  return limb;
}

}  // namespace

Sample makeHand() {
  std::vector<Limb> limbs{
      palm(),
      finger({"index", {-0.01, 0.78, 0.335}, {0.06, 1.0, 0.14}, {0.46, 0.29, 0.20}, 0.112}),
      finger({"middle", {-0.02, 0.84, 0.10}, {0.06, 1.0, 0.03}, {0.50, 0.33, 0.21}, 0.116}),
      finger({"ring", {-0.01, 0.80, -0.13}, {0.07, 1.0, -0.09}, {0.46, 0.31, 0.20}, 0.110}),
      finger({"little", {0.01, 0.70, -0.345}, {0.08, 1.0, -0.20}, {0.36, 0.22, 0.17}, 0.094}),
      finger({"thumb", {0.08, 0.20, 0.30}, {0.28, 0.72, 0.68}, {0.36, 0.32, 0.22}, 0.150}),
  };
  Solid solid(std::move(limbs));
  solid.standOn(-0.62, 0.05);
  Sample sample = meshOfSolid(solid, {.edge = 0.042, .asTriangles = true});
  sample.name = "hand";
  sample.about = "A hand with its fingers close beside each other";
  return sample;
}

}  // namespace pbffd::samples
