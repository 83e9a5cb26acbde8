#include "resources/samples/generator/solid.h"

#include "core/base/error.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd::samples {

class SolidTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void distanceToARoundConeIsExact() {
    const Bone bone{{0, 0, 0}, {2, 0, 0}, 1.0, 0.5};
    QVERIFY(std::abs(bone.distance({-3, 0, 0}) - 2.0) < 1e-12);
    QVERIFY(std::abs(bone.distance({4, 0, 0}) - 1.5) < 1e-12);
    // The cone that touches both balls leans by asin(0.25).
    const double sine = 0.25;
    const Vec3 normal(sine, std::sqrt(1.0 - sine * sine), 0);
    const Vec3 onCone = Vec3(1, 0, 0) + 0.75 * normal;
    QVERIFY(std::abs(bone.distance(onCone)) < 1e-12);
    QVERIFY(std::abs(bone.distance(onCone + 0.3 * normal) - 0.3) < 1e-12);
  }

  void ballInsideTheOtherDoesNotCount() {
    const Bone bone{{0, 0, 0}, {0.1, 0, 0}, 1.0, 0.2};
    QVERIFY(std::abs(bone.distance({0, 3, 0}) - 2.0) < 1e-12);
  }

  void limbsThatAreNearStayApart() {
    const Limb body{"body", {{{-2, 0, 0}, {2, 0, 0}, 0.5, 0.5}}};
    const Limb left{"left", {{{-0.3, 0, 0}, {-0.3, 3, 0}, 0.25, 0.25}}, 0.1, 0.3};
    const Limb right{"right", {{{0.3, 0, 0}, {0.3, 3, 0}, 0.25, 0.25}}, 0.1, 0.3};
    const Solid solid({body, left, right});
    QVERIFY(solid.value({0, 2, 0}) > 0.0);    // between them
    QVERIFY(solid.value({0.3, 2, 0}) < 0.0);  // within one
    QVERIFY(solid.value({0, 0, 0}) < 0.0);
  }

  void mirroredLimbLiesOnTheOtherSide() {
    const Limb limb{"left_arm", {{{0, 0, 1}, {0, 1, 2}, 0.5, 0.25}}, 0.1, 0.1, "left_shoulder"};
    const Limb other = mirrored(limb);
    QCOMPARE(other.name, std::string("right_arm"));
    QCOMPARE(other.parent, std::string("right_shoulder"));
    QCOMPARE(other.bones[0].distance({0.1, 0.2, -3}), limb.bones[0].distance({0.1, 0.2, 3}));
  }

  void unknownParentIsRefused() {
    const Limb body{"body", {{{0, 0, 0}, {1, 0, 0}}}};
    const Limb limb{"hand", {{{0, 0, 0}, {1, 0, 0}}}, 0.1, 0.1, "arm"};
    QVERIFY_EXCEPTION_THROWN(Solid({body, limb}), InvalidInput);
    QVERIFY_EXCEPTION_THROWN(Solid(std::vector<Limb>{}), InvalidInput);
  }
};

const test::Registration<SolidTest> registration;

}  // namespace pbffd::samples

#include "solid_test.moc"
