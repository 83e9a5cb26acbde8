#include "app/dataset/gltf_document.h"

#include "app/dataset/dataset.h"
#include "app/dataset/gltf_file_names.h"
#include "app/dataset/gltf_text.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"

#include <bit>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>

namespace pbffd {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint32_t magic = 0x46546C67;      // "glTF"
constexpr std::uint32_t jsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t binChunk = 0x004E4942;   // "BIN"
constexpr int singlePrecision = 5126;

// glTF is little-endian.
static_assert(std::endian::native == std::endian::little);

std::uint32_t wordAt(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  if (at + sizeof word <= bytes.size()) {
    std::memcpy(&word, bytes.data() + at, sizeof word);
  }
  return word;
}

void appendWord(std::string& bytes, std::size_t word) {
  const auto narrow = static_cast<std::uint32_t>(word);
  bytes.append(reinterpret_cast<const char*>(&narrow), sizeof narrow);
}

void appendChunk(std::string& bytes, std::uint32_t type, std::string content, char padding) {
  content.append((4 - content.size() % 4) % 4, padding);
  appendWord(bytes, content.size());
  appendWord(bytes, type);
  bytes += content;
}

}  // namespace

GltfDocument::GltfDocument(const std::filesystem::path& path) : path_(path) {
  const std::string bytes = readFile(path);
  isBinary_ = wordAt(bytes, 0) == magic;
  try {
    if (isBinary_) {
      readBinary(bytes);
    } else {
      json_ = Json::parse(bytes);
    }
  } catch (const nlohmann::json::exception& error) {
    fail(format("its JSON is malformed: {}", error.what()));
  }
  if (!json_.is_object() || !json_.contains("asset")) {
    fail("its JSON has no \"asset\", so it is no glTF 2.0");
  }
  guarded([this] { readBuffers(); });
}

void GltfDocument::readBinary(const std::string& bytes) {
  if (wordAt(bytes, 4) != 2) {
    fail(format("it is of version {}; only version 2 is known", wordAt(bytes, 4)));
  }
  std::size_t at = 12;
  for (int number = 0; at + 8 <= bytes.size(); ++number) {
    const std::size_t length = wordAt(bytes, at);
    const std::uint32_t type = wordAt(bytes, at + 4);
    if (length > bytes.size() - at - 8) {
      fail(format("the chunk at byte {} should have {} bytes, but the file ends before", at, length));
    }
    if (number == 0 && type == jsonChunk) {
      json_ = Json::parse(std::string_view(bytes).substr(at + 8, length));
    } else if (number == 1 && type == binChunk) {
      chunk_ = bytes.substr(at + 8, length);
    } else {
      laterChunks_ += bytes.substr(at, 8 + length);
    }
    at += 8 + length;
  }
}

void GltfDocument::readBuffers() {
  for (const Json& entry : list("buffers")) {
    Buffer buffer;
    const std::string uri = entry.value("uri", std::string());
    if (uri.empty()) {
      if (!isBinary_ || !buffers_.empty()) {
        fail(format("buffer {} has no \"uri\"", buffers_.size()));
      }
      buffer.bytes = chunk_;
    } else if (uri.starts_with("data:")) {
      buffer.storage = Storage::text;
      const std::size_t comma = uri.find(";base64,");
      auto bytes =
          comma == std::string::npos ? std::nullopt : fromBase64(std::string_view(uri).substr(comma + 8));
      if (!bytes) {
        fail(format("the data of buffer {} is not base64", buffers_.size()));
      }
      buffer.bytes = std::move(*bytes);
    } else {
      buffer.storage = Storage::file;
      buffer.bytes = readFile(path_.parent_path() / fromUri(uri));
    }
    if (buffer.bytes.size() < number(entry, "byteLength", 0)) {
      fail(format("buffer {} should have {} bytes, but has {}", buffers_.size(), number(entry, "byteLength", 0),
                  buffer.bytes.size()));
    }
    buffers_.push_back(std::move(buffer));
  }
}

const Json& GltfDocument::list(const char* name) const {
  static const Json none = Json::array();
  const auto found = json_.find(name);
  if (found == json_.end()) {
    return none;
  }
  if (!found->is_array()) {
    fail(format("\"{}\" is no array", name));
  }
  return *found;
}

std::size_t GltfDocument::number(const Json& object, const char* key, std::size_t otherwise) const {
  const auto found = object.find(key);
  if (found == object.end()) {
    return otherwise;
  }
  if (!found->is_number_unsigned()) {
    fail(format("\"{}\" is no whole number", key));
  }
  return found->get<std::size_t>();
}

std::int64_t GltfDocument::count(std::size_t accessor) const {
  const Json& accessors = list("accessors");
  if (accessor >= accessors.size() || !accessors[accessor].is_object()) {
    fail(format("there is no accessor {}", accessor));
  }
  return static_cast<std::int64_t>(number(accessors[accessor], "count", 0));
}

GltfDocument::Place GltfDocument::placeOf(std::size_t accessor, int width) const {
  return guarded([&] { return findPlace(accessor, width); });
}

GltfDocument::Place GltfDocument::findPlace(std::size_t accessor, int width) const {
  const auto total = static_cast<std::size_t>(count(accessor));
  const Json& entry = list("accessors")[accessor];
  const std::string type = format("VEC{}", width);
  if (entry.value("type", std::string()) != type ||
      number(entry, "componentType", 0) != static_cast<std::size_t>(singlePrecision)) {
    fail(
        format("accessor {} is not of type {} in single precision; save the model without quantized "
               "attributes",
               accessor, type));
  }
  if (entry.contains("sparse") || !entry.contains("bufferView")) {
    fail(format("accessor {} is sparse; save the model without sparse accessors", accessor));
  }
  const Json& views = list("bufferViews");
  const std::size_t view = number(entry, "bufferView", 0);
  if (view >= views.size() || !views[view].is_object()) {
    fail(format("accessor {} names buffer view {}, which does not exist", accessor, view));
  }
  if (views[view].contains("extensions")) {
    fail(format("buffer view {} is compressed; save the model without compression", view));
  }
  const std::size_t rowBytes = sizeof(float) * static_cast<std::size_t>(width);
  const std::size_t viewBegin = number(views[view], "byteOffset", 0);
  const std::size_t viewBytes = number(views[view], "byteLength", 0);
  const std::size_t offset = number(entry, "byteOffset", 0);
  const Place place{number(views[view], "buffer", 0), viewBegin + offset,
                    number(views[view], "byteStride", rowBytes), total};
  if (place.buffer >= buffers_.size() || viewBegin > buffers_[place.buffer].bytes.size() ||
      viewBytes > buffers_[place.buffer].bytes.size() - viewBegin) {
    fail(format("buffer view {} of accessor {} reaches beyond its buffer", view, accessor));
  }
  if (place.stride < rowBytes || place.stride > 252 || offset > viewBytes ||
      (total > 0 &&
       (viewBytes - offset < rowBytes || (viewBytes - offset - rowBytes) / place.stride < total - 1))) {
    fail(format("accessor {} reaches beyond its buffer view", accessor));
  }
  return place;
}

GltfDocument::Rows GltfDocument::rows(std::size_t accessor, int width) const {
  const Place place = placeOf(accessor, width);
  Rows rows(static_cast<Eigen::Index>(place.count), width);
  std::vector<float> row(static_cast<std::size_t>(width));
  for (std::size_t i = 0; i < place.count; ++i) {
    std::memcpy(row.data(), buffers_[place.buffer].bytes.data() + place.begin + i * place.stride,
                row.size() * sizeof(float));
    for (std::size_t k = 0; k < row.size(); ++k) {
      rows(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = row[k];
    }
  }
  return rows;
}

void GltfDocument::setRows(std::size_t accessor, const Rows& rows) {
  const Place place = placeOf(accessor, static_cast<int>(rows.cols()));
  using Singles = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Singles singles = rows.cast<float>();
  Buffer& buffer = buffers_[place.buffer];
  buffer.isChanged = true;
  for (std::size_t i = 0; i < place.count; ++i) {
    std::memcpy(buffer.bytes.data() + place.begin + i * place.stride,
                singles.data() + i * static_cast<std::size_t>(rows.cols()),
                static_cast<std::size_t>(rows.cols()) * sizeof(float));
  }
  Json& entry = json_["accessors"][accessor];
  for (const char* key : {"min", "max"}) {
    if (!entry.contains(key) || place.count == 0) {
      continue;
    }
    Json bounds = Json::array();
    for (const auto column : singles.colwise()) {
      bounds.push_back(std::string_view(key) == "min" ? column.minCoeff() : column.maxCoeff());
    }
    if (!entry[key].is_array() || entry[key].size() != bounds.size()) {
      fail(format("\"{}\" of accessor {} should have {} numbers", key, accessor, bounds.size()));
    }
    entry[key] = std::move(bounds);
  }
}

GltfDocument::Files GltfDocument::encode(const std::filesystem::path& target) const {
  return guarded([&] { return encodeAs(target); });
}

GltfDocument::Files GltfDocument::encodeAs(const std::filesystem::path& target) const {
  Files files;
  Json json = json_;
  std::optional<GltfFileNames> names;
  for (std::size_t b = 0; b < buffers_.size(); ++b) {
    const Buffer& buffer = buffers_[b];
    if (!buffer.isChanged || buffer.storage == Storage::chunk) {
      continue;
    }
    if (buffer.storage == Storage::text) {
      const std::string uri = json["buffers"][b]["uri"];
      json["buffers"][b]["uri"] = uri.substr(0, uri.find(',') + 1) + toBase64(buffer.bytes);
      continue;
    }
    if (!names) {
      names.emplace(*this, target);
    }
    const std::string name = names->nameFor(b);
    json["buffers"][b]["uri"] = toUri(name);
    files.buffers.emplace_back(name, &buffer.bytes);
  }
  files.bytes = isBinary_ ? encodeBinary(json) : json.dump(2) + "\n";
  return files;
}

std::vector<std::string> GltfDocument::filesBeside() const {
  return guarded([this] { return findFilesBeside(); });
}

std::vector<std::string> GltfDocument::findFilesBeside() const {
  std::vector<std::string> names;
  for (const Json& image : list("images")) {
    const std::string uri = image.value("uri", std::string());
    if (!uri.empty() && !uri.starts_with("data:")) {
      names.push_back(fromUri(uri));
    }
  }
  for (std::size_t b = 0; b < buffers_.size(); ++b) {
    if (buffers_[b].storage == Storage::file && !buffers_[b].isChanged) {
      names.push_back(fromUri(list("buffers")[b].value("uri", std::string())));
    }
  }
  return names;
}

std::string GltfDocument::encodeBinary(const Json& json) const {
  std::string chunks;
  appendChunk(chunks, jsonChunk, json.dump(), ' ');
  if (!chunk_.empty()) {
    const bool isBuffer = !buffers_.empty() && buffers_[0].storage == Storage::chunk;
    appendChunk(chunks, binChunk, isBuffer ? buffers_[0].bytes : chunk_, '\0');
  }
  chunks += laterChunks_;
  if (chunks.size() + 12 > std::numeric_limits<std::uint32_t>::max()) {
    fail("it would be longer than 4 GiB, which a GLB file cannot be");
  }
  std::string bytes;
  appendWord(bytes, magic);
  appendWord(bytes, 2);
  appendWord(bytes, 12 + chunks.size());
  return bytes + chunks;
}

void GltfDocument::fail(const std::string& what) const {
  throw InvalidInput(format("Could not apply the project to {}: {}.", path_.string(), what));
}

}  // namespace pbffd
