#pragma once

#include <fmt/format.h>

namespace pbffd {

/// Builds a message: text("{} vertices", n). The one place that knows which library formats.
using fmt::format;

}  // namespace pbffd
