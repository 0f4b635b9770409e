// SPDX-License-Identifier: Apache-2.0
// The options of `gasjet import`.
#pragma once

#include <CLI/CLI.hpp>

#include "commands/command.hpp"

namespace driver::commands {

/// Adds the command; the command line is parsed into `a`.
void add_import(CLI::App& app, ImportArguments& a);

}  // namespace driver::commands
