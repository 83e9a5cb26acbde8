#include "resources/samples/generator/sample.h"
#include "resources/samples/generator/solid_mesh.h"

namespace pbffd::samples {
namespace {

// In metres: 1.75 high, facing z is to the left of the figure, x ahead of it.

const Vec3 ahead{1, 0, 0};

Limb body() {
  return {"body",
          {{{0.00, 0.96, 0.04}, {0.00, 0.96, -0.04}, 0.118, 0.118, 0.94, ahead},
           {{0.00, 0.98, 0}, {0.00, 1.12, 0}, 0.138, 0.130, 0.80, ahead},
           {{0.00, 1.12, 0}, {0.00, 1.31, 0}, 0.130, 0.172, 0.70, ahead},
           {{-0.005, 1.395, 0.125}, {-0.005, 1.395, -0.125}, 0.080, 0.080},
           {{-0.01, 1.42, 0}, {0.01, 1.56, 0}, 0.080, 0.060}},
          0.07,
          0.06};
}

Limb head() {
  return {"head",
          {{{0.010, 1.690, 0}, {0.030, 1.620, 0}, 0.122, 0.092, 0.88, {0, 0, 1}},
           {{0.122, 1.660, 0}, {0.130, 1.638, 0}, 0.013, 0.020}},
          0.035,
          0.035};
}

Limb leftEar() {
  return {"left_ear",
          {{{0.005, 1.675, 0.106}, {0.008, 1.640, 0.100}, 0.032, 0.024, 0.65, {0, 0, 1}}},
          0.01,
          0.012,
          "head"};
}

Limb leftArm() {
  return chain("left_arm",
               {{{0.000, 1.400, 0.165}, 0.080},
                {{0.000, 1.385, 0.250}, 0.066},
                {{-0.003, 1.362, 0.350}, 0.060},
                {{-0.005, 1.340, 0.460}, 0.049},
                {{0.005, 1.328, 0.540}, 0.051},
                {{0.020, 1.306, 0.710}, 0.035}},
               0.06);
}

Limb leftHand() {
  return {"left_hand",
          {{{0.020, 1.306, 0.705}, {0.022, 1.298, 0.780}, 0.042, 0.052, 0.62, {0, 1, 0}},
           {{0.022, 1.298, 0.780}, {0.022, 1.276, 0.890}, 0.052, 0.038, 0.62, {0, 1, 0}},
           {{0.050, 1.300, 0.735}, {0.092, 1.290, 0.795}, 0.028, 0.024}},
          0.014,
          0.03,
          "left_arm"};
}

Limb leftLeg() {
  return chain("left_leg",
               {{{0.000, 0.930, 0.085}, 0.112},
                {{0.005, 0.760, 0.096}, 0.097},
                {{0.010, 0.500, 0.105}, 0.064},
                {{-0.010, 0.380, 0.107}, 0.065},
                {{-0.012, 0.220, 0.109}, 0.050},
                {{-0.010, 0.100, 0.110}, 0.043}},
               0.05);
}

Limb leftFoot() {
  return chain(
      "left_foot",
      {{{-0.022, 0.055, 0.110}, 0.050}, {{0.060, 0.048, 0.118}, 0.050}, {{0.150, 0.028, 0.128}, 0.040}}, 0.03,
      "left_leg");
}

}  // namespace

Sample makeFigure() {
  std::vector<Limb> limbs{body(), head()};
  for (const Limb& limb : {leftEar(), leftArm(), leftHand(), leftLeg(), leftFoot()}) {
    limbs.push_back(limb);
    limbs.push_back(mirrored(limb));
  }
  Solid solid(std::move(limbs));
  solid.standOn(0.0, 0.015);
  Sample sample = meshOfSolid(solid, {.edge = 0.0215, .asTriangles = false});
  sample.name = "figure";
  sample.about = "A standing figure with the arms out";
  return sample;
}

}  // namespace pbffd::samples
