#include "app/cli/commands.h"
#include "app/cli/output.h"
#include "app/cli/terminal_progress.h"
#include "core/base/error.h"
#include "core/base/interrupt_watch.h"

#include <chrono>
#include <cstdio>
#include <exception>
#include <new>

namespace {

using namespace pbffd;

constexpr int done = 0;
constexpr int failed = 1;
constexpr int wrongUsage = 2;

/// How long cancelled work may take to stop by itself.
constexpr std::chrono::milliseconds patience(800);

/// Does the work, and says on standard error what could not be done.
int perform(const cli::Action& action, cli::TerminalProgress& terminal, const Progress& progress) {
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
    terminal.clear();
    std::fputs(cli::lastWords().c_str(), stderr);
    return failed;
  } catch (const std::bad_alloc&) {
    return fail("There is not enough memory for this.");
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}

/// Help and version are answers; everything else is wrong usage, and says what is right.
int report(const CLI::App& app, const CLI::ParseError& error, const char* first) {
  if (error.get_exit_code() == done) {
    return app.exit(error);
  }
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  if (chosen.empty() && first != nullptr && first[0] != '-') {
    std::fprintf(stderr, "pbffd: '%s' is no command of this program.\n", first);
  } else {
    std::fprintf(stderr, "pbffd: %s\n", error.what());
  }
  std::fprintf(stderr, "Usage: pbffd %s ...; pbffd %s--help says more.\n",
               chosen.empty() ? "COMMAND" : chosen.front()->get_name().c_str(),
               chosen.empty() ? "" : (chosen.front()->get_name() + " ").c_str());
  return wrongUsage;
}

}  // namespace

int main(int argc, char** argv) {
  cli::TerminalProgress terminal;
  const Progress progress([&terminal](std::string_view stage, double share) { terminal.show(stage, share); });
  InterruptWatch watch(progress, patience, cli::lastWords);
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
  cli::addApply(app, action, watch);
#endif
  cli::addBench(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report(app, error, argc > 1 ? argv[1] : nullptr);
  }
  return perform(action, terminal, progress);
}
