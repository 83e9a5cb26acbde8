#include "core/ffd/live_kernel_body.h"
#include "core/ffd/live_kernels.h"

namespace pbffd {
namespace {

/// Loops that the compiler turns into whatever every processor has.
struct Sixteen {
  float lanes[16];

  static Sixteen all(float value) {
    Sixteen result;
    for (float& lane : result.lanes) {
      lane = value;
    }
    return result;
  }
  static Sixteen load(const float* from) {
    Sixteen result;
    for (int k = 0; k < 16; ++k) {
      result.lanes[k] = from[k];
    }
    return result;
  }
  friend Sixteen operator+(const Sixteen& a, const Sixteen& b) {
    Sixteen result;
    for (int k = 0; k < 16; ++k) {
      result.lanes[k] = a.lanes[k] + b.lanes[k];
    }
    return result;
  }
  friend Sixteen fused(const Sixteen& a, const Sixteen& b, const Sixteen& c) {
    Sixteen result;
    for (int k = 0; k < 16; ++k) {
      result.lanes[k] = a.lanes[k] * b.lanes[k] + c.lanes[k];
    }
    return result;
  }
  friend Sixteen kept(const Sixteen& a, unsigned members) {
    Sixteen result;
    for (int k = 0; k < 16; ++k) {
      result.lanes[k] = (members >> k & 1U) != 0 ? a.lanes[k] : 0.0F;
    }
    return result;
  }
  friend void store(const Sixteen& x, const Sixteen& y, const Sixteen& z, float* to) {
    for (int k = 0; k < 16; ++k) {
      to[3 * k] = x.lanes[k];
      to[3 * k + 1] = y.lanes[k];
      to[3 * k + 2] = z.lanes[k];
    }
  }
};

}  // namespace

LiveKernel livePlainKernel() {
  return &LiveBody<Sixteen>::run;
}

}  // namespace pbffd
