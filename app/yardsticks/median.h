#pragma once

#include "core/base/progress.h"

#include <functional>

namespace pbffd {

/// The median time of `work` in seconds, over at least three runs, more of what is over quickly and fewer of
/// what takes very long; `prepare` is run before each and not counted. Throws Cancelled.
double medianSeconds(const std::function<void()>& prepare, const std::function<void()>& work,
                     const Progress& progress = {});
double medianSeconds(const std::function<void()>& work, const Progress& progress = {});

}  // namespace pbffd
