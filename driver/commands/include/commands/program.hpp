// SPDX-License-Identifier: Apache-2.0
// The program: a command line in, an exit code out.
#pragma once

#include "many_runs/crew.hpp"

namespace driver::commands {

/// Runs the subcommand that the command line asks for; those of many runs let `crew` compute them.
int run_command_line(int argc, char** argv, const MakeCrew& crew);
/// The same as a whole program: errors are told, and are exit codes.
int program(int argc, char** argv, const MakeCrew& crew);

}  // namespace driver::commands
