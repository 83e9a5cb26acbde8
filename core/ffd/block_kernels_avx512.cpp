#include "core/ffd/block_kernel_body.h"

namespace pbffd {

#if defined(__AVX512F__)

namespace {

struct Here;

}  // namespace

const BlockKernels* blockAvx512Kernels() {
  return &BlockBody<Here>::all;
}

#else

const BlockKernels* blockAvx512Kernels() {
  return nullptr;
}

#endif

}  // namespace pbffd
