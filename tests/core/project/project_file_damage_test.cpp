#include "tests/core/project/saved_project.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <sys/resource.h>

#include <csignal>
#include <iterator>

namespace pbffd {

using test::contains;
using test::Json;

/// Project files that are damaged, made by hand or newer: refused with where and why.
class ProjectFileDamageTest : public QObject, private test::SavedProject {
  Q_OBJECT

 private Q_SLOTS:
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
    writeArchive(path(), archive);
    QVERIFY(contains(refusal(), "there is no project.json"));
  }

  void membersOfOneNameAreRefused() {
    saveProject(path(), edited());
    // A member of another name of the same length is renamed in the bytes.
    Archive archive = readArchive(path());
    archive.members.push_back({"project.jsoo", "{}", false});
    writeArchive(path(), archive);
    std::string bytes = readFile(path());
    for (std::size_t at = bytes.find("project.jsoo"); at != std::string::npos;
         at = bytes.find("project.jsoo")) {
      bytes.replace(at, 12, "project.json");
    }
    writeFileAtomically(path(), bytes);
    QVERIFY(contains(refusal(), "project.json is in it twice"));
  }

  void aDiskWithoutRoomLeavesTheFileThatWasThere() {
    saveProject(path(), edited());
    const std::string before = readFile(path());
    rlimit limit{};
    QCOMPARE(getrlimit(RLIMIT_FSIZE, &limit), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{before.size() / 2, limit.rlim_max};
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &small), 0);
    std::string message;
    try {
      saveProject(path(), edited());
    } catch (const IoError& error) {
      message = error.what();
    }
    setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, handler);
    QVERIFY2(contains(message, path().string() + ": File too large."), message.c_str());
    QVERIFY(readFile(path()) == before);
    const std::filesystem::directory_iterator files(path().parent_path());
    QCOMPARE(std::distance(begin(files), end(files)), std::ptrdiff_t{1});
  }

  void absurdlyPackedMembersAreRefused() {
    saveProject(path(), edited());
    Archive archive = readArchive(path());
    archive.members.push_back({"zeros.bin", std::string(std::size_t{80} << 20, '\0'), true});
    writeArchive(path(), archive);
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
};

const test::Registration<ProjectFileDamageTest> registration;

}  // namespace pbffd

#include "project_file_damage_test.moc"
