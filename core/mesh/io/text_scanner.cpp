#include "core/mesh/io/text_scanner.h"

#include "core/base/text.h"
#include "core/mesh/io/numbers.h"

#include <cmath>

namespace pbffd::io {
namespace {

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

bool isLineEnd(char c) {
  return c == '\n' || c == '\r';
}

}  // namespace

TextScanner::TextScanner(const Input& input, TextSyntax syntax, std::size_t start, std::size_t line)
    : input_(input),
      syntax_(syntax),
      at_(input.bytes.data() + start),
      end_(input.bytes.data() + input.bytes.size()),
      line_(line) {
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  if (input.bytes.substr(start).starts_with(byteOrderMark)) {
    at_ += byteOrderMark.size();
  }
}

void TextScanner::skipLineEnd() {
  if (*at_ == '\r' && at_ + 1 < end_ && at_[1] == '\n') {
    ++at_;
  }
  ++at_;
  ++line_;
}

bool TextScanner::skipContinuation() {
  if (!syntax_.hasContinuations || *at_ != '\\' || at_ + 1 >= end_ || !isLineEnd(at_[1])) {
    return false;
  }
  ++at_;
  skipLineEnd();
  return true;
}

/// Whether this line goes on with a word.
bool TextScanner::skipBlanks() {
  while (at_ < end_) {
    if (isBlank(*at_)) {
      ++at_;
    } else if (isLineEnd(*at_)) {
      return false;
    } else if (syntax_.hasComments && *at_ == '#') {
      while (at_ < end_ && !isLineEnd(*at_)) {
        ++at_;
      }
      return false;
    } else if (!skipContinuation()) {
      return true;
    }
  }
  return false;
}

std::string_view TextScanner::word() {
  if (!skipBlanks()) {
    return {};
  }
  const char* begin = at_;
  while (at_ < end_ && !isBlank(*at_) && !isLineEnd(*at_)) {
    ++at_;
  }
  const bool joinsNextLine = syntax_.hasContinuations && at_[-1] == '\\' && at_ < end_ && isLineEnd(*at_);
  if (joinsNextLine) {
    --at_;
  }
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

std::string_view TextScanner::wordAnywhere() {
  while (!skipBlanks()) {
    if (at_ == end_) {
      return {};
    }
    skipLineEnd();
  }
  return word();
}

void TextScanner::skipLine() {
  while (!word().empty()) {
  }
  if (at_ < end_) {
    skipLineEnd();
  }
}

std::string_view TextScanner::firstWordOfNextLine() {
  skipLine();
  return wordAnywhere();
}

void TextScanner::failMissing(std::string_view what) const {
  if (at_ == end_) {
    fail(format("the file ends where {} belongs", what), adviceCutOff);
  }
  fail(format("the line ends where {} belongs", what));
}

double TextScanner::number(std::string_view word, std::string_view what) const {
  if (word.empty()) {
    failMissing(what);
  }
  const auto value = parseNumber(word);
  if (!value) {
    fail(format("{} stands where {} belongs, and is no number", inQuotes(word), what));
  }
  return *value;
}

double TextScanner::coordinate(std::string_view word, std::string_view what) const {
  const double value = number(word, what);
  if (!std::isfinite(value)) {
    fail(format("{} is {}, which is not a finite number", what, inQuotes(word)));
  }
  return value;
}

std::int64_t TextScanner::integer(std::string_view word, std::string_view what) const {
  if (word.empty()) {
    failMissing(what);
  }
  const auto value = parseInteger(word);
  if (!value) {
    fail(format("{} stands where {} belongs, and is no whole number", inQuotes(word), what));
  }
  return *value;
}

void TextScanner::fail(std::string_view what, std::string_view advice) const {
  input_.failAtLine(line_, what, advice);
}

}  // namespace pbffd::io
