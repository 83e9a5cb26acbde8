#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pbffd::io {

/// The number that the whole word spells in decimal, a plus sign allowed; infinite where it is too large
/// for a double, and infinite or NaN where the word says so. Independent of the locale.
std::optional<double> parseNumber(std::string_view word);

/// The integer that the whole word spells in decimal.
std::optional<std::int64_t> parseInteger(std::string_view word);

/// Appends the shortest decimal text that reads back as the same number.
void appendNumber(std::string& text, double value);

void appendInteger(std::string& text, std::int64_t value);

}  // namespace pbffd::io
