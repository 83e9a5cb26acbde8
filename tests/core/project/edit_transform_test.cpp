#include "tests/core/project/projects.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <QtTest>

#include <algorithm>
#include <array>
#include <limits>

namespace pbffd {

using test::after;
using test::contains;
using test::difference;
using test::pointOf;
using test::projectWith;
using test::refusal;

namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();
}

class EditTransformTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void transformScalesThenTurnsAboutTheMedian() {
    const Project before = projectWith();
    Transform edit;
    edit.where = {3, {1, 2, 3}};
    edit.scale = Vec3(2, 1, 1);
    edit.rotationAxis = Vec3(0, 0, 5);
    edit.degrees = 90.0;
    Vec3 pivot;
    for (int k = 0; k < 3; ++k) {
      std::array<double, 3> values{pointOf(before, 1).pose.center[k], pointOf(before, 2).pose.center[k],
                                   pointOf(before, 3).pose.center[k]};
      std::sort(values.begin(), values.end());
      pivot[k] = values[1];
    }
    const Mat3 linear = (Mat3() << 0, -1, 0, 2, 0, 0, 0, 0, 1).finished();
    const AffineMap map = makeMap(linear, pivot - linear * pivot);
    const Project moved = after(before, edit);
    for (const PointId id : {1, 2, 3}) {
      QVERIFY(difference(pointOf(moved, id).pose, pbffd::moved(pointOf(before, id).pose, map)) < 1e-14);
    }
  }

  void transformAlongABasisAndAboutEachOwnCentre() {
    const Project before = projectWith();
    Transform edit;
    edit.where = {3, {4, 6}};
    edit.eachItsOwn = true;
    edit.basis = Eigen::AngleAxisd(M_PI / 4, Vec3::UnitZ()).toRotationMatrix();
    edit.scale = Vec3(3, 1, 1);
    const Project moved = after(before, edit);
    const Mat3 linear = edit.basis * edit.scale.asDiagonal() * edit.basis.transpose();
    for (const PointId id : {4, 6}) {
      QVERIFY(pointOf(moved, id).pose.center == pointOf(before, id).pose.center);
      QVERIFY((pointOf(moved, id).pose.axes - linear * pointOf(before, id).pose.axes).norm() < 1e-13);
    }
  }

  void transformWeightsShareOutAngleAndScale() {
    const Project before = projectWith();
    Transform edit;
    edit.where = {3, {4}};
    edit.eachItsOwn = true;
    edit.scale = Vec3(4, 4, 4);
    edit.degrees = 60.0;
    edit.spread.weights = {0.5};
    const Mat3 linear = 2.0 * Eigen::AngleAxisd(M_PI / 6, Vec3::UnitZ()).toRotationMatrix();
    const Project moved = after(before, edit);
    QVERIFY((pointOf(moved, 4).pose.axes - linear * pointOf(before, 4).pose.axes).norm() < 1e-14);
    edit.scale = Vec3(-1, 1, 1);
    QVERIFY(contains(refusal(before, edit), "negative scale"));
  }

  void transformsThatCannotBeDoneAreRefused() {
    const Project before = projectWith();
    Transform edit;
    edit.where = {3, {4}};
    const auto with = [&](auto change) {
      Transform changed = edit;
      change(changed);
      return refusal(before, changed);
    };
    QVERIFY(contains(with([](Transform& t) { t.scale = Vec3(1, 0, 1); }), "scale of 0"));
    QVERIFY(contains(with([](Transform& t) { t.scale = Vec3(1, NAN, 1); }), "not finite"));
    QVERIFY(contains(with([](Transform& t) { t.basis = Mat3::Zero(); }), "singular"));
    QVERIFY(contains(with([](Transform& t) { t.degrees = infinity; }), "not finite"));
    QVERIFY(contains(with([](Transform& t) { t.pivot = Vec3(NAN, 0, 0); }), "not finite"));
    QVERIFY(contains(with([](Transform& t) {
                       t.degrees = 10;
                       t.rotationAxis = Vec3::Zero();
                     }),
                     "axis has no length"));
    QVERIFY(contains(with([](Transform& t) { t.scale = Vec3(1, 1e-14, 1); }), "singular"));
  }
};

const test::Registration<EditTransformTest> registration;

}  // namespace pbffd

#include "edit_transform_test.moc"
