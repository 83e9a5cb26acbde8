#include "core/ffd/placement/placement.h"
#include "core/ffd/placement/surface_parts.h"
#include "tests/core/ffd/placement/placed.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <set>
#include <string>

namespace pbffd {
namespace {

using test::gapsOf;
using test::place;
using test::rest;
using test::stretched;
using test::withPoints;

Mesh turnedInsideOut(const Mesh& mesh) {
  Mesh turned;
  turned.positions = mesh.positions;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const std::vector<Index> face(mesh.faces[f].rbegin(), mesh.faces[f].rend());
    turned.faces.add(face);
  }
  return turned;
}

}  // namespace

class PlacementSurfacesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void insideOutMeshIsTakenTheRightWay() {
    const PlacementResult right = place(test::cylinder(), withPoints(100));
    const auto turned = rest(turnedInsideOut(test::cylinder()));
    const PlacementResult result = placeControlPoints(turned, withPoints(100));
    const SurfaceParts parts(rest(test::cylinder()), Surface::automatic);
    for (const ControlPoint& point : result.finest) {
      QCOMPARE(parts.isInside(point.rest.center), point.kind == PointKind::interior);
    }
    QCOMPARE(result.finest.size(), right.finest.size());
  }

  void hollowStaysEmpty() {
    // A ball with a hollow: the inner shell looks inward.
    const Mesh hollow =
        test::merged(test::sphere(), turnedInsideOut(test::placedAt(test::sphere(), 0.6, Vec3::Zero())));
    int interior = 0;
    for (const ControlPoint& point : place(hollow, withPoints(200)).finest) {
      if (point.kind == PointKind::interior) {
        ++interior;
        QVERIFY(point.rest.center.norm() > 0.59);
      }
    }
    QCOMPARE(interior, 100);
  }

  void openSheetGetsPointsOnBothSides() {
    const PlacementResult result = place(test::sheet(10), withPoints(60));
    QCOMPARE(result.finest.size(), Index(60));
    QVERIFY(!result.asClosed);
    QVERIFY(result.remarks.at(0).find("open") != std::string::npos);
    int above = 0;
    for (const ControlPoint& point : result.finest) {
      QCOMPARE(point.kind, PointKind::exterior);
      above += point.rest.center.z() > 0.0;
    }
    QVERIFY(above > 15 && above < 45);
    QCOMPARE(gapsOf(*rest(test::sheet(10)), result.finest).uncovered, 0);
  }

  void surfaceOverridesWhatTheMeshIs() {
    PlacementOptions options = withPoints(60);
    options.surface = Surface::open;
    const PlacementResult open = place(test::cylinder(), options);
    QVERIFY(!open.asClosed);
    QVERIFY(open.remarks.at(0).find("as asked") != std::string::npos);
    options.surface = Surface::closed;
    QVERIFY(place(test::cylinder(), options).asClosed);
    // A sheet has no inside; all points go outside, and the result says so.
    const PlacementResult sheet = place(test::sheet(10), options);
    QCOMPARE(sheet.finest.size(), Index(60));
    QVERIFY(sheet.remarks.size() >= 2);
  }

  void everyPartGetsPoints() {
    Mesh mesh = test::sphere();
    for (int i = 1; i < 6; ++i) {
      mesh = test::merged(mesh, test::placedAt(test::cube(), 0.1, Vec3(2.0 * i, 0, 0)));
    }
    mesh = test::merged(mesh, test::placedAt(test::sheet(4), 0.3, Vec3(0, 5, 0)));
    const PlacementResult result = place(mesh, withPoints(100));
    QCOMPARE(result.finest.size(), Index(100));
    QVERIFY(result.asClosed);
    for (int i = 0; i < 7; ++i) {
      const Vec3 center = i < 6 ? Vec3(2.0 * i, 0, 0) : Vec3(0, 5, 0);
      const auto isNear = [&](const ControlPoint& point) { return (point.rest.center - center).norm() < 1.9; };
      QVERIFY(std::any_of(result.finest.begin(), result.finest.end(), isNear));
    }
    QVERIFY(result.remarks.at(0).find("6 are closed") != std::string::npos);
    QVERIFY(result.remarks.at(0).find("1 is open") != std::string::npos);
  }

  void morePartsThanPointsShareThem() {
    Mesh mesh = test::cube();
    for (int i = 1; i < 30; ++i) {
      mesh = test::merged(mesh, test::placedAt(test::cube(), 1.0, Vec3(3.0 * i, 0, 0)));
    }
    const PlacementResult result = place(mesh, withPoints(10));
    QCOMPARE(result.finest.size(), Index(10));
    QVERIFY(result.remarks.back().find("30 separate parts") != std::string::npos);
    QCOMPARE(gapsOf(*rest(mesh), result.finest).uncovered, 0);
  }

  void verticesWithoutFacesDoNotMatter() {
    Mesh mesh = test::cylinder();
    PlacementOptions options = withPoints(60);
    options.masterMode = MasterMode::paper;
    const PlacementResult without = place(mesh, options);
    mesh.positions.conservativeResize(mesh.positions.rows() + 1, 3);
    mesh.positions.bottomRows(1) << 1e6, 1e6, 1e6;
    const PlacementResult with = place(mesh, options);
    QVERIFY(with.finest == without.finest);
    QVERIFY(with.master.rest == without.master.rest);
  }

  void shellsInTheSamePlaceShareNoPoint() {
    const PlacementResult result = place(test::merged(test::fork(), test::fork()), withPoints(100));
    QCOMPARE(result.finest.size(), Index(100));
    std::set<std::array<double, 3>> places;
    for (const ControlPoint& point : result.finest) {
      places.insert({point.rest.center.x(), point.rest.center.y(), point.rest.center.z()});
      QVERIFY(point.rest.axes.col(0).norm() < 3.0);
    }
    QCOMPARE(places.size(), std::size_t{100});
  }

  void manySmallPartsGetAPointInsideEach() {
    Mesh mesh = test::placedAt(test::sheet(20), 10.0, Vec3(0, 0, -1));
    for (int i = 0; i < 30; ++i) {
      mesh = test::merged(mesh, test::placedAt(test::cube(), 0.2, Vec3(i % 6 - 2.5, i / 6 - 2.0, 0.0)));
    }
    const PlacementResult result = place(mesh, withPoints(80));
    QCOMPARE(result.finest.size(), Index(80));
    for (int i = 0; i < 30; ++i) {
      const Vec3 center(i % 6 - 2.5, i / 6 - 2.0, 0.0);
      const auto isInCube = [&](const ControlPoint& point) {
        return (point.rest.center - center).cwiseAbs().maxCoeff() < 0.1;
      };
      QVERIFY(std::any_of(result.finest.begin(), result.finest.end(), isInCube));
    }
  }

  void facesThatDisagreeAreNamed() {
    Mesh mesh;
    mesh.positions = test::cylinder().positions;
    const Mesh cylinder = test::cylinder();
    for (Index f = 0; f < cylinder.faces.size(); ++f) {
      std::vector<Index> face(cylinder.faces[f].begin(), cylinder.faces[f].end());
      if (f % 2 == 0) {
        std::reverse(face.begin(), face.end());
      }
      mesh.faces.add(face);
    }
    const PlacementResult result = place(mesh, withPoints(60));
    QCOMPARE(result.finest.size(), Index(60));
    QVERIFY(!result.asClosed);
    QVERIFY(result.remarks.at(1).find("do not agree on which side is out") != std::string::npos);
    QCOMPARE(gapsOf(*rest(mesh), result.finest).uncovered, 0);
  }

  void tooLittleRoomInsideIsSaid() {
    Mesh mesh = test::placedAt(test::cube(), 0.01, Vec3::Zero());
    for (int i = 1; i < 40; ++i) {
      mesh = test::merged(mesh, test::placedAt(test::cube(), 0.01, Vec3(i, 0.3 * i, 0)));
    }
    const PlacementResult result = place(mesh, withPoints(5000));
    int inside = 0;
    for (const ControlPoint& point : result.finest) {
      inside += point.kind == PointKind::interior;
    }
    const bool isSaid =
        std::any_of(result.remarks.begin(), result.remarks.end(),
                    [](const std::string& remark) { return remark.find("room inside") != std::string::npos; });
    QCOMPARE(isSaid, inside < 2500);
  }

  void closedMeshWithoutVolumeGetsPointsOutside() {
    const Mesh flat = stretched(test::cube(), Vec3(1, 1, 0));
    const PlacementResult result = place(flat, withPoints(40));
    QCOMPARE(result.finest.size(), Index(40));
    QCOMPARE(gapsOf(*rest(flat), result.finest).uncovered, 0);
  }
};

const test::Registration<PlacementSurfacesTest> registration;

}  // namespace pbffd

#include "placement_surfaces_test.moc"
