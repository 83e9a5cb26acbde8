#include "tests/app/cli/cli_support.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QJsonArray>
#include <QtTest>

namespace pbffd {

class PlaceTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aMeshIsNeverOverwritten() {
    const test::CommandFolder folder;
    folder.placedSphere("a.pbffd");
    const QByteArray before = folder.read("sphere.obj");
    for (const QString& output : {folder.path("sphere.obj"), folder.path("other.stl"), QString("-")}) {
      const auto placed = test::runPbffd({"place", folder.path("sphere.obj"), "-o", output});
      QCOMPARE(placed.status, 1);
      QVERIFY2(placed.errors.contains("Nothing was written"), placed.errors);
      const auto edited = test::runPbffd({"edit", folder.path("a.pbffd"), "--edits", "-", "-o", output}, "[]");
      QCOMPARE(edited.status, 1);
      QVERIFY2(edited.errors.contains("Nothing was written"), edited.errors);
    }
    QCOMPARE(folder.read("sphere.obj"), before);
  }

  void defaultsAreTwoHundredPointsOnThreeLevels() {
    const test::CommandFolder folder;
    const QString mesh = folder.writeObj("bar.obj", test::cylinder());
    const auto result = test::runPbffd({"place", mesh, "-o", folder.path("a.pbffd")});
    QVERIFY2(result.status == 0, result.errors);
    const QJsonArray levels =
        test::runPbffd({"info", folder.path("a.pbffd"), "--json"}).json()["levels"].toArray();
    QCOMPARE(levels.size(), 3);
    QCOMPARE(levels[2].toObject()["points"].toInt(), 200);
    QVERIFY(levels[1].toObject()["points"].toInt() < 200);
  }

  void fewPointsGetTheLevelsTheyAllow() {
    const test::CommandFolder folder;
    const QString mesh = folder.writeObj("bar.obj", test::cylinder());
    const QStringList three{"place", mesh, "-o", folder.path("a.pbffd"), "--points", "3"};
    const auto result = test::runPbffd(three);
    QVERIFY2(result.status == 0, result.errors);
    const QJsonArray levels =
        test::runPbffd({"info", folder.path("a.pbffd"), "--json"}).json()["levels"].toArray();
    QCOMPARE(levels.size(), 2);
    const auto asked = test::runPbffd(three + QStringList{"--levels", "3"});
    QCOMPARE(asked.status, 1);
    QVERIFY2(asked.errors.contains("3 points allow at most 2 levels"), asked.errors);
  }

  void everyOptionIsTaken() {
    const test::CommandFolder folder;
    const QString mesh = folder.writeObj("bar.obj", test::cylinder());
    const auto result = test::runPbffd({"place",
                                        mesh,
                                        "-o",
                                        folder.path("a.pbffd"),
                                        "--points",
                                        "24",
                                        "--levels",
                                        "1",
                                        "--kernel",
                                        "wendland",
                                        "--master",
                                        "0.02",
                                        "--offset",
                                        "0.1",
                                        "--exterior-share",
                                        "0.25",
                                        "--sites",
                                        "all",
                                        "--reach",
                                        "all",
                                        "--seed",
                                        "7",
                                        "--radius-factor",
                                        "1.8",
                                        "--surface",
                                        "closed",
                                        "--regions",
                                        "sphere"});
    QVERIFY2(result.status == 0, result.errors);
    const QJsonArray levels =
        test::runPbffd({"info", folder.path("a.pbffd"), "--json"}).json()["levels"].toArray();
    QCOMPARE(levels, QJsonArray{QJsonObject({{"level", 1}, {"points", 24}})});
  }

  void sameInputGivesTheSameProject() {
    const test::CommandFolder folder;
    const QString mesh = folder.writeObj("bar.obj", test::cylinder());
    for (const char* name : {"a.pbffd", "b.pbffd"}) {
      QCOMPARE(test::runPbffd({"place", mesh, "-o", folder.path(name), "--points", "40"}).status, 0);
    }
    QCOMPARE(folder.read("a.pbffd"), folder.read("b.pbffd"));
  }

  void paperSettingsCanBeOverridden() {
    const test::CommandFolder folder;
    const QString mesh = folder.writeObj("bar.obj", test::cylinder());
    QCOMPARE(test::runPbffd({"place", mesh, "-o", folder.path("a.pbffd"), "--paper", "--points", "20"}).status,
             0);
    QCOMPARE(test::runPbffd(
                 {"place", mesh, "-o", folder.path("b.pbffd"), "--paper", "--points", "20", "--offset", "0.03"})
                 .status,
             0);
    QVERIFY(folder.read("a.pbffd") != folder.read("b.pbffd"));
  }

  void meshThatCannotBePlacedLeavesTheOutput_data() {
    QTest::addColumn<QByteArray>("mesh");
    QTest::newRow("no faces") << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    QTest::newRow("infinite") << QByteArray("v 0 0 0\nv inf 0 0\nv 0 1 0\nf 1 2 3\n");
    QTest::newRow("on a line") << QByteArray("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    QTest::newRow("in a point") << QByteArray("v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n");
    QTest::newRow("cut off") << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 ");
  }
  void meshThatCannotBePlacedLeavesTheOutput() {
    QFETCH(QByteArray, mesh);
    const test::CommandFolder folder;
    const QString file = folder.write("bad.obj", mesh);
    folder.write("out.pbffd", "what was there");
    const auto result = test::runPbffd({"place", file, "-o", folder.path("out.pbffd")});
    QCOMPARE(result.status, 1);
    QVERIFY2(result.errors.contains("bad.obj"), result.errors);
    QCOMPARE(folder.read("out.pbffd"), QByteArray("what was there"));
  }

  void outputThatCannotBeWrittenIsNamed() {
    const test::CommandFolder folder;
    const QString mesh = folder.writeObj("bar.obj", test::cylinder());
    const auto result = test::runPbffd({"place", mesh, "-o", folder.path("none/out.pbffd"), "--points", "20"});
    QCOMPARE(result.status, 1);
    QVERIFY2(result.errors.contains("none/out.pbffd"), result.errors);
  }
};

const test::Registration<PlaceTest> registration;

}  // namespace pbffd

#include "place_test.moc"
