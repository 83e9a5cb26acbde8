#include "app/dataset/raw_header.h"

#include "core/base/text.h"

#include <algorithm>

namespace pbffd {
namespace {

/// More than the longest double takes.
constexpr std::size_t width = 26;

}  // namespace

void LengthRange::add(const StoredLengths& lengths) {
  least = std::min(least, lengths.least);
  largest = std::max(largest, lengths.largest);
}

RawHeader::RawHeader(const std::string& text, const std::vector<const RawArray*>& arrays) {
  for (std::size_t a = 0; a < arrays.size(); ++a) {
    for (const RawArray::Range& range : arrays[a]->ranges) {
      rooms_.push_back({range, a, 0, {}});
    }
  }
  std::sort(rooms_.begin(), rooms_.end(),
            [](const Room& x, const Room& y) { return x.range.begin < y.range.begin; });
  std::size_t at = 0;
  for (Room& room : rooms_) {
    text_.append(text, at, room.range.begin - at);
    room.begin = text_.size();
    // The closing quote of an attribute follows its number, the spaces follow the quote.
    text_.append(width + (room.range.isAttribute ? 1 : 0), ' ');
    room.quote = room.range.isAttribute ? text.substr(room.range.end, 1) : std::string();
    at = room.range.end + room.quote.size();
  }
  text_.append(text, at);
}

std::string RawHeader::filled(const std::vector<LengthRange>& lengths) const {
  std::string text = text_;
  for (const Room& room : rooms_) {
    const LengthRange& range = lengths[room.array];
    const double length = room.range.isLargest ? range.largest : std::min(range.least, range.largest);
    const std::string number = format("{}", length) + room.quote;
    text.replace(room.begin, number.size(), number);
  }
  return text;
}

}  // namespace pbffd
