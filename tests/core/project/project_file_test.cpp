#include "core/project/project_file.h"
#include "core/project/shape.h"
#include "tests/core/project/saved_project.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd {

using test::after;
using test::contains;
using test::Json;

class ProjectFileTest : public QObject, private test::SavedProject {
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
};

const test::Registration<ProjectFileTest> registration;

}  // namespace pbffd

#include "project_file_test.moc"
