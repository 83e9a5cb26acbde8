#include "core/ffd/deform/space_kernels.h"

#include "core/ffd/instructions.h"

namespace pbffd {
namespace {

const SpaceKernels* fastest() {
  const SpaceKernels* kernels = hasInstructions(Instructions::avx512) ? spaceAvx512Kernels() : nullptr;
  if (kernels == nullptr && hasInstructions(Instructions::avx2)) {
    kernels = spaceAvx2Kernels();
  }
  return kernels != nullptr ? kernels : spacePlainKernels();
}

}  // namespace

const SpaceKernels& spaceKernels() {
  static const SpaceKernels* const kernels = fastest();
  return *kernels;
}

}  // namespace pbffd
