#pragma once

#include "core/base/types.h"

#include <vector>

#include <vtkSmartPointer.h>

class vtkCellArray;
class vtkFloatArray;
class vtkPoints;
class vtkPolyData;

namespace pbffd::ui {

/// Points whose floats are another's: no copy. `values`, 3 a point, must outlive what is returned.
vtkSmartPointer<vtkFloatArray> borrowedArray(const std::vector<float>& values, int width, const char* name);
vtkSmartPointer<vtkPoints> borrowedPoints(const std::vector<float>& values);

/// Floats that the array owns, `width` a row.
vtkSmartPointer<vtkFloatArray> ownedArray(const std::vector<float>& values, int width, const char* name);

/// Cells of `size` corners each, one after the other: triangles (3), lines (2), points (1).
vtkSmartPointer<vtkCellArray> cellsOf(const std::vector<Index>& corners, int size);

/// The vertices of `data` and their attributes, as a growing list of floats.
struct VertexList {
  std::vector<float> positions;
  std::vector<float> colors;
  void add(const Vec3& position, const float* color);
};

/// Puts an attribute (float, `width` a vertex) into the point data.
void setAttribute(vtkPolyData& data, const std::vector<float>& values, int width, const char* name);

}  // namespace pbffd::ui
