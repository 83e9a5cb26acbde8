#pragma once

#include "core/base/types.h"
#include "core/ffd/placement/placement.h"

#include <nlohmann/json.hpp>

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Reading JSON strictly; private to the .cpp files of this folder.

namespace pbffd {

using Json = nlohmann::json;

/// A JSON value and where it stands, so that what is wrong with it can be said: "/2/move/by: a list of three
/// numbers is expected". All members throw InvalidInput.
class JsonReader {
 public:
  JsonReader(const Json& value, std::string path) : value_(&value), path_(std::move(path)) {}

  const Json& value() const { return *value_; }
  const std::string& path() const { return path_; }

  bool has(const char* key) const { return value_->is_object() && value_->contains(key); }
  JsonReader at(const char* key) const;
  JsonReader element(std::size_t index) const;
  std::size_t size() const;  ///< of a list

  void requireObject() const;
  /// No other keys than these.
  void requireKeys(const std::vector<std::string_view>& known) const;

  bool boolean() const;
  double number() const;
  std::int64_t integer(std::int64_t low, std::int64_t high) const;
  PointId identifier() const;
  std::string string() const;
  Vec3 vector() const;
  /// Three vectors, which become the columns.
  Mat3 axes() const;
  /// Three rows of four numbers.
  AffineMap map() const;
  Frame frame() const;

  /// One of the words; gives what stands beside it.
  template <class Value>
  Value word(std::initializer_list<std::pair<std::string_view, Value>> words) const {
    const std::string found = string();
    std::string expected;
    for (const auto& [name, value] : words) {
      if (name == found) {
        return value;
      }
      expected += (expected.empty() ? "\"" : ", \"") + std::string(name) + "\"";
    }
    fail("\"" + found + "\" is none of " + expected);
  }

  [[noreturn]] void fail(const std::string& why) const;

 private:
  const Json* value_;
  std::string path_;
};

Json toJson(const Vec3& vector);
Json axesToJson(const Mat3& axes);
Json toJson(const AffineMap& map);
Json toJson(const Frame& frame);

/// The options of `place` as contract.md names them: the keys that are there over the defaults, or, with
/// "paper": true, over paperOptions(). Other keys are not looked at.
PlacementOptions placementFrom(const JsonReader& reader);
Json toJson(const PlacementOptions& options);
std::vector<std::string_view> placementKeys();

/// The words of the contract for values of one kind.
Kernel kernelFrom(const JsonReader& reader);
std::string_view wordOf(Kernel kernel);
Reach reachFrom(const JsonReader& reader);
std::string_view wordOf(Reach reach);
MasterMode masterModeFrom(const JsonReader& reader);
std::string_view wordOf(MasterMode mode);

}  // namespace pbffd
