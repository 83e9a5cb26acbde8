#include "app/dataset/gltf_text.h"

#include "core/base/text.h"

#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>

namespace pbffd {
namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::optional<std::string> fromBase64(std::string_view text) {
  while (text.ends_with('=')) {
    text.remove_suffix(1);
  }
  std::array<int, 256> values;
  values.fill(-1);
  for (std::size_t i = 0; i < alphabet.size(); ++i) {
    values[static_cast<unsigned char>(alphabet[i])] = static_cast<int>(i);
  }
  std::string bytes;
  bytes.reserve(text.size() * 3 / 4);
  std::uint32_t held = 0;
  int bits = 0;
  for (const char c : text) {
    const int value = values[static_cast<unsigned char>(c)];
    if (value < 0) {
      return std::nullopt;
    }
    held = held << 6 | static_cast<std::uint32_t>(value);
    bits += 6;
    if (bits >= 8) {
      bits -= 8;
      bytes += static_cast<char>(held >> bits & 0xff);
    }
  }
  return bytes;
}

std::string toBase64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t held = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      held = held << 8 | (at + k < bytes.size() ? static_cast<unsigned char>(bytes[at + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += at + k > bytes.size() ? '=' : alphabet[held >> (18 - 6 * k) & 63];
    }
  }
  return text;
}

std::string fromUri(std::string_view uri) {
  std::string name;
  while (!uri.empty()) {
    unsigned value = 0;
    const bool isCode = uri.size() >= 3 && uri[0] == '%' &&
                        std::from_chars(uri.data() + 1, uri.data() + 3, value, 16).ptr == uri.data() + 3;
    name += isCode ? static_cast<char>(value) : uri[0];
    uri.remove_prefix(isCode ? 3 : 1);
  }
  return name;
}

std::string toUri(std::string_view name) {
  std::string uri;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool isPlain = std::isalnum(byte) != 0 || std::string_view("-._~/").find(c) != std::string_view::npos;
    uri += isPlain ? std::string(1, c) : format("%{:02X}", byte);
  }
  return uri;
}

}  // namespace pbffd
