#include "core/mesh/mesh.h"
#include "core/mesh/normals.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <QtTest>

namespace pbffd {
namespace {

double area(const Points& positions, const Triangles& triangles) {
  double sum = 0.0;
  for (Index t = 0; t < triangles.size(); ++t) {
    const Vec3 a = positions.row(triangles.vertices()[3 * t]);
    const Vec3 b = positions.row(triangles.vertices()[3 * t + 1]);
    const Vec3 c = positions.row(triangles.vertices()[3 * t + 2]);
    sum += 0.5 * (b - a).cross(c - a).norm();
  }
  return sum;
}

}  // namespace

class TriangulationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void trianglesStayAndQuadsBecomeTwo() {
    const Mesh cube = test::cube();
    const Triangles triangles = triangulate(cube.positions, cube.faces);
    QCOMPARE(triangles.size(), 12);
    QCOMPARE(area(cube.positions, triangles), 6.0);
  }

  void concavePolygonIsCoveredOnce() {
    // An L of area 3, its reflex corner away from the first one; once in the plane, once turned.
    Mesh mesh;
    mesh.positions.resize(6, 3);
    mesh.positions << 0, 2, 0, 0, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0, 1, 2, 0;
    mesh.faces.add(std::vector<Index>{2, 3, 4, 5, 0, 1});
    for (const double angle : {0.0, 1.0}) {
      const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized()).toRotationMatrix();
      const Points positions = mesh.positions * turn.transpose();
      const Triangles triangles = triangulate(positions, mesh.faces);
      QCOMPARE(triangles.size(), 4);
      QVERIFY(std::abs(area(positions, triangles) - 3.0) < 1e-12);
    }
  }

  void degenerateFacesGiveWhatTheyCan() {
    Mesh mesh;
    mesh.positions = Points::Zero(4, 3);
    mesh.faces.add(std::vector<Index>{0, 1});
    mesh.faces.add(std::vector<Index>{0, 1, 2, 3});
    QCOMPARE(triangulate(mesh.positions, mesh.faces).size(), 2);
  }

  void trianglesKnowTheirFaces() {
    Mesh mesh;
    mesh.positions = test::cube().positions;
    mesh.faces.add(std::vector<Index>{0, 1, 2});
    mesh.faces.add(std::vector<Index>{4, 5, 6});
    const Triangles alone = triangulate(mesh.positions, mesh.faces);
    QVERIFY(alone.vertices().data() == mesh.faces.vertices().data());
    QCOMPARE(alone.faceOf(1), 1);
    mesh.faces.add(std::vector<Index>{0, 1});
    mesh.faces.add(std::vector<Index>{4, 5, 7, 6});
    const Triangles mixed = triangulate(mesh.positions, mesh.faces);
    QCOMPARE(mixed.size(), 4);
    QCOMPARE(mixed.faceOf(1), 1);
    QCOMPARE(mixed.faceOf(2), 3);
    QCOMPARE(mixed.faceOf(3), 3);
  }

  void normalsOfASpherePointOutwards() {
    const Mesh sphere = test::sphere(40, 80);
    const Points normals = vertexNormals(sphere.positions, triangulate(sphere.positions, sphere.faces));
    for (Index v = 0; v < sphere.vertexCount(); ++v) {
      QVERIFY(normals.row(v).dot(sphere.positions.row(v)) > 0.995);
    }
  }

  void aVertexOfNoFaceHasNoNormal() {
    Mesh mesh = test::cube();
    mesh.positions.conservativeResize(9, 3);
    mesh.positions.row(8).setZero();
    const Points normals = vertexNormals(mesh.positions, triangulate(mesh.positions, mesh.faces));
    QCOMPARE(normals.row(8).norm(), 0.0);
    QVERIFY(std::abs(normals.row(0).norm() - 1.0) < 1e-15);
  }
};

const test::Registration<TriangulationTest> registration;

}  // namespace pbffd

#include "triangulation_test.moc"
