#include "core/base/figures.h"

#include "core/base/text.h"

#include <cmath>

namespace pbffd {
namespace {

constexpr const char* minus = "\u2212";
/// From here on the commas are harder to read than a power.
constexpr double mostWritten = 1e9;

/// So that it ends in zeros beyond the third digit.
double roundedToThree(double size) {
  const double unit = std::pow(10.0, std::floor(std::log10(size)) - 2.0);
  return std::round(size / unit) * unit;
}

}  // namespace

std::string counted(std::size_t count) {
  std::string digits = std::to_string(count);
  for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3) {
    digits.insert(static_cast<std::size_t>(at), 1, ',');
  }
  return digits;
}

std::string figures(double value) {
  const double size = std::abs(value);
  std::string text = size >= 999.5 && size < mostWritten
                         ? counted(static_cast<std::size_t>(std::llround(roundedToThree(size))))
                         : format("{:.3g}", size);
  if (const std::size_t power = text.find("e-"); power != std::string::npos) {
    text.replace(power + 1, 1, minus);
  }
  return value < 0.0 ? minus + text : text;
}

}  // namespace pbffd
