#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pbffd::cli {

/// Writes to standard output. Throws IoError where that cannot be written (a full disk, a closed pipe).
void print(std::string_view text);

/// Writes what the user should know to standard error, a line each.
void printRemarks(const std::vector<std::string>& remarks);

/// What standard error is told when cancelled work is ended.
std::string lastWords();

/// 12345 as "12,345".
std::string grouped(std::int64_t number);

}  // namespace pbffd::cli
