#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace pbffd {

/// The whole content of a file. Throws IoError that names the file and the reason.
std::string readFile(const std::filesystem::path& path);

/// Writes beside `path` and renames, so that `path` holds either its old content or all of the new one.
/// Throws IoError that names the file and the reason (a full disk, no permission); `path` is then untouched.
void writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

/// The same for what `write` puts into the file that it is given the name of, an empty one beside `path`; it may
/// replace it. What `write` throws passes through.
void replaceFile(const std::filesystem::path& path,
                 const std::function<void(const std::filesystem::path& temporary)>& write);

/// Waits until the disk has the whole file, called `name` in messages; at once on file systems that cannot. Throws
/// IoError.
void synchronize(const std::filesystem::path& file, const std::filesystem::path& name);

/// Where writing to `path` ends: links are followed, also one to a file that is not there yet. Throws IoError
/// where something is there that is no regular file.
std::filesystem::path writeTarget(const std::filesystem::path& path);

/// Throws the IoError of a file that could not be written: names it, what the system says (an errno), what to
/// try.
[[noreturn]] void failToWrite(const std::filesystem::path& path, int code);

/// The SHA-256 digest of `bytes`, 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace pbffd
