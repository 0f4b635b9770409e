// SPDX-License-Identifier: Apache-2.0
// What a ladder varies: the parts of its plan.
#pragma once

#include "case_settings.hpp"
#include "many_runs/ladder.hpp"

namespace driver {

void add_effects(const Scene& scene, const CaseSettings& settings, LadderPlan& plan);
void add_resolutions(const Scene& scene, const CaseSettings& settings, LadderPlan& plan);

/// Adds what takes the membrane out of the bag's case to the plan, or says why that cannot be.
void add_no_membrane(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                     const Scene& scene, const CaseSettings& settings, const std::string& quantity,
                     LadderPlan& plan);

/// What takes the membrane out of the plan's case, and gives its gas this volume, as TOML.
std::vector<std::string> without_membrane(const LadderPlan& plan, const std::string& volume);

/// The volume that follows its pressure as that of the bag of the case with `overrides` does at rest, as
/// TOML; or nothing, and the plan says why unless it was an interrupt.
std::optional<std::string> bag_by_volume(const std::filesystem::path& file,
                                         const std::vector<std::string>& overrides, bool quiet,
                                         LadderPlan& plan);

/// The full case less one thing more each time, the least important first: the name of what is left out, and
/// all choices. None of it depends on the clock: the rungs are the same whenever and in how many parts a
/// ladder runs.
std::vector<std::pair<std::string, std::vector<std::size_t>>> combinations(const LadderResult& result);

}  // namespace driver
