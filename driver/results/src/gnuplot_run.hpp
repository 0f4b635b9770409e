// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace driver {

/// Runs `gnuplot NAME.gp` in `folder`. Returns what failed; empty if nothing did.
std::string run_gnuplot(const std::filesystem::path& folder, const std::string& name);

}  // namespace driver
