#include "app/apply_mpi/shared_apply.h"
#include "core/base/error.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

namespace {

using namespace pbffd;

constexpr int done = 0;
constexpr int failed = 1;
constexpr int wrongUsage = 2;

/// Shorter than mpirun waits between asking a process to end and killing it.
constexpr std::chrono::milliseconds patience(300);

struct Arguments {
  mpi::SharedApply work;
  std::vector<std::string> transports;
  std::string align = "none";
};

void addArguments(CLI::App& app, Arguments& arguments) {
  app.set_version_flag("--version", "pbffd-apply-mpi " PBFFD_VERSION);
  app.add_option("PROJECT", arguments.work.project, "The project (PBFFD)")->required();
  app.add_option("MESH", arguments.work.source, "A partitioned VTK data set (.pvtu, .pvtp)")->required();
  app.add_option("-o,--output", arguments.work.target, "The index file to write")->required()->type_name("OUT");
  app.add_option("--align", arguments.align,
                 "Fit place, size and turn to the project's mesh first: none, similarity")
      ->check(CLI::IsMember({"none", "similarity"}))
      ->capture_default_str();
  app.add_option("--transport", arguments.transports,
                 "An array that turns along: NAME, NAME:vector or NAME:normal")
      ->type_name("NAME")
      ->allow_extra_args(false);
}

/// Does the work, and says on standard error what could not be done, on the rank where it could not.
int perform(Arguments& arguments, const mpi::Ranks& ranks, InterruptWatch& watch, const Progress& progress) {
  const auto fail = [&ranks](const char* what) {
    std::fprintf(stderr, "pbffd-apply-mpi: rank %d: %s\n", ranks.rank(), what);
    return failed;
  };
  try {
    arguments.work.options.align = arguments.align == "similarity";
    arguments.work.options.transports = parseTransports(arguments.transports);
    const ApplyReport report = mpi::applyShared(arguments.work, ranks, watch, progress);
    if (ranks.isFirst()) {
      for (const std::string& remark : withOptions(report.remarks)) {
        std::fprintf(stderr, "pbffd-apply-mpi: %s\n", remark.c_str());
      }
      std::printf("Deformed %lld points in %zu pieces on %d process%s; wrote %s.\n",
                  static_cast<long long>(report.points), report.pieces, ranks.count(),
                  ranks.count() == 1 ? "" : "es", arguments.work.target.c_str());
    }
    return done;
  } catch (const mpi::OtherRankFailed&) {
    return failed;
  } catch (const Cancelled&) {
    return fail("Cancelled; nothing was written.");
  } catch (const std::bad_alloc&) {
    return fail("There is not enough memory for this.");
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  const Progress progress([](std::string_view, double) {});
  InterruptWatch watch(progress, patience, mpi::stoppedWords);
  const mpi::Ranks ranks(argc, argv);
  CLI::App app(
      "Deform a partitioned data set as a project deforms its own mesh, each process its share of the pieces:\n"
      "  mpirun -n 4 pbffd-apply-mpi PROJECT MESH -o OUT",
      "pbffd-apply-mpi");
  Arguments arguments;
  addArguments(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Every rank sees the same words; one says so.
    const int status = ranks.isFirst() ? app.exit(error) : error.get_exit_code();
    return status == done ? done : wrongUsage;
  }
  return perform(arguments, ranks, watch, progress);
}
