#include "core/ffd/block_kernel_body.h"

namespace pbffd {
namespace {

struct Here;

}  // namespace

const BlockKernels* blockPlainKernels() {
  return &BlockBody<Here>::all;
}

}  // namespace pbffd
