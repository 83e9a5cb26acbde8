#include "app/dataset/partition.h"

#include "app/dataset/dataset.h"
#include "app/dataset/xml_tags.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"

#include <sys/stat.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

namespace pbffd {
namespace fs = std::filesystem;
namespace {

/// Where a piece lies below the folder of the new index: its own relative name, without leaving that folder.
fs::path relativeName(const fs::path& name) {
  if (name.is_absolute()) {
    return name.filename();
  }
  fs::path relative;
  for (const fs::path& part : name.lexically_normal()) {
    if (part != "..") {
      relative /= part;
    }
  }
  return relative;
}

/// Where below the folder of the new index the pieces go; empty for that folder itself. Two indexes that are
/// made of one source must not share pieces.
fs::path piecesFolder(const fs::path& index, const fs::path& target) {
  return index.filename() == target.filename() ? fs::path() : target.stem();
}

/// What tells files apart, whatever they are called; nothing where there is none.
using FileId = std::pair<dev_t, ino_t>;
std::optional<FileId> fileAt(const fs::path& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? std::optional(FileId(status.st_dev, status.st_ino))
                                            : std::nullopt;
}

/// The pieces by the files that they are read from.
std::multimap<FileId, std::size_t> piecesByFile(const Partition& partition) {
  std::multimap<FileId, std::size_t> pieces;
  for (std::size_t p = 0; p < partition.pieces.size(); ++p) {
    if (const auto file = fileAt(partition.pieces[p].source)) {
      pieces.emplace(*file, p);
    }
  }
  return pieces;
}

/// Writing a piece must not take away what another one is read from.
void requireNoSource(const Partition& partition, std::size_t piece,
                     const std::multimap<FileId, std::size_t>& sources) {
  const fs::path& target = partition.pieces[piece].target;
  const auto there = fileAt(target);
  const auto [begin, end] = there ? sources.equal_range(*there) : std::pair(sources.end(), sources.end());
  const auto other = std::find_if(begin, end, [&](const auto& source) { return source.second != piece; });
  if (other != end) {
    throw InvalidInput(format("Could not write {}: it is {} of the source. Choose another folder.",
                              target.string(), describePiece(partition, other->second)));
  }
}

void requirePieces(const Partition& partition) {
  const std::multimap<FileId, std::size_t> sources = piecesByFile(partition);
  std::set<fs::path> targets;
  for (std::size_t p = 0; p < partition.pieces.size(); ++p) {
    const Partition::Piece& piece = partition.pieces[p];
    std::error_code ignored;
    if (!fs::exists(piece.source, ignored)) {
      throw InvalidInput(format(
          "Could not read {}: the file of {} does not exist. Put it back at {}, or take it out of the index.",
          partition.index.string(), describePiece(partition, p), piece.source.string()));
    }
    if (!targets.insert(piece.target).second) {
      throw InvalidInput(
          format("Could not read {}: {} would be written to {}, like another piece. Give each piece "
                 "a name of its own.",
                 partition.index.string(), describePiece(partition, p), piece.target.string()));
    }
    requireNoSource(partition, p, sources);
  }
}

}  // namespace

bool isPartition(const fs::path& path) {
  return std::find(partitionEndings.begin(), partitionEndings.end(), endingOf(path)) != partitionEndings.end();
}

Partition readPartition(const fs::path& index, const fs::path& target) {
  requireSameEnding(index, target);
  Partition partition{index, readFile(index), {}};
  const fs::path below = piecesFolder(index, target);
  try {
    for (const XmlTag& tag : scanXmlTags(partition.text)) {
      const XmlTag::Attribute* source = tag.find("Source");
      if (tag.name != "Piece" || tag.isEnd || source == nullptr) {
        continue;
      }
      const fs::path name = below / relativeName(source->value);
      partition.pieces.push_back({index.parent_path() / source->value, target.parent_path() / name,
                                  name.generic_string(), source->begin, source->end});
    }
  } catch (const InvalidInput& error) {
    throw InvalidInput(
        format("Could not read {}: {}. The file is damaged; write it anew.", index.string(), error.what()));
  }
  if (partition.pieces.empty()) {
    throw InvalidInput(
        format("Could not read {}: it names no piece (<Piece Source=\"...\">). Is it the index of a "
               "partitioned data set?",
               index.string()));
  }
  requirePieces(partition);
  return partition;
}

std::string indexText(const Partition& partition) {
  std::string text;
  std::size_t at = 0;
  for (const Partition::Piece& piece : partition.pieces) {
    text.append(partition.text, at, piece.begin - at);
    text += escapedForXml(piece.targetName);
    at = piece.end;
  }
  return text + partition.text.substr(at);
}

std::string describePiece(const Partition& partition, std::size_t piece) {
  return format("piece {} of {} ({})", piece + 1, partition.pieces.size(),
                partition.pieces[piece].source.lexically_normal().string());
}

}  // namespace pbffd
