// SPDX-License-Identifier: Apache-2.0
// summary.json of a run.
#pragma once

#include <string>
#include <vector>

#include "base/run_id.hpp"
#include "engine/run.hpp"
#include "results/skin_checks.hpp"

namespace driver {

/// Text of summary.json of a run, with any outcome.
std::string summary_text(const Scene& scene, const State& state, const RunOutcome& outcome,
                         const std::vector<SkinCheck>& checks, const Provenance& provenance);
/// The text while the run goes on.
std::string summary_of_running(const Scene& scene, const Provenance& provenance);

}  // namespace driver
