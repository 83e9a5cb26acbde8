#pragma once

#include "core/base/interrupt_watch.h"
#include "core/base/progress.h"

#include <CLI/CLI.hpp>
#include <functional>

namespace pbffd::cli {

/// What the command line asks for, made when it is parsed. Long work reports to `progress` and stops when that
/// is cancelled. Throws Error for what could not be done; the output file is then untouched.
using Action = std::function<void(const Progress& progress)>;

// Each adds a subcommand to `app` that, when it is the one given, leaves its action in `action`.

void addInfo(CLI::App& app, Action& action);
void addPlace(CLI::App& app, Action& action);
void addEdit(CLI::App& app, Action& action);
void addExport(CLI::App& app, Action& action);
/// watch: told of the folder to remove when it ends the program.
void addApply(CLI::App& app, Action& action, InterruptWatch& watch);
void addBench(CLI::App& app, Action& action);

}  // namespace pbffd::cli
