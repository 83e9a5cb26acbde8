#include "core/project/control_json.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/ffd/frame_checks.h"
#include "core/project/edit_scope.h"

#include <unordered_map>
#include <unordered_set>

namespace pbffd {
namespace {

/// What messages about several levels begin with.
constexpr std::string_view misfit = "the levels do not fit together:";

std::string_view wordOf(PointKind kind) {
  switch (kind) {
    case PointKind::interior:
      return "interior";
    case PointKind::exterior:
      return "exterior";
    case PointKind::manual:
      return "manual";
    case PointKind::merged:
      return "merged";
    case PointKind::curve:
      return "curve";
  }
  return "manual";
}

PointKind kindFrom(const JsonReader& reader) {
  return reader.word<PointKind>({{"interior", PointKind::interior},
                                 {"exterior", PointKind::exterior},
                                 {"manual", PointKind::manual},
                                 {"merged", PointKind::merged},
                                 {"curve", PointKind::curve}});
}

Json pointToJson(const ControlPoint& point, bool isBound) {
  Json json = {{"id", point.id},
               {"name", point.name},
               {"kind", wordOf(point.kind)},
               {"enabled", point.enabled},
               {"locked", point.locked},
               {"strength", point.strength},
               {"reach", pbffd::wordOf(point.reach)},
               {"rest", toJson(point.rest)},
               {"pose", toJson(point.pose)}};
  if (!point.mergedFrom.empty()) {
    json["merged_from"] = point.mergedFrom;
  }
  if (isBound) {
    json["binding"] = {{"at", toJson(point.binding.at)}, {"local", toJson(point.binding.local)}};
  }
  return json;
}

template <class Check>
Frame checkedFrame(const JsonReader& reader, const Check& check) {
  const Frame frame = reader.frame();
  try {
    check(frame);
  } catch (const InvalidInput& error) {
    reader.fail(error.what());
  }
  return frame;
}

double positiveNumber(const JsonReader& reader) {
  const double number = reader.number();
  if (!(number > 0.0)) {
    reader.fail("it must be above 0");
  }
  return number;
}

double strengthFrom(const JsonReader& reader) {
  const double strength = reader.number();
  try {
    requireStrength(strength);
  } catch (const InvalidInput& error) {
    reader.fail(error.what());
  }
  return strength;
}

Binding bindingFrom(const JsonReader& reader) {
  const Binding binding{reader.at("at").vector(), reader.at("local").map()};
  if (!isInvertible(binding.local.leftCols<3>())) {
    reader.at("local").fail("the map is singular: it leaves no volume");
  }
  return binding;
}

std::vector<PointId> membersFrom(const JsonReader& reader) {
  std::vector<PointId> members;
  for (std::size_t i = 0; i < reader.size(); ++i) {
    // 0 names no point.
    if (const PointId id = reader.element(i).integer(0, greatestPointId); id != 0) {
      members.push_back(id);
    }
  }
  return members;
}

ControlPoint pointFrom(const JsonReader& reader, bool isBound) {
  const auto read = [&](const char* key, auto& value, const auto& from) {
    if (reader.has(key)) {
      value = from(reader.at(key));
    }
  };
  const auto boolean = [](const JsonReader& one) { return one.boolean(); };
  ControlPoint point;
  point.id = reader.at("id").identifier();
  read("name", point.name, [](const JsonReader& one) { return one.string(); });
  read("kind", point.kind, kindFrom);
  read("enabled", point.enabled, boolean);
  read("locked", point.locked, boolean);
  read("strength", point.strength, strengthFrom);
  read("reach", point.reach, reachFrom);
  read("merged_from", point.mergedFrom, membersFrom);
  point.rest = checkedFrame(reader.at("rest"), requireRest);
  point.pose = checkedFrame(reader.at("pose"), requirePose);
  const bool hasBinding = reader.has("binding") && !reader.at("binding").value().is_null();
  if (isBound && !hasBinding) {
    reader.fail(format("{} point {} has no \"binding\" to the next coarser level", misfit, point.id));
  }
  if (!isBound && hasBinding) {
    reader.fail(format("{} point {} has a \"binding\", but there is no coarser level", misfit, point.id));
  }
  if (isBound) {
    point.binding = bindingFrom(reader.at("binding"));
  }
  return point;
}

Master masterFrom(const JsonReader& reader) {
  Master master;
  master.value = reader.at("value").number();
  if (master.value < 0.0) {
    reader.at("value").fail("it must be 0 or more");
  }
  master.mode = masterModeFrom(reader.at("mode"));
  master.rest = checkedFrame(reader.at("rest"), requireRest);
  master.pose = checkedFrame(reader.at("pose"), requirePose);
  return master;
}

Basis basisFrom(const JsonReader& reader) {
  Basis basis;
  basis.kernel = kernelFrom(reader.at("kernel"));
  if (reader.has("sigma")) {
    basis.sigma = positiveNumber(reader.at("sigma"));
  }
  return basis;
}

void requireUniqueIds(const std::vector<Level>& levels, const JsonReader& reader) {
  std::unordered_set<PointId> seen;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    for (Index i = 0; i < levels[l].size(); ++i) {
      if (!seen.insert(levels[l][i].id).second) {
        reader.element(l).at("points").element(i).fail(
            format("the identifier {} is used twice", levels[l][i].id));
      }
    }
  }
}

/// What the points of a level stand for are points of the next finer one, each of one alone.
void requireMembers(const Level& level, const Level& finer, const JsonReader& points) {
  std::unordered_map<PointId, PointId> parentOf;
  for (const ControlPoint& point : finer) {
    parentOf.emplace(point.id, 0);
  }
  for (Index i = 0; i < level.size(); ++i) {
    const auto fail = [&](const std::string& why) {
      points.element(i).at("merged_from").fail(format("{} {}", misfit, why));
    };
    for (const PointId member : level[i].mergedFrom) {
      const auto parent = parentOf.find(member);
      if (parent == parentOf.end()) {
        fail(format("point {} is not on the next finer level", member));
      }
      if (parent->second != 0) {
        fail(format("point {} is named twice: point {} stands for it already", member, parent->second));
      }
      parent->second = level[i].id;
    }
  }
}

void requireFit(const std::vector<Level>& levels, const JsonReader& reader) {
  const Level none;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    if (levels[l].empty() && levels.size() > 1) {
      reader.element(l).fail(format("{} level {} has no points", misfit, l + 1));
    }
    requireMembers(levels[l], l + 1 < levels.size() ? levels[l + 1] : none, reader.element(l).at("points"));
  }
}

}  // namespace

Json controlsToJson(const ControlSet& set) {
  Json levels = Json::array();
  for (std::size_t l = 0; l < set.levels.size(); ++l) {
    Json points = Json::array();
    for (const ControlPoint& point : set.levels[l]) {
      points.push_back(pointToJson(point, l > 0));
    }
    levels.push_back({{"points", std::move(points)}});
  }
  return {{"basis", {{"kernel", pbffd::wordOf(set.basis.kernel)}, {"sigma", set.basis.sigma}}},
          {"master",
           {{"value", set.master.value},
            {"mode", pbffd::wordOf(set.master.mode)},
            {"rest", toJson(set.master.rest)},
            {"pose", toJson(set.master.pose)}}},
          {"levels", std::move(levels)}};
}

ControlSet controlsFrom(const JsonReader& document) {
  ControlSet set;
  set.basis = basisFrom(document.at("basis"));
  set.master = masterFrom(document.at("master"));
  const JsonReader levels = document.at("levels");
  if (levels.size() == 0) {
    levels.fail("there must be at least one level");
  }
  set.levels.clear();
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const JsonReader points = levels.element(l).at("points");
    Level level;
    for (std::size_t i = 0; i < points.size(); ++i) {
      level.append(pointFrom(points.element(i), l > 0));
    }
    set.levels.push_back(std::move(level));
  }
  requireUniqueIds(set.levels, levels);
  requireFit(set.levels, levels);
  return set;
}

}  // namespace pbffd
