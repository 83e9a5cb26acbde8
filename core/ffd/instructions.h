#pragma once

namespace pbffd {

/// What inner loops are compiled for: any processor, AVX2 with FMA, AVX-512.
enum class Instructions { plain, avx2, avx512 };

/// Whether this processor has them.
bool hasInstructions(Instructions instructions);

}  // namespace pbffd
