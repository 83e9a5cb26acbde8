#include "tests/app/cli/cli_support.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd {

class ExportTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void unmovedMeshComesOutByteForByte() {
    const test::CommandFolder folder;
    const QString project = folder.placedSphere("a.pbffd");
    const auto result = test::runPbffd({"export", project, "-o", folder.path("b.obj")});
    QVERIFY2(result.status == 0, result.errors);
    QCOMPARE(folder.read("b.obj"), folder.read("sphere.obj"));
  }

  void endingIsTheFormat_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"b.off", "b.ply", "b.stl", "B.PLY"}) {
      QTest::newRow(name) << name;
    }
  }
  void endingIsTheFormat() {
    QFETCH(QString, name);
    const test::CommandFolder folder;
    const QString project = folder.placedSphere("a.pbffd");
    QCOMPARE(test::runPbffd({"export", project, "-o", folder.path(name)}).status, 0);
    const QJsonObject info = test::runPbffd({"info", folder.path(name), "--json"}).json();
    QCOMPARE(info["vertices"].toInt(), test::sphere().vertexCount());
    QCOMPARE(info["closed"].toBool(), true);
  }

  void whatTheFormatCannotHoldIsTold() {
    const test::CommandFolder folder;
    const QString mesh =
        folder.write("a.obj",
                     "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 3/3 2/2\n"
                     "f 1/1 2/2 4/3\nf 2/2 3/3 4/1\nf 3/3 1/1 4/2\n");
    QCOMPARE(test::runPbffd({"place", mesh, "-o", folder.path("a.pbffd"), "--points", "4"}).status, 0);
    const auto result = test::runPbffd({"export", folder.path("a.pbffd"), "-o", folder.path("b.stl")});
    QCOMPARE(result.status, 0);
    QVERIFY2(result.errors.contains("STL cannot hold the texture coordinates"), result.errors);
    const auto same = test::runPbffd({"export", folder.path("a.pbffd"), "-o", folder.path("b.obj")});
    QVERIFY2(same.errors.isEmpty(), same.errors);
  }

  void unknownEndingIsRefused() {
    const test::CommandFolder folder;
    const QString project = folder.placedSphere("a.pbffd");
    folder.write("b.xyz", "what was there");
    const auto result = test::runPbffd({"export", project, "-o", folder.path("b.xyz")});
    QCOMPARE(result.status, 1);
    QVERIFY2(result.errors.contains("b.xyz") && result.errors.contains(".obj"), result.errors);
    QCOMPARE(folder.read("b.xyz"), QByteArray("what was there"));
  }

  void meshInPlaceOfAProjectIsRefused() {
    const test::CommandFolder folder;
    const QString mesh = folder.writeObj("a.obj", test::cube());
    const auto result = test::runPbffd({"export", mesh, "-o", folder.path("b.obj")});
    QCOMPARE(result.status, 1);
    QVERIFY2(result.errors.contains("a.obj") && result.errors.contains("pbffd place"), result.errors);
    QCOMPARE(folder.read("b.obj"), QByteArray("(no file)"));
  }
};

const test::Registration<ExportTest> registration;

}  // namespace pbffd

#include "export_test.moc"
