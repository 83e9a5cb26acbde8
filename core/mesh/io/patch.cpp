#include "core/mesh/io/patch.h"

#include "core/mesh/io/numbers.h"

#include <utility>

namespace pbffd::io {

Patch::Patch(std::string_view source) : source_(source) {
  result_.reserve(source.size() + source.size() / 4);
}

void Patch::replace(std::string_view piece, std::string_view bytes) {
  const auto begin = static_cast<std::size_t>(piece.data() - source_.data());
  result_.append(source_, copied_, begin - copied_);
  result_.append(bytes);
  copied_ = begin + piece.size();
}

void Patch::replace(std::string_view piece, double number) {
  replace(piece, std::string_view());
  appendNumber(result_, number);
}

std::string Patch::finish() {
  result_.append(source_, copied_);
  copied_ = source_.size();
  return std::exchange(result_, {});
}

}  // namespace pbffd::io
