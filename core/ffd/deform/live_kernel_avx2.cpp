#include "core/ffd/deform/live_kernel_body.h"
#include "core/ffd/deform/live_kernels.h"

#if defined(__AVX2__) && defined(__FMA__)

#include <immintrin.h>

namespace pbffd {
namespace {

struct Sixteen {
  __m256 low, high;

  static Sixteen all(float value) { return {_mm256_set1_ps(value), _mm256_set1_ps(value)}; }
  static Sixteen load(const float* from) { return {_mm256_loadu_ps(from), _mm256_loadu_ps(from + 8)}; }
  friend Sixteen operator+(const Sixteen& a, const Sixteen& b) {
    return {_mm256_add_ps(a.low, b.low), _mm256_add_ps(a.high, b.high)};
  }
  friend Sixteen fused(const Sixteen& a, const Sixteen& b, const Sixteen& c) {
    return {_mm256_fmadd_ps(a.low, b.low, c.low), _mm256_fmadd_ps(a.high, b.high, c.high)};
  }
  friend Sixteen kept(const Sixteen& a, unsigned members) {
    const __m256i bits = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    const auto mask = [&](unsigned eight) {
      return _mm256_castsi256_ps(
          _mm256_cmpeq_epi32(_mm256_and_si256(_mm256_set1_epi32(static_cast<int>(eight)), bits), bits));
    };
    return {_mm256_and_ps(a.low, mask(members)), _mm256_and_ps(a.high, mask(members >> 8))};
  }
};

/// x0 y0 z0 x1 ... of eight vertices.
void storeEight(__m256 x, __m256 y, __m256 z, float* to) {
  const __m256 xy = _mm256_shuffle_ps(x, y, _MM_SHUFFLE(2, 0, 2, 0));
  const __m256 yz = _mm256_shuffle_ps(y, z, _MM_SHUFFLE(3, 1, 3, 1));
  const __m256 zx = _mm256_shuffle_ps(z, x, _MM_SHUFFLE(3, 1, 2, 0));
  const __m256 first = _mm256_shuffle_ps(xy, zx, _MM_SHUFFLE(2, 0, 2, 0));
  const __m256 second = _mm256_shuffle_ps(yz, xy, _MM_SHUFFLE(3, 1, 2, 0));
  const __m256 third = _mm256_shuffle_ps(zx, yz, _MM_SHUFFLE(3, 1, 3, 1));
  _mm256_storeu_ps(to, _mm256_permute2f128_ps(first, second, 0x20));
  _mm256_storeu_ps(to + 8, _mm256_permute2f128_ps(third, first, 0x30));
  _mm256_storeu_ps(to + 16, _mm256_permute2f128_ps(second, third, 0x31));
}

void store(const Sixteen& x, const Sixteen& y, const Sixteen& z, float* to) {
  storeEight(x.low, y.low, z.low, to);
  storeEight(x.high, y.high, z.high, to + 24);
}

}  // namespace

LiveKernel liveAvx2Kernel() {
  return &LiveBody<Sixteen>::run;
}

}  // namespace pbffd

#else

namespace pbffd {

LiveKernel liveAvx2Kernel() {
  return nullptr;
}

}  // namespace pbffd

#endif
