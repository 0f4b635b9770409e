// SPDX-License-Identifier: Apache-2.0
// The options of `gasjet mesh` and its subcommands.
#pragma once

#include <CLI/CLI.hpp>

#include "commands/command.hpp"

namespace driver::commands {

/// Adds the command; the command line is parsed into `arguments`.
void add_mesh(CLI::App& app, MeshArguments& arguments);
/// Runs the subcommand of the command line.
int dispatch_mesh(const CLI::App& mesh, const MeshArguments& arguments);

}  // namespace driver::commands
