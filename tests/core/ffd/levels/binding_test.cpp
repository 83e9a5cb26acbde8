#include "core/ffd/levels/binding.h"

#include "core/base/error.h"
#include "core/ffd/levels/hierarchy.h"
#include "tests/core/ffd/scenes.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd {

class BindingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aBindingThatWouldLoseThePoseIsAnError() {
    for (const double thickness : {1e-4, 1e-10, 0.0}) {
      // Along no axis, so that rounding counts.
      const Mat3 turn = test::Scene::turnBy(Vec3(0.4, 0.5, 0.6));
      const AffineMap thin =
          makeMap(turn.transpose() * Vec3(1, 1, thickness).asDiagonal() * turn, Vec3(0.1, 0.2, 0.3));
      ControlPoint upright = test::pointAt(7, Vec3(0.5, 0.5, 0.5), 0.4);
      if (thickness > 1e-5) {
        upright.binding = bindingTo(upright, thin, 0);
        QVERIFY((boundPose(upright, thin).axes - upright.pose.axes).norm() < 1e-11);
        continue;
      }
      try {
        static_cast<void>(bindingTo(upright, thin, 0));
        QFAIL("a pose was lost");
      } catch (const InvalidInput& error) {
        QVERIFY(QString(error.what()).contains("point 7 cannot hang on level 1, which is flattened there"));
      }
    }
  }

  void contradictingBindingsAreTakenAnew() {
    ControlSet set = leveled();
    QCOMPARE(mendBindings(*mesh_, set), 0);
    const ControlSet rest = set;
    ControlPoint coarse = set.levels[0][0];
    coarse.pose.center += Vec3(0.3, 0.1, 0.0);
    set.levels[0].replace(0, coarse);
    carryDown(rest, set, 0, levelBindings(*mesh_, set));
    const ControlSet whole = set;
    QCOMPARE(mendBindings(*mesh_, set), 0);
    QVERIFY(set == whole);
    ControlPoint displaced = set.levels[2][3];
    displaced.binding.local.col(3) += Vec3(0.1, 0, 0);
    set.levels[2].replace(3, displaced);
    ControlPoint misplaced = set.levels[1][2];
    misplaced.binding.at += Vec3(0, 0.1, 0);
    set.levels[1].replace(2, misplaced);
    QCOMPARE(mendBindings(*mesh_, set), 2);
    QVERIFY(set.levels[2][3].pose == whole.levels[2][3].pose);
    QVERIFY((set.levels[2][3].binding.local - whole.levels[2][3].binding.local).norm() < 1e-13);
    QVERIFY(set.levels[1][2].binding.at == set.levels[1][2].rest.center);
    QCOMPARE(mendBindings(*mesh_, set), 0);
  }

  void bindingsThatCannotBeMendedAreAnError() {
    ControlSet set = leveled();
    const AffineMap flat = makeMap(Mat3(Vec3(1, 1, 0).asDiagonal()), Vec3::Zero());
    for (Index i = 0; i < set.levels[0].size(); ++i) {
      ControlPoint point = set.levels[0][i];
      point.pose = moved(point.rest, flat);
      set.levels[0].replace(i, point);
    }
    set.master.pose = moved(set.master.rest, flat);
    QVERIFY_EXCEPTION_THROWN(mendBindings(*mesh_, set), InvalidInput);
  }

 private:
  /// Three levels over a sphere.
  ControlSet leveled() const {
    ControlSet set = test::Scene(test::sphere()).set;
    PointId nextId = 1000;
    set.levels = buildLevels(set.finest(), 3, nextId);
    return set;
  }

  std::shared_ptr<const RestMesh> mesh_ = std::make_shared<const RestMesh>(test::sphere());
};

const test::Registration<BindingTest> registration;

}  // namespace pbffd

#include "binding_test.moc"
