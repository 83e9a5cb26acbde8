#pragma once

#include "core/ffd/placement/placement.h"

#include <CLI/CLI.hpp>
#include <memory>

namespace pbffd::cli {

/// Adds the options of placement to a command. Call the result after parsing: it gives what was chosen, with
/// the program's defaults, or the paper's settings where those were asked for, for the rest. Throws
/// CLI::ValidationError for a value out of its range.
std::function<PlacementOptions()> addPlacementOptions(CLI::App& command);

}  // namespace pbffd::cli
