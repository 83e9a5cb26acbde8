#include "core/project/json_reader.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/project/edit_scope.h"

#include <algorithm>
#include <cmath>

namespace pbffd {

void JsonReader::fail(const std::string& why) const {
  throw InvalidInput(format("{}: {}", path_.empty() ? "/" : path_, why));
}

JsonReader JsonReader::at(const char* key) const {
  requireObject();
  const auto found = value_->find(key);
  if (found == value_->end()) {
    fail(format("\"{}\" is missing", key));
  }
  return {*found, path_ + "/" + key};
}

JsonReader JsonReader::element(std::size_t index) const {
  return {(*value_)[index], path_ + "/" + std::to_string(index)};
}

std::size_t JsonReader::size() const {
  if (!value_->is_array()) {
    fail("a list is expected");
  }
  return value_->size();
}

void JsonReader::requireObject() const {
  if (!value_->is_object()) {
    fail("an object is expected");
  }
}

void JsonReader::requireKeys(const std::vector<std::string_view>& known) const {
  requireObject();
  for (const auto& [key, ignored] : value_->items()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      std::string expected;
      for (const std::string_view name : known) {
        expected += (expected.empty() ? "" : ", ") + std::string(name);
      }
      fail(format("the key \"{}\" is not known; known are: {}", key, expected.empty() ? "none" : expected));
    }
  }
}

bool JsonReader::boolean() const {
  if (!value_->is_boolean()) {
    fail("true or false is expected");
  }
  return value_->get<bool>();
}

double JsonReader::number() const {
  if (!value_->is_number()) {
    fail("a number is expected");
  }
  const auto number = value_->get<double>();
  if (!std::isfinite(number)) {
    fail("the number is not finite");
  }
  return number;
}

std::int64_t JsonReader::integer(std::int64_t low, std::int64_t high) const {
  if (!value_->is_number_integer()) {
    fail("a whole number is expected");
  }
  const bool isHuge =
      value_->is_number_unsigned() && value_->get<std::uint64_t>() > static_cast<std::uint64_t>(high);
  if (isHuge || value_->get<std::int64_t>() < low || value_->get<std::int64_t>() > high) {
    fail(format("{} is not from {} to {}", value_->dump(), low, high));
  }
  return value_->get<std::int64_t>();
}

PointId JsonReader::identifier() const {
  return integer(1, greatestPointId);
}

std::string JsonReader::string() const {
  if (!value_->is_string()) {
    fail("a text is expected");
  }
  return value_->get<std::string>();
}

Vec3 JsonReader::vector() const {
  if (!value_->is_array() || value_->size() != 3) {
    fail("a list of three numbers is expected");
  }
  return {element(0).number(), element(1).number(), element(2).number()};
}

Mat3 JsonReader::axes() const {
  if (!value_->is_array() || value_->size() != 3) {
    fail("a list of three axes is expected, each of three numbers");
  }
  Mat3 axes;
  axes << element(0).vector(), element(1).vector(), element(2).vector();
  return axes;
}

AffineMap JsonReader::map() const {
  if (!value_->is_array() || value_->size() != 3) {
    fail("a map is expected: three rows of four numbers");
  }
  AffineMap map;
  for (int row = 0; row < 3; ++row) {
    const JsonReader numbers = element(row);
    if (!numbers.value().is_array() || numbers.value().size() != 4) {
      numbers.fail("a row of four numbers is expected");
    }
    for (int column = 0; column < 4; ++column) {
      map(row, column) = numbers.element(column).number();
    }
  }
  return map;
}

Frame JsonReader::frame() const {
  return {at("center").vector(), at("axes").axes()};
}

Json toJson(const Vec3& vector) {
  return Json::array({vector.x(), vector.y(), vector.z()});
}

Json axesToJson(const Mat3& axes) {
  return Json::array({toJson(Vec3(axes.col(0))), toJson(Vec3(axes.col(1))), toJson(Vec3(axes.col(2)))});
}

Json toJson(const AffineMap& map) {
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row) {
    rows.push_back(Json::array({map(row, 0), map(row, 1), map(row, 2), map(row, 3)}));
  }
  return rows;
}

Json toJson(const Frame& frame) {
  return {{"center", toJson(frame.center)}, {"axes", axesToJson(frame.axes)}};
}

Kernel kernelFrom(const JsonReader& reader) {
  return reader.word<Kernel>(
      {{"smooth", Kernel::smooth}, {"wendland", Kernel::wendland}, {"gaussian", Kernel::gaussian}});
}

std::string_view wordOf(Kernel kernel) {
  return kernel == Kernel::smooth ? "smooth" : kernel == Kernel::wendland ? "wendland" : "gaussian";
}

Reach reachFrom(const JsonReader& reader) {
  return reader.word<Reach>({{"connected", Reach::connected}, {"all", Reach::all}});
}

std::string_view wordOf(Reach reach) {
  return reach == Reach::all ? "all" : "connected";
}

MasterMode masterModeFrom(const JsonReader& reader) {
  return reader.word<MasterMode>({{"constant", MasterMode::constant}, {"paper", MasterMode::paper}});
}

std::string_view wordOf(MasterMode mode) {
  return mode == MasterMode::paper ? "paper" : "constant";
}

}  // namespace pbffd
