#include "core/ffd/deform/live_kernel_body.h"
#include "core/ffd/deform/live_kernels.h"

#if defined(__AVX512F__)

#include <immintrin.h>

namespace pbffd {
namespace {

struct Sixteen {
  static constexpr std::ptrdiff_t count = 16;
  __m512 lanes;

  static Sixteen all(float value) { return {_mm512_set1_ps(value)}; }
  static Sixteen load(const float* from) { return {_mm512_loadu_ps(from)}; }
  friend Sixteen operator+(const Sixteen& a, const Sixteen& b) { return {_mm512_add_ps(a.lanes, b.lanes)}; }
  friend Sixteen fused(const Sixteen& a, const Sixteen& b, const Sixteen& c) {
    return {_mm512_fmadd_ps(a.lanes, b.lanes, c.lanes)};
  }
  friend Sixteen kept(const Sixteen& a, unsigned members) {
    return {_mm512_maskz_mov_ps(static_cast<__mmask16>(members), a.lanes)};
  }
};

/// Where the numbers of part `part` (of three) of x0 y0 z0 x1 ... come from: first those of x and y, then z.
struct Origins {
  alignas(64) int ofXAndY[3][16];
  alignas(64) int ofZ[3][16];

  constexpr Origins() : ofXAndY(), ofZ() {
    for (int at = 0; at < 48; ++at) {
      const int vertex = at / 3;
      const int axis = at % 3;
      ofXAndY[at / 16][at % 16] = axis == 1 ? 16 + vertex : vertex;
      ofZ[at / 16][at % 16] = axis == 2 ? 16 + vertex : at % 16;
    }
  }
};
constexpr Origins origins;

void store(const Sixteen& x, const Sixteen& y, const Sixteen& z, float* to) {
  for (int part = 0; part < 3; ++part) {
    const __m512i ofXAndY = _mm512_load_si512(origins.ofXAndY[part]);
    const __m512i ofZ = _mm512_load_si512(origins.ofZ[part]);
    const __m512 xy = _mm512_permutex2var_ps(x.lanes, ofXAndY, y.lanes);
    _mm512_storeu_ps(to + 16 * part, _mm512_permutex2var_ps(xy, ofZ, z.lanes));
  }
}

}  // namespace

LiveKernel liveAvx512Kernel() {
  return &LiveBody<Sixteen>::run;
}

}  // namespace pbffd

#else

namespace pbffd {

LiveKernel liveAvx512Kernel() {
  return nullptr;
}

}  // namespace pbffd

#endif
