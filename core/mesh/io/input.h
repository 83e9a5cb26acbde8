#pragma once

#include "core/base/progress.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace pbffd::io {

inline constexpr std::string_view adviceCutOff = "The file may be cut off; export it again.";
inline constexpr std::string_view adviceCorrect = "Correct it there, or export the file again.";

/// A file that is being read, and how to say what is wrong with it: every message names the file, the line
/// or byte, what is wrong there and what to try.
struct Input {
  std::string_view bytes;
  std::string name;
  Progress progress;

  [[noreturn]] void fail(std::string_view what, std::string_view advice) const;
  /// `line` counts from 1.
  [[noreturn]] void failAtLine(std::size_t line, std::string_view what, std::string_view advice) const;
  /// `byte` counts from 0.
  [[noreturn]] void failAtByte(std::size_t byte, std::string_view what, std::string_view advice) const;

  /// Called every few thousand steps: reports how far reading is, and throws Cancelled when asked to stop.
  void checkpoint(std::size_t byte) const;
};

/// How many steps may lie between two checkpoints; a power of two.
inline constexpr std::size_t stepsToCheckpoint = 8192;

/// A word of a file for a message: in quotation marks, shortened, control characters and bytes that are no
/// ASCII replaced.
std::string inQuotes(std::string_view word);

/// "1 vertex", "2 vertices".
std::string counted(std::size_t count, std::string_view one, std::string_view many);

}  // namespace pbffd::io
