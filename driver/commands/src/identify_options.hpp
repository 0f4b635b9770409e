// SPDX-License-Identifier: Apache-2.0
// The options of `gasjet identify`.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "commands/command.hpp"

namespace driver::commands {

/// Adds the command; the command line is parsed into `a`.
void add_identify(CLI::App& app, IdentifyArguments& a);

/// The value of --heat-loss [W/K]; nothing for "fit". Throws CaseError for other texts.
std::optional<double> heat_loss(const IdentifyArguments& a);

}  // namespace driver::commands
