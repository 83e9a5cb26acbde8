#include "core/mesh/io/input.h"

#include "core/base/error.h"
#include "core/base/text.h"

namespace pbffd::io {

void Input::fail(std::string_view what, std::string_view advice) const {
  throw InvalidInput(format("Could not read {}. {}. {}", name, what, advice));
}

void Input::failAtLine(std::size_t line, std::string_view what, std::string_view advice) const {
  fail(format("Line {}: {}", line, what), advice);
}

void Input::failAtByte(std::size_t byte, std::string_view what, std::string_view advice) const {
  fail(format("Byte {}: {}", byte, what), advice);
}

void Input::checkpoint(std::size_t byte) const {
  progress.throwIfCancelled();
  progress.report("Reading the mesh", bytes.empty() ? 1.0 : static_cast<double>(byte) / bytes.size());
}

std::string inQuotes(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string result = "\"";
  for (const char c : word.substr(0, longest)) {
    result += c >= ' ' && c <= '~' ? c : '?';
  }
  if (word.size() > longest) {
    result += "...";
  }
  return result + '"';
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return format("{} {}", count, count == 1 ? one : many);
}

}  // namespace pbffd::io
