#include "core/mesh/io/numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <system_error>

namespace pbffd::io {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// What a number becomes whose decimal form is beyond the range of doubles: the sign of its exponent tells
/// too large from too small, and without an exponent only digits before the point make it too large.
double outOfRange(std::string_view word) {
  const bool isNegative = word.front() == '-';
  const std::size_t exponent = word.find_first_of("eE");
  bool isSmall = false;
  if (exponent != std::string_view::npos) {
    isSmall = exponent + 1 < word.size() && word[exponent + 1] == '-';
  } else {
    const std::string_view whole = word.substr(0, word.find('.'));
    isSmall = std::none_of(whole.begin(), whole.end(), [](char c) { return c >= '1' && c <= '9'; });
  }
  const double size = isSmall ? 0.0 : std::numeric_limits<double>::infinity();
  return isNegative ? -size : size;
}

}  // namespace

std::optional<double> parseNumber(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && (isDigit(word[1]) || word[1] == '.' || word[1] == 'i')) {
    word.remove_prefix(1);
  }
  double value = 0.0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || word.empty() || error == std::errc::invalid_argument) {
    return std::nullopt;
  }
  return error == std::errc::result_out_of_range ? outOfRange(word) : value;
}

std::optional<std::int64_t> parseInteger(std::string_view word) {
  std::int64_t value = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || error != std::errc()) {
    return std::nullopt;
  }
  return value;
}

void appendNumber(std::string& text, double value) {
  // The longest shortest form of a double has 24 characters.
  std::array<char, 32> buffer;
  const auto written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), written.ptr);
}

void appendInteger(std::string& text, std::int64_t value) {
  std::array<char, 32> buffer;
  const auto written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), written.ptr);
}

}  // namespace pbffd::io
