#include "app/dataset/vtk_fields.h"

#include "core/base/parallel.h"
#include "core/base/text.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>

#include <algorithm>

namespace pbffd {
namespace {

/// Rows taken at a time: enough for all cores, little beside the data set.
constexpr std::int64_t portion = 1 << 19;

constexpr std::size_t grain = 1 << 14;

/// Calls body(row) for each row of a portion, on all cores.
template <class Body>
void forEachRow(std::int64_t count, const Body& body) {
  parallelFor(static_cast<std::size_t>(count), grain, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<std::int64_t>(begin); i < static_cast<std::int64_t>(end); ++i) {
      body(i);
    }
  });
}

/// The numbers of an array whose rows lie one after the other; null for any other array.
float* floatsOf(vtkDataArray& array) {
  vtkFloatArray* floats = vtkFloatArray::FastDownCast(&array);
  return floats == nullptr ? nullptr : floats->GetPointer(0);
}
double* doublesOf(vtkDataArray& array) {
  vtkDoubleArray* doubles = vtkDoubleArray::FastDownCast(&array);
  return doubles == nullptr ? nullptr : doubles->GetPointer(0);
}

template <class Number>
void setRows(Number* numbers, std::int64_t first, const Points& rows) {
  forEachRow(rows.rows(), [&](std::int64_t i) {
    for (int axis = 0; axis < 3; ++axis) {
      numbers[3 * (first + i) + axis] = static_cast<Number>(rows(i, axis));
    }
  });
}

void setRows(vtkDataArray& array, std::int64_t first, const Points& rows) {
  if (double* doubles = doublesOf(array)) {
    setRows(doubles, first, rows);
  } else if (float* floats = floatsOf(array)) {
    setRows(floats, first, rows);
  } else {
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      const Vec3 row = rows.row(i);
      array.SetTuple(first + i, row.data());
    }
  }
}

void transport(const VtkField& field, std::int64_t first, const std::vector<Mat3>& gradients) {
  Points rows = rowsOf(*field.array, first, static_cast<std::int64_t>(gradients.size()));
  transportRows(rows, gradients, field.kind);
  setRows(*field.array, first, rows);
}

/// The mean of each cell's points.
Points cellCenters(vtkPointSet& data, std::int64_t first, std::int64_t count) {
  Points centers = Points::Zero(count, 3);
  const vtkNew<vtkIdList> points;
  for (std::int64_t i = 0; i < count; ++i) {
    data.GetCellPoints(first + i, points);
    for (vtkIdType k = 0; k < points->GetNumberOfIds(); ++k) {
      Vec3 point;
      data.GetPoint(points->GetId(k), point.data());
      centers.row(i) += point.transpose() / static_cast<double>(points->GetNumberOfIds());
    }
  }
  return centers;
}

void transportCellFields(vtkPointSet& data, const VtkFields& fields, const Carrying& carrying) {
  const std::int64_t cells = fields.ofCells.empty() ? 0 : data.GetNumberOfCells();
  for (std::int64_t first = 0; first < cells; first += portion) {
    const Points centers = cellCenters(data, first, std::min(portion, cells - first));
    const std::vector<Mat3> gradients = carrying.space.image(centers, carrying.progress).gradients;
    for (const VtkField& field : fields.ofCells) {
      transport(field, first, gradients);
    }
  }
}

/// Returns whether any point is elsewhere now.
bool movePoints(vtkPointSet& data, const VtkFields& fields, const Carrying& carrying) {
  bool hasMoved = false;
  vtkDataArray& array = *data.GetPoints()->GetData();
  const std::int64_t count = array.GetNumberOfTuples();
  for (std::int64_t first = 0; first < count; first += portion) {
    carrying.progress.report("Deforming", static_cast<double>(first) / static_cast<double>(count));
    const Points rest = rowsOf(array, first, std::min(portion, count - first));
    if (fields.ofPoints.empty()) {
      const Points moved = carrying.space.positions(rest);
      hasMoved = hasMoved || moved != rest;
      setRows(array, first, moved);
    } else {
      const SpaceImage image = carrying.space.image(rest);
      hasMoved = hasMoved || image.positions != rest;
      setRows(array, first, image.positions);
      for (const VtkField& field : fields.ofPoints) {
        transport(field, first, image.gradients);
      }
    }
    carrying.progress.throwIfCancelled();
  }
  return hasMoved;
}

/// Points that are whole numbers cannot follow a deformation: they become doubles.
void makePointsReal(vtkPointSet& data) {
  vtkDataArray& array = *data.GetPoints()->GetData();
  if (floatsOf(array) == nullptr && doublesOf(array) == nullptr) {
    const vtkNew<vtkDoubleArray> doubles;
    doubles->DeepCopy(&array);
    doubles->SetName(array.GetName());
    data.GetPoints()->SetData(doubles);
  }
}

}  // namespace

VtkFields fieldsOf(vtkPointSet& data, const std::vector<Transport>& transports,
                   const std::filesystem::path& path) {
  VtkFields fields;
  for (const Transport& transport : transports) {
    vtkDataArray* ofPoints = data.GetPointData()->GetArray(transport.array.c_str());
    vtkDataArray* ofCells = data.GetCellData()->GetArray(transport.array.c_str());
    if (ofPoints == nullptr && ofCells == nullptr) {
      failForMissingArray(path, transport,
                          "there is none of that name in its point or cell data. Check the name.");
    }
    for (vtkDataArray* array : {ofPoints, ofCells}) {
      if (array == nullptr) {
        continue;
      }
      if (array->GetNumberOfComponents() != 3 ||
          (floatsOf(*array) == nullptr && doublesOf(*array) == nullptr)) {
        failForMissingArray(path, transport,
                            "it does not hold three real numbers a row, so it is neither vectors nor normals.");
      }
      const bool isNormal = array == data.GetPointData()->GetNormals() ||
                            array == data.GetCellData()->GetNormals() || namesNormals(transport.array);
      (array == ofPoints ? fields.ofPoints : fields.ofCells)
          .push_back({array, transport.kind.value_or(isNormal ? FieldKind::normal : FieldKind::vector)});
    }
  }
  return fields;
}

bool deform(vtkPointSet& data, const VtkFields& fields, const Carrying& carrying) {
  if (!carrying.space.movesAnything()) {
    return false;
  }
  makePointsReal(data);
  transportCellFields(data, fields, carrying);
  const bool hasMoved = movePoints(data, fields, carrying);
  // Modified() also drops the ranges that VTK keeps with an array and would write to the file.
  data.GetPoints()->GetData()->Modified();
  data.GetPoints()->Modified();
  for (const auto* list : {&fields.ofPoints, &fields.ofCells}) {
    for (const VtkField& field : *list) {
      field.array->Modified();
    }
  }
  // What turns along may turn where no point moves.
  return hasMoved || !fields.ofPoints.empty() || !fields.ofCells.empty();
}

Points rowsOf(vtkDataArray& array, std::int64_t first, std::int64_t count) {
  Points rows(count, 3);
  using Floats = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;
  if (const double* doubles = doublesOf(array)) {
    rows = Eigen::Map<const Points>(doubles + 3 * first, count, 3);
  } else if (const float* floats = floatsOf(array)) {
    rows = Eigen::Map<const Floats>(floats + 3 * first, count, 3).cast<double>();
  } else {
    for (std::int64_t i = 0; i < count; ++i) {
      Vec3 row;
      array.GetTuple(first + i, row.data());
      rows.row(i) = row;
    }
  }
  return rows;
}

}  // namespace pbffd
