#pragma once

namespace pbffd {

/// Whether cells of this VTK type (vtkCellType.h) have a volume.
bool isVolumeCell(int type);

}  // namespace pbffd
