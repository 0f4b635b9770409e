// SPDX-License-Identifier: Apache-2.0
// The program: a command line in, an exit code out.
#pragma once

#include "many_runs/crew.hpp"

namespace driver::commands {

/// Runs the subcommand of the command line. Commands of many runs let `crew` compute them.
int run_command_line(int argc, char** argv, const MakeCrew& crew);
/// The same as a whole program: prints errors and turns them into exit codes.
int program(int argc, char** argv, const MakeCrew& crew);

}  // namespace driver::commands
