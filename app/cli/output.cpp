#include "app/cli/output.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace pbffd::cli {

void print(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw IoError(format("Could not write to standard output: {}.", std::generic_category().message(errno)));
  }
}

void printRemarks(const std::vector<std::string>& remarks) {
  for (const std::string& remark : remarks) {
    std::fprintf(stderr, "pbffd: %s\n", remark.c_str());
  }
}

std::string lastWords() {
  return "pbffd: Cancelled; nothing was written.\n";
}

std::string grouped(std::int64_t number) {
  std::string digits = std::to_string(number);
  const std::size_t first = number < 0 ? 1 : 0;
  for (std::size_t at = digits.size(); at > first + 3;) {
    at -= 3;
    digits.insert(at, 1, ',');
  }
  return digits;
}

}  // namespace pbffd::cli
