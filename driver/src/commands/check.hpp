// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "driver/forecast.hpp"

namespace driver::commands {

/// Settings, defaults, warnings, derived values, species and forecast of a state at the start; units stand in
/// the keys.
std::string check_json(const CaseDocument& document, const Scene& scene, const State& state,
                       const Forecast& forecast);

}  // namespace driver::commands
