#include "core/ffd/placement/interior_points.h"
#include "core/base/error.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace pbffd {
namespace {

SurfaceParts partsOf(Mesh mesh) {
  return {std::make_shared<const RestMesh>(std::move(mesh)), Surface::automatic};
}

std::vector<bool> flagsOfAll(const SurfaceParts& parts, const SurfaceSamples& sites,
                             const VoronoiVertices& vertices) {
  std::vector<Index> rows(static_cast<std::size_t>(vertices.size()));
  std::iota(rows.begin(), rows.end(), 0);
  return insideFlags(rows, parts, sites, vertices, {});
}

/// wrongPerMille: so many of the Voronoi vertices may differ.
void requireFlagsLikeTheWindingNumber(const SurfaceParts& parts, const SurfaceSamples& sites,
                                      int wrongPerMille = 1) {
  const VoronoiVertices vertices = voronoiVertices(sites.positions);
  const std::vector<bool> flags = flagsOfAll(parts, sites, vertices);
  int wrong = 0;
  for (Index v = 0; v < vertices.size(); ++v) {
    wrong += flags[static_cast<std::size_t>(v)] != parts.isInside(vertices.positions.row(v));
  }
  QVERIFY(vertices.size() > 100);
  QVERIFY2(1000 * wrong <= wrongPerMille * vertices.size(),
           qPrintable(QString("%1 of %2").arg(wrong).arg(vertices.size())));
}

void requireFlagsLikeTheWindingNumber(const SurfaceParts& parts) {
  requireFlagsLikeTheWindingNumber(parts, everyVertex(parts));
}

/// Without every n-th face.
Mesh withHoles(const Mesh& mesh, Index n) {
  Mesh holed;
  holed.positions = mesh.positions;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (f % n != 0) {
      holed.faces.add(mesh.faces[f]);
    }
  }
  return holed;
}

/// Moved a little and never twice the same, so that no Voronoi vertex lies in a wall.
Mesh roughened(Mesh mesh, double amount) {
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    mesh.positions.row(v) +=
        amount * Vec3(std::sin(12.9 * v), std::sin(7.3 * v), std::sin(4.1 * v)).transpose();
  }
  return mesh;
}

/// As equations.md has it, from all that is inside.
double sliverLimit(const SurfaceParts& parts, const SurfaceSamples& sites, const VoronoiVertices& vertices,
                   const std::vector<bool>& isInside, Index part) {
  std::vector<double> radii;
  double total = 0.0;
  for (Index v = 0; v < vertices.size(); ++v) {
    if (isInside[static_cast<std::size_t>(v)] && sites.parts[vertices.sites(v)[0]] == part) {
      radii.push_back(vertices.radii[v] / parts.mesh().diagonal());
      total += std::pow(radii.back(), 3);
    }
  }
  std::sort(radii.begin(), radii.end());
  double below = 0.0;
  double usual = 0.0;
  for (std::size_t i = 0; i < radii.size() && below < 0.5 * total; ++i) {
    usual = radii[i];
    below += std::pow(usual, 3);
  }
  return parts.mesh().diagonal() * std::min(0.01, 0.5 * usual);
}

}  // namespace

class InteriorPointsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void votesAgreeWithTheWindingNumber() {
    requireFlagsLikeTheWindingNumber(partsOf(test::fork()));
    requireFlagsLikeTheWindingNumber(partsOf(test::cylinder()));
    // Shells within each other, where votes would go wrong and none are taken.
    requireFlagsLikeTheWindingNumber(partsOf(
        test::merged(test::sphere(20, 40), test::placedAt(test::sphere(20, 40), 0.9, Vec3(0.05, 0, 0)))));
    // A mesh that runs through itself.
    requireFlagsLikeTheWindingNumber(
        partsOf(test::merged(test::cylinder(), test::placedAt(test::cylinder(), 1.0, Vec3(0.5, 0.2, 0.1)))));
  }

  void votesAgreeOnAThinSheet() {
    Mesh plate = test::triangulated(test::cube());
    plate.positions.col(2) *= 0.004;
    const SurfaceParts parts = partsOf(plate);
    const SurfaceSamples sites = withFaceSamples(parts, everyVertex(parts), 6000, 0);
    requireFlagsLikeTheWindingNumber(parts, sites);
  }

  /// Two surfaces: no votes are taken there.
  void flagsAgreeInAShell() {
    const Mesh inner = test::placedAt(test::sphere(30, 60), 0.97, Vec3::Zero());
    Mesh hollow;
    hollow.positions = inner.positions;
    for (Index f = 0; f < inner.faces.size(); ++f) {
      hollow.faces.add(std::vector<Index>(inner.faces[f].rbegin(), inner.faces[f].rend()));
    }
    requireFlagsLikeTheWindingNumber(partsOf(roughened(test::merged(test::sphere(30, 60), hollow), 1e-3)));
  }

  void votesAgreeMostlyWhereThereAreHoles() {
    for (const Mesh& mesh : {test::fork(), test::sphere(30, 60)}) {
      const SurfaceParts parts(std::make_shared<const RestMesh>(withHoles(roughened(mesh, 1e-3), 10)),
                               Surface::closed);
      requireFlagsLikeTheWindingNumber(parts, everyVertex(parts), 30);
    }
  }

  void pointsLieAlongTheAxisOfACylinder() {
    const SurfaceParts parts = partsOf(test::cylinder());
    const PointPool pool = voronoiPointsInside(parts, everyVertex(parts), {});
    QVERIFY(pool.size() > 20);
    std::set<int> stretches;
    for (Index i = 0; i < pool.size(); ++i) {
      const Vec3 at = pool.points.row(i);
      QVERIFY(parts.isInside(at));
      if (std::hypot(at.y(), at.z()) < 0.01) {
        stretches.insert(static_cast<int>(4.0 * at.x()));
      }
    }
    // In every quarter between the caps.
    for (int stretch = 2; stretch < 14; ++stretch) {
      QVERIFY(stretches.contains(stretch));
    }
  }

  void sliversStayOutWhereThereIsVolume() {
    Mesh mesh = test::sphere(60, 120);
    // Roughness makes slivers beside the surface.
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
      mesh.positions.row(v) *= 1.0 + 0.004 * std::sin(12.9898 * v);
    }
    const SurfaceParts parts = partsOf(mesh);
    const SurfaceSamples sites = everyVertex(parts);
    const VoronoiVertices vertices = voronoiVertices(sites.positions);
    const std::vector<bool> flags = flagsOfAll(parts, sites, vertices);
    const PointPool pool = voronoiPointsInside(parts, sites, {});
    QVERIFY(pool.size() < std::count(flags.begin(), flags.end(), true));
    for (Index i = 0; i < pool.size(); ++i) {
      QVERIFY(parts.mesh().nearestVertex().nearest(pool.points.row(i)).distance >=
              0.01 * parts.mesh().diagonal());
    }
  }

  void thoseKeptAreInsideAndNoSlivers() {
    // Where balls are large and where they are small, most of them less than 1 % of the diagonal.
    const Mesh thin = test::cylinder(4.0, 0.02, 200, 24);
    for (const Mesh& mesh :
         {test::fork(), thin, test::merged(test::placedAt(test::sphere(), 1.0, Vec3(9, 0, 0)), thin)}) {
      const SurfaceParts parts = partsOf(roughened(mesh, 1e-4));
      const SurfaceSamples sites = everyVertex(parts);
      const VoronoiVertices vertices = voronoiVertices(sites.positions);
      const std::vector<bool> flags = flagsOfAll(parts, sites, vertices);
      std::vector<double> limits;
      for (Index part = 0; part < parts.count(); ++part) {
        limits.push_back(sliverLimit(parts, sites, vertices, flags, part));
      }
      Index kept = 0;
      const PointPool pool = voronoiPointsInside(parts, sites, {});
      for (Index v = 0; v < vertices.size(); ++v) {
        const Index part = sites.parts[vertices.sites(v)[0]];
        if (flags[static_cast<std::size_t>(v)] && vertices.radii[v] >= limits[part]) {
          QVERIFY2(
              kept < pool.size() && pool.points.row(kept) == vertices.positions.row(v),
              qPrintable(
                  QString("vertex %1 of %2, radius %3").arg(v).arg(vertices.size()).arg(vertices.radii[v])));
          QCOMPARE(pool.parts[kept], part);
          ++kept;
        }
      }
      QVERIFY(kept > 0);
      QCOMPARE(pool.size(), kept);
    }
  }

  void thinPlateKeepsItsMiddle() {
    Mesh plate = test::triangulated(test::cube());
    plate.positions.col(2) *= 0.004;
    const SurfaceParts parts = partsOf(plate);
    const SurfaceSamples sites = withFaceSamples(parts, everyVertex(parts), 8000, 0);
    QVERIFY(voronoiPointsInside(parts, sites, {}).size() > 100);
  }

  void sitesInAPlaneOrTooFewGiveNone() {
    const SurfaceParts flat = partsOf(test::sheet(5));
    QCOMPARE(voronoiPointsInside(flat, everyVertex(flat), {}).size(), 0);
    QCOMPARE(voronoiPointsInside(flat, SurfaceSamples(), {}).size(), 0);
  }

  void cancelStopsIt() {
    const Progress progress([](std::string_view, double) {});
    progress.cancel();
    const SurfaceParts parts = partsOf(test::sphere());
    QVERIFY_EXCEPTION_THROWN(voronoiPointsInside(parts, everyVertex(parts), progress), Cancelled);
  }
};

const test::Registration<InteriorPointsTest> registration;

}  // namespace pbffd

#include "interior_points_test.moc"
