#include "app/dataset/vtk_dataset.h"

#include "app/dataset/raw_file.h"
#include "app/dataset/vtk_cell_kinds.h"
#include "app/dataset/vtk_fields.h"
#include "app/dataset/vtk_files.h"
#include "core/base/error.h"
#include "core/base/text.h"

#include <vtkCellTypes.h>
#include <vtkDataArray.h>
#include <vtkDataWriter.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <utility>

namespace pbffd {
namespace {

bool hasVolume(vtkPointSet& data) {
  if (vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(&data)) {
    const vtkNew<vtkCellTypes> types;
    grid->GetCellTypes(types);
    for (vtkIdType i = 0; i < types->GetNumberOfTypes(); ++i) {
      if (isVolumeCell(types->GetCellType(i))) {
        return true;
      }
    }
    return false;
  }
  vtkStructuredGrid* structured = vtkStructuredGrid::SafeDownCast(&data);
  return structured != nullptr && structured->GetDataDimension() == 3;
}

class VtkDataset : public Dataset {
 public:
  VtkDataset(std::filesystem::path path, VtkFile file) : path_(std::move(path)), file_(std::move(file)) {}

  std::int64_t pointCount() const override { return file_.data->GetNumberOfPoints(); }
  bool hasVolumeCells() const override { return hasVolume(*file_.data); }

  Points sample(std::int64_t stride) const override {
    const std::int64_t count = (pointCount() + stride - 1) / stride;
    Points points(count, 3);
    for (std::int64_t i = 0; i < count; ++i) {
      Vec3 point;
      file_.data->GetPoint(i * stride, point.data());
      points.row(i) = point;
    }
    return points;
  }

  std::vector<Remark> write(const std::filesystem::path& target, StagedFiles& staged,
                            const Carrying& carrying) override {
    requireSameEnding(path_, target);
    // A piece without points may lack the arrays that the others have.
    const VtkFields fields = pointCount() > 0 ? fieldsOf(*file_.data, carrying.transports, path_) : VtkFields();
    const std::filesystem::path path = staged.add(target);
    if (pointCount() == 0 || !deform(*file_.data, fields, carrying)) {
      RawFile::copyWhole(path_, path, target, carrying.progress);
      return {};
    }
    writeVtkFile(file_, path, target, carrying.progress);
    return remarks(fields);
  }

 private:
  std::vector<Remark> remarks(const VtkFields& fields) const {
    std::vector<Remark> remarks;
    for (const std::string& warning : file_.warnings) {
      remarks.push_back(format("VTK says of {}: {}.", path_.string(), warning));
    }
    if (file_.legacyType == VTK_ASCII) {
      remarks.push_back(format(
          "{} is a legacy file of text, in which VTK drops digits; what was made of it holds its numbers in "
          "binary, so that nothing else changes.",
          path_.string()));
    }
    vtkDataArray* normals = file_.data->GetPointData()->GetNormals();
    const bool isTransported = std::any_of(fields.ofPoints.begin(), fields.ofPoints.end(),
                                           [&](const VtkField& field) { return field.array == normals; });
    if (normals != nullptr && normals->GetName() != nullptr && !isTransported) {
      remarks.push_back(keptNormalsRemark(path_, normals->GetName()));
    }
    return remarks;
  }

  std::filesystem::path path_;
  VtkFile file_;
};

}  // namespace

std::unique_ptr<Dataset> openVtkDataset(const std::filesystem::path& path, const Progress& progress) {
  return std::make_unique<VtkDataset>(path, readVtkFile(path, progress));
}

}  // namespace pbffd
