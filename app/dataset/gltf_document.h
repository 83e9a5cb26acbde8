#pragma once

#include "core/base/types.h"

#include <nlohmann/json.hpp>

#include <compare>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace pbffd {

/// A glTF file with its buffers in memory.
class GltfDocument {
 public:
  /// Throws IoError, or InvalidInput that names the file and the place in it.
  explicit GltfDocument(const std::filesystem::path& path);

  const nlohmann::ordered_json& json() const { return json_; }
  /// An array of the top level; empty where there is none.
  const nlohmann::ordered_json& list(const char* name) const;
  const std::filesystem::path& path() const { return path_; }

  std::int64_t count(std::size_t accessor) const;

  /// Where the rows of an accessor lie, in bytes.
  struct Place {
    std::size_t buffer;
    std::size_t begin;
    std::size_t stride;
    std::size_t count;
    auto operator<=>(const Place&) const = default;
  };
  /// Of an accessor of real numbers, `width` a row. Throws InvalidInput where it is of another kind, or reaches
  /// beyond its buffer.
  Place placeOf(std::size_t accessor, int width) const;

  /// Its rows: N x width. Throws as placeOf() does.
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Rows rows(std::size_t accessor, int width) const;

  /// Writes rows of the same number and width back, rounded to single precision, with the accessor's new
  /// bounds where it has any.
  void setRows(std::size_t accessor, const Rows& rows);

  /// A file that is called `target`, and the files beside it that its changed buffers become.
  struct Files {
    std::string bytes;
    std::vector<std::pair<std::string, const std::string*>> buffers;  ///< name, content
  };
  Files encode(const std::filesystem::path& target) const;

  /// The files that it names and that encode() does not give anew: images, buffers that did not change.
  std::vector<std::string> filesBeside() const;

  [[noreturn]] void fail(const std::string& what) const;

  /// Does something with the JSON, which may hold values of any type anywhere; fails where they are wrong.
  template <class Work>
  auto guarded(const Work& work) const {
    try {
      return work();
    } catch (const nlohmann::json::exception& error) {
      fail(std::string("its JSON is not as glTF 2.0 wants it: ") + error.what());
    }
  }

 private:
  enum class Storage { chunk, text, file };
  struct Buffer {
    std::string bytes;
    Storage storage = Storage::chunk;
    bool isChanged = false;
  };
  void readBinary(const std::string& bytes);
  void readBuffers();
  std::size_t number(const nlohmann::ordered_json& object, const char* key, std::size_t otherwise) const;
  Place findPlace(std::size_t accessor, int width) const;
  Files encodeAs(const std::filesystem::path& target) const;
  std::vector<std::string> findFilesBeside() const;
  std::string encodeBinary(const nlohmann::ordered_json& json) const;

  std::filesystem::path path_;
  bool isBinary_ = false;
  nlohmann::ordered_json json_;
  std::string chunk_;        ///< the BIN chunk
  std::string laterChunks_;  ///< with their headers
  std::vector<Buffer> buffers_;
};

}  // namespace pbffd
