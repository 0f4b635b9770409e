// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/command.hpp"

namespace driver::commands {

/// `compare --enclosure`: judges a history by the proved bounds in the file of the reference. Returns the
/// exit code; throws CaseError.
int compare_enclosure(const CompareArguments& arguments, const Tolerance& tolerance);

}  // namespace driver::commands
