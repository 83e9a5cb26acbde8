#include "tests/app/cli/cli_support.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd {

class BenchTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyFigureIsMeasured() {
    const test::CommandFolder folder;
    const QString mesh = folder.writeObj("bar.obj", test::cylinder());
    const auto result = test::runPbffd({"bench", mesh, "--points", "20", "--json"});
    QVERIFY2(result.status == 0, result.errors);
    const QJsonObject json = result.json();
    QCOMPARE(json["vertices"].toInt(), test::cylinder().vertexCount());
    const QJsonObject seconds = json["seconds"].toObject();
    for (const char* key : {"qhull", "assemble", "parameterize", "deform_all", "deform_one", "eigen_eq7",
                            "assemble_10000_points", "parameterize_brute_force", "parameterize_connected",
                            "parameterize_connected_brute_force", "parameterize_all",
                            "parameterize_all_brute_force", "triad_bytes_per_second"}) {
      QVERIFY2(seconds[key].toDouble() > 0.0, key);
    }
    const QJsonObject ratios = json["ratios"].toObject();
    QCOMPARE(ratios["assemble_qhull"].toDouble(), seconds["assemble"].toDouble() / seconds["qhull"].toDouble());
    QVERIFY(ratios["deform_bandwidth"].toDouble() > 0.0);
    QVERIFY(json["brute_force_difference"].toDouble() < 1e-6);
    QVERIFY(json["assemble_10000_points_placed"].toInt() > 0);
    QVERIFY(json["triad_bytes_of_array"].toDouble() >= 64 << 20);
  }

  void flatSheetHasNoDiagram() {
    const test::CommandFolder folder;
    const QString mesh = folder.writeObj("sheet.obj", test::sheet());
    const auto result = test::runPbffd({"bench", mesh, "--points", "20", "--json"});
    QVERIFY2(result.status == 0, result.errors);
    const QJsonObject seconds = result.json()["seconds"].toObject();
    QVERIFY(seconds["qhull"].isNull());
    QVERIFY(seconds["assemble"].toDouble() > 0.0);
    QVERIFY(result.json()["ratios"].toObject()["assemble_qhull"].isNull());
    const auto text = test::runPbffd({"bench", mesh, "--points", "20"});
    QVERIFY2(text.output.contains("the vertices lie in a plane"), text.output);
    QVERIFY2(text.output.contains("found room"), text.output);
    QVERIFY2(text.output.contains("Parameterize, reach connected"), text.output);
  }

  void meshThatCannotBePlacedIsNamed() {
    const test::CommandFolder folder;
    const QString mesh = folder.write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    const auto result = test::runPbffd({"bench", mesh});
    QCOMPARE(result.status, 1);
    QVERIFY2(result.errors.contains("bad.obj"), result.errors);
  }
};

const test::Registration<BenchTest> registration;

}  // namespace pbffd

#include "bench_test.moc"
