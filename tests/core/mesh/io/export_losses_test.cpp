#include "core/mesh/io/export_losses.h"
#include "core/mesh/io/mesh_io.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd {

class ExportLossesTest : public QObject {
  Q_OBJECT

  /// A quadrilateral whose vertices have a texture coordinate each, and a triangle that uses another for one.
  static Mesh textured() {
    return parse(
        "mtllib a.mtl\no thing\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 1\nv 9 9 9\n"
        "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt .5 .5\nvn 0 0 1\ng part\nusemtl red\n"
        "f 1/1/1 2/2/1 3/3/1 4/4/1\nf 2/5/1 5/1/1 3/3/1\n",
        "a.obj");
  }
  static Mesh parse(const char* text, const char* name) {
    return parseMesh(std::make_shared<const std::string>(text), name);
  }
  static QString all(const Mesh& mesh, MeshFormat format) {
    QStringList lines;
    for (const std::string& loss : exportLosses(mesh, format)) {
      lines << QString::fromStdString(loss);
    }
    return lines.join('\n');
  }

 private Q_SLOTS:
  void theSourcesOwnFormatLosesNothing() { QCOMPARE(all(textured(), MeshFormat::obj), QString()); }

  void whatAFormatCannotHoldIsNamed() {
    QCOMPARE(all(textured(), MeshFormat::off),
             QString("OFF cannot hold the texture coordinates, groups and materials of a.obj: left out."));
    QCOMPARE(all(textured(), MeshFormat::ply),
             QString("PLY cannot hold groups and materials of a.obj: left out."));
    const QString stl = all(textured(), MeshFormat::stl);
    QVERIFY2(stl.startsWith("STL cannot hold the normals, the texture coordinates, groups and materials"),
             qPrintable(stl));
    QVERIFY2(
        stl.contains("one face of more corners is cut") && stl.contains("one vertex of no face is left out"),
        qPrintable(stl));
  }

  void coloursAndColumnsOfItsOwnAreNamed() {
    const Mesh mesh = parse(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float quality\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0 255 0 0 1\n1 0 0 0 255 0 2\n0 1 0 0 0 255 3\n3 0 1 2\n",
        "a.ply");
    QCOMPARE(all(mesh, MeshFormat::obj), QString("OBJ cannot hold 'quality' of a.ply: left out."));
    QCOMPARE(all(mesh, MeshFormat::stl),
             QString("STL cannot hold the colours of the vertices and 'quality' of a.ply: left out."));
  }

  void aPlainMeshLosesNothing() {
    const Mesh mesh = parse("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "b.obj");
    for (const MeshFormat format : {MeshFormat::off, MeshFormat::ply, MeshFormat::stl}) {
      QCOMPARE(all(mesh, format), QString());
    }
  }
};

const test::Registration<ExportLossesTest> registration;

}  // namespace pbffd

#include "export_losses_test.moc"
