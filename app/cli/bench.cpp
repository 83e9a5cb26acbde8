#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/measurements.h"
#include "app/cli/output.h"
#include "app/cli/place_options.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/mesh/io/mesh_io.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

namespace pbffd::cli {
namespace {

struct BenchCommand {
  std::filesystem::path mesh;
  PlacementOptions placement;
  bool asJson = false;
};

std::string jsonText(const Measurements& m) {
  using Json = nlohmann::ordered_json;
  const auto orNull = [](const std::optional<double>& number) { return number ? Json(*number) : Json(); };
  const Json json{{"vertices", m.vertices},
                  {"seconds",
                   {{"qhull", orNull(m.qhull)},
                    {"assemble", m.assemble},
                    {"parameterize", m.parameterize().seconds},
                    {"deform_all", m.deformAll},
                    {"deform_one", m.deformOne},
                    {"eigen_eq7", m.eigenEq7},
                    {"triad_bytes_per_second", m.triad.bytesPerSecond},
                    {"assemble_10000_points", m.assembleMany},
                    {"parameterize_brute_force", m.parameterize().bruteForce},
                    {"parameterize_connected", m.connected.seconds},
                    {"parameterize_connected_brute_force", m.connected.bruteForce},
                    {"parameterize_all", m.all.seconds},
                    {"parameterize_all_brute_force", m.all.bruteForce}}},
                  {"ratios",
                   {{"assemble_qhull", orNull(m.timesQhull(m.assemble))},
                    {"deform_bandwidth", m.deformBandwidth()},
                    {"parameterize_qhull", orNull(m.timesQhull(m.parameterize().seconds))},
                    {"assemble_10000_points", m.assembleMany / m.assemble},
                    {"brute_force_parameterize", m.parameterize().bruteForce / m.parameterize().seconds},
                    {"brute_force_parameterize_connected", m.connected.bruteForce / m.connected.seconds},
                    {"brute_force_parameterize_all", m.all.bruteForce / m.all.seconds}}},
                  {"assemble_10000_points_placed", m.manyPlaced},
                  {"brute_force_difference", std::max(m.connected.difference, m.all.difference)},
                  {"triad_bytes_of_array", m.triad.bytesOfArray},
                  {"last_level_cache_bytes", m.triad.lastLevelCache}};
  return json.dump() + "\n";
}

std::string row(std::string_view label, double seconds, std::string_view remark) {
  return format("  {:<30}{:>12.3f} ms  {}\n", label, 1e3 * seconds, remark);
}

std::string qhullRow(const Measurements& m) {
  const char* label = "Qhull on every vertex";
  return m.qhull ? row(label, *m.qhull, "")
                 : format("  {:<30}{:>12}     the vertices lie in a plane: there is no diagram in space\n",
                          label, "none");
}

std::string parameterizeRows(std::string_view reach, const ParameterizeTimes& times, std::string_view remark) {
  return row(format("Parameterize, reach {}", reach), times.seconds, remark) +
         row("  every vertex and every point", times.bruteForce,
             format("{:.1f} x as long, the same weights to {:.0e}", times.bruteForce / times.seconds,
                    times.difference));
}

std::string triadText(const Triad& triad) {
  const auto mebibytes = [](std::size_t bytes) { return bytes >> 20U; };
  return format("Bandwidth: {:.1f} GB/s, the triad over three arrays of {} MiB", 1e-9 * triad.bytesPerSecond,
                mebibytes(triad.bytesOfArray)) +
         (triad.lastLevelCache == 0
              ? std::string(".\n")
              : format("; the last cache has {} MiB.\n", mebibytes(triad.lastLevelCache)));
}

std::string tableText(const BenchCommand& command, const Measurements& m) {
  const auto byQhull = [&](double seconds, int digits) {
    return m.qhull ? format("{:.{}f} x Qhull", *m.timesQhull(seconds), digits) : std::string();
  };
  return format("{}: {} vertices, {} control points, {:.1f} a vertex, {} threads\n", command.mesh.string(),
                grouped(m.vertices), grouped(m.points), m.influences, threadCount()) +
         qhullRow(m) + row("Assemble the control points", m.assemble, byQhull(m.assemble, 2)) +
         row("Assemble 10,000 points", m.assembleMany,
             format("{:.1f} x as long; {} found room", m.assembleMany / m.assemble, grouped(m.manyPlaced))) +
         parameterizeRows("connected", m.connected, byQhull(m.connected.seconds, 4)) +
         parameterizeRows("all", m.all, byQhull(m.all.seconds, 4)) +
         row("Deform, all points moved", m.deformAll,
             format("{:.2f} of the memory's bandwidth", m.deformBandwidth())) +
         row("Deform, one point moved", m.deformOne, format("{:.1f} x faster", m.deformAll / m.deformOne)) +
         row("Eq. (7) in sparse matrices", m.eigenEq7,
             format("one thread; the deformation is {:.1f} x faster", m.eigenEq7 / m.deformAll)) +
         triadText(m.triad);
}

void bench(const BenchCommand& command, const Progress& progress) {
  const Mesh mesh = readMesh(command.mesh, progress);
  const Measurements measurements =
      naming(command.mesh.string(), [&] { return measure(mesh, command.placement, progress); });
  print(command.asJson ? jsonText(measurements) : tableText(command, measurements));
}

}  // namespace

void addBench(CLI::App& app, Action& action) {
  CLI::App* subcommand =
      app.add_subcommand("bench", "Time the steps of the paper's Table 1 and the deformation on a mesh");
  const auto command = std::make_shared<BenchCommand>();
  subcommand->add_option("MESH", command->mesh, "The mesh (OBJ, OFF, PLY, STL)")->required();
  subcommand->add_flag("--json", command->asJson, "Print one JSON object");
  const auto placement = addPlacementOptions(*subcommand);
  subcommand->callback([command, placement, &action] {
    command->placement = placement();
    action = [command](const Progress& progress) { bench(*command, progress); };
  });
}

}  // namespace pbffd::cli
