#include "tests/app/dataset/fixture.h"

#include "tests/support/shapes.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkPolyDataWriter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace pbffd::test {
namespace {

Project projectOn(Reach reach, bool isBent) {
  Project project;
  project.mesh = std::make_shared<const RestMesh>(sphere(24, 36));
  project.controls.master = {};
  PointId id = 1;
  for (const Vec3& center : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, 0, 0)}) {
    ControlPoint point;
    point.id = id++;
    point.reach = reach;
    point.rest = {center, 1.1 * Mat3::Identity()};
    point.pose = point.rest;
    if (isBent && point.id % 2 == 1) {
      point.pose.center += Vec3(0.3, 0.2, -0.1);
      point.pose.axes = Eigen::AngleAxisd(0.4, Vec3(1, 2, 0).normalized()) * point.pose.axes;
    }
    project.controls.levels[0].append(point);
  }
  project.nextId = id;
  return project;
}

/// Three numbers a row that say where the row is.
template <class Array>
vtkSmartPointer<Array> vectors(const char* name, vtkIdType rows) {
  const auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(rows);
  for (vtkIdType i = 0; i < rows; ++i) {
    const auto t = static_cast<double>(i);
    array->SetTuple3(i, std::sin(t), std::cos(2.0 * t), 0.25 + 0.5 * std::sin(3.0 * t));
  }
  return array;
}

vtkSmartPointer<vtkIntArray> numbers(const char* name, vtkIdType rows) {
  const auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(name);
  for (vtkIdType i = 0; i < rows; ++i) {
    array->InsertNextValue(static_cast<int>(7 * i));
  }
  return array;
}

template <class Writer>
void writeXmlWith(const std::filesystem::path& path, vtkPointSet& data, XmlMode mode) {
  const vtkNew<Writer> writer;
  writer->SetInputData(&data);
  writer->SetFileName(path.c_str());
  writer->SetCompressorType(mode == XmlMode::rawCompressed ? vtkXMLWriter::ZLIB : vtkXMLWriter::NONE);
  writer->SetDataMode(mode == XmlMode::ascii    ? vtkXMLWriter::Ascii
                      : mode == XmlMode::binary ? vtkXMLWriter::Binary
                                                : vtkXMLWriter::Appended);
  writer->SetEncodeAppendedData(mode == XmlMode::base64 ? 1 : 0);
  writer->SetHeaderType(mode == XmlMode::raw ? vtkXMLWriter::UInt64 : vtkXMLWriter::UInt32);
  if (mode == XmlMode::rawBigEndian) {
    writer->SetByteOrderToBigEndian();
  }
  writer->Write();
}

template <class Writer>
void writeLegacyWith(const std::filesystem::path& path, vtkPointSet& data, bool isBinary, int version) {
  const vtkNew<Writer> writer;
  writer->SetInputData(&data);
  writer->SetFileName(path.c_str());
  writer->SetFileType(isBinary ? VTK_BINARY : VTK_ASCII);
  writer->SetFileVersion(version);
  writer->SetHeader("a title of its own");
  writer->Write();
}

template <class Reader>
vtkSmartPointer<vtkPointSet> readWith(const std::filesystem::path& path) {
  const vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return vtkSmartPointer<vtkPointSet>(reader->GetOutput());
}

template <class Reader>
vtkSmartPointer<vtkPointSet> readLegacyWith(const std::filesystem::path& path) {
  const vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllFieldsOn();
  reader->Update();
  return vtkSmartPointer<vtkPointSet>(reader->GetOutput());
}

Points rowsOfArray(vtkDataArray* array) {
  Points rows(array == nullptr ? 0 : array->GetNumberOfTuples(), 3);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    Vec3 row;
    array->GetTuple(i, row.data());
    rows.row(i) = row;
  }
  return rows;
}

}  // namespace

Project bentProject(Reach reach) {
  return projectOn(reach, true);
}

Project restingProject() {
  return projectOn(Reach::all, false);
}

vtkSmartPointer<vtkUnstructuredGrid> hexahedra(int n, bool isDouble) {
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const vtkNew<vtkPoints> points;
  points->SetDataType(isDouble ? VTK_DOUBLE : VTK_FLOAT);
  const int side = n + 1;
  for (int i = 0; i < side * side * side; ++i) {
    const Vec3 at(i % side, i / side % side, i / (side * side));
    const Vec3 place = 2.0 / n * at - Vec3::Ones();
    points->InsertNextPoint(place.data());
  }
  grid->SetPoints(points);
  for (int i = 0; i < n * n * n; ++i) {
    const vtkIdType first = i % n + side * (i / n % n + side * (i / (n * n)));
    const vtkIdType up = side * side;
    const vtkIdType corners[8] = {first,      first + 1,      first + 1 + side,      first + side,
                                  first + up, first + up + 1, first + up + 1 + side, first + up + side};
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
  }
  const vtkIdType pointCount = grid->GetNumberOfPoints();
  grid->GetPointData()->AddArray(vectors<vtkFloatArray>("velocity", pointCount));
  grid->GetPointData()->SetNormals(vectors<vtkFloatArray>("Normals", pointCount));
  grid->GetPointData()->AddArray(numbers("id", pointCount));
  grid->GetCellData()->AddArray(vectors<vtkDoubleArray>("flux", grid->GetNumberOfCells()));
  grid->GetCellData()->AddArray(numbers("pressure", grid->GetNumberOfCells()));
  return grid;
}

vtkSmartPointer<vtkPolyData> polygons() {
  const Mesh mesh = sphere(8, 12);
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  const vtkNew<vtkPoints> points;
  for (Eigen::Index i = 0; i < mesh.positions.rows(); ++i) {
    points->InsertNextPoint(mesh.positions(i, 0), mesh.positions(i, 1), mesh.positions(i, 2));
  }
  data->SetPoints(points);
  data->AllocateEstimate(mesh.faces.size(), 4);
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const std::vector<vtkIdType> corners(mesh.faces[f].begin(), mesh.faces[f].end());
    data->InsertNextCell(VTK_POLYGON, static_cast<int>(corners.size()), corners.data());
  }
  data->GetPointData()->AddArray(vectors<vtkFloatArray>("velocity", data->GetNumberOfPoints()));
  return data;
}

void writeXml(const std::filesystem::path& path, vtkPointSet& data, XmlMode mode) {
  if (vtkPolyData::SafeDownCast(&data) != nullptr) {
    writeXmlWith<vtkXMLPolyDataWriter>(path, data, mode);
  } else {
    writeXmlWith<vtkXMLUnstructuredGridWriter>(path, data, mode);
  }
}

void writeLegacy(const std::filesystem::path& path, vtkPointSet& data, bool isBinary, int version) {
  if (vtkPolyData::SafeDownCast(&data) != nullptr) {
    writeLegacyWith<vtkPolyDataWriter>(path, data, isBinary, version);
  } else {
    writeLegacyWith<vtkUnstructuredGridWriter>(path, data, isBinary, version);
  }
}

vtkSmartPointer<vtkPointSet> readBack(const std::filesystem::path& path) {
  if (path.extension() == ".vtu") {
    return readWith<vtkXMLUnstructuredGridReader>(path);
  }
  if (path.extension() == ".vtp") {
    return readWith<vtkXMLPolyDataReader>(path);
  }
  return readLegacyWith<vtkUnstructuredGridReader>(path);
}

Points pointsOf(vtkPointSet& data) {
  return rowsOfArray(data.GetPoints() == nullptr ? nullptr : data.GetPoints()->GetData());
}

Points pointArray(vtkPointSet& data, const std::string& name) {
  return rowsOfArray(data.GetPointData()->GetArray(name.c_str()));
}

Points cellArray(vtkPointSet& data, const std::string& name) {
  return rowsOfArray(data.GetCellData()->GetArray(name.c_str()));
}

std::vector<std::string> namesIn(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace pbffd::test
