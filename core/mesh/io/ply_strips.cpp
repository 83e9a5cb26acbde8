#include "core/mesh/io/ply_strips.h"

#include <array>
#include <utility>

namespace pbffd::io {

void StripTriangles::add(std::span<const Index> strip, Polygons& faces) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < strip.size(); ++i) {
    if (strip[i] < 0) {
      begin = i + 1;
    } else if (i >= begin + 2) {
      std::array<Index, 3> triangle{strip[i - 2], strip[i - 1], strip[i]};
      if ((i - begin) % 2 == 1) {
        std::swap(triangle[0], triangle[1]);
      }
      if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) {
        ++joining_;
      } else {
        faces.add(triangle);
      }
    }
  }
}

}  // namespace pbffd::io
