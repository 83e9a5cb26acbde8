#include "ui/views/vertex_data.h"

#include <cstring>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>

namespace pbffd::ui {

vtkSmartPointer<vtkFloatArray> borrowedArray(const std::vector<float>& values, int width, const char* name) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(width);
  // VTK takes a plain pointer and, told to leave the memory alone (1), only reads through it.
  array->SetArray(const_cast<float*>(values.data()), static_cast<vtkIdType>(values.size()), 1);
  return array;
}

vtkSmartPointer<vtkPoints> borrowedPoints(const std::vector<float>& values) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(borrowedArray(values, 3, "Points"));
  return points;
}

vtkSmartPointer<vtkFloatArray> ownedArray(const std::vector<float>& values, int width, const char* name) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(width);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  if (!values.empty()) {
    std::memcpy(array->GetPointer(0), values.data(), values.size() * sizeof(float));
  }
  return array;
}

vtkSmartPointer<vtkCellArray> cellsOf(const std::vector<Index>& corners, int size) {
  const vtkIdType count = static_cast<vtkIdType>(corners.size()) / size;
  vtkNew<vtkTypeInt32Array> offsets;
  offsets->SetNumberOfValues(count + 1);
  for (vtkIdType i = 0; i <= count; ++i) {
    offsets->SetValue(i, static_cast<vtkTypeInt32>(i * size));
  }
  vtkNew<vtkTypeInt32Array> connectivity;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(corners.size()));
  static_assert(sizeof(Index) == sizeof(vtkTypeInt32));
  if (!corners.empty()) {
    std::memcpy(connectivity->GetPointer(0), corners.data(), corners.size() * sizeof(Index));
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

void VertexList::add(const Vec3& position, const float* color) {
  for (int i = 0; i < 3; ++i) {
    positions.push_back(static_cast<float>(position[i]));
  }
  colors.insert(colors.end(), color, color + 4);
}

void setAttribute(vtkPolyData& data, const std::vector<float>& values, int width, const char* name) {
  data.GetPointData()->AddArray(ownedArray(values, width, name));
}

}  // namespace pbffd::ui
