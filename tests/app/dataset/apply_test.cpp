#include "app/dataset/apply.h"
#include "app/dataset/field_transport.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/ffd/deform/space_deformation.h"
#include "core/mesh/io/mesh_io.h"
#include "tests/app/dataset/fixture.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <Eigen/Geometry>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>

Q_DECLARE_METATYPE(pbffd::test::XmlMode)

namespace pbffd {
namespace {

Points deformed(const Project& project, const Points& places, ReachRule rule = ReachRule::all) {
  return SpaceDeformation(project.mesh, project.controls, rule).positions(places);
}

SpaceImage imageOf(const Project& project, const Points& places) {
  return SpaceDeformation(project.mesh, project.controls, ReachRule::all).image(places);
}

Points inSinglePrecision(const Points& points) {
  return points.cast<float>().cast<double>();
}

}  // namespace

class ApplyTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    dir_ = std::make_unique<QTemporaryDir>();
    folder_ = dir_->path().toStdString();
  }

  void everyXmlModeKeepsItsSettingsAndArrays_data() {
    using test::XmlMode;
    QTest::addColumn<XmlMode>("mode");
    QTest::addColumn<bool>("isDouble");
    QTest::addColumn<QString>("mark");
    QTest::newRow("raw, double") << XmlMode::raw << true << "encoding=\"raw\"";
    QTest::newRow("raw, single") << XmlMode::raw << false << "header_type=\"UInt64\"";
    QTest::newRow("raw, other byte order") << XmlMode::rawBigEndian << true << "BigEndian";
    QTest::newRow("compressed") << XmlMode::rawCompressed << true << "vtkZLibDataCompressor";
    QTest::newRow("base64") << XmlMode::base64 << false << "encoding=\"base64\"";
    QTest::newRow("text") << XmlMode::ascii << false << "format=\"ascii\"";
    QTest::newRow("inline") << XmlMode::binary << true << "format=\"binary\"";
  }
  void everyXmlModeKeepsItsSettingsAndArrays() {
    QFETCH(test::XmlMode, mode);
    QFETCH(bool, isDouble);
    QFETCH(QString, mark);
    const auto grid = test::hexahedra(9, isDouble);
    test::writeXml(folder_ / "a.vtu", *grid, mode);
    const Project project = test::bentProject();
    const ApplyReport report = applyToFile(project, folder_ / "a.vtu", folder_ / "b.vtu");
    QCOMPARE(report.points, std::int64_t{1000});
    const auto result = test::readBack(folder_ / "b.vtu");
    const Points expected = deformed(project, test::pointsOf(*grid));
    QCOMPARE(result->GetPoints()->GetDataType(), isDouble ? VTK_DOUBLE : VTK_FLOAT);
    QVERIFY(test::pointsOf(*result) == (isDouble ? expected : inSinglePrecision(expected)));
    QVERIFY(test::pointsOf(*result) != test::pointsOf(*grid));
    for (const char* name : {"velocity", "Normals"}) {
      QVERIFY(test::pointArray(*result, name) == test::pointArray(*grid, name));
    }
    QVERIFY(test::cellArray(*result, "flux") == test::cellArray(*grid, "flux"));
    QCOMPARE(result->GetPointData()->GetArray("id")->GetTuple1(999), 7.0 * 999);
    QCOMPARE(result->GetNumberOfCells(), vtkIdType{729});
    QVERIFY(QByteArray::fromStdString(readFile(folder_ / "b.vtu")).contains(mark.toUtf8()));
    QCOMPARE(test::namesIn(folder_), (std::vector<std::string>{"a.vtu", "b.vtu"}));
  }

  void streamedFileDiffersInItsPositionsAlone() {
    const auto grid = test::hexahedra(9, true);
    test::writeXml(folder_ / "a.vtu", *grid, test::XmlMode::raw);
    applyToFile(test::bentProject(), folder_ / "a.vtu", folder_ / "b.vtu");
    const std::string before = readFile(folder_ / "a.vtu");
    const std::string after = readFile(folder_ / "b.vtu");
    const auto tail = [](const std::string& bytes) { return bytes.substr(bytes.find("<AppendedData")); };
    QCOMPARE(tail(before).size(), tail(after).size());
    std::size_t first = 0;
    std::size_t last = 0;
    for (std::size_t i = 0; i < tail(before).size(); ++i) {
      if (tail(before)[i] != tail(after)[i]) {
        first = first == 0 ? i : first;
        last = i;
      }
    }
    QVERIFY(last - first < 1000 * 24);
    // The lengths that the header notes are those of the new positions.
    double least = 0.0;
    double largest = 0.0;
    readRange(after, least, largest);
    const Points points = test::pointsOf(*test::readBack(folder_ / "b.vtu"));
    QVERIFY(std::abs(points.rowwise().norm().minCoeff() - least) < 1e-12);
    QVERIFY(std::abs(points.rowwise().norm().maxCoeff() - largest) < 1e-12);
  }

  void fileCanBeDeformedInPlace() {
    const auto grid = test::hexahedra(4, true);
    test::writeXml(folder_ / "a.vtu", *grid, test::XmlMode::raw);
    const Project project = test::bentProject();
    applyToFile(project, folder_ / "a.vtu", folder_ / "a.vtu");
    QVERIFY(test::pointsOf(*test::readBack(folder_ / "a.vtu")) == deformed(project, test::pointsOf(*grid)));
  }

  void legacyFilesKeepTheirVersionNumbersAndTitle_data() {
    QTest::addColumn<bool>("isBinary");
    QTest::addColumn<int>("version");
    QTest::newRow("text 4.2") << false << 42;
    QTest::newRow("binary 4.2") << true << 42;
    QTest::newRow("text 5.1") << false << 51;
    QTest::newRow("binary 5.1") << true << 51;
  }
  void legacyFilesKeepTheirVersionNumbersAndTitle() {
    QFETCH(bool, isBinary);
    QFETCH(int, version);
    const auto grid = test::hexahedra(5, false);
    test::writeLegacy(folder_ / "a.vtk", *grid, isBinary, version);
    const Project project = test::bentProject();
    const ApplyReport report = applyToFile(project, folder_ / "a.vtk", folder_ / "b.vtk");
    const bool isTold = std::any_of(report.remarks.begin(), report.remarks.end(), [](const Remark& remark) {
      return remark.text.find("legacy file of text") != std::string::npos;
    });
    QCOMPARE(isTold, !isBinary);
    const auto lines = [&](const char* name) {
      return QByteArray::fromStdString(readFile(folder_ / name)).split('\n').mid(0, 4);
    };
    QList<QByteArray> expected = lines("a.vtk");
    expected[2] = "BINARY";
    QCOMPARE(lines("b.vtk"), expected);
    const auto result = test::readBack(folder_ / "b.vtk");
    const auto source = test::readBack(folder_ / "a.vtk");
    QVERIFY(test::pointsOf(*result) == inSinglePrecision(deformed(project, test::pointsOf(*source))));
    QCOMPARE(test::pointArray(*result, "velocity").rows(), Eigen::Index{216});
    for (const char* name : {"velocity", "Normals"}) {
      QVERIFY(test::pointArray(*result, name) == test::pointArray(*source, name));
    }
    QCOMPARE(test::cellArray(*result, "flux").rows(), Eigen::Index{125});
    QVERIFY(test::cellArray(*result, "flux") == test::cellArray(*source, "flux"));
  }

  void legacyTextKeepsEveryDigit() {
    writeFileAtomically(
        folder_ / "a.vtk",
        "# vtk DataFile Version 3.0\nprecise\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 2 double\n"
        "1000.0625 5.123456789012345 7\n0.9 0.1 0\nCELLS 1 3\n2 0 1\nCELL_TYPES 1\n3\n"
        "POINT_DATA 2\nSCALARS heat double\nLOOKUP_TABLE default\n0.12345678901234567 1e300\n");
    const Project project = test::bentProject();
    applyToFile(project, folder_ / "a.vtk", folder_ / "b.vtk");
    const auto result = test::readBack(folder_ / "b.vtk");
    const Points points = test::pointsOf(*result);
    QVERIFY(points == deformed(project, test::pointsOf(*test::readBack(folder_ / "a.vtk"))));
    QVERIFY(points(0, 0) == 1000.0625 && points(0, 1) == 5.123456789012345 && points(1, 0) != 0.9);
    vtkDataArray* heat = result->GetPointData()->GetArray("heat");
    QVERIFY(heat != nullptr);
    QVERIFY(heat->GetTuple1(0) == 0.12345678901234567 && heat->GetTuple1(1) == 1e300);
  }

  void fieldsTurnOnRequest_data() {
    QTest::addColumn<test::XmlMode>("mode");
    QTest::newRow("streamed") << test::XmlMode::raw;
    QTest::newRow("by VTK") << test::XmlMode::binary;
  }
  void fieldsTurnOnRequest() {
    QFETCH(test::XmlMode, mode);
    const auto grid = test::hexahedra(6, true);
    test::writeXml(folder_ / "a.vtu", *grid, mode);
    const Project project = test::bentProject();
    const ApplyReport report =
        applyToFile(project, folder_ / "a.vtu", folder_ / "b.vtu",
                    {false, {parseTransport("velocity"), parseTransport("Normals")}, {}});
    QVERIFY(report.remarks.empty());
    const auto result = test::readBack(folder_ / "b.vtu");
    const SpaceImage image = imageOf(project, test::pointsOf(*grid));
    QVERIFY(test::pointsOf(*result) == image.positions);
    const Points velocity = test::pointArray(*grid, "velocity");
    const Points normals = test::pointArray(*grid, "Normals");
    for (Eigen::Index i = 0; i < velocity.rows(); ++i) {
      const Mat3& gradient = image.gradients[static_cast<std::size_t>(i)];
      const Vec3 moved = gradient * velocity.row(i).transpose();
      QVERIFY((moved - test::pointArray(*result, "velocity").row(i).transpose()).norm() < 1e-6);
      const Vec3 turned = transported(gradient, normals.row(i), FieldKind::normal);
      QVERIFY((turned - test::pointArray(*result, "Normals").row(i).transpose()).norm() < 1e-6);
    }
  }

  void cellFieldsTurnAtTheCellsCenters_data() {
    QTest::addColumn<test::XmlMode>("mode");
    QTest::newRow("raw") << test::XmlMode::raw;
    QTest::newRow("by VTK") << test::XmlMode::ascii;
  }
  void cellFieldsTurnAtTheCellsCenters() {
    QFETCH(test::XmlMode, mode);
    const auto grid = test::hexahedra(4, true);
    test::writeXml(folder_ / "a.vtu", *grid, mode);
    const Project project = test::bentProject();
    applyToFile(project, folder_ / "a.vtu", folder_ / "b.vtu", {false, {parseTransport("flux:vector")}, {}});
    Points center(1, 3);
    center << -0.75, -0.75, -0.75;
    const Vec3 expected =
        imageOf(project, center).gradients[0] * test::cellArray(*grid, "flux").row(0).transpose();
    const Vec3 flux = test::cellArray(*test::readBack(folder_ / "b.vtu"), "flux").row(0);
    QVERIFY((flux - expected).norm() < 1e-9);
  }

  void keptNormalsAreMentioned() {
    test::writeXml(folder_ / "a.vtu", *test::hexahedra(3, true), test::XmlMode::raw);
    const ApplyReport report = applyToFile(test::bentProject(), folder_ / "a.vtu", folder_ / "b.vtu");
    QCOMPARE(report.remarks.size(), std::size_t{1});
    QVERIFY(QString::fromStdString(report.remarks[0].text).contains("'Normals'"));
    QCOMPARE(report.remarks[0].option, std::string("--transport Normals"));
    QVERIFY(withOption(report.remarks[0]).ends_with("(--transport Normals)."));
  }

  void fileThatStaysIsMentioned() {
    const std::string far = "v 50 50 50\nv 51 50 50\n";
    writeFileAtomically(folder_ / "far.obj", far);
    const auto remarkOf = [&](const Project& project) {
      const ApplyReport report = applyToFile(project, folder_ / "far.obj", folder_ / "b.obj");
      return QString::fromStdString(report.remarks.size() == 1 ? withOption(report.remarks[0]) : std::string());
    };
    QVERIFY(remarkOf(test::bentProject()).contains("--align similarity"));
    QVERIFY(remarkOf(test::restingProject()).contains("at rest"));
    QCOMPARE(readFile(folder_ / "b.obj"), far);
  }

  void volumeCellsTakeAllAndSurfacesDoNot() {
    const Project project = test::bentProject(Reach::connected);
    const auto grid = test::hexahedra(9, true);
    test::writeXml(folder_ / "a.vtu", *grid, test::XmlMode::raw);
    const ApplyReport report = applyToFile(project, folder_ / "a.vtu", folder_ / "b.vtu");
    QVERIFY(QString::fromStdString(report.remarks.at(0).text).contains("volume cells"));
    QVERIFY(test::pointsOf(*test::readBack(folder_ / "b.vtu")) == deformed(project, test::pointsOf(*grid)));

    const auto surface = test::polygons();
    for (const test::XmlMode mode : {test::XmlMode::raw, test::XmlMode::rawCompressed}) {
      test::writeXml(folder_ / "a.vtp", *surface, mode);
      QVERIFY(applyToFile(project, folder_ / "a.vtp", folder_ / "b.vtp").remarks.empty());
      QVERIFY(test::pointsOf(*test::readBack(folder_ / "b.vtp")) ==
              inSinglePrecision(deformed(project, test::pointsOf(*surface), ReachRule::asStored)));
    }
  }

  void meshesAndPointCloudsFollow() {
    const Project project = test::bentProject();
    const std::string cloud = "# a cloud\nv 0.9 0.1 0\nv 5 5 5\nv 1 0 0.125\n";
    writeFileAtomically(folder_ / "a.obj", cloud);
    applyToFile(project, folder_ / "a.obj", folder_ / "b.obj");
    const Mesh before = readMesh(folder_ / "a.obj");
    const Mesh after = readMesh(folder_ / "b.obj");
    QVERIFY(after.positions == deformed(project, before.positions));
    const std::string bytes = readFile(folder_ / "b.obj");
    QVERIFY(bytes.starts_with("# a cloud\nv ") && bytes.find("\nv 5 5 5\n") != std::string::npos);
    applyToFile(test::restingProject(), folder_ / "a.obj", folder_ / "c.obj");
    QCOMPARE(readFile(folder_ / "c.obj"), cloud);
  }

  void alignedFileIsDeformedWhereItLies() {
    const Project project = test::bentProject();
    Mesh other = project.mesh->mesh();
    const Mat3 turn = Eigen::AngleAxisd(0.3, Vec3::UnitX()).matrix();
    const AffineMap place = makeMap(2.5 * turn, Vec3(10, 20, 30));
    for (Eigen::Index i = 0; i < other.positions.rows(); ++i) {
      other.positions.row(i) = applyMap(place, other.positions.row(i).transpose());
    }
    writeFileAtomically(folder_ / "a.ply", encodeMesh(other, {other.positions, {}}, MeshFormat::ply));
    ApplyOptions options;
    options.align = true;
    const ApplyReport report = applyToFile(project, folder_ / "a.ply", folder_ / "b.ply", options);
    QVERIFY(QString::fromStdString(report.remarks.at(0).text).startsWith("Aligned"));
    // A sphere fits in any turn, so the size and the place alone are certain: what moves is as large as it.
    const double largest = (readMesh(folder_ / "b.ply").positions - readMesh(folder_ / "a.ply").positions)
                               .rowwise()
                               .norm()
                               .maxCoeff();
    const double atRest =
        (deformed(project, project.mesh->positions()) - project.mesh->positions()).rowwise().norm().maxCoeff();
    QVERIFY(std::abs(largest - 2.5 * atRest) < 0.05 * largest);
  }

 private:
  static void readRange(const std::string& bytes, double& least, double& largest) {
    const std::size_t points = bytes.find("<Points>");
    const std::size_t low = bytes.find("RangeMin=\"", points);
    const std::size_t high = bytes.find("RangeMax=\"", points);
    least = std::stod(bytes.substr(low + 10));
    largest = std::stod(bytes.substr(high + 10));
  }

  std::unique_ptr<QTemporaryDir> dir_;
  std::filesystem::path folder_;
};

const test::Registration<ApplyTest> registration;

}  // namespace pbffd

#include "apply_test.moc"
