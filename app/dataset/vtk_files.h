#pragma once

#include "app/dataset/vtk_settings.h"
#include "core/base/progress.h"

#include <vtkPointSet.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>
#include <vector>

namespace pbffd {

/// A data set and how its file was written.
struct VtkFile {
  vtkSmartPointer<vtkPointSet> data;
  XmlSettings xml;                    ///< of an XML file
  LegacyHeader legacy;                ///< of a legacy file
  int legacyType = 0;                 ///< of a legacy file: VTK_ASCII or VTK_BINARY
  std::string title;                  ///< the second line of a legacy file
  std::vector<std::string> warnings;  ///< of VTK while it was read
};

/// Throws IoError, or InvalidInput that names the file and says what VTK found wrong in it; Cancelled.
VtkFile readVtkFile(const std::filesystem::path& path, const Progress& progress);

/// Writes to `path`, in messages called `name`, with the settings of the file that was read; a legacy file is
/// always binary, since VTK's text drops digits. Throws IoError, Cancelled; what was written is then not whole.
void writeVtkFile(const VtkFile& file, const std::filesystem::path& path, const std::filesystem::path& name,
                  const Progress& progress);

}  // namespace pbffd
