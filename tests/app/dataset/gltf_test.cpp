#include "app/dataset/apply.h"
#include "app/dataset/field_transport.h"
#include "app/dataset/gltf_document.h"
#include "app/dataset/gltf_text.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/ffd/deform/space_deformation.h"
#include "tests/app/dataset/fixture.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <QTemporaryDir>
#include <QtTest>

#include <cstring>

namespace pbffd {
namespace {

using Json = nlohmann::ordered_json;

constexpr int rowCount = 3;

/// Three interleaved rows of position and normal (24 bytes a row), then three tangents.
std::string bufferBytes() {
  const std::vector<float> numbers{0.9F, 0.1F,  0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 0.2F, 0.3F, 0.0F,
                                   1.0F, 0.0F,  5.0F, 5.0F, 5.0F, 0.0F, 0.0F, 1.0F, 0.0F, 1.0F,
                                   0.0F, -1.0F, 0.0F, 0.0F, 1.0F, 1.0F, 1.0F, 0.0F, 0.0F, 1.0F};
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(float)};
}

/// One triangle, placed in the scene by a child and its parent, with a member that nobody knows.
Json model() {
  return Json::parse(R"({
    "asset": {"version": "2.0", "generator": "a test"},
    "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"children": [1], "scale": [0.5, 0.5, 0.5]},
              {"mesh": 0, "translation": [0.1, 0, 0], "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476]}],
    "meshes": [{"name": "t", "primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TANGENT": 2}}]}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0.1, 0], "max": [5, 5, 5]},
      {"bufferView": 0, "byteOffset": 12, "componentType": 5126, "count": 3, "type": "VEC3"},
      {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC4"}],
    "bufferViews": [{"buffer": 0, "byteLength": 72, "byteStride": 24},
                    {"buffer": 0, "byteOffset": 72, "byteLength": 48}],
    "buffers": [{"byteLength": 120}],
    "extras": {"unknown": [1, 2.5, "three"]}
  })");
}

void append(std::string& bytes, std::size_t word) {
  const auto narrow = static_cast<std::uint32_t>(word);
  bytes.append(reinterpret_cast<const char*>(&narrow), 4);
}

std::string binaryFile(const Json& json, const std::string& buffer) {
  std::string text = json.dump();
  text.append((4 - text.size() % 4) % 4, ' ');
  std::string bytes;
  append(bytes, 0x46546C67);
  append(bytes, 2);
  append(bytes, 12 + 8 + text.size() + 8 + buffer.size());
  append(bytes, text.size());
  append(bytes, 0x4E4F534A);
  bytes += text;
  append(bytes, buffer.size());
  append(bytes, 0x004E4942);
  return bytes + buffer;
}

AffineMap toScene() {
  const Mat3 turn = Eigen::AngleAxisd(0.5 * 3.14159265358979323846, Vec3::UnitZ()).matrix();
  return composed(makeMap(0.5 * Mat3::Identity(), Vec3::Zero()), makeMap(turn, Vec3(0.1, 0, 0)));
}

}  // namespace

class GltfTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    dir_ = std::make_unique<QTemporaryDir>();
    folder_ = dir_->path().toStdString();
    std::filesystem::create_directories(folder_ / "out");
  }

  void base64AndUrisComeBack() {
    for (const std::string bytes : {"", "a", "ab", "abc", "\xff\x01\x80\x7f"}) {
      QCOMPARE(fromBase64(toBase64(bytes)).value(), bytes);
    }
    QCOMPARE(toBase64("any carnal pleas"), std::string("YW55IGNhcm5hbCBwbGVhcw=="));
    QVERIFY(!fromBase64("a*b").has_value());
    QCOMPARE(fromUri(toUri("a b%c/d.bin")), std::string("a b%c/d.bin"));
    QCOMPARE(fromUri("a%20b%zz%"), std::string("a b%zz%"));
  }

  void meshIsDeformedWhereTheSceneHasIt_data() {
    QTest::addColumn<QString>("kind");
    QTest::newRow("binary") << "binary";
    QTest::newRow("text with its data in it") << "text";
    QTest::newRow("text with a buffer beside it") << "file";
  }
  void meshIsDeformedWhereTheSceneHasIt() {
    QFETCH(QString, kind);
    const std::string name = write(kind, model());
    const Project project = test::bentProject();
    const ApplyReport report = applyToFile(project, folder_ / name, folder_ / "out" / name);
    QCOMPARE(report.points, std::int64_t{rowCount});
    const GltfDocument before(folder_ / name);
    const GltfDocument after(folder_ / "out" / name);
    const AffineMap map = toScene();
    Points scene(rowCount, 3);
    for (Eigen::Index i = 0; i < rowCount; ++i) {
      scene.row(i) = applyMap(map, before.rows(0, 3).row(i).transpose());
    }
    const SpaceImage image = SpaceDeformation(project.mesh, project.controls).image(scene);
    for (Eigen::Index i = 0; i < rowCount; ++i) {
      const Vec3 place = applyMap(map, after.rows(0, 3).row(i).transpose());
      QVERIFY((place - image.positions.row(i).transpose()).norm() < 1e-6);
      const Mat3 turn = map.leftCols<3>() / 0.5;
      const Mat3 gradient = turn.transpose() * image.gradients[static_cast<std::size_t>(i)] * turn;
      const Vec3 normal = transported(gradient, before.rows(1, 3).row(i), FieldKind::normal);
      QVERIFY((normal - after.rows(1, 3).row(i).transpose()).norm() < 1e-6);
      const Vec3 tangent = (gradient * before.rows(2, 4).row(i).head<3>().transpose()).normalized();
      QVERIFY((tangent - after.rows(2, 4).row(i).head<3>().transpose()).norm() < 1e-6);
      QCOMPARE(after.rows(2, 4)(i, 3), before.rows(2, 4)(i, 3));
    }
    QVERIFY(after.rows(0, 3).row(0) != before.rows(0, 3).row(0));
    QVERIFY(after.rows(0, 3).row(2) == before.rows(0, 3).row(2));
    QCOMPARE(after.json()["accessors"][0]["max"][0].get<double>(), after.rows(0, 3).col(0).maxCoeff());
    QCOMPARE(after.json()["extras"].dump(), before.json()["extras"].dump());
    QCOMPARE(after.json()["nodes"].dump(), before.json()["nodes"].dump());
  }

  void bytesUnderTwoNumbersMoveOnce() {
    Json json = model();
    for (const int original : {0, 1, 2}) {
      json["accessors"].push_back(json["accessors"][original]);
    }
    json["meshes"][0]["primitives"].push_back(
        Json::parse(R"({"attributes": {"POSITION": 3, "NORMAL": 4, "TANGENT": 5}})"));
    const Project project = test::bentProject();
    applyToFile(project, folder_ / write("binary", model()), folder_ / "out/once.glb");
    const ApplyReport report = applyToFile(project, folder_ / write("binary", json), folder_ / "out/twice.glb");
    QCOMPARE(report.points, std::int64_t{rowCount});
    const GltfDocument once(folder_ / "out/once.glb");
    const GltfDocument twice(folder_ / "out/twice.glb");
    QVERIFY(twice.rows(3, 3) == once.rows(0, 3) && twice.rows(4, 3) == once.rows(1, 3));
    QVERIFY(twice.rows(5, 4) == once.rows(2, 4));
    QCOMPARE(twice.json()["accessors"][3].dump(), once.json()["accessors"][0].dump());
  }

  void unmovedModelKeepsEveryByte() {
    const std::string name = write("binary", model());
    applyToFile(test::restingProject(), folder_ / name, folder_ / "out" / name);
    QVERIFY(readFile(folder_ / name) == readFile(folder_ / "out" / name));
  }

  void changedBufferIsWrittenBesideUnderTheNewName() {
    const std::string name = write("file", model());
    applyToFile(test::bentProject(), folder_ / name, folder_ / "out/bent model.gltf");
    QCOMPARE(test::namesIn(folder_ / "out"), (std::vector<std::string>{"bent model.bin", "bent model.gltf"}));
    const GltfDocument after(folder_ / "out/bent model.gltf");
    QCOMPARE(after.json()["buffers"][0]["uri"].get<std::string>(), std::string("bent%20model.bin"));
  }

  void buffersNeverTakeThePlaceOfOtherFiles() {
    Json json = model();
    json["buffers"].push_back(Json::parse(R"({"byteLength": 4, "uri": "bent.bin"})"));
    json["images"] = Json::parse(R"([{"uri": "bent_1.bin"}])");
    writeFileAtomically(folder_ / "bent.bin", "else");
    writeFileAtomically(folder_ / "out/bent.bin", "mine");
    writeFileAtomically(folder_ / "out/bent_2.bin", "mine");
    const std::string name = write("file", json);
    applyToFile(test::bentProject(), folder_ / name, folder_ / "out/bent.gltf");
    QCOMPARE(readFile(folder_ / "out/bent.bin"), std::string("mine"));
    QCOMPARE(readFile(folder_ / "out/bent_2.bin"), std::string("mine"));
    const std::vector<std::string> names{"bent.bin", "bent.gltf", "bent_2.bin", "bent_3.bin"};
    QCOMPARE(test::namesIn(folder_ / "out"), names);
    applyToFile(test::bentProject(), folder_ / "out/bent.gltf", folder_ / "out/bent.gltf");
    QCOMPARE(test::namesIn(folder_ / "out"), names);
    QCOMPARE(readFile(folder_ / "out/bent.bin"), std::string("mine"));
  }

  void secondApplicationReplacesTheBuffersOfTheFirst() {
    const std::string name = write("file", model());
    for (int times = 0; times < 2; ++times) {
      applyToFile(test::bentProject(), folder_ / name, folder_ / "out/bent.gltf");
      QCOMPARE(test::namesIn(folder_ / "out"), (std::vector<std::string>{"bent.bin", "bent.gltf"}));
    }
  }

  void buffersOfTheSourceStay() {
    const std::string name = write("file", model());
    std::string json = readFile(folder_ / name);
    json.replace(json.find("the%20data"), 10, "the_data");
    writeFileAtomically(folder_ / "the_data.bin", bufferBytes());
    writeFileAtomically(folder_ / name, json);
    writeFileAtomically(folder_ / "the_data.gltf", json);
    applyToFile(test::bentProject(), folder_ / name, folder_ / "the_data.gltf");
    QVERIFY(readFile(folder_ / "the_data.bin") == bufferBytes());
    QVERIFY(GltfDocument(folder_ / "the_data.gltf").rows(0, 3) != GltfDocument(folder_ / name).rows(0, 3));
  }

  void skinnedMeshIsPlacedByNoNode() {
    Json json = model();
    json["skins"] = Json::parse(R"([{"joints": [0]}])");
    json["nodes"][1]["skin"] = 0;
    json["meshes"][0]["primitives"][0]["targets"] = Json::parse(R"([{"POSITION": 0}])");
    const std::string name = write("binary", json);
    const Project project = test::bentProject();
    const ApplyReport report = applyToFile(project, folder_ / name, folder_ / "out" / name);
    QVERIFY(QString::fromStdString(report.remarks.at(0).text).contains("morph targets"));
    const Points before = GltfDocument(folder_ / name).rows(0, 3);
    const Points after = GltfDocument(folder_ / "out" / name).rows(0, 3);
    QVERIFY((after - SpaceDeformation(project.mesh, project.controls).positions(before)).norm() < 1e-6);
  }

  void whatCannotBeRewrittenIsNamed_data() {
    QTest::addColumn<QString>("patch");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* name, const char* patch, const char* said) {
      QTest::newRow(name) << patch << said;
    };
    row("one mesh in two places", R"([{"op":"add","path":"/nodes/-","value":{"mesh":0}}])", "several places");
    row("a circle of nodes", R"([{"op":"add","path":"/nodes/1/children","value":[1]}])", "no tree");
    row("Draco",
        R"([{"op":"add","path":"/meshes/0/primitives/0/extensions","value":{"KHR_draco_mesh_compression":{}}}])",
        "Draco");
    row("quantized", R"([{"op":"replace","path":"/accessors/0/componentType","value":5123}])", "accessor 0");
    row("sparse", R"([{"op":"add","path":"/accessors/0/sparse","value":{}}])", "sparse");
    row("too long", R"([{"op":"replace","path":"/accessors/0/count","value":4}])", "accessor 0 reaches");
    row("huge", R"([{"op":"add","path":"/bufferViews/0/byteOffset","value":18446744073709551615}])",
        "buffer view 0");
    row("a huge offset", R"([{"op":"add","path":"/accessors/0/byteOffset","value":18446744073709551615}])",
        "accessor 0 reaches");
    row("a longer view", R"([{"op":"replace","path":"/bufferViews/1/byteLength","value":999}])",
        "buffer view 1");
    row("no such view", R"([{"op":"replace","path":"/accessors/0/bufferView","value":9}])", "view 9");
    row("no such accessor",
        R"([{"op":"replace","path":"/meshes/0/primitives/0/attributes/POSITION","value":9}])", "accessor 9");
    row("not a list", R"([{"op":"replace","path":"/nodes","value":{}}])", "\"nodes\"");
    row("a flat node", R"([{"op":"replace","path":"/nodes/0/scale","value":[1,0,1]}])", "flattens");
    row("a short scale", R"([{"op":"replace","path":"/nodes/0/scale","value":[1]}])", "scale");
    row("no asset", R"([{"op":"remove","path":"/asset"}])", "asset");
    row("a longer buffer", R"([{"op":"replace","path":"/buffers/0/byteLength","value":999}])", "buffer 0");
    row("a name of a buffer that is none", R"([{"op":"add","path":"/buffers/0/uri","value":5}])", "string");
    row("a buffer that is none", R"([{"op":"replace","path":"/buffers","value":[5]}])", "JSON");
    row("a type that is none", R"([{"op":"replace","path":"/accessors/0/type","value":5}])", "string");
    row("bounds of another size", R"([{"op":"replace","path":"/accessors/0/min","value":[0,0,0,0,0]}])",
        "\"min\" of accessor 0");
    row("bounds that are none", R"([{"op":"replace","path":"/accessors/0/max","value":{"x":1}}])",
        "\"max\" of accessor 0");
    row("rows over other rows", R"([{"op":"replace","path":"/accessors/1/byteOffset","value":8}])",
        "accessor 1 lies over");
    row("normals that are the positions",
        R"([{"op":"replace","path":"/meshes/0/primitives/0/attributes/NORMAL","value":0}])",
        "accessor 0 lies over");
    row("no points", R"([{"op":"replace","path":"/meshes","value":[]},{"op":"remove","path":"/nodes/1/mesh"}])",
        "no points");
  }
  void whatCannotBeRewrittenIsNamed() {
    QFETCH(QString, patch);
    QFETCH(QString, said);
    const std::string name = write("binary", model().patch(Json::parse(patch.toStdString())));
    const QString message = QString::fromStdString(
        test::messageOf([&] { applyToFile(test::bentProject(), folder_ / name, folder_ / "out" / name); }));
    QVERIFY2(message.contains(said) && message.contains(QString::fromStdString(name)), qPrintable(message));
    QVERIFY(test::namesIn(folder_ / "out").empty());
  }

  void damagedFilesAreNamed() {
    const std::string good = binaryFile(model(), bufferBytes());
    for (const std::string& bytes : {good.substr(0, 30), good.substr(0, good.size() - 20), std::string("{"),
                                     std::string(), std::string("[]")}) {
      writeFileAtomically(folder_ / "bad.glb", bytes);
      const std::string message = test::messageOf(
          [&] { applyToFile(test::bentProject(), folder_ / "bad.glb", folder_ / "out/bad.glb"); });
      QVERIFY2(message.find("bad.glb") != std::string::npos, message.c_str());
    }
    QVERIFY(test::namesIn(folder_ / "out").empty());
  }

  void transportBelongsToVtkAlone() {
    const std::string name = write("binary", model());
    QVERIFY_EXCEPTION_THROWN(applyToFile(test::bentProject(), folder_ / name, folder_ / "out" / name,
                                         {false, {parseTransport("NORMAL")}, {}}),
                             InvalidInput);
  }

 private:
  /// Writes a model and returns its name.
  std::string write(const QString& kind, Json json) const {
    if (kind == "binary") {
      writeFileAtomically(folder_ / "a.glb", binaryFile(json, bufferBytes()));
      return "a.glb";
    }
    json["buffers"][0]["uri"] =
        kind == "text" ? "data:application/octet-stream;base64," + toBase64(bufferBytes()) : "the%20data.bin";
    writeFileAtomically(folder_ / "the data.bin", bufferBytes());
    writeFileAtomically(folder_ / "a.gltf", json.dump());
    return "a.gltf";
  }

  std::unique_ptr<QTemporaryDir> dir_;
  std::filesystem::path folder_;
};

const test::Registration<GltfTest> registration;

}  // namespace pbffd

#include "gltf_test.moc"
