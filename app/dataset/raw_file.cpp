#include "app/dataset/raw_file.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>
#include <vector>

namespace pbffd {
namespace {

/// Copied between two looks at whether to go on.
constexpr std::uint64_t copyStep = std::uint64_t{32} << 20;

[[noreturn]] void failToRead(const std::filesystem::path& name, int code) {
  throw IoError(format("Could not read {}: {}. Copy it to this machine and try again.", name.string(),
                       std::generic_category().message(code)));
}

}  // namespace

RawFile RawFile::forReading(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    failToRead(path, errno);
  }
  return {descriptor, path};
}

RawFile RawFile::forWriting(const std::filesystem::path& path, const std::filesystem::path& name) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) {
    failToWrite(name, errno);
  }
  return {descriptor, name};
}

RawFile::~RawFile() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

RawFile::RawFile(RawFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), name_(std::move(other.name_)) {}

void RawFile::close() {
  if (::close(std::exchange(descriptor_, -1)) != 0 && errno != EINTR) {
    failToWrite(name_, errno);
  }
}

void RawFile::read(std::uint64_t at, std::span<char> bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (count < 0 && errno == EINTR) {
      continue;
    }
    if (count <= 0) {
      failToRead(name_, count < 0 ? errno : EIO);
    }
    bytes = bytes.subspan(static_cast<std::size_t>(count));
    at += static_cast<std::uint64_t>(count);
  }
}

void RawFile::write(std::uint64_t at, std::string_view bytes) {
  const std::uint64_t begin = at;
  while (!bytes.empty()) {
    const ssize_t count = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (count < 0 && errno == EINTR) {
      continue;
    }
    if (count < 0) {
      failToWrite(name_, errno);
    }
    bytes.remove_prefix(static_cast<std::size_t>(count));
    at += static_cast<std::uint64_t>(count);
  }
  beginWriting(begin, at - begin);
}

void RawFile::copyWhole(const std::filesystem::path& source, const std::filesystem::path& path,
                        const std::filesystem::path& name, const Progress& progress) {
  RawFile out = forWriting(path, name);
  out.copy(forReading(source), 0, std::filesystem::file_size(source), 0, progress);
  out.close();
}

void RawFile::beginWriting(std::uint64_t at, std::uint64_t bytes) const {
  // Where that is not possible the disk begins when it likes.
  ::sync_file_range(descriptor_, static_cast<off_t>(at), static_cast<off_t>(bytes), SYNC_FILE_RANGE_WRITE);
}

bool RawFile::copyInKernel(const RawFile& source, std::uint64_t from, std::uint64_t at, std::uint64_t bytes) {
  auto in = static_cast<off_t>(from);
  auto out = static_cast<off_t>(at);
  while (bytes > 0) {
    const ssize_t count = ::copy_file_range(source.descriptor_, &in, descriptor_, &out, bytes, 0);
    if (count < 0 && errno == EINTR) {
      continue;
    }
    if (count < 0 && (errno == ENOSPC || errno == EDQUOT || errno == EFBIG)) {
      failToWrite(name_, errno);
    }
    if (count <= 0) {
      return false;
    }
    bytes -= static_cast<std::uint64_t>(count);
  }
  return true;
}

void RawFile::copy(const RawFile& source, std::uint64_t from, std::uint64_t end, std::uint64_t at,
                   const Progress& progress) {
  bool inKernel = true;
  std::vector<char> buffer;
  for (; from < end; from += std::min(copyStep, end - from), at += copyStep) {
    progress.throwIfCancelled();
    const std::uint64_t bytes = std::min(copyStep, end - from);
    // Not every pair of file systems can do it; what was copied before it failed is copied again.
    inKernel = inKernel && copyInKernel(source, from, at, bytes);
    if (!inKernel) {
      buffer.resize(bytes);
      source.read(from, buffer);
      write(at, {buffer.data(), buffer.size()});
    } else {
      beginWriting(at, bytes);
    }
  }
}

}  // namespace pbffd
