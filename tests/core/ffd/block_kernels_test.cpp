#include "core/ffd/block_kernels.h"
#include "core/ffd/basis.h"
#include "core/ffd/instructions.h"
#include "tests/core/ffd/scenes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace pbffd {

class BlockKernelsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theFastestIsOneThatTheProcessorHas() {
    bool isKnown = false;
    for (const BlockKernels* kernels : variants()) {
      isKnown = isKnown || kernels == &blockKernels();
    }
    QVERIFY(isKnown);
  }

  void everyVariantGivesTheBitsOfTheFormulas() {
    for (const BlockKernels* kernels : variants()) {
      for (int trial = 0; trial < 3000; ++trial) {
        const Region region(frame(trial));
        const std::array<double, 48> points = numbers<48>(1.0);
        const Basis basis{static_cast<Kernel>(trial % 3), uniform(0.5, 10.0)};
        Lanes squared;
        Lanes values;
        kernels->squaredDistances(points.data(), region.numbers(), squared.data());
        kernels->radial({static_cast<int>(basis.kernel), basis.sigma}, squared.data(), values.data());
        const unsigned inside = kernels->inside(points.data(), region.numbers());
        for (std::size_t k = 0; k < 16; ++k) {
          const double expected = region.squaredDistance({points[k], points[16 + k], points[32 + k]});
          QVERIFY(isSame(squared[k], expected));
          QVERIFY(isSame(values[k], basisValue(basis, expected)));
          QCOMPARE((inside >> k & 1U) != 0, expected < 1.0);
        }
      }
    }
  }

  void membersAloneAreAddedAndWeighed() {
    for (const BlockKernels* kernels : variants()) {
      const Basis basis{Kernel::wendland, 3.0};
      const std::array<double, 48> points = numbers<48>(1.0);
      const Region regions[2] = {Region(frame(0)), Region(frame(1))};
      const PointNumbers level[3] = {{regions[1].numbers(), numbersOf(basis), 0.5},
                                     {regions[0].numbers(), numbersOf(basis), 7.0},
                                     {regions[0].numbers(), numbersOf(basis), 3.0}};
      const std::array<Index, 2> list{2, 0};
      const std::array<std::uint16_t, 2> members{0x8001U, 0xfffeU};
      Lanes values[2];
      Lanes sums;
      sums.fill(1.0);
      kernels->memberValues(points.data(), level, list.data(), members.data(), 2, values[0].data(), sums.data());
      std::array<float, 32> weights{};
      Lanes toWeight;
      toWeight.fill(0.25);
      kernels->weights(values[0].data(), 2, toWeight.data(), weights.data());
      for (std::size_t k = 0; k < 16; ++k) {
        for (std::size_t i = 0; i < 2; ++i) {
          const double square = regions[i].squaredDistance({points[k], points[16 + k], points[32 + k]});
          const bool isMember = (members[i] >> k & 1U) != 0;
          QVERIFY(isSame(values[i][k], isMember ? level[list[i]].strength * basisValue(basis, square) : 0.0));
          QCOMPARE(weights[16 * i + k], static_cast<float>(0.25 * values[i][k]));
        }
        QVERIFY(isSame(sums[k], 1.0 + values[0][k] + values[1][k]));
      }
    }
  }

  void boxesThatHoldAPointOfTheRegionMeetIt() {
    unsigned missed = 0;
    for (int trial = 0; trial < 3000; ++trial) {
      const Frame rest = frame(trial);
      const Region region(rest);
      std::array<double, 48> boxes{};
      for (std::size_t k = 0; k < 8; ++k) {
        // Around a point on or within the border, off its middle by less than the half sizes.
        Vec3 u(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
        u *= (k % 2 == 0 ? 1.0 - 1e-12 : uniform(0, 1)) / u.norm();
        const Vec3 inside = rest.center + rest.axes * u;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double half = uniform(0, 0.1);
          boxes[24 + 8 * axis + k] = half;
          boxes[8 * axis + k] = inside[static_cast<Eigen::Index>(axis)] + uniform(-1, 1) * half;
        }
      }
      boxes[5] = std::numeric_limits<double>::quiet_NaN();
      const unsigned met = variants().front()->meets(boxes.data(), region.numbers()) & 0xffU;
      QCOMPARE(met, 0xffU & ~(1U << 5U));
      boxes[0] += 50.0;
      for (const BlockKernels* kernels : variants()) {
        const unsigned farther = kernels->meets(boxes.data(), region.numbers()) & 0xffU;
        QCOMPARE(farther, 0xfeU & ~(1U << 5U));
        missed += farther != met;
      }
    }
    QVERIFY(missed > 0);
  }

  void boxesInARegionHoldOnlyPointsInside() {
    int whole = 0;
    for (int trial = 0; trial < 300; ++trial) {
      const Frame rest = frame(trial);
      const Region region(rest);
      std::array<double, 48> boxes{};
      for (std::size_t k = 0; k < 8; ++k) {
        const Vec3 center = rest.center + rest.axes * Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
        for (std::size_t axis = 0; axis < 3; ++axis) {
          boxes[8 * axis + k] = center[static_cast<Eigen::Index>(axis)];
          boxes[24 + 8 * axis + k] = uniform(0, 0.2) * rest.axes.col(0).norm();
        }
      }
      const unsigned found = variants().front()->meets(boxes.data(), region.numbers());
      for (const BlockKernels* kernels : variants()) {
        QCOMPARE(kernels->meets(boxes.data(), region.numbers()), found);
      }
      QCOMPARE((found >> 8U) & ~found, 0U);
      for (std::size_t k = 0; k < 8; ++k) {
        for (unsigned corner = 0; corner < 8 && (found >> (8 + k) & 1U) != 0; ++corner) {
          Vec3 at;
          for (std::size_t axis = 0; axis < 3; ++axis) {
            const double half = boxes[24 + 8 * axis + k];
            at[static_cast<Eigen::Index>(axis)] =
                boxes[8 * axis + k] + ((corner >> axis & 1U) != 0 ? half : -half);
          }
          QVERIFY(region.squaredDistance(at) < 1.0);
          ++whole;
        }
      }
    }
    QVERIFY(whole > 1000);
  }

  void pointsNearAPlaceAreFoundByTheirDistance() {
    for (int trial = 0; trial < 300; ++trial) {
      const std::array<double, 48> points = numbers<48>(1.0);
      const Vec3 place(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
      for (const BlockKernels* kernels : variants()) {
        Lanes squared;
        const unsigned near = kernels->nearPoints(points.data(), place.data(), 0.8, squared.data());
        for (std::size_t k = 0; k < 16; ++k) {
          const Vec3 d = Vec3(points[k], points[16 + k], points[32 + k]) - place;
          QVERIFY(isSame(squared[k], d.x() * d.x() + d.y() * d.y() + d.z() * d.z()));
          QCOMPARE((near >> k & 1U) != 0, squared[k] < 0.8);
        }
      }
    }
  }

  void boxesAreNoFartherThanTheyAre() {
    for (int trial = 0; trial < 300; ++trial) {
      std::array<double, 48> boxes = numbers<48>(1.0);
      std::for_each(boxes.begin() + 24, boxes.end(), [](double& half) { half = std::abs(half); });
      boxes[3] = std::numeric_limits<double>::quiet_NaN();
      const Vec3 place(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
      std::array<double, 8> first{};
      const unsigned found = variants().front()->nearBoxes(boxes.data(), place.data(), 0.5, first.data());
      for (const BlockKernels* kernels : variants()) {
        std::array<double, 8> squared{};
        QCOMPARE(kernels->nearBoxes(boxes.data(), place.data(), 0.5, squared.data()), found);
        QVERIFY(std::memcmp(squared.data(), first.data(), sizeof first) == 0);
      }
      for (std::size_t k = 0; k < 8; ++k) {
        double exact = 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double away = std::abs(place[static_cast<Eigen::Index>(axis)] - boxes[8 * axis + k]);
          exact += std::pow(std::max(away - boxes[24 + 8 * axis + k], 0.0), 2);
        }
        QVERIFY(k == 3 || (first[k] <= exact && first[k] >= exact - 1e-13));
        QCOMPARE((found >> k & 1U) != 0, first[k] < 0.5);
      }
    }
  }

 private:
  static std::vector<const BlockKernels*> variants() {
    std::vector<const BlockKernels*> all;
    for (const auto& [instructions, kernels] : {std::pair(Instructions::plain, blockPlainKernels()),
                                                std::pair(Instructions::avx2, blockAvx2Kernels()),
                                                std::pair(Instructions::avx512, blockAvx512Kernels())}) {
      if (kernels != nullptr && hasInstructions(instructions)) {
        all.push_back(kernels);
      }
    }
    return all;
  }

  static bool isSame(double a, double b) { return std::memcmp(&a, &b, sizeof(double)) == 0; }

  double uniform(double low, double high) { return low + (high - low) * (chance_() / 4294967296.0); }

  template <std::size_t count>
  std::array<double, count> numbers(double size) {
    std::array<double, count> result;
    for (double& number : result) {
      number = uniform(-size, size);
    }
    return result;
  }

  /// Turned; a sphere every other time.
  Frame frame(int trial) {
    Vec3 axes(uniform(0.2, 1), uniform(0.2, 1), uniform(0.2, 1));
    if (trial % 2 == 0) {
      axes.fill(axes[0]);
    }
    const Vec3 turn(uniform(-1, 1), uniform(-1, 1), 1);
    return {Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)),
            test::Scene::turnBy(turn) * axes.asDiagonal()};
  }

  std::mt19937 chance_{11};
};

const test::Registration<BlockKernelsTest> registration;

}  // namespace pbffd

#include "block_kernels_test.moc"
