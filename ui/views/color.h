#pragma once

#include <QColor>

#include <array>

namespace pbffd::ui {

/// Red, green, blue and opacity, 0 to 1, as shaders take them.
using Rgba = std::array<float, 4>;

inline Rgba rgba(const QColor& color) {
  return {static_cast<float>(color.redF()), static_cast<float>(color.greenF()),
          static_cast<float>(color.blueF()), static_cast<float>(color.alphaF())};
}

inline Rgba withAlpha(Rgba color, float alpha) {
  color[3] = alpha;
  return color;
}

/// `share` of `other` mixed into the colour; the opacity stays.
inline Rgba mixed(const Rgba& color, const Rgba& other, float share) {
  Rgba result = color;
  for (int i = 0; i < 3; ++i) {
    result[i] += share * (other[i] - color[i]);
  }
  return result;
}

}  // namespace pbffd::ui
