#include "ui/views/round_numbers.h"

#include <cmath>

namespace pbffd::ui {

double roundedDown125(double length) {
  if (!(length > 0.0) || !std::isfinite(length)) {
    return 0.0;
  }
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  const double digit = length / power;
  // A hair of slack: 0.1 / 0.1 may come out a little below 1.
  const double slack = 1.0 - 1e-9;
  return power * (digit >= 5.0 * slack ? 5.0 : digit >= 2.0 * slack ? 2.0 : 1.0);
}

}  // namespace pbffd::ui
