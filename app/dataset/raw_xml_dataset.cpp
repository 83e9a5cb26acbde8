#include "app/dataset/raw_xml_dataset.h"

#include "app/dataset/raw_file.h"
#include "app/dataset/raw_header.h"
#include "app/dataset/raw_rows.h"
#include "app/dataset/raw_xml_layout.h"
#include "app/dataset/vtk_cell_kinds.h"
#include "app/dataset/vtk_dataset.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

namespace pbffd {
namespace {

/// Rows taken at a time: enough to find what is near in space, little memory.
constexpr std::int64_t portion = 1 << 17;

/// Bytes copied at a time.
constexpr std::uint64_t copyPortion = std::uint64_t{32} << 20;

/// A piece's array that changes.
struct Moving {
  const RawArray* array;
  FieldKind kind;  ///< of a field; unused for the positions
  std::uint64_t bytes;
};

/// What changes of a piece: the positions first, then the fields.
struct MovingPiece {
  std::vector<Moving> arrays;
  std::int64_t points;
  std::size_t first;  ///< number of the first of them among the arrays of all pieces
};

/// A part of the work on a file, independent of the others: rows of a piece, or bytes to copy.
struct Part {
  const MovingPiece* piece;  ///< null: bytes
  std::uint64_t begin;       ///< the first row or byte
  std::uint64_t end;
};

class RawXmlDataset : public Dataset {
 public:
  RawXmlDataset(std::filesystem::path path, RawXmlLayout layout)
      : path_(std::move(path)), layout_(std::move(layout)), file_(RawFile::forReading(path_)) {}

  std::int64_t pointCount() const override {
    std::int64_t count = 0;
    for (const RawPiece& piece : layout_.pieces) {
      count += piece.points;
    }
    return count;
  }

  bool hasVolumeCells() const override {
    return std::any_of(layout_.pieces.begin(), layout_.pieces.end(), [&](const RawPiece& piece) {
      std::vector<char> types;
      const std::int64_t cells = piece.cellTypes == 0 ? 0 : piece.cells;
      for (std::int64_t first = 0; first < cells; first += portion) {
        types.resize(static_cast<std::size_t>(std::min(portion, cells - first)));
        file_.read(piece.cellTypes + static_cast<std::uint64_t>(first), types);
        if (std::any_of(types.begin(), types.end(), [](char type) { return isVolumeCell(type); })) {
          return true;
        }
      }
      return false;
    });
  }

  Points sample(std::int64_t stride) const override {
    Points points((pointCount() + stride - 1) / stride, 3);
    Eigen::Index row = 0;
    std::int64_t before = 0;
    for (const RawPiece& piece : layout_.pieces) {
      for (std::int64_t i = (stride - before % stride) % stride; i < piece.points; i += stride) {
        points.row(row++) = readRows(file_, piece.positions, i, 1, layout_.isSwapped);
      }
      before += piece.points;
    }
    return points;
  }

  std::vector<Remark> write(const std::filesystem::path& target, StagedFiles& staged,
                            const Carrying& carrying) override {
    requireSameEnding(path_, target);
    if (turnsCellArrays(carrying.transports)) {
      return openVtkDataset(path_, carrying.progress)->write(target, staged, carrying);
    }
    const std::vector<MovingPiece> moving = movingPieces(carrying.transports);
    const std::filesystem::path path = staged.add(target);
    if (!writeMoved(path, target, moving, carrying)) {
      RawFile::copyWhole(path_, path, target, carrying.progress);
      return {};
    }
    return remarks(carrying.transports);
  }

 private:
  /// Those need the points of each cell, which lie anywhere in the file: VTK reads it whole then.
  bool turnsCellArrays(const std::vector<Transport>& transports) const {
    return std::any_of(transports.begin(), transports.end(), [&](const Transport& transport) {
      return layout_.cellArrays.contains(transport.array);
    });
  }

  std::vector<MovingPiece> movingPieces(const std::vector<Transport>& transports) const {
    std::vector<MovingPiece> pieces;
    std::size_t first = 0;
    for (const RawPiece& piece : layout_.pieces) {
      if (piece.points > 0) {
        pieces.push_back({movingOf(piece, transports), piece.points, first});
        first += pieces.back().arrays.size();
      }
    }
    return pieces;
  }

  std::vector<Moving> movingOf(const RawPiece& piece, const std::vector<Transport>& transports) const {
    const auto bytes = [&](const RawArray& array) {
      return array.rowBytes() * static_cast<std::uint64_t>(piece.points);
    };
    std::vector<Moving> moving{{&piece.positions, FieldKind::vector, bytes(piece.positions)}};
    for (const Transport& transport : transports) {
      const auto array =
          std::find_if(piece.pointArrays.begin(), piece.pointArrays.end(),
                       [&](const RawArray& candidate) { return candidate.name == transport.array; });
      if (array == piece.pointArrays.end()) {
        failForMissingArray(path_, transport,
                            "there is none of that name with three real numbers a row in its point data. Check "
                            "the name.");
      }
      const bool isNormal = array->name == piece.normals || namesNormals(array->name);
      moving.push_back(
          {&*array, transport.kind.value_or(isNormal ? FieldKind::normal : FieldKind::vector), bytes(*array)});
    }
    return moving;
  }

  /// Returns whether anything may be other than before; else what was written is of no use.
  bool writeMoved(const std::filesystem::path& path, const std::filesystem::path& target,
                  const std::vector<MovingPiece>& moving, const Carrying& carrying) const {
    if (!carrying.space.movesAnything()) {
      return false;
    }
    RawFile out = RawFile::forWriting(path, target);
    // What turns along may turn where no point moves.
    const bool hasMoved = copyMoved(out, moving, carrying) || !carrying.transports.empty();
    out.close();
    return hasMoved;
  }

  /// Copies and deforms at once: the one waits for the disk and the memory, the other for the processor.
  /// Returns whether any point is elsewhere now.
  bool copyMoved(RawFile& out, const std::vector<MovingPiece>& pieces, const Carrying& carrying) const {
    std::vector<const RawArray*> arrays;
    for (const MovingPiece& piece : pieces) {
      for (const Moving& moving : piece.arrays) {
        arrays.push_back(moving.array);
      }
    }
    const RawHeader header(layout_.header, arrays);
    const std::uint64_t shift = header.size() - layout_.header.size();
    const std::vector<Part> parts = partsOf(pieces);
    std::vector<LengthRange> lengths(arrays.size());
    std::mutex mutex;
    std::atomic<std::size_t> done{0};
    std::atomic<bool> hasMoved{false};
    parallelFor(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) {
        carrying.progress.throwIfCancelled();
        if (parts[p].piece == nullptr) {
          out.copy(file_, parts[p].begin, parts[p].end, parts[p].begin + shift, carrying.progress);
        } else {
          const std::vector<StoredLengths> stored = moveRows(out, parts[p], shift, {carrying.space, hasMoved});
          const std::lock_guard lock(mutex);
          for (std::size_t a = 0; a < stored.size(); ++a) {
            lengths[parts[p].piece->first + a].add(stored[a]);
          }
        }
        carrying.progress.report("Deforming", static_cast<double>(++done) / static_cast<double>(parts.size()));
      }
    });
    out.write(0, header.filled(lengths));
    return hasMoved;
  }

  /// All that lies behind the header: the rows that move, and the bytes between them.
  std::vector<Part> partsOf(const std::vector<MovingPiece>& pieces) const {
    std::vector<Part> parts;
    std::map<std::uint64_t, std::uint64_t> gaps;
    for (const MovingPiece& piece : pieces) {
      for (const Moving& moving : piece.arrays) {
        gaps.emplace(moving.array->begin, moving.array->begin + moving.bytes);
      }
      append(parts, {&piece, 0, static_cast<std::uint64_t>(piece.points)}, portion);
    }
    std::uint64_t from = layout_.header.size();
    for (const auto& [begin, end] : gaps) {
      append(parts, {nullptr, from, begin}, copyPortion);
      from = std::max(from, end);
    }
    append(parts, {nullptr, from, layout_.fileBytes}, copyPortion);
    return parts;
  }

  static void append(std::vector<Part>& parts, const Part& whole, std::uint64_t most) {
    for (std::uint64_t begin = whole.begin; begin < whole.end; begin += most) {
      parts.push_back({whole.piece, begin, std::min(begin + most, whole.end)});
    }
  }

  struct Moves {
    const PlacedSpace& space;
    std::atomic<bool>& any;  ///< set where a point moves

    void note(const Points& rest, const Points& moved) const {
      if (!any && rest != moved) {
        any = true;
      }
    }
  };

  /// Returns the lengths of the rows of each array.
  std::vector<StoredLengths> moveRows(RawFile& out, const Part& part, std::uint64_t shift,
                                      const Moves& moves) const {
    const bool isSwapped = layout_.isSwapped;
    const std::vector<Moving>& moving = part.piece->arrays;
    const auto first = static_cast<std::int64_t>(part.begin);
    const auto count = static_cast<std::int64_t>(part.end - part.begin);
    const Points rest = readRows(file_, *moving[0].array, first, count, isSwapped);
    std::vector<StoredLengths> lengths;
    const auto store = [&](const Moving& array, const Points& values) {
      lengths.push_back(writeRows(out, *array.array, first, values, {shift, isSwapped}));
    };
    if (moving.size() == 1) {
      const Points moved = moves.space.positions(rest);
      moves.note(rest, moved);
      store(moving[0], moved);
      return lengths;
    }
    const SpaceImage image = moves.space.image(rest);
    moves.note(rest, image.positions);
    store(moving[0], image.positions);
    for (const Moving& field : std::span(moving).subspan(1)) {
      Points values = readRows(file_, *field.array, first, count, isSwapped);
      transportRows(values, image.gradients, field.kind);
      store(field, values);
    }
    return lengths;
  }

  std::vector<Remark> remarks(const std::vector<Transport>& transports) const {
    for (const RawPiece& piece : layout_.pieces) {
      const bool isTransported =
          std::any_of(transports.begin(), transports.end(),
                      [&](const Transport& transport) { return transport.array == piece.normals; });
      if (!piece.normals.empty() && !isTransported) {
        return {keptNormalsRemark(path_, piece.normals)};
      }
    }
    return {};
  }

  std::filesystem::path path_;
  RawXmlLayout layout_;
  RawFile file_;
};

}  // namespace

std::unique_ptr<Dataset> openRawXmlDataset(const std::filesystem::path& path, const Progress&) {
  std::optional<RawXmlLayout> layout = rawXmlLayoutOf(path);
  return layout ? std::make_unique<RawXmlDataset>(path, std::move(*layout)) : nullptr;
}

}  // namespace pbffd
