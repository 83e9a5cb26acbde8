#include "core/mesh/coarse_mesh.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <QElapsedTimer>
#include <QtTest>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <set>
#include <thread>

namespace pbffd {
namespace {

/// How many edges are not between two triangles.
Index edgesNotOfTwo(const std::vector<Index>& triangles) {
  std::map<std::pair<Index, Index>, int> edges;
  for (std::size_t c = 0; c < triangles.size(); c += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++edges[std::minmax(triangles[c + k], triangles[c + (k + 1) % 3])];
    }
  }
  return static_cast<Index>(
      std::count_if(edges.begin(), edges.end(), [](const auto& edge) { return edge.second != 2; }));
}

double volumeOf(const RestMesh& mesh, const CoarseMesh& coarse) {
  double volume = 0.0;
  const auto at = [&](std::size_t c) -> Vec3 {
    return mesh.positions().row(coarse.vertices[coarse.triangles[c]]);
  };
  for (std::size_t c = 0; c < coarse.triangles.size(); c += 3) {
    volume += at(c).dot(at(c + 1).cross(at(c + 2))) / 6.0;
  }
  return volume;
}

/// The largest distance of a vertex of the mesh from the nearest of the stand-in.
double farthest(const RestMesh& mesh, const CoarseMesh& coarse) {
  double worst = 0.0;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    double least = 1e300;
    for (const Index other : coarse.vertices) {
      least = std::min(least, (mesh.positions().row(v) - mesh.positions().row(other)).norm());
    }
    worst = std::max(worst, least);
  }
  return worst;
}

Index trianglesOf(const CoarseMesh& coarse) {
  return static_cast<Index>(coarse.triangles.size() / 3);
}

}  // namespace

class CoarseMeshTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void thereAreAboutAsManyTrianglesAsAllowed_data() {
    QTest::addColumn<Index>("most");
    for (const Index most : {300, 1000, 3000, 8000}) {
      QTest::newRow(QByteArray::number(most)) << most;
    }
  }

  void thereAreAboutAsManyTrianglesAsAllowed() {
    QFETCH(Index, most);
    for (const Mesh& shape : {test::sphere(80, 161), test::fork(0.1, 120, 61), test::sheet(100)}) {
      const RestMesh mesh(shape);
      const CoarseMesh coarse = coarseMesh(mesh, most);
      QVERIFY(trianglesOf(coarse) <= most);
      QVERIFY2(trianglesOf(coarse) > most / 2, QByteArray::number(trianglesOf(coarse)).constData());
    }
  }

  void verticesAreSomeOfTheMeshsOwn() {
    const RestMesh mesh(test::sphere(80, 161));
    const CoarseMesh coarse = coarseMesh(mesh, 1000);
    QVERIFY(std::is_sorted(coarse.vertices.begin(), coarse.vertices.end()));
    const std::set<Index> own(coarse.vertices.begin(), coarse.vertices.end());
    QCOMPARE(own.size(), coarse.vertices.size());
    QVERIFY(*own.begin() >= 0 && *own.rbegin() < mesh.vertexCount());
    const std::set<Index> used(coarse.triangles.begin(), coarse.triangles.end());
    QCOMPARE(used.size(), coarse.vertices.size());
    QCOMPARE(*used.rbegin(), static_cast<Index>(coarse.vertices.size()) - 1);
  }

  void shapeStays() {
    const RestMesh mesh(test::sphere(80, 161));
    const CoarseMesh coarse = coarseMesh(mesh, 3000);
    const double share = volumeOf(mesh, coarse) / (4.0 / 3.0 * M_PI);
    QVERIFY2(share > 0.98 && share < 1.0, QByteArray::number(share).constData());
    QVERIFY(farthest(mesh, coarse) < 0.2);
    QCOMPARE(edgesNotOfTwo(coarse.triangles), 0);
  }

  void edgesAndCornersOfABoxStay() {
    // A cube with a fine grid on each side, as a box of points; its corners are vertices.
    const RestMesh mesh(boxOfSheets(40));
    const CoarseMesh coarse = coarseMesh(mesh, 1500);
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 at((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
      const bool isKept = std::any_of(coarse.vertices.begin(), coarse.vertices.end(),
                                      [&](Index v) { return mesh.positions().row(v).transpose() == at; });
      QVERIFY2(isKept, QByteArray::number(corner).constData());
    }
    QVERIFY(std::abs(volumeOf(mesh, coarse) - 8.0) < 1e-3);
  }

  void trianglesFaceAsTheirVerticesDo() {
    // Waves a little longer than the cells: some clusters and the vertices that stand for them lie in another
    // order.
    Mesh rough = test::sphere(200, 401);
    for (Index v = 0; v < rough.vertexCount(); ++v) {
      const Vec3 at = rough.positions.row(v);
      rough.positions.row(v) *= 1.0 + 0.02 * std::sin(40.0 * at.x()) * std::sin(37.0 * at.y() + 29.0 * at.z());
    }
    const RestMesh mesh(rough);
    const CoarseMesh coarse = coarseMesh(mesh, 8000);
    const auto vertex = [&](std::size_t c) { return coarse.vertices[coarse.triangles[c]]; };
    const auto at = [&](std::size_t c) -> Vec3 { return mesh.positions().row(vertex(c)); };
    for (std::size_t c = 0; c < coarse.triangles.size(); c += 3) {
      const Vec3 across = (at(c + 1) - at(c)).cross(at(c + 2) - at(c));
      Vec3 normals = Vec3::Zero();
      for (std::size_t k = 0; k < 3; ++k) {
        normals += mesh.normals().row(vertex(c + k));
      }
      QVERIFY(across.dot(normals) >= 0.0);
    }
    QVERIFY(std::abs(volumeOf(mesh, coarse) / (4.0 / 3.0 * M_PI) - 1.0) < 0.03);
  }

  void nearSurfacesDoNotMerge() {
    // Two spheres, one just inside the other: cells hold vertices of both.
    const Mesh outer = test::sphere(80, 161);
    const RestMesh mesh(test::merged(outer, test::placedAt(outer, 0.995, Vec3::Zero())));
    const CoarseMesh coarse = coarseMesh(mesh, 3000);
    const Index half = outer.vertexCount();
    for (std::size_t c = 0; c < coarse.triangles.size(); c += 3) {
      const bool isOuter = coarse.vertices[coarse.triangles[c]] < half;
      QVERIFY((coarse.vertices[coarse.triangles[c + 1]] < half) == isOuter);
      QVERIFY((coarse.vertices[coarse.triangles[c + 2]] < half) == isOuter);
    }
    const double share = volumeOf(mesh, coarse) / (4.0 / 3.0 * M_PI * (1.0 + std::pow(0.995, 3)));
    QVERIFY2(share > 0.95 && share < 1.0, QByteArray::number(share).constData());
  }

  void verticesAtOnePlaceAreClusteredAsOne() {
    // Every triangle has vertices of its own, as in an STL file.
    const Mesh whole = test::triangulated(test::sphere(80, 161));
    Mesh soup;
    soup.positions.resize(3 * whole.faces.size(), 3);
    for (Index f = 0; f < whole.faces.size(); ++f) {
      for (Index k = 0; k < 3; ++k) {
        soup.positions.row(3 * f + k) = whole.positions.row(whole.faces[f][k]);
      }
      soup.faces.add(std::vector<Index>{3 * f, 3 * f + 1, 3 * f + 2});
    }
    const RestMesh mesh(soup);
    const CoarseMesh coarse = coarseMesh(mesh, 3000);
    QVERIFY(trianglesOf(coarse) > 1500);
    QCOMPARE(edgesNotOfTwo(coarse.triangles), 0);
  }

  void farFromTheOriginTheSameVerticesStay() {
    const Mesh sphere = test::sphere(40, 81);
    const RestMesh near(sphere);
    const RestMesh far(test::placedAt(sphere, 1.0, Vec3(1 << 20, -(1 << 21), 1 << 19)));
    const double share = static_cast<double>(coarseMesh(far, 1000).vertices.size()) /
                         static_cast<double>(coarseMesh(near, 1000).vertices.size());
    QVERIFY(share > 0.8 && share < 1.25);
    QCOMPARE(edgesNotOfTwo(coarseMesh(far, 1000).triangles), 0);
  }

  void smallMeshesStayWhole() {
    const RestMesh mesh(test::cube());
    const CoarseMesh coarse = coarseMesh(mesh, 12);
    QCOMPARE(coarse.vertices.size(), std::size_t(8));
    QVERIFY(std::ranges::equal(coarse.triangles, mesh.triangles().vertices()));
  }

  void tinyPartsAreJoined() {
    // 5,000 grains of eight triangles over a sphere: within a cell of the grid none hangs together with another.
    const Mesh grain = test::triangulated(test::placedAt(test::sphere(2, 4), 0.012, Vec3::Zero()));
    const Mesh ball = test::sphere(50, 100);
    const RestMesh mesh(scattered(grain, ball.positions));
    const Index most = mesh.triangles().size() / 10;
    const CoarseMesh coarse = coarseMesh(mesh, most);
    QVERIFY(trianglesOf(coarse) <= most);
    QVERIFY2(trianglesOf(coarse) > most / 2, QByteArray::number(trianglesOf(coarse)).constData());
    QVERIFY2(farthest(mesh, coarse) < 0.25, QByteArray::number(farthest(mesh, coarse)).constData());
  }

  void leavesOfATreeDoNotVanish() {
    const Mesh trunk = test::triangulated(test::cylinder(4.0, 0.1, 100, 40));
    const Mesh leaf = test::triangulated(test::placedAt(test::sheet(2), 0.02, Vec3::Zero()));
    const Mesh crown = scattered(leaf, test::placedAt(test::sphere(40, 80), 1.0, Vec3(4, 0, 0)).positions);
    const RestMesh mesh(test::merged(trunk, crown));
    const CoarseMesh coarse = coarseMesh(mesh, 4000);
    const auto ofCrown = std::count_if(coarse.vertices.begin(), coarse.vertices.end(),
                                       [&](Index v) { return v >= trunk.vertexCount(); });
    QVERIFY(2 * ofCrown > static_cast<std::ptrdiff_t>(coarse.vertices.size()));
    QVERIFY(farthest(mesh, coarse) < 0.4);
  }

  void meshesWithoutAreaAreTakenToo() {
    QVERIFY(coarseMesh(RestMesh(Mesh()), 100).triangles.empty());
    Mesh point = test::triangulated(test::sphere(10, 20));
    point.positions.setOnes();
    QVERIFY(coarseMesh(RestMesh(point), 10).triangles.empty());
    Mesh line = test::sheet(20);
    line.positions.rightCols<2>().setZero();
    QVERIFY(trianglesOf(coarseMesh(RestMesh(line), 10)) <= 10);
  }

  void bitsDoNotDependOnThreads() {
    const RestMesh mesh(test::fork(0.1, 60, 31));
    const CoarseMesh many = coarseMesh(mesh, 1000);
    const ThreadLimit one(1);
    const CoarseMesh alone = coarseMesh(mesh, 1000);
    QVERIFY(alone.vertices == many.vertices && alone.triangles == many.triangles);
  }

  void cancelThrows() {
    const RestMesh mesh(test::sphere());
    const Progress progress([](std::string_view, double) {});
    progress.cancel();
    QVERIFY_EXCEPTION_THROWN(coarseMesh(mesh, 100, progress), Cancelled);
  }

  void cancelIsNoticedSoon() {
    const RestMesh mesh(test::sphere(700, 701));  // about a million triangles
    mesh.triangles();
    mesh.normals();
    mesh.graph();
    for (const int wait : {1, 10, 30, 60, 100, 150}) {
      const Progress progress([](std::string_view, double) {});
      std::thread other([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(wait));
        progress.cancel();
      });
      QElapsedTimer timer;
      timer.start();
      try {
        coarseMesh(mesh, 50000, progress);
      } catch (const Cancelled&) {
      }
      const auto spent = timer.elapsed();
      other.join();
      QVERIFY2(spent < wait + 200, QByteArray::number(spent).constData());
    }
  }

 private:
  /// A copy of the shape at each of the places.
  static Mesh scattered(const Mesh& shape, const Points& places) {
    Mesh all;
    all.positions.resize(shape.vertexCount() * places.rows(), 3);
    for (Index place = 0; place < places.rows(); ++place) {
      const Index first = place * shape.vertexCount();
      all.positions.middleRows(first, shape.vertexCount()) = shape.positions.rowwise() + places.row(place);
      for (Index f = 0; f < shape.faces.size(); ++f) {
        std::vector<Index> corners(shape.faces[f].begin(), shape.faces[f].end());
        for (Index& corner : corners) {
          corner += first;
        }
        all.faces.add(corners);
      }
    }
    return all;
  }

  /// Six sheets of n x n quads, the sides of the cube [-1, 1]^3, joined by position alone.
  static Mesh boxOfSheets(int n) {
    Mesh box;
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {-1, 1}) {
        Mesh sheet = test::sheet(n);
        Mat3 turn = Mat3::Zero();
        turn((axis + 1) % 3, 0) = side;
        turn((axis + 2) % 3, 1) = 1;
        turn(axis, 2) = side;
        sheet.positions = (sheet.positions * turn.transpose()).rowwise() + side * Vec3::Unit(axis).transpose();
        box = box.vertexCount() == 0 ? sheet : test::merged(box, sheet);
      }
    }
    return box;
  }
};

const test::Registration<CoarseMeshTest> registration;

}  // namespace pbffd

#include "coarse_mesh_test.moc"
