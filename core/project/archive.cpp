#include "core/project/archive.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"

#include <zip.h>

#include <algorithm>
#include <memory>
#include <unordered_set>

namespace pbffd {
namespace {

constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20;
/// No mesh that this program can open is larger.
constexpr std::uint64_t largestMember = 8192 * mebibyte;
/// Text packs to a tenth or so; what promises far more is made to fill the memory.
constexpr std::uint64_t suspiciousSize = 64 * mebibyte;
constexpr std::uint64_t suspiciousRatio = 400;

struct CloseArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
using ArchiveHandle = std::unique_ptr<zip_t, CloseArchive>;

struct CloseFile {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using FileHandle = std::unique_ptr<zip_file_t, CloseFile>;

struct FreeSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using SourceHandle = std::unique_ptr<zip_source_t, FreeSource>;

std::string messageOf(zip_error_t& error) {
  std::string message = zip_error_strerror(&error);
  zip_error_fini(&error);
  return message;
}

[[noreturn]] void failToOpen(const std::filesystem::path& path, const std::string& why) {
  throw InvalidInput(
      format("Could not open {}: {}. The file may be cut off or damaged; copy it again, or open an "
             "earlier version.",
             path.string(), why));
}

/// An archive over bytes that outlive it.
ArchiveHandle openedArchive(const std::filesystem::path& path, const std::string& bytes) {
  zip_error_t error;
  zip_error_init(&error);
  SourceHandle source(zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error));
  if (!source) {
    throw IoError(format("Could not open {}: {}.", path.string(), messageOf(error)));
  }
  ArchiveHandle archive(zip_open_from_source(source.get(), ZIP_RDONLY, &error));
  if (!archive) {
    failToOpen(path, format("it is not a whole ZIP archive ({})", messageOf(error)));
  }
  source.release();
  zip_error_fini(&error);
  return archive;
}

void requireReadable(const std::filesystem::path& path, const zip_stat_t& status) {
  if ((status.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && status.encryption_method != ZIP_EM_NONE) {
    failToOpen(path, format("{} in it is encrypted", status.name));
  }
  const std::uint64_t packed = std::max<std::uint64_t>(status.comp_size, 1);
  if (status.size > largestMember || (status.size > suspiciousSize && status.size / packed > suspiciousRatio)) {
    failToOpen(path, format("{} in it claims to unpack to {} MiB", status.name, status.size / mebibyte));
  }
}

std::string unpacked(zip_t* archive, const std::filesystem::path& path, const zip_stat_t& status,
                     const Progress& progress) {
  const FileHandle file(zip_fopen_index(archive, status.index, 0));
  if (!file) {
    failToOpen(path, format("{} in it cannot be unpacked ({})", status.name, zip_strerror(archive)));
  }
  std::string bytes(status.size, '\0');
  std::uint64_t filled = 0;
  while (filled < status.size) {
    progress.throwIfCancelled();
    const auto read =
        zip_fread(file.get(), bytes.data() + filled, std::min(status.size - filled, 4 * mebibyte));
    if (read <= 0) {
      failToOpen(path, format("{} in it is damaged ({})", status.name,
                              read < 0 ? zip_file_strerror(file.get()) : "it ends early"));
    }
    filled += static_cast<std::uint64_t>(read);
  }
  // The check sum is looked at when the end is reached.
  char beyond = 0;
  if (const auto more = zip_fread(file.get(), &beyond, 1); more != 0) {
    failToOpen(path, format("{} in it is damaged ({})", status.name,
                            more < 0 ? zip_file_strerror(file.get()) : "it is longer than it says"));
  }
  return bytes;
}

[[noreturn]] void failToBuild(zip_t* archive, const std::filesystem::path& path) {
  zip_error_t* const error = zip_get_error(archive);
  if (zip_error_system_type(error) == ZIP_ET_SYS && zip_error_code_system(error) != 0) {
    failToWrite(path, zip_error_code_system(error));
  }
  throw IoError(format("Could not write {}: {}.", path.string(), zip_error_strerror(error)));
}

void add(zip_t* archive, const std::filesystem::path& path, const ArchiveMember& member) {
  constexpr zip_flags_t utf8 = ZIP_FL_ENC_UTF_8;
  zip_int64_t index = -1;
  if (member.name.ends_with('/')) {
    index = zip_dir_add(archive, member.name.c_str(), utf8);
  } else {
    SourceHandle source(zip_source_buffer(archive, member.content().data(), member.content().size(), 0));
    index = source ? zip_file_add(archive, member.name.c_str(), source.get(), utf8) : -1;
    if (index >= 0) {
      source.release();
    }
  }
  if (index < 0) {
    failToBuild(archive, path);
  }
  const auto place = static_cast<zip_uint64_t>(index);
  // Of the levels 1 to 9: a mesh of 64 MB takes 0.9 s, a sixteenth of what the 9th takes, to a third of its length
  // (0.336 of it; the 9th 0.318).
  constexpr zip_uint32_t level = 4;
  const zip_int32_t method = member.compressed && !member.content().empty() ? ZIP_CM_DEFLATE : ZIP_CM_STORE;
  // The earliest date that a ZIP can hold: the same project gives the same bytes.
  constexpr zip_uint16_t midnight = 0;
  constexpr zip_uint16_t firstOf1980 = (1U << 5U) | 1U;
  if (zip_set_file_compression(archive, place, method, level) != 0 ||
      zip_file_set_dostime(archive, place, midnight, firstOf1980, 0) != 0) {
    failToBuild(archive, path);
  }
}

int isCancelled(zip_t*, void* progress) {
  return static_cast<const Progress*>(progress)->isCancelled() ? 1 : 0;
}

}  // namespace

const ArchiveMember* Archive::find(const std::string& name) const {
  const auto found = std::find_if(members.begin(), members.end(),
                                  [&](const ArchiveMember& member) { return member.name == name; });
  return found == members.end() ? nullptr : &*found;
}

Archive readArchive(const std::filesystem::path& path, const Progress& progress) {
  const std::string bytes = readFile(path);
  if (bytes.empty()) {
    failToOpen(path, "it is empty");
  }
  const ArchiveHandle handle = openedArchive(path, bytes);
  Archive archive;
  std::uint64_t total = 0;
  std::unordered_set<std::string> names;
  for (zip_int64_t i = 0; i < zip_get_num_entries(handle.get(), 0); ++i) {
    zip_stat_t status;
    constexpr zip_uint64_t needed = ZIP_STAT_NAME | ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_INDEX;
    if (zip_stat_index(handle.get(), static_cast<zip_uint64_t>(i), 0, &status) != 0 ||
        (status.valid & needed) != needed) {
      failToOpen(path, "its list of members is damaged");
    }
    requireReadable(path, status);
    total += status.size;
    if (total > largestMember) {
      failToOpen(path, format("its members claim to unpack to more than {} MiB", largestMember / mebibyte));
    }
    // Readers differ in which of two members of one name they take.
    if (!names.insert(status.name).second) {
      failToOpen(path, format("{} is in it twice", status.name));
    }
    archive.members.push_back(
        {status.name, unpacked(handle.get(), path, status, progress),
         (status.valid & ZIP_STAT_COMP_METHOD) == 0 || status.comp_method != ZIP_CM_STORE});
  }
  return archive;
}

void writeArchive(const std::filesystem::path& path, const Archive& archive, const Progress& progress) {
  replaceFile(path, [&](const std::filesystem::path& temporary) {
    int code = 0;
    ArchiveHandle handle(zip_open(temporary.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code));
    if (!handle) {
      zip_error_t error;
      zip_error_init_with_code(&error, code);
      throw IoError(format("Could not write {}: {}.", path.string(), messageOf(error)));
    }
    for (const ArchiveMember& member : archive.members) {
      add(handle.get(), path, member);
    }
    Progress asked = progress;
    zip_register_cancel_callback_with_state(handle.get(), isCancelled, nullptr, &asked);
    if (zip_close(handle.get()) != 0) {
      progress.throwIfCancelled();
      failToBuild(handle.get(), path);
    }
    handle.release();
  });
}

}  // namespace pbffd
