#include "tests/app/cli/cli_support.h"
#include "tests/support/test_main.h"

#include <QJsonArray>
#include <QtTest>

namespace pbffd {
namespace {

/// Adds a point in the middle of the sphere and moves it, so that it needs to know of no other point.
const QByteArray addAndMove = R"([
  {"add": {"center": [0.9, 0, 0], "axes": [[0.5, 0, 0], [0, 0.5, 0], [0, 0, 0.5]], "id": 5000}},
  {"move": {"points": [5000], "by": [0.25, 0, 0]}}
])";

}  // namespace

class EditTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void editsChangeTheShape() {
    const test::CommandFolder folder;
    const QString project = folder.placedSphere("a.pbffd");
    const QString edits = folder.write("edits.json", addAndMove);
    const auto result = test::runPbffd({"edit", project, "--edits", edits, "-o", folder.path("b.pbffd")});
    QVERIFY2(result.status == 0, result.errors);
    const QJsonArray levels =
        test::runPbffd({"info", folder.path("b.pbffd"), "--json"}).json()["levels"].toArray();
    QCOMPARE(levels.last().toObject()["points"].toInt(), 31);
    QCOMPARE(test::runPbffd({"export", folder.path("b.pbffd"), "-o", folder.path("b.obj")}).status, 0);
    QVERIFY(folder.read("b.obj") != folder.read("sphere.obj"));
  }

  void refinedPointsAreAdded() {
    const test::CommandFolder folder;
    const QString project = folder.placedSphere("a.pbffd");
    const auto refined = [&](const QByteArray& edits) {
      return test::runPbffd({"edit", project, "--edits", "-", "-o", folder.path("b.pbffd")}, edits);
    };
    const auto result = refined(R"([{"refine": {"points": [1, 2, 3], "factor": 3}}])");
    QVERIFY2(result.status == 0, result.errors);
    const QJsonArray levels =
        test::runPbffd({"info", folder.path("b.pbffd"), "--json"}).json()["levels"].toArray();
    QCOMPARE(levels.last().toObject()["points"].toInt(), 36);
    const auto refused = refined(R"([{"reset": {}}, {"refine": {"points": [1], "factor": 1000}}])");
    QCOMPARE(refused.status, 1);
    QVERIFY2(refused.errors.contains("edit 2 (refine, at /1): the factor is 1000; it must be 2 to 64"),
             refused.errors);
  }

  void whatIsWrittenCanBeReadAgain() {
    const test::CommandFolder folder;
    const QString project = folder.placedSphere("a.pbffd");
    const QByteArray before = folder.read("a.pbffd");
    const QByteArray add = R"([{"add": {"center": [0.9, 0, 0], "id": 9007199254740991}}])";
    const auto result = test::runPbffd({"edit", project, "--edits", "-", "-o", project}, add);
    QCOMPARE(result.status, 1);
    QVERIFY2(result.errors.contains("identifiers are used up"), result.errors);
    QCOMPARE(folder.read("a.pbffd"), before);
  }

  void editsFromStandardInputAreTheSame() {
    const test::CommandFolder folder;
    const QString project = folder.placedSphere("a.pbffd");
    const QString edits = folder.write("edits.json", addAndMove);
    QCOMPARE(test::runPbffd({"edit", project, "--edits", edits, "-o", folder.path("b.pbffd")}).status, 0);
    QCOMPARE(test::runPbffd({"edit", project, "--edits", "-", "-o", folder.path("c.pbffd")}, addAndMove).status,
             0);
    QCOMPARE(folder.read("c.pbffd"), folder.read("b.pbffd"));
  }

  void projectCanBeEditedInPlace() {
    const test::CommandFolder folder;
    const QString project = folder.placedSphere("a.pbffd");
    const QByteArray before = folder.read("a.pbffd");
    QCOMPARE(test::runPbffd({"edit", project, "--edits", "-", "-o", project}, addAndMove).status, 0);
    QVERIFY(folder.read("a.pbffd") != before);
  }

  void noEditsKeepTheProject() {
    const test::CommandFolder folder;
    const QString project = folder.placedSphere("a.pbffd");
    QCOMPARE(test::runPbffd({"edit", project, "--edits", "-", "-o", folder.path("b.pbffd")}, "[]").status, 0);
    QCOMPARE(folder.read("b.pbffd"), folder.read("a.pbffd"));
  }

  void editThatCannotBeDoneIsNamedByItsPlace_data() {
    QTest::addColumn<QByteArray>("edits");
    QTest::addColumn<QByteArray>("place");
    QTest::newRow("no such point") << QByteArray(
                                          R"([{"reset": {}}, {"move": {"points": [99999], "by": [0, 0, 1]}}])")
                                   << QByteArray("/1");
    QTest::newRow("unknown edit") << QByteArray(R"([{"reset": {}}, {"reset": {}}, {"melt": {}}])")
                                  << QByteArray("/2");
    QTest::newRow("not JSON") << QByteArray("[{") << QByteArray("standard input");
    QTest::newRow("no number") << QByteArray(R"([{"master": {"value": "much", "mode": "constant"}}])")
                               << QByteArray("/0");
  }
  void editThatCannotBeDoneIsNamedByItsPlace() {
    QFETCH(QByteArray, edits);
    QFETCH(QByteArray, place);
    const test::CommandFolder folder;
    const QString project = folder.placedSphere("a.pbffd");
    folder.write("out.pbffd", "what was there");
    const auto result =
        test::runPbffd({"edit", project, "--edits", "-", "-o", folder.path("out.pbffd")}, edits);
    QCOMPARE(result.status, 1);
    QVERIFY2(result.errors.contains(place), result.errors);
    QCOMPARE(folder.read("out.pbffd"), QByteArray("what was there"));
  }

  void missingFilesAreNamed() {
    const test::CommandFolder folder;
    const QString project = folder.placedSphere("a.pbffd");
    const auto edits = test::runPbffd({"edit", project, "--edits", folder.path("none.json"), "-o", project});
    QCOMPARE(edits.status, 1);
    QVERIFY2(edits.errors.contains("none.json"), edits.errors);
    const auto noProject =
        test::runPbffd({"edit", folder.path("none.pbffd"), "--edits", "-", "-o", folder.path("b.pbffd")}, "[]");
    QCOMPARE(noProject.status, 1);
    QVERIFY2(noProject.errors.contains("none.pbffd"), noProject.errors);
    QCOMPARE(folder.read("b.pbffd"), QByteArray("(no file)"));
  }
};

const test::Registration<EditTest> registration;

}  // namespace pbffd

#include "edit_test.moc"
