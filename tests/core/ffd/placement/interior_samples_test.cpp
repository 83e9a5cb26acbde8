#include "core/ffd/placement/interior_samples.h"
#include "core/base/error.h"
#include "core/ffd/placement/interior_points.h"
#include "tests/core/ffd/placement/placed.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <cmath>
#include <set>

namespace pbffd {
namespace {

SurfaceParts partsOf(Mesh mesh) {
  return {std::make_shared<const RestMesh>(std::move(mesh)), Surface::automatic};
}

PointPool medialPoints(const SurfaceParts& parts) {
  return voronoiPointsInside(parts, everyVertex(parts), {});
}

void requireInside(const PointPool& pool, const SurfaceParts& parts) {
  for (Index i = 0; i < pool.size(); ++i) {
    QVERIFY(parts.isInside(pool.points.row(i)));
  }
}

}  // namespace

class InteriorSamplesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void sphereIsFilledWithSpreadPoints() {
    // The larger one has ten times as many places in its centre; they are one all the same.
    for (const int rings : {16, 50}) {
      const SurfaceParts parts = partsOf(test::sphere(rings, 2 * rings));
      const PointPool pool = withInteriorSamples(medialPoints(parts), 100, parts, 0, {});
      QVERIFY(pool.size() >= 100);
      QVERIFY(test::leastDistance(pool.points) > 0.06);
      requireInside(pool, parts);
    }
  }

  void axisStaysAndGetsPointsBesideIt() {
    const SurfaceParts parts = partsOf(test::cylinder());
    const PointPool pool = withInteriorSamples(medialPoints(parts), 100, parts, 0, {});
    std::set<int> stretches;
    int beside = 0;
    for (Index i = 0; i < pool.size(); ++i) {
      const Vec3 at = pool.points.row(i);
      const bool isOnAxis = std::hypot(at.y(), at.z()) < 0.01;
      beside += std::hypot(at.y(), at.z()) > 0.1 && at.x() > 1.0 && at.x() < 3.0;
      if (isOnAxis) {
        stretches.insert(static_cast<int>(4.0 * at.x()));
      }
    }
    for (int stretch = 2; stretch < 14; ++stretch) {
      QVERIFY(stretches.contains(stretch));
    }
    QVERIFY(beside > 20);
    requireInside(pool, parts);
  }

  void richAxisNeedsNoSamples() {
    const SurfaceParts parts = partsOf(test::fork());
    const PointPool axis = medialPoints(parts);
    const PointPool pool = withInteriorSamples(axis, 5, parts, 0, {});
    // A choice of places, each one of the axis, in their order.
    QVERIFY(pool.size() > 15 && pool.size() < axis.size());
    Index at = 0;
    for (Index i = 0; i < pool.size(); ++i) {
      while (at < axis.size() && axis.points.row(at) != pool.points.row(i)) {
        ++at;
      }
      QVERIFY(at < axis.size());
    }
    QCOMPARE(withInteriorSamples(axis, 0, parts, 0, {}).size(), axis.size());
  }

  void partsAreToldApartHoweverNear() {
    Mesh mesh = test::sphere(40, 80);
    for (int i = 0; i < 10; ++i) {
      mesh = test::merged(mesh, test::placedAt(test::cube(), 1e-3, Vec3(3, 2e-3 * i, 0)));
    }
    const SurfaceParts parts = partsOf(mesh);
    const SurfaceSamples sites = withFaceSamples(parts, everyVertex(parts), 6000, 0);
    PointPool pool = voronoiPointsInside(parts, sites, {});
    for (Index part = 1; part <= 10; ++part) {
      pool.append(Vec3(3, 2e-3 * (part - 1), 0), part);
    }
    pool.shrink();
    const PointPool filled = withInteriorSamples(pool, 50, parts, 0, {});
    QCOMPARE(std::set<Index>(filled.parts.begin(), filled.parts.end()).size(), std::size_t(11));
  }

  void volumeThatNoGridMeetsKeepsItsPlaces() {
    // Two specks far apart: a grid over both has no point in either.
    const Mesh speck = test::placedAt(test::sphere(8, 16), 1e-6, Vec3::Zero());
    const SurfaceParts parts = partsOf(test::merged(speck, test::placedAt(speck, 1.0, Vec3(9, 8, 7))));
    PointPool pool;
    for (int i = 0; i < 40; ++i) {
      pool.append(Vec3(1e-8 * i, 0, 0), 0);
    }
    pool.shrink();
    const PointPool filled = withInteriorSamples(pool, 30, parts, 0, {});
    QVERIFY(filled.size() >= 30);
    requireInside(filled, parts);
  }

  void cancelStopsIt() {
    const Progress progress([](std::string_view, double) {});
    progress.cancel();
    QVERIFY_EXCEPTION_THROWN(withInteriorSamples({}, 100, partsOf(test::sphere()), 0, progress), Cancelled);
  }
};

const test::Registration<InteriorSamplesTest> registration;

}  // namespace pbffd

#include "interior_samples_test.moc"
