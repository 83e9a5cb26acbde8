#include "core/ffd/block_kernel_body.h"

namespace pbffd {

#if defined(__AVX2__)

namespace {

struct Here;

}  // namespace

const BlockKernels* blockAvx2Kernels() {
  return &BlockBody<Here>::all;
}

#else

const BlockKernels* blockAvx2Kernels() {
  return nullptr;
}

#endif

}  // namespace pbffd
