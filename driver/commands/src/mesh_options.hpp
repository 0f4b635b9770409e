// SPDX-License-Identifier: Apache-2.0
// The options of `gasjet mesh` and its subcommands.
#pragma once

#include <CLI/CLI.hpp>

#include "commands/command.hpp"

namespace driver::commands {

/// Adds the command; what the command line says of it stands in `arguments`.
void add_mesh(CLI::App& app, MeshArguments& arguments);
/// Runs the subcommand that the command line asks for.
int dispatch_mesh(const CLI::App& mesh, const MeshArguments& arguments);

}  // namespace driver::commands
