#include "core/ffd/levels/hierarchy.h"
#include "core/project/json_reader.h"

#include <algorithm>
#include <limits>

namespace pbffd {
namespace {

int wholeNumber(const JsonReader& reader) {
  return static_cast<int>(reader.integer(0, std::numeric_limits<int>::max()));
}

std::optional<int> sitesFrom(const JsonReader& reader) {
  if (reader.value().is_string()) {
    return reader.word<int>({{"all", 0}});
  }
  return static_cast<int>(reader.integer(1, std::numeric_limits<int>::max()));
}

}  // namespace

std::vector<std::string_view> placementKeys() {
  return {"points",         "levels",  "kernel",  "sigma", "master", "master_mode", "radius_factor", "offset",
          "exterior_share", "surface", "regions", "reach", "sites",  "seed",        "paper"};
}

PlacementOptions placementFrom(const JsonReader& reader) {
  reader.requireObject();
  const auto read = [&](const char* key, auto& value, const auto& from) {
    if (reader.has(key)) {
      value = from(reader.at(key));
    }
  };
  const auto number = [](const JsonReader& one) { return one.number(); };
  const bool isPaper = reader.has("paper") && reader.at("paper").boolean();
  PlacementOptions options = isPaper ? paperOptions() : PlacementOptions{};
  read("points", options.points, wholeNumber);
  // As on the command line: few points allow few levels; only who asks for more is to hear of it.
  options.levels = std::min(options.levels, greatestLevelCount(options.points));
  read("levels", options.levels, wholeNumber);
  read("kernel", options.basis.kernel, kernelFrom);
  read("sigma", options.basis.sigma, number);
  if (reader.has("master")) {
    options.master = number(reader.at("master"));
    options.masterMode = MasterMode::constant;
  }
  read("master_mode", options.masterMode, masterModeFrom);
  read("radius_factor", options.radiusFactor, number);
  read("offset", options.offset, number);
  read("exterior_share", options.exteriorShare, number);
  read("surface", options.surface, [](const JsonReader& one) {
    return one.word<Surface>(
        {{"auto", Surface::automatic}, {"closed", Surface::closed}, {"open", Surface::open}});
  });
  read("regions", options.regions, [](const JsonReader& one) {
    return one.word<RegionShape>({{"sphere", RegionShape::sphere}, {"ellipsoid", RegionShape::ellipsoid}});
  });
  read("reach", options.reach, reachFrom);
  read("sites", options.sites, sitesFrom);
  read("seed", options.seed, [](const JsonReader& one) {
    return static_cast<unsigned>(one.integer(0, std::numeric_limits<unsigned>::max()));
  });
  return options;
}

Json toJson(const PlacementOptions& options) {
  Json json = {{"points", options.points},
               {"levels", options.levels},
               {"kernel", wordOf(options.basis.kernel)},
               {"sigma", options.basis.sigma},
               {"master", options.master},
               {"master_mode", wordOf(options.masterMode)},
               {"radius_factor", options.radiusFactor},
               {"offset", options.offset},
               {"exterior_share", options.exteriorShare},
               {"surface", options.surface == Surface::automatic ? "auto"
                           : options.surface == Surface::closed  ? "closed"
                                                                 : "open"},
               {"regions", options.regions == RegionShape::sphere ? "sphere" : "ellipsoid"},
               {"reach", wordOf(options.reach)},
               {"seed", options.seed}};
  if (options.sites) {
    json["sites"] = *options.sites == 0 ? Json("all") : Json(*options.sites);
  }
  return json;
}

}  // namespace pbffd
