#include "core/ffd/live_kernel.h"

#include "core/ffd/live_kernels.h"

#include <initializer_list>

namespace pbffd {
namespace {

bool hasInstructions(Instructions instructions) {
#if defined(__x86_64__)
  switch (instructions) {
    case Instructions::plain:
      return true;
    case Instructions::avx2:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case Instructions::avx512:
      return __builtin_cpu_supports("avx512f");
  }
#endif
  return instructions == Instructions::plain;
}

}  // namespace

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
