#include "core/ffd/deform/inverse.h"
#include "core/ffd/deform/space_deformation.h"
#include "tests/core/ffd/scenes.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd {

class InverseTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void imagesLeadBackToTheirPlaces() {
    test::Scene scene(test::sphere());
    scene.poseAtRandom(0.05, true);
    const SpaceDeformation deformation(scene.mesh, scene.set);
    const Points deformed = deformation.positions(scene.mesh->positions());
    int found = 0;
    const int count = 50;
    for (int i = 0; i < count; ++i) {
      Points place(1, 3);
      place.row(0) = 0.9 * Vec3(std::sin(i), std::cos(2.0 * i), std::sin(3.0 * i)).transpose();
      const Vec3 image = deformation.positions(place).row(0).transpose();
      if (const auto rest = restPlaceOf(image, scene.mesh, scene.set, deformed)) {
        Points back(1, 3);
        back.row(0) = rest->transpose();
        QVERIFY((deformation.positions(back).row(0).transpose() - image).norm() <=
                1e-12 * scene.mesh->diagonal());
        ++found;
      }
    }
    QCOMPARE(found, count);
  }

  void atRestEveryPlaceIsItsOwn() {
    const test::Scene scene(test::sphere());
    const auto rest = restPlaceOf(Vec3(0.1, 0.2, 0.3), scene.mesh, scene.set, scene.mesh->positions());
    QVERIFY(rest.has_value());
    QVERIFY((*rest - Vec3(0.1, 0.2, 0.3)).norm() < 1e-12);
  }

  void aFlattenedSpaceHasNoPlaceBesideItsPlane() {
    test::Scene scene(test::sphere());
    scene.poseBy(makeMap(Mat3(Vec3(1, 1, 0).asDiagonal()), Vec3::Zero()));
    const SpaceDeformation deformation(scene.mesh, scene.set);
    QVERIFY(
        !restPlaceOf(Vec3(0, 0, 0.5), scene.mesh, scene.set, deformation.positions(scene.mesh->positions())));
  }
};

const test::Registration<InverseTest> registration;

}  // namespace pbffd

#include "inverse_test.moc"
