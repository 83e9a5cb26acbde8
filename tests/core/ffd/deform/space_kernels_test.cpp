#include "core/ffd/deform/space_kernels.h"
#include "core/ffd/basis.h"
#include "core/ffd/deform/displacement.h"
#include "core/ffd/instructions.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>
#include <utility>
#include <vector>

namespace pbffd {

class SpaceKernelsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theFastestIsOneThatTheProcessorHas() {
    const auto all = variants();
    QVERIFY(std::find(all.begin(), all.end(), &spaceKernels()) != all.end());
  }

  void everyVariantAddsTheBitsOfTheDisplacement() {
    for (const SpaceKernels* kernels : variants()) {
      for (int trial = 0; trial < 1000; ++trial) {
        const Scene scene = made(trial);
        std::array<double, 48> sums = scene.before;
        kernels->addDisplacement(scene.term(), sums.data());
        for (std::size_t k = 0; k < 16; ++k) {
          const Vec3 moved = scene.displacement(scene.point(k));
          for (std::size_t axis = 0; axis < 3; ++axis) {
            const double weight = scene.values[k] * scene.toWeight[k];
            const double expected = scene.before[16 * axis + k] + weight * moved[static_cast<int>(axis)];
            QVERIFY(isSame(sums[16 * axis + k], expected));
          }
        }
      }
    }
  }

  void everyVariantGivesTheSlopesOfTheMembersAlone() {
    for (const SpaceKernels* kernels : variants()) {
      for (int trial = 0; trial < 1000; ++trial) {
        const Scene scene = made(trial);
        GradientSums sums{};
        kernels->addSlope(scene.points.data(), scene.influence(), sums);
        for (std::size_t k = 0; k < 16; ++k) {
          const Vec3 expected = scene.slope(k);
          const Vec3 slope(sums.slopes[k], sums.slopes[16 + k], sums.slopes[32 + k]);
          QVERIFY((slope - expected).norm() <= 1e-14 * (1.0 + expected.norm()));
          QVERIFY((scene.members >> k & 1U) != 0 || slope == Vec3::Zero());
        }
      }
    }
  }

  void everyVariantGivesTheTermsOfTheGradient() {
    for (const SpaceKernels* kernels : variants()) {
      for (int trial = 0; trial < 1000; ++trial) {
        const Scene scene = made(trial);
        GradientSums sums{};
        kernels->addGradient(scene.term(), scene.influence(), sums);
        for (std::size_t k = 0; k < 16; ++k) {
          const double weight = scene.values[k] * scene.toWeight[k];
          const Vec3 moved = scene.displacement(scene.point(k));
          const Mat3 expected =
              weight * scene.displacement.linear + scene.toWeight[k] * moved * scene.slope(k).transpose();
          Mat3 linear;
          for (int i = 0; i < 9; ++i) {
            linear(i / 3, i % 3) = sums.linear[16 * static_cast<std::size_t>(i) + k];
          }
          QVERIFY((linear - expected).norm() <= 1e-13 * (1.0 + expected.norm()));
          const Vec3 displaced(sums.displaced[k], sums.displaced[16 + k], sums.displaced[32 + k]);
          QVERIFY((displaced - weight * moved).norm() == 0.0);
        }
      }
    }
  }

  void allVariantsGiveTheSameBits() {
    const std::vector<const SpaceKernels*> all = variants();
    for (int trial = 0; trial < 1000; ++trial) {
      const Scene scene = made(trial);
      GradientSums first{};
      all.front()->addGradient(scene.term(), scene.influence(), first);
      for (const SpaceKernels* kernels : all) {
        GradientSums sums{};
        kernels->addGradient(scene.term(), scene.influence(), sums);
        QVERIFY(std::memcmp(&sums, &first, sizeof sums) == 0);
      }
    }
  }

 private:
  /// A control point over a block, some of whose points it moves.
  struct Scene {
    Basis basis;
    Region region;
    Displacement displacement;
    double strength;
    unsigned members;
    std::array<double, 48> points;
    std::array<double, 48> before;
    Lanes values;
    Lanes toWeight;

    Vec3 point(std::size_t k) const { return {points[k], points[16 + k], points[32 + k]}; }
    SpaceTerm term() const {
      return {points.data(),
              {displacement.center.data(), displacement.linear.data(), displacement.shift.data()},
              values.data(),
              toWeight.data()};
    }
    InfluenceNumbers influence() const { return {region.numbers(), numbersOf(basis), strength, members}; }
    Vec3 slope(std::size_t k) const {
      if ((members >> k & 1U) == 0) {
        return Vec3::Zero();
      }
      const Vec3 u = region.parameter(point(k));
      return 2.0 * strength * basisSlope(basis, u.squaredNorm()) * (region.toLocal.transpose() * u);
    }
  };

  Scene made(int trial) {
    std::mt19937 random(static_cast<unsigned>(trial));
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    const auto vector = [&] { return Vec3(number(random), number(random), number(random)); };
    const Frame rest{0.2 * vector(), Vec3(0.8, 1.0, 1.2 + 0.1 * number(random)).asDiagonal()};
    Frame pose = rest;
    pose.center += vector();
    pose.axes.col(0) += 0.3 * vector();
    Scene scene{{static_cast<Kernel>(trial % 3), 3.0},
                Region(rest),
                Displacement(rest, pose),
                1.0 + 0.5 * number(random),
                static_cast<unsigned>(random()) & 0xffffU,
                {},
                {},
                {},
                {}};
    for (double& coordinate : scene.points) {
      coordinate = number(random);
    }
    for (double& sum : scene.before) {
      sum = number(random);
    }
    for (std::size_t k = 0; k < 16; ++k) {
      scene.values[k] = (scene.members >> k & 1U) != 0 ? 0.5 + 0.5 * number(random) : 0.0;
      scene.toWeight[k] = 1.0 + 0.5 * number(random);
    }
    return scene;
  }

  static std::vector<const SpaceKernels*> variants() {
    std::vector<const SpaceKernels*> all;
    for (const auto& [instructions, kernels] : {std::pair(Instructions::plain, spacePlainKernels()),
                                                std::pair(Instructions::avx2, spaceAvx2Kernels()),
                                                std::pair(Instructions::avx512, spaceAvx512Kernels())}) {
      if (kernels != nullptr && hasInstructions(instructions)) {
        all.push_back(kernels);
      }
    }
    return all;
  }

  static bool isSame(double a, double b) { return std::memcmp(&a, &b, sizeof(double)) == 0; }
};

const test::Registration<SpaceKernelsTest> registration;

}  // namespace pbffd

#include "space_kernels_test.moc"
