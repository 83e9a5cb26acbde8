#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pbffd::io {

/// A copy of some bytes in which pieces are replaced, from front to back. All else stays as it is.
class Patch {
 public:
  explicit Patch(std::string_view source);

  /// `piece` is a view into the source, behind all pieces before it.
  void replace(std::string_view piece, std::string_view bytes);
  /// With the shortest decimal text of the number.
  void replace(std::string_view piece, double number);

  /// The copy, to its end. The patch is empty afterwards.
  std::string finish();

 private:
  std::string_view source_;
  std::size_t copied_ = 0;  ///< bytes of the source that are in the result or replaced
  std::string result_;
};

}  // namespace pbffd::io
