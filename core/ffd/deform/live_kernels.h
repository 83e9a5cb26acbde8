#pragma once

#include "core/ffd/deform/live_kernel.h"

namespace pbffd {

// One a source file, each compiled for its instructions; nullptr where the compiler does not have them.
LiveKernel livePlainKernel();
LiveKernel liveAvx2Kernel();
LiveKernel liveAvx512Kernel();

}  // namespace pbffd
