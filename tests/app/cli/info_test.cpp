#include "tests/app/cli/cli_support.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QJsonArray>
#include <QtTest>

namespace pbffd {

class InfoTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void meshIsCounted() {
    const test::CommandFolder folder;
    const QString mesh = folder.writeObj("cube.obj", test::cube());
    const auto result = test::runPbffd({"info", mesh, "--json"});
    QCOMPARE(result.status, 0);
    const QJsonObject info = result.json();
    QCOMPARE(info["kind"].toString(), QString("mesh"));
    QCOMPARE(info["vertices"].toInt(), 8);
    QCOMPARE(info["faces"].toInt(), 6);
    QCOMPARE(info["triangles"].toInt(), 12);
    QCOMPARE(info["polygons"].toObject(), QJsonObject({{"4", 6}}));
    QCOMPARE(info["components"].toInt(), 1);
    QCOMPARE(info["boundary_edges"].toInt(-1), 0);
    QCOMPARE(info["nonmanifold_edges"].toInt(-1), 0);
    QCOMPARE(info["isolated_vertices"].toInt(-1), 0);
    QCOMPARE(info["closed"].toBool(), true);
    QCOMPARE(info["bounds"].toArray(), (QJsonArray{QJsonArray{-0.5, -0.5, -0.5}, QJsonArray{0.5, 0.5, 0.5}}));
    QVERIFY(info["attributes"].isArray());
    QCOMPARE(info.size(), 12);
    // A thirteenth only where there is something to remark.
    const QString thin = folder.write("thin.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 2\n");
    QCOMPARE(test::runPbffd({"info", thin, "--json"}).json()["remarks"].toArray().size(), 1);
  }

  void openMeshWithLooseVertexIsSeen() {
    const test::CommandFolder folder;
    const QString mesh =
        folder.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nvt 0 0\nf 1/1 2/1 3/1\n");
    const QJsonObject info = test::runPbffd({"info", mesh, "--json"}).json();
    QCOMPARE(info["closed"].toBool(true), false);
    QCOMPARE(info["boundary_edges"].toInt(), 3);
    QCOMPARE(info["isolated_vertices"].toInt(), 1);
    QVERIFY(info["attributes"].toArray().contains("vt"));
  }

  void projectIsCounted() {
    const test::CommandFolder folder;
    const auto result = test::runPbffd({"info", folder.placedSphere("a.pbffd"), "--json"});
    QCOMPARE(result.status, 0);
    const QJsonObject info = result.json();
    QCOMPARE(info["kind"].toString(), QString("project"));
    QCOMPARE(info["version"].toInt(), 1);
    QCOMPARE(info["mesh"].toObject()["vertices"].toInt(), test::sphere().vertexCount());
    const QJsonArray levels = info["levels"].toArray();
    QCOMPARE(levels.size(), 2);
    QCOMPARE(levels[0].toObject()["level"].toInt(), 1);
    QCOMPARE(levels[1].toObject(), QJsonObject({{"level", 2}, {"points", 30}}));
    for (const char* key : {"curves", "constraints", "poses", "history"}) {
      QCOMPARE(info[key].toInt(-1), 0);
    }
  }

  void textNamesWhatThereIs() {
    const test::CommandFolder folder;
    const QString mesh = folder.writeObj("cube.obj", test::cube());
    const auto result = test::runPbffd({"info", mesh});
    QCOMPARE(result.status, 0);
    QVERIFY(result.output.contains("cube.obj"));
    QVERIFY(result.output.contains("closed"));
    const auto project = test::runPbffd({"info", folder.placedSphere("a.pbffd")});
    QVERIFY(project.output.contains("30 control points"));
  }

  void badFileIsNamedWithItsReason_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QByteArray>("place");
    QTest::newRow("missing") << "none.obj" << QByteArray() << QByteArray("none.obj");
    QTest::newRow("empty") << "empty.ply" << QByteArray("") << QByteArray("empty.ply");
    QTest::newRow("no such vertex") << "far.obj" << QByteArray("v 0 0 0\nv 1 0 0\nf 1 2 9\n")
                                    << QByteArray("3");
    QTest::newRow("not a number") << "word.obj" << QByteArray("v 0 zero 0\n") << QByteArray("1");
    QTest::newRow("no project") << "fake.pbffd" << QByteArray("not a zip") << QByteArray("fake.pbffd");
    QTest::newRow("unknown ending") << "a.xyz" << QByteArray("1 2 3\n") << QByteArray("a.xyz");
  }
  void badFileIsNamedWithItsReason() {
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    QFETCH(QByteArray, place);
    const test::CommandFolder folder;
    const QString file = name.startsWith("none") ? folder.path(name) : folder.write(name, bytes);
    const auto result = test::runPbffd({"info", file, "--json"});
    QCOMPARE(result.status, 1);
    QVERIFY2(result.errors.contains(name.toUtf8()), result.errors);
    QVERIFY2(result.errors.contains(place), result.errors);
    QVERIFY(result.output.isEmpty());
  }
};

const test::Registration<InfoTest> registration;

}  // namespace pbffd

#include "info_test.moc"
