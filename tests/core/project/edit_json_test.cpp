#include "core/project/edit_json.h"
#include "tests/core/project/projects.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <cstring>

namespace pbffd {

using test::contains;

class EditJsonTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyEditComesBackAsItWas_data() {
    QTest::addColumn<QString>("json");
    const auto row = [](const char* name, const char* json) { QTest::newRow(name) << QString(json); };
    row("move", R"({"move":{"by":[0.1,0.2,-0.30000000000000004],"level":2,"points":[1,2]}})");
    row("move each", R"({"move":{"by":[[1.0,0.0,0.0],[0.0,1.0,0.0]],"follow":"none","points":[1,2]}})");
    row("move spread",
        R"({"move":{"by":[1.0,0.0,0.0],"master":true,"mirror":["x","z"],"plane":[0.5,0.0,0.0],"points":[1],"weights":[0.25]}})");
    row("transform",
        R"({"transform":{"basis":[[0.0,1.0,0.0],[-1.0,0.0,0.0],[0.0,0.0,1.0]],"level":1,"pivot":[1.0,2.0,3.0],"points":[7],"rotate":{"axis":[0.0,0.0,1.0],"degrees":30.0},"scale":[1.0,2.0,3.0]}})");
    row("transform each", R"({"transform":{"pivot":"each","points":[7],"scale":[2.0,2.0,2.0]}})");
    row("set_pose",
        R"({"set_pose":{"axes":[[1.0,2.0,3.0],[4.0,5.0,6.0],[7.0,8.0,10.0]],"center":[1.0,2.0,3.0],"point":3}})");
    row("set_region",
        R"({"set_region":{"axes":[[1.0,0.0,0.0],[0.0,1.0,0.0],[0.0,0.0,1.0]],"center":[1.0,2.0,3.0],"level":1,"point":3}})");
    row("add",
        R"({"add":{"axes":[[1.0,0.0,0.0],[0.0,1.0,0.0],[0.0,0.0,1.0]],"center":[1.0,2.0,3.0],"id":17,"level":1,"name":"Nose","posed":true}})");
    row("add without axes", R"({"add":{"center":[1.0,2.0,3.0]}})");
    row("remove", R"({"remove":{"points":[1,2,9007199254740991]}})");
    row("enable", R"({"enable":{"enabled":false,"points":[1]}})");
    row("lock", R"({"lock":{"level":3,"locked":true,"points":[1]}})");
    row("strength", R"({"strength":{"points":[1],"value":2.5}})");
    row("reach", R"({"reach":{"points":[1],"value":"all"}})");
    row("refine", R"({"refine":{"factor":3,"level":2,"points":[4,5]}})");
    row("rename", R"({"rename":{"name":"Nase ä","point":1}})");
    row("levels", R"({"levels":{"count":4}})");
    row("levels kept", R"({"levels":{"count":4,"keep":true}})");
    row("master", R"({"master":{"mode":"paper","value":0.2}})");
    row("kernel", R"({"kernel":{"name":"gaussian","sigma":2.5}})");
    row("reset", R"({"reset":{}})");
    row("reset points", R"({"reset":{"level":2,"master":true,"points":[3,4]}})");
    row("group",
        R"({"group":{"edits":[{"reset":{}},{"group":{"edits":[{"levels":{"count":1}}],"text":"b"}}],"text":"a"}})");
    row("place",
        R"({"place":{"exterior_share":0.25,"keep_edits":true,"kernel":"wendland","levels":2,"master":0.5,"master_mode":"paper","offset":0.1,"points":50,"radius_factor":1.5,"reach":"all","regions":"ellipsoid","seed":7,"sigma":2.0,"sites":"all","surface":"open","symmetric":"y"}})");
  }

  void everyEditComesBackAsItWas() {
    QFETCH(QString, json);
    const std::string text = json.toUtf8().toStdString();
    const std::vector<Edit> edits = parseEdits("[" + text + "]", "edits.json");
    QCOMPARE(edits.size(), std::size_t{1});
    QCOMPARE(toJson(edits[0]), text);
    QCOMPARE(toJson(parseEdits(text, "edits.json")[0]), text);
  }

  void numbersKeepEveryBit() {
    const double numbers[] = {1.0 / 3.0, 0.1 + 0.2, 5e-324, 1.7976931348623157e308, -0.0, 123456789.123456789};
    for (const double number : numbers) {
      Move edit{{std::nullopt, {1}}, {Vec3(number, 1, 2)}, Follow::none, {}};
      const auto back = std::get<Move>(parseEdits(toJson(edit), "e")[0].value());
      QVERIFY(std::memcmp(&back.by[0][0], &number, sizeof number) == 0);
    }
  }

  void placeOptionsStandOverTheDefaults() {
    const auto place = [](const char* json) { return std::get<Place>(parseEdits(json, "e")[0].value()); };
    QVERIFY(place(R"({"place":{}})").options == PlacementOptions{});
    QVERIFY(place(R"({"place":{"paper":true}})").options == paperOptions());
    PlacementOptions paper = paperOptions();
    paper.points = 77;
    paper.sites = 500;
    QVERIFY(place(R"({"place":{"paper":true,"points":77,"sites":500}})").options == paper);
    const PlacementOptions given = place(R"({"place":{"paper":true,"master":0.2}})").options;
    QVERIFY(given.masterMode == MasterMode::constant);
    QCOMPARE(given.master, 0.2);
    QCOMPARE(place(R"({"place":{"points":3}})").options.levels, 2);
    QCOMPARE(place(R"({"place":{"points":3,"levels":3}})").options.levels, 3);
  }

  void mistakesAreNamedWithTheirPlace_data() {
    QTest::addColumn<QString>("json");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* json, const char* message) {
      QTest::newRow(json) << QString(json) << QString(message);
    };
    row(R"([{"reset":{}},{"move":{"points":[1],"by":[1,2]}}])",
        "e.json: edit 2 (move): /1/move/by: a list of three numbers");
    row(R"([{"move":{"points":[1],"by":[1,2,"3"]}}])", "/0/move/by/2: a number is expected");
    row(R"([{"move":{"points":[1,2],"by":[[1,2,3]]}}])", "/0/move/by: it has 1 vectors for 2 points");
    row(R"([{"move":{"points":[1.5],"by":[1,2,3]}}])", "/0/move/points/0: a whole number is expected");
    row(R"([{"move":{"points":[-1],"by":[1,2,3]}}])", "is not from 1 to");
    row(R"([{"move":{"points":[1],"by":[1,2,3],"speed":1}}])", "the key \"speed\" is not known");
    row(R"([{"move":{"by":[1,2,3]}}])", "\"points\" is missing");
    row(R"([{"move":{"points":[1],"by":[1,2,3],"follow":"rigid"}}])", "\"rigid\" is not in this version yet");
    row(R"([{"move":{"points":[1],"by":[1,2,3],"follow":"me"}}])", "\"me\" is none of \"frames\", \"none\"");
    row(R"([{"jump":{}}])", "there is no edit 'jump'");
    row(R"([{"refine":{"points":[1],"factor":1.5}}])", "/0/refine/factor: a whole number");
    row(R"([{"pull":{"targets":[]}}])", "'pull' is not in this version yet");
    row(R"([{"rename":{"curve":1,"name":"x"}}])", "renaming a curve is not in this version yet");
    row(R"([{"reset":{},"bake":{}}])", "this has 2");
    row(R"([{}])", "this has 0");
    row(R"([5])", "an object is expected");
    row(R"(5)", "a list of edits is expected");
    row(R"([{"enable":{"points":[1],"enabled":1}}])", "true or false");
    row(R"([{"levels":{"count":2.5}}])", "a whole number");
    row(R"([{"reset":{"master":true}}])", "/0/reset: \"points\" is missing");
    row(R"([{"place":{"points":1e999}}])", "e.json, edit 1 (at /0): a number is too large");
    row(R"([{"reset":{}},{"strength":{"points":[1],"value":NaN}}])",
        "e.json, edit 2 (at /1): line 1, column 49 is not valid JSON: a number must be finite");
    row("[{\"reset\":{}},\n{\"reset\":{}", "edit 2 (at /1): line 2");
    row("", "e.json: there is nothing in it");
    row(R"([{"strength":{"points":[1],"value":2,"value":3}}])",
        "e.json, edit 1 (at /0): it has \"value\" twice in one object");
    row(R"([{"group":{"edits":[{"reset":{"x":1}}]}}])",
        "edit 1 (group): edit 1 (reset): /0/group/edits/0/reset: the key \"x\"");
  }

  void nestingOutOfAllReasonIsRefused() {
    QVERIFY_EXCEPTION_THROWN(parseEdits(std::string(1000000, '['), "e.json"), InvalidInput);
    std::string groups;
    for (int i = 0; i < 100000; ++i) {
      groups += "{\"group\":{\"edits\":[";
    }
    QVERIFY_EXCEPTION_THROWN(parseEdits(groups, "e.json"), InvalidInput);
  }

  void mistakesAreNamedWithTheirPlace() {
    QFETCH(QString, json);
    QFETCH(QString, message);
    try {
      parseEdits(json.toStdString(), "e.json");
      QFAIL("no error");
    } catch (const InvalidInput& error) {
      QVERIFY2(contains(error.what(), message.toStdString()), error.what());
    }
  }
};

const test::Registration<EditJsonTest> registration;

}  // namespace pbffd

#include "edit_json_test.moc"
