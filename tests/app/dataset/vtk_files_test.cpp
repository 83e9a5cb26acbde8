#include "app/dataset/apply.h"
#include "app/dataset/vtk_settings.h"
#include "core/base/file.h"
#include "tests/app/dataset/fixture.h"
#include "tests/support/test_main.h"

#include <vtkLogger.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkScalarsToColors.h>
#include <vtkUnstructuredGrid.h>

#include <QTemporaryDir>
#include <QtTest>

namespace pbffd {

/// What VTK's files may hold beside what VTK writes by default.
class VtkFilesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    dir_ = std::make_unique<QTemporaryDir>();
    folder_ = dir_->path().toStdString();
  }

  void headerMayBeInSingleQuotes() {
    const auto grid = test::hexahedra(4, true);
    test::writeXml(folder_ / "a.vtu", *grid, test::XmlMode::raw);
    applyToFile(test::bentProject(), folder_ / "a.vtu", folder_ / "b.vtu");
    std::string bytes = readFile(folder_ / "a.vtu");
    const std::size_t end = bytes.find("<AppendedData");
    std::replace(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(end), '"', '\'');
    writeFileAtomically(folder_ / "single.vtu", bytes);
    applyToFile(test::bentProject(), folder_ / "single.vtu", folder_ / "c.vtu");
    std::string expected = readFile(folder_ / "b.vtu");
    const std::size_t headerEnd = expected.find("<AppendedData");
    std::replace(expected.begin(), expected.begin() + static_cast<std::ptrdiff_t>(headerEnd), '"', '\'');
    QVERIFY(readFile(folder_ / "c.vtu") == expected);
    QVERIFY(test::pointsOf(*test::readBack(folder_ / "c.vtu")) ==
            test::pointsOf(*test::readBack(folder_ / "b.vtu")));
  }

  void settingsAreThoseOfThePiecesArrays() {
    test::writeXml(folder_ / "a.vtu", *test::hexahedra(4, true), test::XmlMode::raw);
    std::string bytes = readFile(folder_ / "a.vtu");
    const std::string ofFile =
        "<FieldData><DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">0.5"
        "</DataArray></FieldData>\n";
    bytes.insert(bytes.find("<Piece"), ofFile);
    writeFileAtomically(folder_ / "timed.vtu", bytes);
    const XmlSettings settings = xmlSettingsOf(folder_ / "timed.vtu");
    QCOMPARE(settings.format, std::string("appended"));
    QCOMPARE(settings.encoding, std::string("raw"));
    QCOMPARE(settings.headerType, std::string("UInt64"));
    applyToFile(test::bentProject(), folder_ / "timed.vtu", folder_ / "b.vtu");
    QVERIFY(readFile(folder_ / "b.vtu").find(ofFile) != std::string::npos);
  }

  void legacyFileKeepsItsAttributesAndAllOtherArrays() {
    writeFileAtomically(
        folder_ / "a.vtk",
        "# vtk DataFile Version 3.0\nattributes\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n"
        "0.9 0 0\n1 0 0\n0 1 0.2\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\nPOINT_DATA 3\n"
        "SCALARS heat float 1\nLOOKUP_TABLE mine\n1 2 3\nLOOKUP_TABLE mine 2\n0 0 0 1\n1 0.5 1 1\n"
        "SCALARS second int 1\nLOOKUP_TABLE default\n7 8 9\nVECTORS v float\n1 0 0 0 1 0 0 0 1\n"
        "NORMALS n float\n0 0 1 0 0 1 0 0 1\nTEXTURE_COORDINATES tc 2 float\n0 0 1 0 0 1\n"
        "TENSORS t float\n1 0 0 0 1 0 0 0 1\n1 0 0 0 1 0 0 0 1\n1 0 0 0 1 0 0 0 1\n"
        "FIELD FieldData 1\nextra 2 3 double\n1 2 3 4 5 6\n");
    const ApplyReport report = applyToFile(test::bentProject(), folder_ / "a.vtk", folder_ / "b.vtk");
    QVERIFY(report.hasMoved);
    const auto result = test::readBack(folder_ / "b.vtk");
    vtkPointData& data = *result->GetPointData();
    QCOMPARE(nameOf(data.GetScalars()), std::string("heat"));
    QCOMPARE(nameOf(data.GetVectors()), std::string("v"));
    QCOMPARE(nameOf(data.GetNormals()), std::string("n"));
    QCOMPARE(nameOf(data.GetTCoords()), std::string("tc"));
    QCOMPARE(nameOf(data.GetTensors()), std::string("t"));
    QVERIFY(data.GetScalars()->GetLookupTable() != nullptr);
    QVERIFY(data.GetArray("second") != nullptr && data.GetArray("second")->GetTuple1(2) == 9.0);
    QVERIFY(data.GetArray("extra") != nullptr && data.GetArray("extra")->GetComponent(2, 1) == 6.0);
  }

  void vtkSpeaksAfterwardsAsItDidBefore() {
    const auto before = vtkLogger::GetCurrentVerbosityCutoff();
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_ERROR);
    test::writeXml(folder_ / "a.vtu", *test::hexahedra(3, true), test::XmlMode::binary);
    applyToFile(test::bentProject(), folder_ / "a.vtu", folder_ / "b.vtu");
    const auto after = vtkLogger::GetCurrentVerbosityCutoff();
    vtkLogger::SetStderrVerbosity(before);
    QCOMPARE(after, vtkLogger::VERBOSITY_ERROR);
  }

 private:
  static std::string nameOf(vtkDataArray* array) {
    return array == nullptr || array->GetName() == nullptr ? std::string() : array->GetName();
  }

  std::unique_ptr<QTemporaryDir> dir_;
  std::filesystem::path folder_;
};

const test::Registration<VtkFilesTest> registration;

}  // namespace pbffd

#include "vtk_files_test.moc"
