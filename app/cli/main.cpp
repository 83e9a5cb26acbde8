#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/terminal_progress.h"
#include "core/base/error.h"

#include <cstdio>
#include <exception>
#include <new>

namespace {

using namespace pbffd;

constexpr int done = 0;
constexpr int failed = 1;
constexpr int wrongUsage = 2;

/// Does the work, and says on standard error what could not be done.
int perform(const cli::Action& action) {
  cli::TerminalProgress terminal;
  const Progress progress([&terminal](std::string_view stage, double share) { terminal.show(stage, share); });
  const cli::InterruptWatch watch(progress);
  const auto fail = [&terminal](const char* what) {
    terminal.clear();
    std::fprintf(stderr, "pbffd: %s\n", what);
    return failed;
  };
  try {
    action(progress);
    terminal.clear();
    return done;
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
  CLI::App app(
      "Point-based free-form deformation: place control points in and around a mesh, move them, and\n"
      "write the deformed mesh.",
      "pbffd");
  app.set_version_flag("--version", "pbffd " PBFFD_VERSION);
  app.require_subcommand(1);
  app.footer("Exit status: 0 done, 1 it could not be done, 2 wrong usage.");
  cli::Action action;
  cli::addInfo(app, action);
  cli::addPlace(app, action);
  cli::addEdit(app, action);
  cli::addExport(app, action);
#ifdef PBFFD_APPLY
  cli::addApply(app, action);
#endif
  cli::addBench(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == done ? done : wrongUsage;
  }
  return perform(action);
}
