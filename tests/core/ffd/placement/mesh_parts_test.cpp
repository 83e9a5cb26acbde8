#include "core/ffd/placement/mesh_parts.h"

#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <algorithm>

namespace pbffd {
namespace {

/// Each face with corners of its own, as programs write them that keep a normal a corner.
Mesh split(const Mesh& mesh) {
  Mesh result;
  result.positions.resize(static_cast<Index>(mesh.faces.vertices().size()), 3);
  Index next = 0;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    std::vector<Index> corners;
    for (const Index vertex : mesh.faces[f]) {
      result.positions.row(next) = mesh.positions.row(vertex);
      corners.push_back(next++);
    }
    result.faces.add(corners);
  }
  return result;
}

/// The first `count` faces turned over.
Mesh partlyTurned(const Mesh& mesh, Index count) {
  Mesh result;
  result.positions = mesh.positions;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    std::vector<Index> face(mesh.faces[f].begin(), mesh.faces[f].end());
    if (f < count) {
      std::reverse(face.begin(), face.end());
    }
    result.faces.add(face);
  }
  return result;
}

}  // namespace

class MeshPartsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void componentsAreParts() {
    const Mesh mesh = test::merged(test::sheet(3), test::cube());
    const MeshParts parts = meshParts(RestMesh(mesh));
    QCOMPARE(parts.isClosed, (std::vector<bool>{false, true}));
    QCOMPARE(parts.ofFace.front(), 0);
    QCOMPARE(parts.ofFace.back(), 1);
    QCOMPARE(parts.inconsistentCount, 0);
  }

  void solidWithCornersOfItsOwnForEachFaceIsClosed() {
    const RestMesh mesh(split(test::cube()));
    QVERIFY(!mesh.topology().isClosed);
    const MeshParts parts = meshParts(mesh);
    QCOMPARE(parts.isClosed, std::vector<bool>{true});
    QCOMPARE(parts.ofFace, std::vector<Index>(6, 0));
  }

  void closedPartsComeFirstWhereSeamsAreJoined() {
    const MeshParts parts = meshParts(RestMesh(test::merged(split(test::sheet(3)), test::cube())));
    QCOMPARE(parts.isClosed, (std::vector<bool>{true, false}));
    QCOMPARE(parts.ofFace, (std::vector<Index>{1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0}));
  }

  void shellsInTheSamePlaceStayClosed() {
    const MeshParts parts = meshParts(RestMesh(test::merged(test::cube(), test::cube())));
    QCOMPARE(parts.isClosed, (std::vector<bool>{true, true}));
    const Mesh withOpen = test::merged(test::merged(test::cube(), test::cube()), split(test::sheet(2)));
    QCOMPARE(meshParts(RestMesh(withOpen)).isClosed, (std::vector<bool>{true, true, false}));
  }

  void facesThatDisagreeMakeNoInside() {
    for (const Mesh& mesh : {partlyTurned(test::cube(), 2), split(partlyTurned(test::cube(), 2))}) {
      const MeshParts parts = meshParts(RestMesh(mesh));
      QCOMPARE(parts.isClosed, std::vector<bool>{false});
      QCOMPARE(parts.inconsistentCount, 1);
    }
    // Inside out as a whole they agree.
    QCOMPARE(meshParts(RestMesh(partlyTurned(test::cube(), 6))).inconsistentCount, 0);
    QCOMPARE(meshParts(RestMesh(partlyTurned(test::sheet(3), 2))).inconsistentCount, 0);
  }
};

const test::Registration<MeshPartsTest> registration;

}  // namespace pbffd

#include "mesh_parts_test.moc"
