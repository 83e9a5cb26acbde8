#include "core/base/error.h"
#include "core/base/file.h"
#include "tests/core/mesh/io/io_support.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <QTemporaryDir>
#include <QtTest>

#include <filesystem>

namespace pbffd {

using namespace test;

namespace {

/// A cube with texture coordinates, a normal for each face and a colour for each vertex.
Mesh dressedCube() {
  Mesh mesh = cube();
  Attribute texture{"vt", AttributeDomain::corner, 2, {0, 0, 1, 0, 1, 1, 0, 1}, {}};
  Attribute normals{"vn", AttributeDomain::corner, 3, {}, {}};
  for (Index face = 0; face < mesh.faces.size(); ++face) {
    const Vec3 a = mesh.positions.row(mesh.faces[face][0]);
    const Vec3 b = mesh.positions.row(mesh.faces[face][1]);
    const Vec3 c = mesh.positions.row(mesh.faces[face][2]);
    const Vec3 normal = (b - a).cross(c - a);
    normals.values.insert(normals.values.end(), {normal[0], normal[1], normal[2]});
    for (Index corner = 0; corner < 4; ++corner) {
      texture.rowOfCorner.push_back(corner);
      normals.rowOfCorner.push_back(face);
    }
  }
  Attribute colors{"color", AttributeDomain::vertex, 3, {}, {}};
  for (int i = 0; i < 24; ++i) {
    colors.values.push_back(i / 51.0);
  }
  mesh.attributes = {texture, normals, colors};
  return mesh;
}

/// The message of the InvalidInput that reading a file ends in.
std::string messageOf(const std::filesystem::path& path) {
  try {
    readMesh(path);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return {};
}

}  // namespace

class MeshIoTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void endingsNameFormats() {
    QVERIFY(formatOfEnding("a/b.OBJ") == MeshFormat::obj);
    QVERIFY(formatOfEnding("b.x.Off") == MeshFormat::off);
    QVERIFY(formatOfEnding("b.ply") == MeshFormat::ply);
    QVERIFY(formatOfEnding("b.stl") == MeshFormat::stl);
    QVERIFY(formatOfEnding("b.obj.gz") == MeshFormat::none);
    QVERIFY(formatOfEnding("obj") == MeshFormat::none);
  }

  void filesAreReadWithTheirSource() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("a b.OBJ").toStdString();
    writeFileAtomically(path, "v 1 2 3\n");
    const Mesh mesh = readMesh(path);
    QCOMPARE(mesh.source.name, std::string("a b.OBJ"));
    QVERIFY(mesh.source.format == MeshFormat::obj);
    QCOMPARE(*mesh.source.bytes, std::string("v 1 2 3\n"));
  }

  void missingFilesAndFoldersAreIoErrors() {
    const QTemporaryDir folder;
    QVERIFY_EXCEPTION_THROWN(readMesh(folder.filePath("none.obj").toStdString()), IoError);
    QVERIFY_EXCEPTION_THROWN(readMesh(folder.filePath("none.xyz").toStdString()), IoError);
    QVERIFY_EXCEPTION_THROWN(readMesh(folder.path().toStdString()), IoError);
  }

  void messagesNameTheFileAsItWasNamed() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("a.obj").toStdString();
    writeFileAtomically(path, "v 1 2 3\nf 1 2 3\n");
    const std::string said = messageOf(path);
    QVERIFY2(said.starts_with("Could not read " + path.string() + ". Line 2: "), said.c_str());
  }

  void unknownEndingsAreRefused() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("a.xyz").toStdString();
    writeFileAtomically(path, "v 1 2 3\n");
    QVERIFY_EXCEPTION_THROWN(readMesh(path), InvalidInput);
    QVERIFY(messageOf(path).starts_with("Could not read " + path.string() + ". Its ending"));
    QVERIFY_EXCEPTION_THROWN(parsed("a", "v 1 2 3\n"), InvalidInput);
    const Mesh mesh = cube();
    QVERIFY_EXCEPTION_THROWN(encodeMesh(mesh, atRest(mesh), MeshFormat::none), InvalidInput);
  }

  void everyFormatHoldsPositionsAndPolygons() {
    const Mesh mesh = merged(cube(), sphere(5, 7));
    const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    const DeformedShape shape = moved(mesh, turn, Vec3(1.0 / 3.0, 0, 1e7));
    for (const std::string name : {"a.obj", "a.off", "a.ply"}) {
      const Mesh again = converted(mesh, shape, name);
      QVERIFY(again.positions == shape.positions);
      QCOMPARE(again.faces.offsets(), mesh.faces.offsets());
      QCOMPARE(again.faces.vertices(), mesh.faces.vertices());
      QVERIFY(again.remarks.empty());
    }
  }

  void stlHoldsTriangles() {
    const Mesh mesh = cube();
    const Mesh again = converted(mesh, atRest(mesh), "a.stl");
    QCOMPARE(again.vertexCount(), 8);
    QCOMPARE(again.faces.size(), 12);
    const Mesh points = parsed("a.obj", "v 0 0 0\n");
    QVERIFY_EXCEPTION_THROWN(encodeMesh(points, atRest(points), MeshFormat::stl), InvalidInput);
    QVERIFY_EXCEPTION_THROWN(encodeMesh(mesh, moved(mesh, 1e39 * Mat3::Identity()), MeshFormat::stl),
                             InvalidInput);
  }

  void facesWithoutAreaReadBack() {
    const Mesh mesh = parsed("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2\nf 3\n");
    for (const std::string name : {"a.off", "a.ply"}) {
      QCOMPARE(converted(mesh, atRest(mesh), name).faces.offsets(), mesh.faces.offsets());
    }
    const std::string obj = encodeMesh(converted(mesh, atRest(mesh), "a.off"), atRest(mesh), MeshFormat::obj);
    QVERIFY(obj.ends_with("f 1 2 3\nl 1 2\np 3\n"));
  }

  void objTakesEverythingOfACubeAlong() {
    const Mesh mesh = dressedCube();
    const Mesh again = converted(mesh, moved(mesh, quarterTurn()), "a.obj");
    QCOMPARE(attribute(again, "vt", AttributeDomain::corner)->values, mesh.attributes[0].values);
    QCOMPARE(attribute(again, "vt", AttributeDomain::corner)->rowOfCorner, mesh.attributes[0].rowOfCorner);
    const Attribute* normals = attribute(again, "vn", AttributeDomain::corner);
    QCOMPARE(normals->rowOfCorner, mesh.attributes[1].rowOfCorner);
    for (std::size_t row = 0; row < 6; ++row) {
      const Vec3 before(mesh.attributes[1].values.data() + 3 * row);
      const Vec3 after(normals->values.data() + 3 * row);
      QVERIFY((quarterTurn() * before - after).isZero(0.0));
    }
    QCOMPARE(attribute(again, "color", AttributeDomain::vertex)->values, mesh.attributes[2].values);
  }

  void plyTakesTextureCoordinatesAndColoursAlong() {
    const Mesh mesh = dressedCube();
    const Mesh ply = converted(mesh, atRest(mesh), "a.ply");
    QCOMPARE(attribute(ply, "red", AttributeDomain::vertex)->values,
             (std::vector<double>{0, 15, 30, 45, 60, 75, 90, 105}));
    QVERIFY2(attribute(ply, "nx", AttributeDomain::vertex) == nullptr, "a corner of a cube has three normals");
    const Mesh obj = converted(ply, atRest(ply), "a.obj");
    const Attribute* texture = attribute(obj, "vt", AttributeDomain::corner);
    QCOMPARE(texture->rowOfCorner.size(), std::size_t{24});
    QCOMPARE(texture->values.size(), std::size_t{48});
    QCOMPARE(attribute(obj, "color", AttributeDomain::vertex)->values, mesh.attributes[2].values);
  }

  void normalsOfVerticesGoFromFormatToFormat() {
    const Mesh off = parsed(
        "a.off", "CNOFF\n3 1 0\n0 0 0 1 0 0 255 0 51\n1 0 0 0 0 2 0 0 0\n0 1 0 0 1 0 0 0 0\n3 0 1 2 0 0 255\n");
    const Mesh ply = converted(off, moved(off, quarterTurn()), "a.ply");
    QCOMPARE(attribute(ply, "nx", AttributeDomain::vertex)->values, (std::vector<double>{0, 0, -1}));
    QCOMPARE(attribute(ply, "nz", AttributeDomain::vertex)->values, (std::vector<double>{0, 2, 0}));
    QCOMPARE(attribute(ply, "blue", AttributeDomain::face)->values, (std::vector<double>{255}));
    const Mesh obj = converted(ply, atRest(ply), "a.obj");
    QCOMPARE(attribute(obj, "vn", AttributeDomain::corner)->values,
             (std::vector<double>{0, 1, 0, 0, 0, 2, -1, 0, 0}));
    const Mesh again = converted(obj, atRest(obj), "a.off");
    QCOMPARE(attribute(again, "normal", AttributeDomain::vertex)->values,
             (std::vector<double>{0, 1, 0, 0, 0, 2, -1, 0, 0}));
    QCOMPARE(attribute(again, "color", AttributeDomain::vertex)->values,
             (std::vector<double>{255, 0, 51, 0, 0, 0, 0, 0, 0}));
  }
};

const test::Registration<MeshIoTest> registration;

}  // namespace pbffd

#include "mesh_io_test.moc"
