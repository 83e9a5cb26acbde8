#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pbffd {

/// Base64 (RFC 4648). Nothing where a character is none of its alphabet.
std::optional<std::string> fromBase64(std::string_view text);
std::string toBase64(std::string_view bytes);

/// The name that a relative URI stands for ("a%20b.bin": "a b.bin"), and back.
std::string fromUri(std::string_view uri);
std::string toUri(std::string_view name);

}  // namespace pbffd
