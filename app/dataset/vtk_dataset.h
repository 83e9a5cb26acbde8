#pragma once

#include "app/dataset/dataset.h"

namespace pbffd {

/// A VTK data set that has points of its own, read and written by VTK: .vtu, .vtp, .vts, legacy .vtk
/// (unstructured grid, polygons, structured grid). All arrays stay; it is written with the settings of its
/// source. The whole data set is held in memory.
std::unique_ptr<Dataset> openVtkDataset(const std::filesystem::path& path, const Progress& progress);

}  // namespace pbffd
