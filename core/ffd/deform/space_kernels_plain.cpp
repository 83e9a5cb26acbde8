#include "core/ffd/deform/space_kernel_body.h"

namespace pbffd {
namespace {

struct Here;

}  // namespace

const SpaceKernels* spacePlainKernels() {
  return &SpaceBody<Here>::all;
}

}  // namespace pbffd
