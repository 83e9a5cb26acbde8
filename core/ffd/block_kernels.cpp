#include "core/ffd/block_kernels.h"

#include "core/ffd/instructions.h"

namespace pbffd {
namespace {

const BlockKernels* fastest() {
  const BlockKernels* kernels = hasInstructions(Instructions::avx512) ? blockAvx512Kernels() : nullptr;
  if (kernels == nullptr && hasInstructions(Instructions::avx2)) {
    kernels = blockAvx2Kernels();
  }
  return kernels != nullptr ? kernels : blockPlainKernels();
}

}  // namespace

const BlockKernels& blockKernels() {
  static const BlockKernels* const kernels = fastest();
  return *kernels;
}

}  // namespace pbffd
