#pragma once

#include "core/base/parallel.h"

#include <mutex>
#include <optional>

namespace pbffd {

/// A value made when first asked for, by whichever thread comes first.
template <class Value>
class Lazy {
 public:
  template <class Make>
  const Value& get(Make&& make) {
    std::call_once(once_, [&] { isolated([&] { value_.emplace(make()); }); });
    return *value_;
  }

 private:
  std::once_flag once_;
  std::optional<Value> value_;
};

}  // namespace pbffd
