#include "core/ffd/deform/live_kernel_body.h"
#include "core/ffd/deform/live_kernels.h"

namespace pbffd {
namespace {

/// Vectors of four, which every processor has; the compiler's own, so that no instruction is named.
struct Sixteen {
  using Four = float __attribute__((vector_size(16)));
  Four quarters[4];

  template <class Make>
  static Sixteen each(const Make& make) {
    return {{make(0), make(1), make(2), make(3)}};
  }
  static Sixteen all(float value) {
    return each([&](int) { return Four{value, value, value, value}; });
  }
  static Sixteen load(const float* from) {
    return each([&](int q) { return Four{from[4 * q], from[4 * q + 1], from[4 * q + 2], from[4 * q + 3]}; });
  }
  friend Sixteen operator+(const Sixteen& a, const Sixteen& b) {
    return each([&](int q) { return a.quarters[q] + b.quarters[q]; });
  }
  friend Sixteen fused(const Sixteen& a, const Sixteen& b, const Sixteen& c) {
    return each([&](int q) { return a.quarters[q] * b.quarters[q] + c.quarters[q]; });
  }
  friend Sixteen kept(const Sixteen& a, unsigned members) {
    return each([&](int q) {
      const auto lane = [&](int k) { return (members >> (4 * q + k) & 1U) != 0 ? a.quarters[q][k] : 0.0F; };
      return Four{lane(0), lane(1), lane(2), lane(3)};
    });
  }
  friend void store(const Sixteen& x, const Sixteen& y, const Sixteen& z, float* to) {
    for (int k = 0; k < 16; ++k) {
      to[3 * k] = x.quarters[k / 4][k % 4];
      to[3 * k + 1] = y.quarters[k / 4][k % 4];
      to[3 * k + 2] = z.quarters[k / 4][k % 4];
    }
  }
};

}  // namespace

LiveKernel livePlainKernel() {
  return &LiveBody<Sixteen>::run;
}

}  // namespace pbffd
