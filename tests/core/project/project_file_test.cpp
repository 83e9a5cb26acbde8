#include "core/project/project_file.h"
#include "core/base/file.h"
#include "core/mesh/io/mesh_io.h"
#include "core/project/archive.h"
#include "core/project/shape.h"
#include "tests/core/project/projects.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>
#include <QtTest>

#include <nlohmann/json.hpp>

#include <functional>

namespace pbffd {

using test::after;
using test::contains;
using test::pointOf;
using Json = nlohmann::json;

class ProjectFileTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void savedProjectsComeBackToTheBit() {
    const Project project = edited();
    saveProject(path(), project);
    const LoadedProject loaded = loadProject(path());
    QVERIFY(loaded.project.controls == project.controls);
    QVERIFY(loaded.project.placement == project.placement);
    QCOMPARE(loaded.project.nextId, project.nextId);
    QCOMPARE(*loaded.project.mesh->mesh().source.bytes, *project.mesh->mesh().source.bytes);
    QCOMPARE(loaded.project.mesh->mesh().source.name, std::string("ball.obj"));
    QVERIFY(loaded.project.mesh->positions() == project.mesh->positions());
    EditWorkspace workspace;
    QVERIFY(deformedShape(project, workspace.weights).positions ==
            deformedShape(loaded.project, workspace.weights).positions);
  }

  void sameProjectGivesTheSameBytes() {
    const Project project = edited();
    saveProject(path(), project);
    const std::string first = readFile(path());
    saveProject(path(), loadProject(path()).project);
    QVERIFY(readFile(path()) == first);
  }

  void fileHoldsWhatTheContractSays() {
    saveProject(path(), edited(), {"PNG", R"({"level":2})"});
    const Archive archive = readArchive(path());
    QCOMPARE(archive.members[0].name, std::string("project.json"));
    QVERIFY(archive.find("mesh/ball.obj") != nullptr);
    QCOMPARE(archive.find("thumbnail.png")->bytes, std::string("PNG"));
    const Json json = Json::parse(archive.members[0].bytes);
    QVERIFY(json["format"] == "pbffd-project");
    QVERIFY(json["version"] == 1);
    QVERIFY(json["mesh"]["sha256"] == sha256(archive.find("mesh/ball.obj")->bytes));
    QVERIFY(json["levels"].size() == 3);
    QVERIFY(json["view"]["level"] == 2);
    QVERIFY(!json["levels"][0]["points"][0].contains("binding"));
    QVERIFY(json["levels"][1]["points"][0]["binding"]["local"].size() == 3);
    QVERIFY(json["levels"][0]["points"][0]["kind"] == "merged");
    QVERIFY(json["levels"][0]["points"][0]["merged_from"].size() >= 1);
    for (const char* list : {"constraints", "curves", "poses"}) {
      QVERIFY(json[list].is_array());
    }
  }

  void viewAndThumbnailAreKeptWhenNoneAreGiven() {
    saveProject(path(), edited(), {"PNG", R"({"level":2})"});
    LoadedProject loaded = loadProject(path());
    QCOMPARE(loaded.extras.thumbnailPng, std::string("PNG"));
    QCOMPARE(loaded.extras.viewJson, std::string(R"({"level":2})"));
    saveProject(path(), loaded.project);
    loaded = loadProject(path());
    QCOMPARE(loaded.extras.thumbnailPng, std::string("PNG"));
    QCOMPARE(loaded.extras.viewJson, std::string(R"({"level":2})"));
    saveProject(path(), loaded.project, {"NEW", R"({"level":3})"});
    QCOMPARE(loadProject(path()).extras.thumbnailPng, std::string("NEW"));
    QCOMPARE(loadProject(path()).extras.viewJson, std::string(R"({"level":3})"));
  }

  void unknownMembersAndKeysSurvive() {
    change([](Archive& archive, Json& json) {
      archive.members.push_back({"history.json", "[1,2]", true});
      archive.members.push_back({"notes/", "", false});
      archive.members.push_back({"notes/a.bin", std::string("\0\1\2", 3), false});
      json["author"] = {{"name", "Ada"}};
      json["mesh"]["unit"] = "mm";
      json["basis"]["hint"] = 1.5;
      json["master"]["rest"]["tag"] = "m";
      json["levels"][1]["colour"] = "red";
      json["levels"][2]["points"][4]["weight_hint"] = 0.25;
      json["levels"][2]["points"][4]["rest"]["note"] = {1, 2, 3};
      json["levels"][1]["points"][0]["binding"]["extra"] = true;
      json["constraints"] = Json::array({{{"vertex", 3}, {"to", {1, 2, 3}}}});
      json["curves"] = Json::array({{{"id", 1}}});
      json["poses"] = Json::array({{{"name", "Up"}}});
    });
    Project project = loadProject(path()).project;
    QCOMPARE(keptCounts(project).constraints, 1);
    QCOMPARE(keptCounts(project).curves, 1);
    QCOMPARE(keptCounts(project).poses, 1);
    QCOMPARE(keptCounts(edited()).poses, 0);
    const PointId tagged = project.controls.levels[2][4].id;
    const PointId other = project.controls.levels[2][0].id;
    project = after(project, Remove{{3, {other}}});
    project = after(project, Move{{3, {tagged}}, {Vec3(1, 0, 0)}, Follow::none, {}});
    saveProject(path(), project);
    const Archive archive = readArchive(path());
    QCOMPARE(archive.find("history.json")->bytes, std::string("[1,2]"));
    QVERIFY(archive.find("notes/") != nullptr);
    QCOMPARE(archive.find("notes/a.bin")->bytes, std::string("\0\1\2", 3));
    const Json json = Json::parse(archive.find("project.json")->bytes);
    QVERIFY(json["author"]["name"] == "Ada");
    QVERIFY(json["mesh"]["unit"] == "mm");
    QVERIFY(json["basis"]["hint"] == 1.5);
    QVERIFY(json["master"]["rest"]["tag"] == "m");
    QVERIFY(json["levels"][1]["colour"] == "red");
    QVERIFY(json["levels"][1]["points"][0]["binding"]["extra"] == true);
    const Json point = json["levels"][2]["points"][3];
    QVERIFY(point["id"] == tagged);
    QVERIFY(point["weight_hint"] == 0.25);
    QVERIFY(point["rest"]["note"] == Json({1, 2, 3}));
    QVERIFY(!json["levels"][2]["points"][4].contains("weight_hint"));
    QVERIFY(json["constraints"][0]["vertex"] == 3);
    QVERIFY(json["curves"][0]["id"] == 1);
    QVERIFY(json["poses"][0]["name"] == "Up");
  }

  void newerVersionsAreRefused() {
    change([](Archive&, Json& json) {
      json["version"] = 2;
      json["levels"] = "something else";
    });
    QCOMPARE(refusal(),
             path().string() + " was made by a newer version (file version 2, this program reads 1). "
                               "Update the program to open it.");
  }

  void damagedDocumentsAreRefused_data() {
    QTest::addColumn<QString>("pointer");
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* pointer, const char* value, const char* message) {
      QTest::addRow("%s %s", pointer, value) << QString(pointer) << QString(value) << QString(message);
    };
    row("/format", "5", "its \"format\" is not");
    row("/version", "0", "/version: 0 is not from 1");
    row("/version", "\"1\"", "/version: a whole number");
    row("/mesh/file", "\"mesh/cow.obj\"", "its mesh mesh/cow.obj is missing");
    row("/mesh/sha256", "\"00\"", "SHA-256 differs");
    row("/levels", "[]", "at least one level");
    row("/levels", "{}", "/levels: a list is expected");
    row("/levels/0/points", "[]", "level 1 has no points");
    row("/levels/2/points/3/id", "1", "the identifier 1 is used twice");
    row("/levels/2/points/3/id", "0", "is not from 1");
    row("/levels/2/points/3/rest/axes/0", "[1,2]", "/levels/2/points/3/rest/axes/0: a list of three numbers");
    row("/levels/2/points/3/rest/axes", "[[1,0,0],[1,0.1,0],[0,0,1]]", "right angles");
    row("/levels/2/points/3/rest/axes/1", "[0,0,0]", "no length");
    row("/levels/2/points/3/pose/axes", "[[1,0,0],[1,0,0],[0,0,1]]", "singular");
    row("/levels/2/points/3/strength", "0", "above 0");
    row("/levels/2/points/3/strength", "1e308", "not between");
    row("/levels/2/points/3/binding/local", "[[0,0,0,0],[0,1,0,0],[0,0,1,0]]", "singular");
    row("/levels/2/points/3/kind", "\"odd\"", "\"odd\" is none of");
    row("/levels/2/points/3/binding/local", "[[1,0,0,0],[0,1,0,0]]", "three rows of four");
    row("/levels/2/points/3/binding", "5", "an object is expected");
    row("/levels/2/points/3/binding", "null", "has no \"binding\" to the next coarser level");
    row("/levels/0/points/3/binding", "{}", "but there is no coarser level");
    row("/levels/1/points/3/merged_from", "[9999]", "point 9999 is not on the next finer level");
    row("/levels/1/points/3/merged_from", "[1, 1]", "point 1 is named twice: point ");
    row("/levels/1/points/3/merged_from", "\"1\"", "a list is expected");
    row("/levels/2/points/3/merged_from", "[1]", "do not fit together");
    row("/master/value", "-1", "0 or more");
    row("/master/mode", "\"x\"", "none of");
    row("/basis/kernel", "\"x\"", "none of");
    row("/basis/sigma", "0", "above 0");
    row("/next_id", "\"x\"", "whole number");
    row("/placement/points", "\"x\"", "whole number");
    row("/view", "5", "an object is expected");
    row("/curves", "{}", "a list is expected");
  }

  void damagedDocumentsAreRefused() {
    QFETCH(QString, pointer);
    QFETCH(QString, value);
    QFETCH(QString, message);
    change([&](Archive&, Json& json) {
      json[Json::json_pointer(pointer.toStdString())] = Json::parse(value.toStdString());
    });
    const std::string said = refusal();
    QVERIFY2(contains(said, message.toStdString()), said.c_str());
    QVERIFY2(contains(said, path().string()), said.c_str());
  }

  void pointsOfTwoParentsAreRefused() {
    change([](Archive&, Json& json) {
      const Json member = json["levels"][1]["points"][0]["merged_from"][0];
      json["levels"][1]["points"][1]["merged_from"].push_back(member);
    });
    QVERIFY(contains(refusal(), "/levels/1/points/1/merged_from: the levels do not fit together: point "));
    QVERIFY(contains(refusal(), "stands for it already"));
  }

  void levelsThatCameOrWentAreRefused_data() {
    QTest::addColumn<int>("gone");
    QTest::addColumn<QString>("message");
    QTest::newRow("no coarsest") << 0 << "point 41 has a \"binding\", but there is no coarser level";
    QTest::newRow("no second") << 1 << "point 41 is not on the next finer level";
    QTest::newRow("no finest") << 2 << "point 1 is not on the next finer level";
    QTest::newRow("one twice") << -1 << "is used twice";
  }
  void levelsThatCameOrWentAreRefused() {
    QFETCH(int, gone);
    QFETCH(QString, message);
    change([&](Archive&, Json& json) {
      Json& levels = json["levels"];
      if (gone < 0) {
        levels.push_back(levels.back());
      } else {
        levels.erase(static_cast<std::size_t>(gone));
      }
    });
    const std::string said = refusal();
    QVERIFY2(contains(said, message.toStdString()), said.c_str());
  }

  void bindingsThatContradictThePosesGiveWay_data() {
    QTest::addColumn<QString>("pointer");
    QTest::addColumn<QString>("value");
    QTest::newRow("local") << "/levels/2/points/3/binding/local"
                           << "[[1,0,0,9],[0,1,0,0],[0,0,1,0]]";
    QTest::newRow("at") << "/levels/1/points/3/binding/at"
                        << "[7,8,9]";
    QTest::newRow("pose") << "/levels/2/points/3/pose/center"
                          << "[0.5,0.5,0.5]";
  }
  void bindingsThatContradictThePosesGiveWay() {
    QFETCH(QString, pointer);
    QFETCH(QString, value);
    change([&](Archive&, Json& json) {
      json[Json::json_pointer(pointer.toStdString())] = Json::parse(value.toStdString());
    });
    const LoadedProject loaded = loadProject(path());
    QCOMPARE(loaded.remarks.size(), std::size_t{1});
    QVERIFY(contains(loaded.remarks[0], "The levels did not fit together: 1 point was not where"));
    QVERIFY(test::levelError(loaded.project) < 1e-12);
    if (pointer.contains("pose")) {
      QVERIFY(loaded.project.controls.finest()[3].pose.center == Vec3(0.5, 0.5, 0.5));
    } else {
      QVERIFY(loaded.project.controls.finest()[3].pose == edited().controls.finest()[3].pose);
    }
    // What is saved then fits.
    saveProject(path(), loaded.project);
    QVERIFY(loadProject(path()).remarks.empty());
    QVERIFY(loadProject(path()).project.controls == loaded.project.controls);
  }

  void levelsThatCannotFitAreRefused() {
    // A coarse level flattened to almost nothing across no axis, under points that stand upright.
    const auto flatten = [](Json& frame) {
      for (Json& axis : frame["axes"]) {
        const double mean = (axis[0].get<double>() + axis[1].get<double>() + axis[2].get<double>()) / 3.0;
        for (Json& number : axis) {
          number = number.get<double>() - (1.0 - 1e-11) * mean;
        }
      }
    };
    change([&](Archive&, Json& json) {
      for (Json& point : json["levels"][0]["points"]) {
        flatten(point["pose"]);
      }
      flatten(json["master"]["pose"]);
    });
    const std::string said = refusal();
    QVERIFY2(contains(said, "the levels do not fit together"), said.c_str());
    QVERIFY2(contains(said, "flattened"), said.c_str());
  }

  void missingKeysAreNamed_data() {
    QTest::addColumn<QString>("pointer");
    for (const char* pointer : {"/format", "/version", "/next_id", "/mesh", "/basis", "/master", "/levels"}) {
      QTest::newRow(pointer) << QString(pointer);
    }
    for (const char* pointer :
         {"/levels/2/points/3/rest", "/levels/2/points/3/pose", "/levels/2/points/3/binding"}) {
      QTest::newRow(pointer) << QString(pointer);
    }
  }

  void missingKeysAreNamed() {
    QFETCH(QString, pointer);
    const Json::json_pointer at(pointer.toStdString());
    change([&](Archive&, Json& json) { json[at.parent_pointer()].erase(at.back()); });
    const std::string said = refusal();
    QVERIFY2(contains(said, at.back()), said.c_str());
  }

  void nextIdIsNeverBelowWhatIsUsed() {
    change([](Archive&, Json& json) { json["next_id"] = 3; });
    const Project project = loadProject(path()).project;
    QCOMPARE(project.nextId, edited().nextId);
  }

  void numbersThatAreNotFiniteAreRefused() {
    changeText("\"next_id\":", "\"big\":1e999,\"next_id\":");
    QVERIFY(contains(refusal(), "too large to be finite"));
    changeText("\"next_id\":", "\"deep\":" + std::string(5000, '[') + std::string(5000, ']') + ",\"next_id\":");
    QVERIFY(contains(refusal(), "nested"));
    changeText("\"next_id\":", "\"next_id\":7,\"next_id\":");
    QVERIFY(contains(refusal(), "\"next_id\" twice"));
    changeText("\"next_id\":", "\"big\":NaN,\"next_id\":");
    QVERIFY(contains(refusal(), "is not valid JSON: a number must be finite"));
    changeText("\"local\":[[", "\"local\":[[NaN,");
    QVERIFY(contains(refusal(), "a number must be finite"));
  }

  void cutOffFilesAreRefused() {
    saveProject(path(), edited());
    const std::string whole = readFile(path());
    for (const double share : {0.0, 0.01, 0.5, 0.99}) {
      writeFileAtomically(path(), whole.substr(0, static_cast<std::size_t>(share * whole.size())));
      QVERIFY2(!refusal().empty(), "cut");
    }
    writeFileAtomically(path(), "no archive at all");
    QVERIFY(contains(refusal(), "not a whole ZIP archive"));
  }

  void flippedBytesAreRefusedOrHarmless() {
    saveProject(path(), edited());
    const std::string whole = readFile(path());
    int refused = 0;
    for (std::size_t at = 0; at < whole.size(); at += 97) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
      writeFileAtomically(path(), damaged);
      refused += refusal().empty() ? 0 : 1;
    }
    QVERIFY(refused > 0);
  }

  void missingFilesAndMembersAreNamed() {
    QVERIFY_EXCEPTION_THROWN(loadProject(folder_.filePath("none.pbffd").toStdString()), IoError);
    saveProject(path(), edited());
    Archive archive = readArchive(path());
    archive.members.erase(archive.members.begin());
    writeFileAtomically(path(), encodeArchive(archive));
    QVERIFY(contains(refusal(), "there is no project.json"));
  }

  void membersOfOneNameAreRefused() {
    saveProject(path(), edited());
    std::string bytes = readFile(path());
    // A member of another name of the same length is renamed in the bytes.
    Archive archive = readArchive(path());
    archive.members.push_back({"project.jsoo", "{}", false});
    bytes = encodeArchive(archive);
    for (std::size_t at = bytes.find("project.jsoo"); at != std::string::npos;
         at = bytes.find("project.jsoo")) {
      bytes.replace(at, 12, "project.json");
    }
    writeFileAtomically(path(), bytes);
    QVERIFY(contains(refusal(), "project.json is in it twice"));
  }

  void absurdlyPackedMembersAreRefused() {
    saveProject(path(), edited());
    Archive archive = readArchive(path());
    archive.members.push_back({"zeros.bin", std::string(std::size_t{80} << 20, '\0'), true});
    writeFileAtomically(path(), encodeArchive(archive));
    QVERIFY(contains(refusal(), "zeros.bin in it claims to unpack to 80 MiB"));
  }

  void brokenMeshesAreNamed() {
    change([](Archive& archive, Json& json) {
      for (ArchiveMember& member : archive.members) {
        if (member.name == "mesh/ball.obj") {
          member.bytes = "v 1 2\nf 1 2 3\n";
          json["mesh"]["sha256"] = sha256(member.bytes);
        }
      }
    });
    QVERIFY(contains(refusal(), "ball.obj"));
  }

  void aMeshThatCameFromNoFileIsWrittenAsOne() {
    const Project project = test::projectWith(10, 1);
    saveProject(path(), project);
    const Project loaded = loadProject(path()).project;
    QVERIFY(loaded.mesh->positions() == project.mesh->positions());
    QVERIFY(loaded.mesh->mesh().faces.vertices() == project.mesh->mesh().faces.vertices());
  }

  void aProjectOfAMeshAloneComesBack() {
    Project project;
    project.mesh = test::projectWith().mesh;
    project.controls.master.rest.axes = 3.0 * Mat3::Identity();
    project.controls.master.pose = project.controls.master.rest;
    saveProject(path(), project);
    QVERIFY(loadProject(path()).project.controls == project.controls);
  }

  void failedSavesLeaveTheOldFile() {
    saveProject(path(), edited());
    const std::string before = readFile(path());
    const Progress progress([](std::string_view, double) {});
    progress.cancel();
    QVERIFY_EXCEPTION_THROWN(saveProject(path(), test::projectWith(), {}, progress), Cancelled);
    QVERIFY(readFile(path()) == before);
    QVERIFY_EXCEPTION_THROWN(loadProject(path(), progress), Cancelled);
    QVERIFY_EXCEPTION_THROWN(saveProject(folder_.filePath("none/a.pbffd").toStdString(), edited()), IoError);
  }

  void oddNamesOfMeshesAreKeptOrMadePlain() {
    Project project = edited();
    Mesh mesh = project.mesh->mesh();
    mesh.source.name = "a b \xc3\xa4.obj";
    project.mesh = std::make_shared<const RestMesh>(mesh);
    saveProject(path(), project);
    QCOMPARE(loadProject(path()).project.mesh->mesh().source.name, mesh.source.name);
    mesh.source.name = "bad\xff.obj";
    project.mesh = std::make_shared<const RestMesh>(mesh);
    saveProject(path(), project);
    QCOMPARE(loadProject(path()).project.mesh->mesh().source.name, std::string("bad_.obj"));
  }

 private:
  std::filesystem::path path() const { return folder_.filePath("ball.pbffd").toStdString(); }

  static Project edited() {
    static const Project project = [] {
      const Mesh sphere = test::sphere(8, 12);
      auto bytes =
          std::make_shared<const std::string>(encodeMesh(sphere, {sphere.positions, {}}, MeshFormat::obj));
      Project made = test::projectWith(40, 3, parseMesh(bytes, "ball.obj"));
      made = after(made,
                   Move{{1, {made.controls.levels[0][0].id}}, {Vec3(0.1, 1.0 / 3.0, 0)}, Follow::frames, {}});
      made = after(made, Rename{3, 2, "Nose \"ä\""});
      made = after(made, Lock{{3, {3}}, true});
      made = after(made, Enable{{3, {5}}, false});
      made = after(made, Strength{{3, {6}}, 1.0 / 7.0});
      made = after(made, SetKernel{{Kernel::gaussian, 2.9}});
      made.placement.points = 40;
      made.placement.sites = 300;
      return made;
    }();
    return project;
  }

  /// Saves the project with its archive and document changed.
  void change(const std::function<void(Archive&, Json&)>& edit) const {
    saveProject(path(), edited());
    Archive archive = readArchive(path());
    Json json = Json::parse(archive.members[0].bytes);
    edit(archive, json);
    archive.members[0].bytes = json.dump();
    writeFileAtomically(path(), encodeArchive(archive));
  }

  void changeText(const std::string& from, const std::string& to) const {
    saveProject(path(), edited());
    Archive archive = readArchive(path());
    std::string& text = archive.members[0].bytes;
    text.replace(text.find(from), from.size(), to);
    writeFileAtomically(path(), encodeArchive(archive));
  }

  /// The message with which the file is refused; empty where it is not.
  std::string refusal() const {
    try {
      static_cast<void>(loadProject(path()));
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return {};
  }

  QTemporaryDir folder_;
};

const test::Registration<ProjectFileTest> registration;

}  // namespace pbffd

#include "project_file_test.moc"
