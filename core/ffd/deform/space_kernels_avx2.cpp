#include "core/ffd/deform/space_kernel_body.h"

namespace pbffd {

#if defined(__AVX2__)

namespace {

struct Here;

}  // namespace

const SpaceKernels* spaceAvx2Kernels() {
  return &SpaceBody<Here>::all;
}

#else

const SpaceKernels* spaceAvx2Kernels() {
  return nullptr;
}

#endif

}  // namespace pbffd
