#include "app/cli/place_options.h"

#include "core/base/error.h"
#include "core/ffd/levels/hierarchy.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace pbffd::cli {
namespace {

const std::map<std::string, Kernel> kernels{
    {"smooth", Kernel::smooth}, {"wendland", Kernel::wendland}, {"gaussian", Kernel::gaussian}};
const std::map<std::string, Surface> surfaces{
    {"auto", Surface::automatic}, {"closed", Surface::closed}, {"open", Surface::open}};
const std::map<std::string, RegionShape> shapes{{"sphere", RegionShape::sphere},
                                                {"ellipsoid", RegionShape::ellipsoid}};
const std::map<std::string, Reach> reaches{{"connected", Reach::connected}, {"all", Reach::all}};

/// What was given on the command line; what was not stays empty.
struct Given {
  std::optional<int> points;
  std::optional<int> levels;
  std::optional<std::string> kernel;
  std::optional<double> sigma;
  std::optional<double> master;
  std::optional<double> radiusFactor;
  std::optional<double> offset;
  std::optional<double> exteriorShare;
  std::optional<std::string> surface;
  std::optional<std::string> regions;
  std::optional<std::string> reach;
  std::optional<std::string> sites;
  std::optional<unsigned> seed;
  bool paper = false;
};

template <class Value>
void take(const std::optional<Value>& given, Value& value) {
  value = given.value_or(value);
}

template <class Value>
void take(const std::optional<std::string>& given, const std::map<std::string, Value>& names, Value& value) {
  if (given) {
    value = names.at(*given);
  }
}

/// "all": every vertex.
int sitesFrom(const std::string& text) {
  return text == "all" ? 0 : std::stoi(text);
}

std::string checkSites(const std::string& text) {
  const bool isNumber =
      !text.empty() && text.size() <= 9 && text.find_first_not_of("0123456789") == std::string::npos;
  return text == "all" || (isNumber && std::stoi(text) > 0) ? ""
                                                            : "'" + text + "' is neither a count nor 'all'";
}

PlacementOptions optionsFrom(const Given& given) {
  PlacementOptions options = given.paper ? paperOptions() : PlacementOptions{};
  take(given.points, options.points);
  // Few points allow few levels; only who asks for more is to hear of it.
  options.levels = given.levels.value_or(std::min(options.levels, greatestLevelCount(options.points)));
  take(given.kernel, kernels, options.basis.kernel);
  take(given.sigma, options.basis.sigma);
  if (given.master) {
    options.master = *given.master;
    options.masterMode = MasterMode::constant;
  }
  take(given.radiusFactor, options.radiusFactor);
  take(given.offset, options.offset);
  take(given.exteriorShare, options.exteriorShare);
  take(given.surface, surfaces, options.surface);
  take(given.regions, shapes, options.regions);
  take(given.reach, reaches, options.reach);
  if (given.sites) {
    options.sites = sitesFrom(*given.sites);
  }
  take(given.seed, options.seed);
  try {
    requireValid(options);
  } catch (const InvalidInput& error) {
    throw CLI::ValidationError(error.what());
  }
  return options;
}

}  // namespace

std::function<PlacementOptions()> addPlacementOptions(CLI::App& command) {
  const auto given = std::make_shared<Given>();
  const auto add = [&command](const char* name, auto& value, const char* about, const char* standard) {
    return command.add_option(name, value, about)->default_str(standard)->group("Placement");
  };
  add("--points", given->points, "Control points of the finest level", "200");
  add("--levels", given->levels, "Levels, each half as fine as the next", "3");
  add("--kernel", given->kernel, "How influence falls off", "smooth")->check(CLI::IsMember(kernels));
  add("--sigma", given->sigma, "Gaussian only: standard deviations to the region's border", "3");
  add("--master", given->master, "Weight of the point that holds what no other reaches", "0.01");
  add("--radius-factor", given->radiusFactor, "Radius of a region by the distance of the nearest neighbour",
      "2.0");
  add("--offset", given->offset, "Distance of exterior points, as a share of the diagonal", "0.05");
  add("--exterior-share", given->exteriorShare, "Share of the points that lie outside", "0.5");
  add("--surface", given->surface, "How the surface is taken", "auto")->check(CLI::IsMember(surfaces));
  add("--regions", given->regions, "Shape of the regions", "sphere")->check(CLI::IsMember(shapes));
  add("--reach", given->reach, "Whether a region ends where the surface leaves it", "connected")
      ->check(CLI::IsMember(reaches));
  command.add_option("--sites", given->sites, "Voronoi sites: N well-spaced vertices, or all")
      ->type_name("N|all")
      ->check(checkSites)
      ->group("Placement");
  add("--seed", given->seed, "Another number gives another arrangement", "0");
  command
      .add_flag(
          "--paper", given->paper,
          "The paper's settings for what is not given: gaussian, its master, radius factor 1.5, offset 0.1, "
          "reach all")
      ->group("Placement");
  return [given] { return optionsFrom(*given); };
}

}  // namespace pbffd::cli
