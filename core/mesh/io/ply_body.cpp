#include "core/mesh/io/ply_body.h"

#include "core/base/text.h"
#include "core/mesh/io/numbers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace pbffd::io {
namespace {

/// The eight bytes at most of a number, in the order of this machine.
using Bytes = std::array<char, 8>;

bool isSwapped(PlyEncoding encoding) {
  constexpr bool isLittleHere = std::endian::native == std::endian::little;
  return (encoding == PlyEncoding::littleEndian) != isLittleHere;
}

/// Calls `visit` with a number of that type.
template <class Visitor>
auto visitType(PlyType type, Visitor visit) {
  switch (type) {
    case PlyType::int8:
      return visit(std::int8_t{});
    case PlyType::uint8:
      return visit(std::uint8_t{});
    case PlyType::int16:
      return visit(std::int16_t{});
    case PlyType::uint16:
      return visit(std::uint16_t{});
    case PlyType::int32:
      return visit(std::int32_t{});
    case PlyType::uint32:
      return visit(std::uint32_t{});
    case PlyType::float32:
      return visit(float{});
    case PlyType::float64:
      break;
  }
  return visit(double{});
}

double valueOf(const Bytes& bytes, PlyType type) {
  return visitType(type, [&](auto number) {
    std::memcpy(&number, bytes.data(), sizeof number);
    return static_cast<double>(number);
  });
}

Bytes bytesOf(double value, PlyType type) {
  return visitType(type, [&](auto number) {
    number = static_cast<decltype(number)>(value);
    Bytes bytes{};
    std::memcpy(bytes.data(), &number, sizeof number);
    return bytes;
  });
}

}  // namespace

PlyBody::PlyBody(const Input& input, const PlyHeader& header)
    : input_(input),
      encoding_(header.encoding),
      text_(input, {}, header.bodyByte, header.bodyLine),
      at_(header.bodyByte) {}

void PlyBody::fail(std::string_view what, std::string_view advice) const {
  if (encoding_ == PlyEncoding::ascii) {
    text_.fail(what, advice);
  }
  input_.failAtByte(last_.empty() ? at_ : static_cast<std::size_t>(last_.data() - input_.bytes.data()), what,
                    advice);
}

double PlyBody::number(PlyType type) {
  if (encoding_ == PlyEncoding::ascii) {
    last_ = text_.wordAnywhere();
    return text_.number(last_, "a number");
  }
  last_ = input_.bytes.substr(at_, sizeOf(type));
  if (last_.size() < sizeOf(type)) {
    fail("the file ends within its data", adviceCutOff);
  }
  at_ += last_.size();
  return decode(type);
}

double PlyBody::decode(PlyType type) const {
  Bytes bytes;
  std::memcpy(bytes.data(), last_.data(), last_.size());
  if (isSwapped(encoding_)) {
    std::reverse(bytes.data(), bytes.data() + last_.size());
  }
  return valueOf(bytes, type);
}

std::int64_t PlyBody::integer(PlyType type) {
  const double value = number(type);
  // Whole numbers of PLY have 32 bits.
  if (value != std::floor(value) || std::abs(value) > 4294967295.0) {
    fail(format("{} stands where a whole number belongs", value));
  }
  return static_cast<std::int64_t>(value);
}

/// Of numbers with so many bytes each; in a text a digit and a blank, but for the last.
bool PlyBody::hasRoom(std::size_t numbers, std::size_t bytesEach) const {
  const std::size_t left = bytesLeft();
  return encoding_ == PlyEncoding::ascii ? numbers <= (left + 1) / 2 : numbers <= left / bytesEach;
}

std::size_t PlyBody::bytesLeft() const {
  return input_.bytes.size() - std::min(input_.bytes.size(), byte());
}

std::size_t PlyBody::listLength(const PlyProperty& property) {
  const std::int64_t length = integer(*property.countType);
  if (length < 0) {
    fail(format("a list has the length {}", length));
  }
  if (!hasRoom(static_cast<std::size_t>(length), sizeOf(property.type))) {
    fail(format("a list has the length {}, but only {} bytes follow", length, bytesLeft()), adviceCutOff);
  }
  return static_cast<std::size_t>(length);
}

void PlyBody::skip(const PlyProperty& property) {
  std::size_t numbers = property.countType ? listLength(property) : 1;
  for (; numbers > 0; --numbers) {
    number(property.type);
  }
}

void PlyBody::checkRoom(const PlyElement& element) const {
  std::size_t each = 0;
  for (const PlyProperty& property : element.properties) {
    each += encoding_ == PlyEncoding::ascii ? 2 : sizeOf(property.countType.value_or(property.type));
  }
  const std::size_t slack = encoding_ == PlyEncoding::ascii ? 1 : 0;
  if (each > 0 && element.count > (bytesLeft() + slack) / each) {
    const std::string what = format("the header promises {} of the element {}, but only {} bytes follow",
                                    element.count, inQuotes(element.name), bytesLeft());
    if (encoding_ == PlyEncoding::ascii) {
      text_.fail(what, adviceCutOff);
    }
    input_.failAtByte(at_, what, adviceCutOff);
  }
}

std::size_t PlyBody::rest() {
  if (encoding_ != PlyEncoding::ascii) {
    return input_.bytes.size() - at_;
  }
  const std::string_view next = text_.wordAnywhere();
  return next.empty() ? 0 : input_.bytes.size() - static_cast<std::size_t>(next.data() - input_.bytes.data());
}

double heldValue(double value, PlyType type) {
  return visitType(type, [&](auto number) {
    using Number = decltype(number);
    using Limits = std::numeric_limits<Number>;
    if constexpr (Limits::is_integer) {
      return std::clamp(std::round(value), static_cast<double>(Limits::min()),
                        static_cast<double>(Limits::max()));
    } else {
      const bool isTooLarge = std::abs(value) > static_cast<double>(Limits::max());
      return isTooLarge ? std::copysign(std::numeric_limits<double>::infinity(), value)
                        : static_cast<double>(static_cast<Number>(value));
    }
  });
}

std::string encodePlyNumber(double value, PlyType type, PlyEncoding encoding) {
  if (isInteger(type)) {
    value = heldValue(value, type);
  }
  if (encoding == PlyEncoding::ascii) {
    std::string text;
    appendNumber(text, value);
    return text;
  }
  Bytes bytes = bytesOf(value, type);
  if (isSwapped(encoding)) {
    std::reverse(bytes.data(), bytes.data() + sizeOf(type));
  }
  return std::string(bytes.data(), sizeOf(type));
}

}  // namespace pbffd::io
