#include "core/project/edit_from_json.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>
#include <limits>
#include <map>

namespace pbffd {
namespace {

Axis axisFrom(const JsonReader& reader) {
  return reader.word<Axis>({{"x", Axis::x}, {"y", Axis::y}, {"z", Axis::z}});
}

std::optional<int> levelFrom(const JsonReader& reader) {
  if (!reader.has("level")) {
    return std::nullopt;
  }
  return static_cast<int>(reader.at("level").integer(1, std::numeric_limits<int>::max()));
}

template <class Value, class From>
std::vector<Value> listFrom(const JsonReader& reader, const From& from) {
  std::vector<Value> values;
  for (std::size_t i = 0; i < reader.size(); ++i) {
    values.push_back(from(reader.element(i)));
  }
  return values;
}

PointSelection selectionFrom(const JsonReader& reader) {
  return {levelFrom(reader),
          listFrom<PointId>(reader.at("points"), [](const JsonReader& one) { return one.identifier(); })};
}

Frame frameFrom(const JsonReader& reader) {
  return {reader.at("center").vector(), reader.at("axes").axes()};
}

Spread spreadFrom(const JsonReader& reader) {
  Spread spread;
  if (reader.has("weights")) {
    spread.weights = listFrom<double>(reader.at("weights"), [](const JsonReader& one) { return one.number(); });
  }
  if (reader.has("master")) {
    spread.master = reader.at("master").boolean();
  }
  if (reader.has("mirror")) {
    spread.mirror = listFrom<Axis>(reader.at("mirror"), axisFrom);
  }
  if (reader.has("plane")) {
    spread.plane = reader.at("plane").vector();
    spread.hasPlane = true;
  }
  return spread;
}

Edit placeFrom(const JsonReader& reader) {
  std::vector<std::string_view> keys = placementKeys();
  keys.insert(keys.end(), {"keep_edits", "symmetric"});
  reader.requireKeys(keys);
  Place edit;
  edit.options = placementFrom(reader);
  if (reader.has("keep_edits")) {
    edit.keepEdits = reader.at("keep_edits").boolean();
  }
  if (reader.has("symmetric")) {
    edit.symmetric = axisFrom(reader.at("symmetric"));
  }
  return edit;
}

Follow followFrom(const JsonReader& reader) {
  if (reader.value() == "rigid") {
    reader.fail("\"rigid\" is not in this version yet; use \"frames\" or \"none\"");
  }
  return reader.word<Follow>({{"frames", Follow::frames}, {"none", Follow::none}});
}

Edit moveFrom(const JsonReader& reader) {
  reader.requireKeys({"level", "points", "by", "follow", "weights", "master", "mirror", "plane"});
  Move edit;
  edit.where = selectionFrom(reader);
  const JsonReader by = reader.at("by");
  const bool isOneEach = by.value().is_array() && !by.value().empty() && by.value().front().is_array();
  edit.by = isOneEach ? listFrom<Vec3>(by, [](const JsonReader& one) { return one.vector(); })
                      : std::vector<Vec3>{by.vector()};
  if (isOneEach && edit.by.size() != edit.where.points.size()) {
    by.fail(format("it has {} vectors for {} points", edit.by.size(), edit.where.points.size()));
  }
  if (reader.has("follow")) {
    edit.follow = followFrom(reader.at("follow"));
  }
  edit.spread = spreadFrom(reader);
  return edit;
}

Edit transformFrom(const JsonReader& reader) {
  reader.requireKeys(
      {"level", "points", "pivot", "basis", "scale", "rotate", "weights", "master", "mirror", "plane"});
  Transform edit;
  edit.where = selectionFrom(reader);
  if (reader.has("pivot")) {
    const JsonReader pivot = reader.at("pivot");
    edit.eachItsOwn = pivot.value() == "each";
    if (!edit.eachItsOwn) {
      edit.pivot = pivot.vector();
    }
  }
  if (reader.has("basis")) {
    edit.basis = reader.at("basis").axes();
  }
  if (reader.has("scale")) {
    edit.scale = reader.at("scale").vector();
  }
  if (reader.has("rotate")) {
    const JsonReader rotate = reader.at("rotate");
    rotate.requireKeys({"axis", "degrees"});
    edit.rotationAxis = rotate.at("axis").vector();
    edit.degrees = rotate.at("degrees").number();
  }
  edit.spread = spreadFrom(reader);
  return edit;
}

Edit setPoseFrom(const JsonReader& reader) {
  reader.requireKeys({"level", "point", "center", "axes"});
  return SetPose{levelFrom(reader), reader.at("point").identifier(), frameFrom(reader)};
}

Edit setRegionFrom(const JsonReader& reader) {
  reader.requireKeys({"level", "point", "center", "axes"});
  return SetRegion{levelFrom(reader), reader.at("point").identifier(), frameFrom(reader)};
}

Edit addFrom(const JsonReader& reader) {
  reader.requireKeys({"level", "center", "axes", "posed", "id", "name"});
  Add edit;
  edit.level = levelFrom(reader);
  edit.rest.center = reader.at("center").vector();
  edit.defaultAxes = !reader.has("axes");
  if (!edit.defaultAxes) {
    edit.rest.axes = reader.at("axes").axes();
  }
  if (reader.has("posed")) {
    edit.posed = reader.at("posed").boolean();
  }
  if (reader.has("id")) {
    edit.id = reader.at("id").identifier();
  }
  if (reader.has("name")) {
    edit.name = reader.at("name").string();
  }
  return edit;
}

Edit removeFrom(const JsonReader& reader) {
  reader.requireKeys({"level", "points"});
  return Remove{selectionFrom(reader)};
}

Edit enableFrom(const JsonReader& reader) {
  reader.requireKeys({"level", "points", "enabled"});
  return Enable{selectionFrom(reader), reader.at("enabled").boolean()};
}

Edit lockFrom(const JsonReader& reader) {
  reader.requireKeys({"level", "points", "locked"});
  return Lock{selectionFrom(reader), reader.at("locked").boolean()};
}

Edit strengthFrom(const JsonReader& reader) {
  reader.requireKeys({"level", "points", "value"});
  return Strength{selectionFrom(reader), reader.at("value").number()};
}

Edit setReachFrom(const JsonReader& reader) {
  reader.requireKeys({"level", "points", "value"});
  return SetReach{selectionFrom(reader), reachFrom(reader.at("value"))};
}

Edit refineFrom(const JsonReader& reader) {
  reader.requireKeys({"level", "points", "factor"});
  Refine edit{selectionFrom(reader)};
  if (reader.has("factor")) {
    edit.factor = static_cast<int>(reader.at("factor").integer(0, std::numeric_limits<int>::max()));
  }
  return edit;
}

Edit renameFrom(const JsonReader& reader) {
  for (const char* other : {"curve", "pin", "pose"}) {
    if (reader.has(other)) {
      reader.at(other).fail(format("renaming a {} is not in this version yet", other));
    }
  }
  reader.requireKeys({"level", "point", "name"});
  return Rename{levelFrom(reader), reader.at("point").identifier(), reader.at("name").string()};
}

Edit levelsFrom(const JsonReader& reader) {
  reader.requireKeys({"count", "keep"});
  SetLevels edit{static_cast<int>(reader.at("count").integer(0, std::numeric_limits<int>::max()))};
  if (reader.has("keep")) {
    edit.keep = reader.at("keep").boolean();
  }
  return edit;
}

Edit masterFrom(const JsonReader& reader) {
  reader.requireKeys({"value", "mode"});
  SetMaster edit;
  if (reader.has("mode")) {
    edit.mode = masterModeFrom(reader.at("mode"));
  }
  if (edit.mode == MasterMode::constant || reader.has("value")) {
    edit.value = reader.at("value").number();
  }
  return edit;
}

Edit kernelEditFrom(const JsonReader& reader) {
  reader.requireKeys({"name", "sigma"});
  SetKernel edit;
  edit.basis.kernel = kernelFrom(reader.at("name"));
  if (reader.has("sigma")) {
    edit.basis.sigma = reader.at("sigma").number();
  }
  return edit;
}

Edit resetFrom(const JsonReader& reader) {
  reader.requireKeys({"level", "points", "master"});
  Reset edit;
  if (reader.has("level") || reader.has("points") || reader.has("master")) {
    edit.where = selectionFrom(reader);
  }
  if (reader.has("master")) {
    edit.master = reader.at("master").boolean();
  }
  return edit;
}

Edit groupFrom(const JsonReader& reader) {
  reader.requireKeys({"text", "edits"});
  Group group;
  if (reader.has("text")) {
    group.text = reader.at("text").string();
  }
  group.edits = editsFrom(reader.at("edits"));
  return group;
}

using FromJson = Edit (*)(const JsonReader&);

const std::map<std::string_view, FromJson>& readers() {
  static const std::map<std::string_view, FromJson> all = {{"place", placeFrom},
                                                           {"move", moveFrom},
                                                           {"transform", transformFrom},
                                                           {"set_pose", setPoseFrom},
                                                           {"set_region", setRegionFrom},
                                                           {"add", addFrom},
                                                           {"remove", removeFrom},
                                                           {"enable", enableFrom},
                                                           {"lock", lockFrom},
                                                           {"strength", strengthFrom},
                                                           {"reach", setReachFrom},
                                                           {"refine", refineFrom},
                                                           {"rename", renameFrom},
                                                           {"levels", levelsFrom},
                                                           {"master", masterFrom},
                                                           {"kernel", kernelEditFrom},
                                                           {"reset", resetFrom},
                                                           {"group", groupFrom}};
  return all;
}

/// Edits of the contract that this version does not have.
bool isOfLaterVersion(std::string_view name) {
  static constexpr std::string_view later[] = {
      "pull",         "pin",       "unpin",        "add_curve", "move_knots", "twist_knots", "add_knot",
      "remove_knots", "set_knots", "remove_curve", "save_pose", "apply_pose", "remove_pose", "bake"};
  return std::find(std::begin(later), std::end(later), name) != std::end(later);
}

std::string nameIn(const Json& edit) {
  return edit.is_object() && edit.size() == 1 ? " (" + edit.items().begin().key() + ")" : std::string();
}

}  // namespace

Edit editFrom(const JsonReader& reader) {
  reader.requireObject();
  if (reader.value().size() != 1) {
    reader.fail(format("an edit is an object with one key, its name; this has {}", reader.value().size()));
  }
  const std::string name = reader.value().items().begin().key();
  const auto found = readers().find(name);
  if (found != readers().end()) {
    return found->second(reader.at(name.c_str()));
  }
  if (isOfLaterVersion(name)) {
    reader.fail(format("'{}' is not in this version yet", name));
  }
  reader.fail(format("there is no edit '{}'", name));
}

std::vector<Edit> editsFrom(const JsonReader& reader) {
  std::vector<Edit> edits;
  for (std::size_t i = 0; i < reader.size(); ++i) {
    const JsonReader one = reader.element(i);
    try {
      edits.push_back(editFrom(one));
    } catch (const InvalidInput& error) {
      throw InvalidInput(format("edit {}{}: {}", i + 1, nameIn(one.value()), error.what()));
    }
  }
  return edits;
}

}  // namespace pbffd
