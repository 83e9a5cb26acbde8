#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/measurements.h"
#include "app/cli/output.h"
#include "app/cli/place_options.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/mesh/io/mesh_io.h"

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
                    {"parameterize", m.parameterize},
                    {"deform_all", m.deformAll},
                    {"deform_one", m.deformOne},
                    {"eigen_eq7", m.eigenEq7},
                    {"triad_bytes_per_second", m.triadBytesPerSecond},
                    {"assemble_10000_points", m.assembleMany},
                    {"parameterize_brute_force", m.bruteForce}}},
                  {"ratios",
                   {{"assemble_qhull", orNull(m.timesQhull(m.assemble))},
                    {"deform_bandwidth", m.deformBandwidth()},
                    {"parameterize_qhull", orNull(m.timesQhull(m.parameterize))},
                    {"assemble_10000_points", m.assembleMany / m.assemble},
                    {"brute_force_parameterize", m.bruteForce / m.parameterize}}}};
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

std::string tableText(const BenchCommand& command, const Measurements& m) {
  const auto byQhull = [&](double seconds, int digits) {
    return m.qhull ? format("{:.{}f} x Qhull", *m.timesQhull(seconds), digits) : std::string();
  };
  return format("{}: {} vertices, {} control points, {:.1f} a vertex, {} threads\n", command.mesh.string(),
                grouped(m.vertices), grouped(m.points), m.influences, threadCount()) +
         qhullRow(m) + row("Assemble the control points", m.assemble, byQhull(m.assemble, 2)) +
         row("Assemble 10,000 points", m.assembleMany,
             format("{:.1f} x as long", m.assembleMany / m.assemble)) +
         row("Parameterize the mesh", m.parameterize, byQhull(m.parameterize, 4)) +
         row("Every vertex and every point", m.bruteForce,
             format("parameterizing is {:.1f} x faster", m.bruteForce / m.parameterize)) +
         row("Deform, all points moved", m.deformAll,
             format("{:.2f} of the memory's bandwidth ({:.1f} GB/s)", m.deformBandwidth(),
                    1e-9 * m.triadBytesPerSecond)) +
         row("Deform, one point moved", m.deformOne, format("{:.1f} x faster", m.deformAll / m.deformOne)) +
         row("Eq. (7) in sparse matrices", m.eigenEq7,
             format("one thread; the deformation is {:.1f} x faster", m.eigenEq7 / m.deformAll));
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
