// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "forecast/forecast.hpp"

namespace driver {

/// Settings, defaults, warnings, derived values, species and forecast of a state at the start; keys contain
/// the units.
std::string check_json(const CaseDocument& document, const Scene& scene, const State& state,
                       const Forecast& forecast);

/// Text of check.json: the same for the start of a run, with its `id`. Empty if the start is outside the
/// models' domain, which the run itself reports.
std::string check_file(const CaseDocument& document, const Scene& scene, const std::string& id);

}  // namespace driver
