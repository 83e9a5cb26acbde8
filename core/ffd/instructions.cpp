#include "core/ffd/instructions.h"

namespace pbffd {

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

}  // namespace pbffd
