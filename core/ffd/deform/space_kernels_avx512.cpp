#include "core/ffd/deform/space_kernel_body.h"

namespace pbffd {

#if defined(__AVX512F__)

namespace {

struct Here;

}  // namespace

const SpaceKernels* spaceAvx512Kernels() {
  return &SpaceBody<Here>::all;
}

#else

const SpaceKernels* spaceAvx512Kernels() {
  return nullptr;
}

#endif

}  // namespace pbffd
