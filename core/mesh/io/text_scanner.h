#pragma once

#include "core/mesh/io/input.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pbffd::io {

struct TextSyntax {
  bool hasComments = false;       ///< '#' where a word could begin ends the line
  bool hasContinuations = false;  ///< a backslash at the end of a line joins the next to it
};

/// Reads a text file word by word. Lines end in LF, CR LF or CR. A word is a view into the bytes of the
/// input, so its place is known to who wants to replace it.
class TextScanner {
 public:
  /// Begins at byte `start`, which lies in line `line`; a byte order mark there is skipped.
  TextScanner(const Input& input, TextSyntax syntax, std::size_t start = 0, std::size_t line = 1);

  /// The next word of this line; empty at its end.
  std::string_view word();
  /// The next word of this or a later line; empty at the end of the file.
  std::string_view wordAnywhere();
  /// The first word of the next line that has one; empty at the end of the file.
  std::string_view firstWordOfNextLine();
  /// Past the rest of this line, comments and continuations included.
  void skipLine();

  /// The line of the last word, from 1.
  std::size_t line() const { return line_; }
  std::size_t byte() const { return static_cast<std::size_t>(at_ - input_.bytes.data()); }
  const Input& input() const { return input_; }

  // What a word stands for. An empty word is missing: `what` names it in the message, as do all others.
  double number(std::string_view word, std::string_view what) const;
  /// A finite number.
  double coordinate(std::string_view word, std::string_view what) const;
  std::int64_t integer(std::string_view word, std::string_view what) const;

  /// Throws InvalidInput for the line of the last word.
  [[noreturn]] void fail(std::string_view what, std::string_view advice = adviceCorrect) const;

 private:
  bool skipBlanks();
  bool skipContinuation();
  void skipLineEnd();
  [[noreturn]] void failMissing(std::string_view what) const;

  const Input& input_;
  TextSyntax syntax_;
  const char* at_;
  const char* end_;
  std::size_t line_;
};

}  // namespace pbffd::io
