#include "core/ffd/deform/live_kernel.h"

#include "core/ffd/deform/live_kernels.h"

#include <initializer_list>

namespace pbffd {

Instructions bestInstructions() {
  for (const Instructions instructions : {Instructions::avx512, Instructions::avx2}) {
    if (liveKernel(instructions) != nullptr) {
      return instructions;
    }
  }
  return Instructions::plain;
}

LiveKernel liveKernel(Instructions instructions) {
  if (!hasInstructions(instructions)) {
    return nullptr;
  }
  switch (instructions) {
    case Instructions::plain:
      return livePlainKernel();
    case Instructions::avx2:
      return liveAvx2Kernel();
    case Instructions::avx512:
      return liveAvx512Kernel();
  }
  return nullptr;
}

}  // namespace pbffd
