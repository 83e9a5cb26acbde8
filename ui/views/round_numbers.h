#pragma once

namespace pbffd::ui {

/// 1, 2 or 5 times a power of ten: the largest that is not above `length`. 0 for 0 and less.
double roundedDown125(double length);

}  // namespace pbffd::ui
