#include "core/base/file.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>
#include <system_error>

namespace pbffd {
namespace {

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() {
    if (value_ >= 0) {
      ::close(value_);
    }
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return value_; }

 private:
  int value_;
};

/// What the user can do about an error of the system.
std::string_view adviceFor(int code) {
  switch (code) {
    case ENOENT:
    case ENOTDIR:
      return "Check the name and its folder.";
    case EACCES:
    case EPERM:
    case EROFS:
      return "Choose a place that you may write to, or change the permissions.";
    case ENOSPC:
    case EDQUOT:
      return "Make room, or choose another place.";
    case ENAMETOOLONG:
      return "Choose a shorter name.";
    default:
      return "Try again, or choose another place.";
  }
}

void writeAll(int descriptor, std::string_view bytes, const std::filesystem::path& path) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written < 0) {
      failToWrite(path, errno);
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// Permissions of the file that is replaced, else what the user's mask gives a new file.
mode_t permissionsFor(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) {
    return status.st_mode & 07777;
  }
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

}  // namespace

void failToWrite(const std::filesystem::path& path, int code) {
  throw IoError(format("Could not write {}: {}. {}", path.string(), std::generic_category().message(code),
                       adviceFor(code)));
}

std::filesystem::path writeTarget(const std::filesystem::path& path) {
  std::error_code failure;
  std::filesystem::path target = path;
  constexpr int mostLinks = 40;
  for (int links = 0; std::filesystem::is_symlink(target, failure); ++links) {
    if (links == mostLinks) {
      failToWrite(path, ELOOP);
    }
    const std::filesystem::path next = std::filesystem::read_symlink(target, failure);
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  if (std::filesystem::exists(target, failure) && !std::filesystem::is_regular_file(target, failure)) {
    throw IoError(format("Could not write {}: it is not a regular file. Choose another name.", path.string()));
  }
  return target;
}

std::string readFile(const std::filesystem::path& path) {
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored)) {
    throw IoError(format("Could not read {}: it is a folder. Name a file in it.", path.string()));
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    const int code = errno;
    throw IoError(format("Could not read {}: {}. {}", path.string(), std::generic_category().message(code),
                         code == EACCES ? "Change its permissions, or ask its owner." : "Check the name."));
  }
  std::string bytes;
  std::error_code unknownSize;
  const auto size = std::filesystem::file_size(path, unknownSize);
  if (!unknownSize) {
    bytes.reserve(size);
  }
  std::array<char, 1 << 16> buffer;
  while (stream.read(buffer.data(), buffer.size()) || stream.gcount() > 0) {
    bytes.append(buffer.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) {
    throw IoError(
        format("Could not read {} to its end. Copy it to this machine and try again.", path.string()));
  }
  return bytes;
}

void synchronize(const std::filesystem::path& file, const std::filesystem::path& name) {
  const Descriptor opened(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (opened.get() < 0 || (::fsync(opened.get()) != 0 && errno != EINVAL && errno != EROFS)) {
    failToWrite(name, errno);
  }
}

void replaceFile(const std::filesystem::path& path,
                 const std::function<void(const std::filesystem::path& temporary)>& write) {
  // A link is followed, so that saving through it does not replace it.
  const std::filesystem::path target = writeTarget(path);
  std::string temporary = target.string() + ".XXXXXX";
  if (const Descriptor made(::mkstemp(temporary.data())); made.get() < 0) {
    failToWrite(path, errno);
  }
  try {
    write(temporary);
    synchronize(temporary, path);
    if (::chmod(temporary.c_str(), permissionsFor(target)) != 0 ||
        ::rename(temporary.c_str(), target.c_str()) != 0) {
      failToWrite(path, errno);
    }
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
}

void writeFileAtomically(const std::filesystem::path& path, std::string_view bytes) {
  replaceFile(path, [&](const std::filesystem::path& temporary) {
    const Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.get() < 0) {
      failToWrite(path, errno);
    }
    writeAll(file.get(), bytes, path);
  });
}

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
  unsigned int length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1) {
    throw IoError("Could not compute a SHA-256 digest.");
  }
  std::string text;
  for (unsigned int i = 0; i < length; ++i) {
    text += format("{:02x}", digest[i]);
  }
  return text;
}

}  // namespace pbffd
