#include "app/dataset/raw_xml_dataset.h"

#include "app/dataset/raw_file.h"
#include "app/dataset/raw_rows.h"
#include "app/dataset/raw_xml_layout.h"
#include "app/dataset/vtk_cell_kinds.h"
#include "core/base/text.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>

namespace pbffd {
namespace {

/// Rows taken at a time: enough for all cores, little memory.
constexpr std::int64_t portion = 1 << 19;

/// The least and largest length of an array's rows, as VTK notes them in the header.
struct LengthRange {
  double least = std::numeric_limits<double>::infinity();
  double largest = 0.0;
};

/// A piece's array that changes.
struct Moving {
  const RawArray* array;
  FieldKind kind;  ///< of a field; unused for the positions
  std::uint64_t bytes;
  LengthRange lengths;
};

/// The header with room for numbers that are known only in the end.
class RewrittenHeader {
 public:
  explicit RewrittenHeader(const RawXmlLayout& layout) : text_(layout.header) {}

  /// Makes room for the lengths of these arrays. Call once.
  void makeRoom(const std::vector<Moving>& arrays) {
    for (std::size_t a = 0; a < arrays.size(); ++a) {
      for (const RawArray::Range& range : arrays[a].array->ranges) {
        rooms_.push_back({range, a, 0});
      }
    }
    std::sort(rooms_.begin(), rooms_.end(),
              [](const Room& x, const Room& y) { return x.range.begin < y.range.begin; });
    std::string text;
    std::size_t at = 0;
    for (Room& room : rooms_) {
      text.append(text_, at, room.range.begin - at);
      room.begin = text.size();
      // The closing quote of an attribute follows its number, the spaces follow the quote.
      text.append(width + (room.range.isAttribute ? 1 : 0), ' ');
      at = room.range.end + (room.range.isAttribute ? 1 : 0);
    }
    text_ = text + text_.substr(at);
  }

  const std::string& filled(const std::vector<Moving>& arrays) {
    for (const Room& room : rooms_) {
      const LengthRange& lengths = arrays[room.array].lengths;
      const double length = room.range.isLargest ? lengths.largest : std::min(lengths.least, lengths.largest);
      const std::string number = format("{}", length) + (room.range.isAttribute ? "\"" : "");
      text_.replace(room.begin, number.size(), number);
    }
    return text_;
  }

  std::size_t size() const { return text_.size(); }

 private:
  /// More than the longest double takes.
  static constexpr std::size_t width = 26;
  struct Room {
    RawArray::Range range;
    std::size_t array;
    std::size_t begin;
  };
  std::string text_;
  std::vector<Room> rooms_;
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

  std::vector<std::string> write(const std::filesystem::path& target, StagedFiles& staged,
                                 const Carrying& carrying) override {
    requireSameEnding(path_, target);
    std::vector<std::vector<Moving>> moving;
    for (const RawPiece& piece : layout_.pieces) {
      moving.push_back(piece.points > 0 ? movingOf(piece, carrying.transports) : std::vector<Moving>());
    }
    RawFile out = RawFile::forWriting(staged.add(target), target);
    if (!carrying.space.movesAnything()) {
      out.copy(file_, 0, layout_.fileBytes, 0, carrying.progress);
      return {};
    }
    copyMoved(out, moving, carrying);
    return remarks(carrying.transports);
  }

 private:
  /// The positions first, then the fields.
  std::vector<Moving> movingOf(const RawPiece& piece, const std::vector<Transport>& transports) const {
    const auto bytes = [&](const RawArray& array) {
      return array.rowBytes() * static_cast<std::uint64_t>(piece.points);
    };
    std::vector<Moving> moving{{&piece.positions, FieldKind::vector, bytes(piece.positions), {}}};
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
      moving.push_back({&*array,
                        transport.kind.value_or(isNormal ? FieldKind::normal : FieldKind::vector),
                        bytes(*array),
                        {}});
    }
    return moving;
  }

  void copyMoved(RawFile& out, const std::vector<std::vector<Moving>>& moving, const Carrying& carrying) const {
    std::vector<Moving> all;
    for (const std::vector<Moving>& piece : moving) {
      all.insert(all.end(), piece.begin(), piece.end());
    }
    RewrittenHeader header(layout_);
    header.makeRoom(all);
    const std::uint64_t dataBegin = layout_.header.size();
    copyUnmoved(out, all, header.size(), carrying.progress);
    std::size_t next = 0;
    std::int64_t done = 0;
    for (std::size_t p = 0; p < layout_.pieces.size(); ++p) {
      const std::size_t first = std::exchange(next, next + moving[p].size());
      for (std::int64_t row = 0; row < layout_.pieces[p].points; row += portion) {
        const std::int64_t rows = std::min(portion, layout_.pieces[p].points - row);
        carrying.progress.report("Deforming", static_cast<double>(done) / static_cast<double>(pointCount()));
        moveRows(out, {all.data() + first, moving[p].size()}, {row, rows}, header.size() - dataBegin, carrying);
        done += rows;
      }
    }
    out.write(0, header.filled(all));
  }

  /// Everything behind the header that does not move.
  void copyUnmoved(RawFile& out, const std::vector<Moving>& moving, std::uint64_t headerBytes,
                   const Progress& progress) const {
    std::map<std::uint64_t, std::uint64_t> gaps;
    for (const Moving& array : moving) {
      gaps.emplace(array.array->begin, array.array->begin + array.bytes);
    }
    const std::uint64_t shift = headerBytes - layout_.header.size();
    std::uint64_t from = layout_.header.size();
    progress.report("Copying");
    for (const auto& [begin, end] : gaps) {
      if (begin > from) {
        out.copy(file_, from, begin, from + shift, progress);
      }
      from = std::max(from, end);
    }
    out.copy(file_, from, layout_.fileBytes, from + shift, progress);
  }

  struct Rows {
    std::int64_t first;
    std::int64_t count;
  };
  void moveRows(RawFile& out, std::span<Moving> moving, const Rows& rows, std::uint64_t shift,
                const Carrying& carrying) const {
    const bool isSwapped = layout_.isSwapped;
    const Points rest = readRows(file_, *moving[0].array, rows.first, rows.count, isSwapped);
    const auto store = [&](Moving& array, const Points& values) {
      const StoredLengths lengths = writeRows(out, *array.array, rows.first, values, {shift, isSwapped});
      array.lengths.least = std::min(array.lengths.least, lengths.least);
      array.lengths.largest = std::max(array.lengths.largest, lengths.largest);
    };
    if (moving.size() == 1) {
      store(moving[0], carrying.space.positions(rest));
      carrying.progress.throwIfCancelled();
      return;
    }
    const SpaceImage image = carrying.space.image(rest);
    store(moving[0], image.positions);
    for (Moving& field : moving.subspan(1)) {
      Points values = readRows(file_, *field.array, rows.first, rows.count, isSwapped);
      transportRows(values, image.gradients, field.kind);
      store(field, values);
    }
    carrying.progress.throwIfCancelled();
  }

  std::vector<std::string> remarks(const std::vector<Transport>& transports) const {
    for (const RawPiece& piece : layout_.pieces) {
      const bool isTransported =
          std::any_of(transports.begin(), transports.end(),
                      [&](const Transport& transport) { return transport.array == piece.normals; });
      if (!piece.normals.empty() && !isTransported) {
        return {format("The normals '{}' of {} were kept as they are; --transport {} turns them along.",
                       piece.normals, path_.string(), piece.normals)};
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
