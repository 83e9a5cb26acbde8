#include "core/ffd/placement/surface_samples.h"
#include "core/mesh/nearest.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

namespace pbffd {
namespace {

SurfaceParts partsOf(Mesh mesh) {
  return {std::make_shared<const RestMesh>(std::move(mesh)), Surface::automatic};
}

/// The least distance of two samples.
double leastDistance(const SurfaceSamples& samples) {
  const NearestPoints nearest(samples.positions);
  double least = 1e300;
  for (Index i = 0; i < samples.size(); ++i) {
    least = std::min(least, nearest.nearest(samples.positions.row(i).transpose(), 2).back().distance);
  }
  return least;
}

}  // namespace

class SurfaceSamplesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyVertexOfAFaceIsTaken() {
    Mesh mesh = test::cube();
    mesh.positions.conservativeResize(9, 3);
    mesh.positions.row(8) = Vec3(7, 7, 7);
    const SurfaceSamples samples = everyVertex(partsOf(mesh));
    QCOMPARE(samples.size(), 8);
    QCOMPARE(samples.positions.rows(), Eigen::Index(8));
    for (Index i = 0; i < 8; ++i) {
      QVERIFY(samples.normals.row(i).dot(samples.positions.row(i)) > 0.0);
    }
  }

  void asManyAreTakenAsAskedFor() {
    const SurfaceParts parts = partsOf(test::sphere(60, 120));
    for (const Index count : {1, 10, 500, 3000}) {
      QCOMPARE(spacedVertices(parts, count, 0).size(), count);
    }
    QCOMPARE(spacedVertices(parts, 100000, 0).size(), parts.mesh().vertexCount());
  }

  void samplesAreVerticesAndStandApart() {
    const SurfaceParts parts = partsOf(test::sphere(60, 120));
    const SurfaceSamples samples = spacedVertices(parts, 400, 0);
    for (Index i = 0; i < samples.size(); ++i) {
      QCOMPARE(parts.mesh().nearestVertex().nearest(samples.positions.row(i)).distance, 0.0);
    }
    // 400 discs on a sphere of area 4 pi have room for a distance of 0.19 at best.
    QVERIFY(leastDistance(samples) > 0.07);
  }

  void sharpEdgesGetMore() {
    // A cylinder bends at its rims and around, its caps and its length are straight.
    const SurfaceParts parts = partsOf(test::cylinder(4.0, 0.5, 200, 96));
    const SurfaceSamples samples = spacedVertices(parts, 800, 0);
    int atRims = 0;
    for (Index i = 0; i < samples.size(); ++i) {
      const double x = samples.positions(i, 0);
      atRims += x < 0.1 || x > 3.9;
    }
    QVERIFY(atRims > 800 / 20 * 1.5);
  }

  void bothSidesOfAThinWallAreSampled() {
    Mesh plate = test::cube();
    plate.positions.col(2) *= 0.001;
    const SurfaceParts parts = partsOf(plate);
    const SurfaceSamples samples = withFaceSamples(parts, everyVertex(parts), 400, 0);
    int above = 0;
    int below = 0;
    for (Index i = 0; i < samples.size(); ++i) {
      above += samples.normals(i, 2) > 0.9;
      below += samples.normals(i, 2) < -0.9;
    }
    QVERIFY(above > 100 && below > 100);
  }

  void facesOfFewVerticesAreSampled() {
    const SurfaceParts parts = partsOf(test::cube());
    const SurfaceSamples samples = withFaceSamples(parts, everyVertex(parts), 300, 0);
    QVERIFY(samples.size() > 200 && samples.size() <= 300);
    QVERIFY(samples.positions.topRows(8) == parts.mesh().positions());
    for (Index i = 8; i < samples.size(); ++i) {
      QVERIFY(std::abs(samples.positions.row(i).cwiseAbs().maxCoeff() - 0.5) < 1e-12);
      QVERIFY(samples.normals.row(i).dot(samples.positions.row(i)) > 0.0);
    }
    QVERIFY(leastDistance(samples) > 0.05);
    QCOMPARE(withFaceSamples(parts, samples, 10, 0).size(), samples.size());
  }

  void everyPartIsSampledAndTold() {
    const SurfaceParts parts =
        partsOf(test::merged(test::sphere(60, 120), test::placedAt(test::sphere(8, 16), 0.01, Vec3(3, 0, 0))));
    const SurfaceSamples samples = spacedVertices(parts, 100, 0);
    QVERIFY(std::count(samples.parts.begin(), samples.parts.end(), 1) > 0);
    QCOMPARE(samplesOf(parts, samples, true).size(), 100);
    QCOMPARE(samplesOf(parts, samples, false).size(), 0);
  }

  void seedChoosesAndNothingElse() {
    const SurfaceParts parts = partsOf(test::sphere(60, 120));
    const SurfaceSamples samples = spacedVertices(parts, 300, 5);
    QVERIFY(samples.positions == spacedVertices(parts, 300, 5).positions);
    QVERIFY(samples.positions != spacedVertices(parts, 300, 6).positions);
  }
};

const test::Registration<SurfaceSamplesTest> registration;

}  // namespace pbffd

#include "surface_samples_test.moc"
