#include "app/dataset/vtk_cell_kinds.h"

#include <vtkGenericCell.h>

#include <array>

namespace pbffd {
namespace {

std::array<bool, 256> volumeTypes() {
  std::array<bool, 256> types{};
  for (int type = 0; type < 256; ++type) {
    // A number that is no type gives null.
    if (vtkCell* made = vtkGenericCell::InstantiateCell(type)) {
      types[static_cast<std::size_t>(type)] = made->GetCellDimension() == 3;
      made->Delete();
    }
  }
  return types;
}

}  // namespace

bool isVolumeCell(int type) {
  static const std::array<bool, 256> types = volumeTypes();
  return types[static_cast<std::size_t>(static_cast<unsigned char>(type))];
}

}  // namespace pbffd
