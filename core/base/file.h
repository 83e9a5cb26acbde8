#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace pbffd {

/// The whole content of a file. Throws IoError that names the file and the reason.
std::string readFile(const std::filesystem::path& path);

/// Writes beside `path` and renames, so that `path` holds either its old content or all of the new one.
/// Throws IoError that names the file and the reason (a full disk, no permission); `path` is then untouched.
void writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

/// The SHA-256 digest of `bytes`, 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace pbffd
