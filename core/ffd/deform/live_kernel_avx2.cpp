#include "core/ffd/deform/live_kernel_body.h"
#include "core/ffd/deform/live_kernels.h"

#if defined(__AVX2__) && defined(__FMA__)

#include <immintrin.h>

namespace pbffd {
namespace {

struct Eight {
  static constexpr std::ptrdiff_t count = 8;
  __m256 lanes;

  static Eight all(float value) { return {_mm256_set1_ps(value)}; }
  static Eight load(const float* from) { return {_mm256_loadu_ps(from)}; }
  friend Eight operator+(const Eight& a, const Eight& b) { return {_mm256_add_ps(a.lanes, b.lanes)}; }
  friend Eight fused(const Eight& a, const Eight& b, const Eight& c) {
    return {_mm256_fmadd_ps(a.lanes, b.lanes, c.lanes)};
  }
  friend Eight kept(const Eight& a, unsigned members) {
    const __m256i bits = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    const __m256i chosen = _mm256_and_si256(_mm256_set1_epi32(static_cast<int>(members)), bits);
    return {_mm256_and_ps(a.lanes, _mm256_castsi256_ps(_mm256_cmpeq_epi32(chosen, bits)))};
  }
};

/// x0 y0 z0 x1 ...
void store(const Eight& x, const Eight& y, const Eight& z, float* to) {
  const __m256 xy = _mm256_shuffle_ps(x.lanes, y.lanes, _MM_SHUFFLE(2, 0, 2, 0));
  const __m256 yz = _mm256_shuffle_ps(y.lanes, z.lanes, _MM_SHUFFLE(3, 1, 3, 1));
  const __m256 zx = _mm256_shuffle_ps(z.lanes, x.lanes, _MM_SHUFFLE(3, 1, 2, 0));
  const __m256 first = _mm256_shuffle_ps(xy, zx, _MM_SHUFFLE(2, 0, 2, 0));
  const __m256 second = _mm256_shuffle_ps(yz, xy, _MM_SHUFFLE(3, 1, 2, 0));
  const __m256 third = _mm256_shuffle_ps(zx, yz, _MM_SHUFFLE(3, 1, 3, 1));
  _mm256_storeu_ps(to, _mm256_permute2f128_ps(first, second, 0x20));
  _mm256_storeu_ps(to + 8, _mm256_permute2f128_ps(third, first, 0x30));
  _mm256_storeu_ps(to + 16, _mm256_permute2f128_ps(second, third, 0x31));
}

}  // namespace

LiveKernel liveAvx2Kernel() {
  return &LiveBody<Eight>::run;
}

}  // namespace pbffd

#else

namespace pbffd {

LiveKernel liveAvx2Kernel() {
  return nullptr;
}

}  // namespace pbffd

#endif
