// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "forecast/forecast.hpp"

namespace driver {

/// Settings, defaults, warnings, derived values, species and forecast of a state at the start; units stand in
/// the keys.
std::string check_json(const CaseDocument& document, const Scene& scene, const State& state,
                       const Forecast& forecast);

/// Text of check.json: the same of a run's own start, with its `id`. Empty if the start is out of the models'
/// domain, of which the run itself tells.
std::string check_file(const CaseDocument& document, const Scene& scene, const std::string& id);

}  // namespace driver
