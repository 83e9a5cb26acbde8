#include "core/ffd/deform/live_kernel_body.h"
#include "core/ffd/deform/live_kernels.h"

namespace pbffd {
namespace {

/// Four at a time, which every processor can; the compiler's own vectors, so that no instruction is named.
struct Four {
  using Vector = float __attribute__((vector_size(16)));
  static constexpr std::ptrdiff_t count = 4;
  Vector lanes;

  static Four all(float value) { return {Vector{value, value, value, value}}; }
  static Four load(const float* from) { return {Vector{from[0], from[1], from[2], from[3]}}; }
  friend Four operator+(const Four& a, const Four& b) { return {a.lanes + b.lanes}; }
  friend Four fused(const Four& a, const Four& b, const Four& c) { return {a.lanes * b.lanes + c.lanes}; }
  friend Four kept(const Four& a, unsigned members) {
    const auto lane = [&](int k) { return (members >> k & 1U) != 0 ? a.lanes[k] : 0.0F; };
    return {Vector{lane(0), lane(1), lane(2), lane(3)}};
  }
  friend void store(const Four& x, const Four& y, const Four& z, float* to) {
    for (int k = 0; k < 4; ++k) {
      to[3 * k] = x.lanes[k];
      to[3 * k + 1] = y.lanes[k];
      to[3 * k + 2] = z.lanes[k];
    }
  }
};

}  // namespace

LiveKernel livePlainKernel() {
  return &LiveBody<Four>::run;
}

}  // namespace pbffd
