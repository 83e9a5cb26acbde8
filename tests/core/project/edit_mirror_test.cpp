#include "core/project/mirror.h"
#include "tests/core/project/projects.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <array>
#include <cmath>

namespace pbffd {

using test::after;
using test::difference;
using test::pointOf;
using test::projectWith;

/// Moves and transforms that act on mirror partners too.
class EditMirrorTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void mirrorPartnersMoveMirrored() {
    const Project before = symmetricProject();
    Move edit{{1, {1}}, {Vec3(0.1, 0.2, 0.3)}, Follow::none, {}};
    edit.spread.mirror = {Axis::x};
    const Project moved = after(before, edit);
    QVERIFY((pointOf(moved, 1).pose.center - pointOf(before, 1).pose.center - Vec3(0.1, 0.2, 0.3)).norm() <
            1e-15);
    QVERIFY((pointOf(moved, 2).pose.center - pointOf(before, 2).pose.center - Vec3(-0.1, 0.2, 0.3)).norm() <
            1e-15);
    QVERIFY(pointOf(moved, 3).pose == pointOf(before, 3).pose);
  }

  void pointsWithoutAPartnerAreTold() {
    Project before = symmetricProject();
    before = after(before, Remove{{1, {2}}});
    Move edit{{1, {1, 3}}, {Vec3(0.1, 0.2, 0.3)}, Follow::none, {}};
    QVERIFY(test::resultOf(before, edit).remarks.empty());
    edit.spread.mirror = {Axis::x};
    const EditResult result = test::resultOf(before, edit);
    QCOMPARE(result.remarks,
             std::vector<std::string>{"1 of 2 points has no mirror partner, so nothing moved across from it."});
  }

  void pointsOnThePlaneStayOnIt() {
    const Project before = symmetricProject();
    Move edit{{1, {3}}, {Vec3(0.1, 0.2, 0.3)}, Follow::none, {}};
    edit.spread.mirror = {Axis::x};
    const Project moved = after(before, edit);
    QVERIFY(pointOf(moved, 3).pose.center.x() == pointOf(before, 3).pose.center.x());
    Transform turn;
    turn.where = {1, {1, 3}};
    turn.rotationAxis = Vec3(1, 1, 0);
    turn.degrees = 50;
    turn.scale = Vec3(2, 1, 1.5);
    turn.pivot = Vec3(0.2, 0.1, 0);
    turn.spread.mirror = {Axis::x};
    const Project turned = after(before, turn);
    QVERIFY(std::abs(pointOf(turned, 3).pose.center.x()) < 1e-15);
    const AffineMap mirror = reflection(Axis::x, Vec3::Zero());
    const AffineMap map = pointOf(turned, 3).map();
    QVERIFY(difference(composed(mirror, composed(map, mirror)), map) < 1e-14);
  }

  void mirroredTransformIsTheMirrorImage() {
    const Project before = symmetricProject();
    Transform edit;
    edit.where = {1, {1}};
    edit.rotationAxis = Vec3(1, 2, -1);
    edit.degrees = 33;
    edit.scale = Vec3(1.3, 0.7, 1);
    edit.pivot = Vec3(0.3, -0.2, 0.4);
    edit.spread.mirror = {Axis::x};
    const Project moved = after(before, edit);
    const AffineMap mirror = reflection(Axis::x, Vec3::Zero());
    QVERIFY(difference(composed(mirror, composed(pointOf(moved, 1).map(), mirror)), pointOf(moved, 2).map()) <
            1e-14);
  }

  void partnersThatAreNamedOrLockedAreLeftAlone() {
    Project before = symmetricProject();
    Move edit{{1, {1, 2}}, {Vec3(0.1, 0, 0)}, Follow::none, {}};
    edit.spread.mirror = {Axis::x};
    const Project both = after(before, edit);
    QVERIFY((pointOf(both, 2).pose.center - pointOf(before, 2).pose.center - Vec3(0.1, 0, 0)).norm() < 1e-15);
    before = after(before, Lock{{1, {2}}, true});
    edit.where.points = {1};
    QVERIFY(pointOf(after(before, edit), 2).pose == pointOf(before, 2).pose);
  }

 private:
  /// Points 1 and 2 are partners across x = 0, point 3 lies on it, point 4 has no partner.
  static Project symmetricProject() {
    Project project = projectWith(4, 1);
    const std::array<Vec3, 4> centres{Vec3(0.5, 0.1, 0.2), Vec3(-0.52, 0.1, 0.2), Vec3(0.0, 0.5, 0),
                                      Vec3(0.9, 0, 0)};
    for (Index i = 0; i < 4; ++i) {
      ControlPoint point = project.controls.levels[0][i];
      point.rest = {centres[i], 0.4 * Mat3::Identity()};
      point.pose = point.rest;
      project.controls.levels[0].replace(i, point);
    }
    return project;
  }
};

const test::Registration<EditMirrorTest> registration;

}  // namespace pbffd

#include "edit_mirror_test.moc"
