#include "resources/samples/generator/sample.h"
#include "resources/samples/generator/solid_mesh.h"

namespace pbffd::samples {
namespace {

// Lengths in the creature's own unit: it stands about 2.3 high and looks along x.

Limb body() {
  return chain("body",
               {{{-0.66, 1.02, 0}, 0.33},
                {{-0.38, 0.96, 0}, 0.43},
                {{0.00, 0.92, 0}, 0.455},
                {{0.38, 0.98, 0}, 0.45},
                {{0.66, 1.22, 0}, 0.34},
                {{0.86, 1.56, 0}, 0.27}},
               0.2);
}

Limb head() {
  return {"head",
          {{{0.88, 1.80, 0}, {1.00, 1.78, 0}, 0.40, 0.38, 0.96},
           {{1.12, 1.68, 0}, {1.40, 1.60, 0}, 0.26, 0.21},
           {{1.02, 1.64, 0.16}, {1.02, 1.64, -0.16}, 0.22, 0.22}},
          0.16,
          0.14};
}

Limb leftEye() {
  return {"left_eye", {{{1.19, 1.895, 0.225}, {1.195, 1.895, 0.23}, 0.11, 0.105}}, 0.02, 0.03, "head"};
}

Limb leftEar() {
  return {"left_ear",
          {{{0.80, 2.04, 0.22}, {0.68, 2.30, 0.44}, 0.11, 0.185, 0.52, {0.75, 0.15, 0.35}},
           {{0.68, 2.30, 0.44}, {0.62, 2.42, 0.56}, 0.185, 0.12, 0.52, {0.75, 0.15, 0.35}}},
          0.03,
          0.10,
          "head"};
}

Limb leftHorn() {
  return {"left_horn", {{{1.00, 2.10, 0.13}, {1.02, 2.32, 0.16}, 0.10, 0.085}}, 0.04, 0.07, "head"};
}

Limb leftFrontLeg() {
  return chain("left_front_leg",
               {{{0.42, 0.92, 0.25}, 0.26},
                {{0.46, 0.56, 0.30}, 0.180},
                {{0.45, 0.30, 0.31}, 0.150},
                {{0.46, 0.11, 0.31}, 0.165},
                {{0.57, 0.08, 0.32}, 0.130}},
               0.14);
}

Limb leftHindLeg() {
  return chain("left_hind_leg",
               {{{-0.52, 0.92, 0.22}, 0.32},
                {{-0.44, 0.58, 0.29}, 0.215},
                {{-0.53, 0.28, 0.31}, 0.150},
                {{-0.51, 0.11, 0.31}, 0.165},
                {{-0.39, 0.08, 0.32}, 0.130}},
               0.14);
}

Limb tail() {
  return chain("tail",
               {{{-0.82, 1.12, 0}, 0.19},
                {{-1.10, 1.22, 0}, 0.125},
                {{-1.34, 1.40, 0}, 0.105},
                {{-1.46, 1.64, 0}, 0.093},
                {{-1.46, 1.84, 0}, 0.100},
                {{-1.42, 1.98, 0}, 0.150},
                {{-1.35, 2.10, 0}, 0.090}},
               0.2);
}

}  // namespace

Sample makeCreature() {
  std::vector<Limb> limbs{body(), head(), tail()};
  for (const Limb& limb : {leftEye(), leftEar(), leftHorn(), leftFrontLeg(), leftHindLeg()}) {
    limbs.push_back(limb);
    limbs.push_back(mirrored(limb));
  }
  Solid solid(std::move(limbs));
  solid.standOn(0.0, 0.05);
  Sample sample = meshOfSolid(solid, {.edge = 0.0545, .asTriangles = true});
  sample.name = "creature";
  sample.about = "A friendly quadruped";
  return sample;
}

}  // namespace pbffd::samples
