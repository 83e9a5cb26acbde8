#pragma once

#include <string>
#include <vector>

namespace pbffd {

/// A sentence that the user should know, in words that every program can show.
struct Remark {
  std::string text;
  std::string option;  ///< how the command line is told to do what the sentence speaks of; empty for nothing

  // A sentence alone is a remark too.
  Remark(std::string words, std::string itsOption = {})
      : text(std::move(words)), option(std::move(itsOption)) {}
};

/// The sentence as a command line says it: with the option in brackets before its full stop.
std::string withOption(const Remark& remark);
std::vector<std::string> withOptions(const std::vector<Remark>& remarks);

}  // namespace pbffd
