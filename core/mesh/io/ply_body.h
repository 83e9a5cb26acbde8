#pragma once

#include "core/mesh/io/ply_header.h"
#include "core/mesh/io/text_scanner.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace pbffd::io {

/// Reads the data of a PLY file number by number, in text and in both binary orders alike.
class PlyBody {
 public:
  PlyBody(const Input& input, const PlyHeader& header);

  /// The next number. Throws InvalidInput where the file ends before it or it is none.
  double number(PlyType type);
  /// The next number as a whole one; throws InvalidInput where it is not.
  std::int64_t integer(PlyType type);
  /// The length of a list, not negative and with room for its numbers.
  std::size_t listLength(const PlyProperty& property);

  /// The bytes of the last number: a word, or its binary form.
  std::string_view last() const { return last_; }

  /// Past one property of one row, whatever it is.
  void skip(const PlyProperty& property);
  /// Throws InvalidInput where fewer bytes are left than `element` needs at least.
  void checkRoom(const PlyElement& element) const;

  std::size_t byte() const { return encoding_ == PlyEncoding::ascii ? text_.byte() : at_; }
  /// Bytes behind the last number that was read, blanks of a text file not counted.
  std::size_t rest();
  /// Throws InvalidInput for the place of the last number.
  [[noreturn]] void fail(std::string_view what, std::string_view advice = adviceCorrect) const;

 private:
  double decode(PlyType type) const;
  std::size_t bytesLeft() const;
  bool hasRoom(std::size_t numbers, std::size_t bytesEach) const;

  const Input& input_;
  PlyEncoding encoding_;
  TextScanner text_;
  std::size_t at_;
  std::string_view last_;
};

/// The number that a property of that type holds for `value`: the nearest, infinite where a floating-point
/// type has no such number.
double heldValue(double value, PlyType type);

/// The bytes that stand for a number in a file of that encoding: in text its shortest form, in binary what
/// the type holds.
std::string encodePlyNumber(double value, PlyType type, PlyEncoding encoding);

}  // namespace pbffd::io
