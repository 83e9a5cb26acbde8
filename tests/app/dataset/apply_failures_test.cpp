#include "app/dataset/apply.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/mesh/io/mesh_io.h"
#include "tests/app/dataset/fixture.h"
#include "tests/support/test_main.h"

#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <QTemporaryDir>
#include <QtTest>

#include <sys/resource.h>

#include <csignal>

Q_DECLARE_METATYPE(pbffd::test::XmlMode)

namespace pbffd {
namespace {

/// While it lives, files cannot grow beyond so many bytes, as on a disk that is full.
class FileLimit {
 public:
  explicit FileLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    handler_ = ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, handler_);
  }
  FileLimit(const FileLimit&) = delete;
  FileLimit& operator=(const FileLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = SIG_DFL;
};

}  // namespace

/// What cannot be done is told with the file's name, and leaves what was there.
class ApplyFailuresTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    dir_ = std::make_unique<QTemporaryDir>();
    folder_ = dir_->path().toStdString();
  }

  void badInputIsNamedAndLeavesNothing_data() {
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("target");
    QTest::addColumn<QString>("transport");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* name, const char* source, const char* target, const char* transport,
                        const char* said) { QTest::newRow(name) << source << target << transport << said; };
    row("missing", "none.vtu", "b.vtu", "", "none.vtu: No such file");
    row("no points", "empty.vtu", "b.vtu", "", "empty.vtu: it has no points");
    row("no points in a cloud", "empty.obj", "b.obj", "", "empty.obj");
    row("cut short", "short.vtu", "b.vtu", "", "short.vtu");
    row("cut short in an array that is copied", "short.vtp", "b.vtp", "", "'offsets' begins at byte");
    row("cut short, compressed", "short_zip.vtu", "b.vtu", "", "short_zip.vtu");
    row("unreadable array", "broken.vtu", "b.vtu", "", "broken.vtu");
    row("cut short, legacy", "short.vtk", "b.vtk", "", "short.vtk: Error reading");
    row("points of no known type", "typeless.vtu", "b.vtu", "", "typeless.vtu");
    row("more points than bytes", "many.vtu", "b.vtu", "", "many.vtu: its header promises");
    row("fewer cells than none", "negative.vtu", "b.vtu", "",
        "negative.vtu: its first piece says NumberOfCells");
    row("fewer components than none", "components.vtu", "b.vtu", "", "components.vtu: the array '");
    row("fewer components than none, compressed", "components_zip.vtu", "b.vtu", "",
        "components_zip.vtu: an array");
    row("a malformed header", "malformed.vtu", "b.vtu", "", "malformed.vtu");
    row("not VTK", "words.vtu", "b.vtu", "", "words.vtu");
    row("not legacy VTK", "words.vtk", "b.vtk", "", "words.vtk");
    row("an image", "image.vtk", "b.vtk", "", "STRUCTURED_POINTS");
    row("another format", "good.vtu", "b.obj", "", "b.obj");
    row("unknown format", "words.txt", "b.txt", "", ".vtu");
    row("no such array", "good.vtu", "b.vtu", "vorticity", "'vorticity' of");
    row("an array of numbers", "good.vtu", "b.vtu", "id", "'id' of");
    row("no folder", "good.vtu", "none/b.vtu", "", "none/b.vtu");
    row("an array of a mesh", "good.obj", "b.obj", "velocity", "'velocity' of");
  }
  void badInputIsNamedAndLeavesNothing() {
    QFETCH(QString, source);
    QFETCH(QString, target);
    QFETCH(QString, transport);
    QFETCH(QString, said);
    makeBadFiles();
    const std::vector<std::string> before = test::namesIn(folder_);
    ApplyOptions options;
    if (!transport.isEmpty()) {
      options.transports.push_back(parseTransport(transport.toStdString()));
    }
    const QString message = QString::fromStdString(test::messageOf([&] {
      applyToFile(test::bentProject(), folder_ / source.toStdString(), folder_ / target.toStdString(), options);
    }));
    QVERIFY2(message.contains(said), qPrintable(message));
    QCOMPARE(test::namesIn(folder_), before);
  }

  void outputThatIsNoRegularFileIsNamedAndStays() {
    std::filesystem::create_symlink("/dev/full", folder_ / "b.vtu");
    test::writeXml(folder_ / "a.vtu", *test::hexahedra(3, true), test::XmlMode::raw);
    const std::string message =
        test::messageOf([&] { applyToFile(test::bentProject(), folder_ / "a.vtu", folder_ / "b.vtu"); });
    QVERIFY2(QString::fromStdString(message).contains("b.vtu"), message.c_str());
    QVERIFY(std::filesystem::is_symlink(folder_ / "b.vtu"));
    QCOMPARE(test::namesIn(folder_), (std::vector<std::string>{"a.vtu", "b.vtu"}));
  }

  void fullDiskIsToldAndLeavesNothing_data() {
    using test::XmlMode;
    QTest::addColumn<XmlMode>("mode");
    QTest::addColumn<bool>("isDouble");
    QTest::addColumn<QString>("mark");
    QTest::newRow("raw") << XmlMode::raw << true << "";
    QTest::newRow("raw, other byte order") << XmlMode::rawBigEndian << true << "";
    QTest::newRow("compressed") << XmlMode::rawCompressed << true << "";
    QTest::newRow("base64") << XmlMode::base64 << false << "";
    QTest::newRow("text") << XmlMode::ascii << false << "";
    QTest::newRow("inline") << XmlMode::binary << true << "";
    QTest::newRow("legacy, text") << test::XmlMode::raw << false << "42";
    QTest::newRow("legacy, binary") << test::XmlMode::raw << true << "51";
    QTest::newRow("mesh") << test::XmlMode::raw << true << "obj";
  }
  void fullDiskIsToldAndLeavesNothing() {
    QFETCH(test::XmlMode, mode);
    QFETCH(bool, isDouble);
    QFETCH(QString, mark);
    const auto grid = test::hexahedra(12, isDouble);
    const int version = mark.toInt();
    const std::string ending = version > 0 ? ".vtk" : mark == "obj" ? ".obj" : ".vtu";
    if (version > 0) {
      test::writeLegacy(folder_ / "a.vtk", *grid, isDouble, version);
    } else if (mark == "obj") {
      const Project project = test::bentProject();
      const Mesh& mesh = project.mesh->mesh();
      writeFileAtomically(folder_ / "a.obj", encodeMesh(mesh, {mesh.positions, {}}, MeshFormat::obj));
    } else {
      test::writeXml(folder_ / "a.vtu", *grid, mode);
    }
    writeFileAtomically(folder_ / ("b" + ending), "old");
    const std::vector<std::string> before = test::namesIn(folder_);
    const std::string message = test::messageOf([&] {
      const FileLimit limit(10000);
      applyToFile(test::bentProject(), folder_ / ("a" + ending), folder_ / ("b" + ending));
    });
    QVERIFY2(QString::fromStdString(message).startsWith(
                 QString::fromStdString("Could not write " + (folder_ / ("b" + ending)).string() + ": ")),
             message.c_str());
    QVERIFY2(message.find("could not do it") == std::string::npos, message.c_str());
    QCOMPARE(readFile(folder_ / ("b" + ending)), std::string("old"));
    QCOMPARE(test::namesIn(folder_), before);
  }

  void cancelledWorkLeavesNothing_data() {
    QTest::addColumn<test::XmlMode>("mode");
    QTest::newRow("streamed") << test::XmlMode::raw;
    QTest::newRow("by VTK") << test::XmlMode::binary;
  }
  void cancelledWorkLeavesNothing() {
    QFETCH(test::XmlMode, mode);
    test::writeXml(folder_ / "a.vtu", *test::hexahedra(9, true), mode);
    const Progress progress([](std::string_view, double) {});
    progress.cancel();
    QVERIFY_EXCEPTION_THROWN(
        applyToFile(test::bentProject(), folder_ / "a.vtu", folder_ / "b.vtu", {}, progress), Cancelled);
    QCOMPARE(test::namesIn(folder_), (std::vector<std::string>{"a.vtu"}));
  }

 private:
  void makeBadFiles() const {
    const auto put = [&](const char* name, const std::string& bytes) {
      writeFileAtomically(folder_ / name, bytes);
    };
    const auto grid = test::hexahedra(5, true);
    test::writeXml(folder_ / "good.vtu", *grid, test::XmlMode::raw);
    const std::string good = readFile(folder_ / "good.vtu");
    std::string many = good;
    many.replace(many.find("NumberOfPoints=\"216\""), 20, "NumberOfPoints=\"9223372036854775807\"");
    put("many.vtu", many);
    std::string negative = good;
    negative.replace(negative.find("NumberOfCells=\"125\""), 19, "NumberOfCells=\"-25\"");
    put("negative.vtu", negative);
    put("components.vtu", withNegativeComponents(good));
    std::string malformed = good;
    malformed.replace(malformed.find("Name=\"types\""), 12, "Name=types  ");
    put("malformed.vtu", malformed);
    put("short.vtu", good.substr(0, good.size() / 2));
    test::writeXml(folder_ / "good.vtp", *test::polygons(), test::XmlMode::raw);
    const std::string surface = readFile(folder_ / "good.vtp");
    put("short.vtp", surface.substr(0, surface.rfind("</AppendedData>") - 8));
    test::writeXml(folder_ / "good_zip.vtu", *grid, test::XmlMode::rawCompressed);
    const std::string packed = readFile(folder_ / "good_zip.vtu");
    put("components_zip.vtu", withNegativeComponents(packed));
    put("short_zip.vtu", packed.substr(0, packed.size() / 2));
    test::writeLegacy(folder_ / "good.vtk", *grid, true, 51);
    const std::string legacy = readFile(folder_ / "good.vtk");
    put("short.vtk", legacy.substr(0, legacy.size() * 9 / 10));
    std::string typeless = good;
    typeless.replace(typeless.find("\"Float64\"", typeless.find("<Points>")), 9, "\"Float9\" ");
    put("typeless.vtu", typeless);
    test::writeXml(folder_ / "text.vtu", *grid, test::XmlMode::ascii);
    std::string broken = readFile(folder_ / "text.vtu");
    broken.replace(broken.find("NumberOfPoints=\"216\""), 20, "NumberOfPoints=\"999\"");
    put("broken.vtu", broken);
    const vtkSmartPointer<vtkUnstructuredGrid> nothing = vtkSmartPointer<vtkUnstructuredGrid>::New();
    test::writeXml(folder_ / "empty.vtu", *nothing, test::XmlMode::raw);
    put("empty.obj", "# nothing\n");
    put("good.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    put("words.vtu", "These are only words.\n");
    put("words.vtk", "These are only words.\n");
    put("words.txt", "These are only words.\n");
    put("image.vtk",
        "# vtk DataFile Version 3.0\nan image\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\n"
        "ORIGIN 0 0 0\nSPACING 1 1 1\n");
  }

  static std::string withNegativeComponents(std::string bytes) {
    return bytes.replace(bytes.find("NumberOfComponents=\"3\""), 22, "NumberOfComponents=\"-3\"");
  }

  std::unique_ptr<QTemporaryDir> dir_;
  std::filesystem::path folder_;
};

const test::Registration<ApplyFailuresTest> registration;

}  // namespace pbffd

#include "apply_failures_test.moc"
