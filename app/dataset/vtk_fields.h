#pragma once

#include "app/dataset/dataset.h"

#include <filesystem>
#include <vector>

class vtkDataArray;
class vtkPointSet;

namespace pbffd {

/// An array of a data set that is to be transported.
struct VtkField {
  vtkDataArray* array;
  FieldKind kind;
};

/// The fields that the transports name, of points and of cells.
struct VtkFields {
  std::vector<VtkField> ofPoints;
  std::vector<VtkField> ofCells;
};

/// Throws InvalidInput that names the file and the array where there is none of that name with three numbers
/// a row.
VtkFields fieldsOf(vtkPointSet& data, const std::vector<Transport>& transports,
                   const std::filesystem::path& path);

/// Moves the points, transports the fields, and lets go of what VTK computed before. Returns whether anything
/// may be other than before.
bool deform(vtkPointSet& data, const VtkFields& fields, const Carrying& carrying);

/// Rows [first, first + count) of an array of three numbers a row.
Points rowsOf(vtkDataArray& array, std::int64_t first, std::int64_t count);

}  // namespace pbffd
