// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>

#include "enclosure/enclose.hpp"
#include "tank.hpp"

/// Random tanks as scenes for proved bounds.
namespace random_tanks {

/// None of a tank with a pressure sensor that acts, or a volume that follows the pressure.
std::optional<enclosure::Scene> scene_of(const Tank& tank, const std::string& csv);

/// Largest distance of libgas's p, T and m from their bounds at the ends of the calls, relative; not a number
/// if libgas refuses. Throws enclosure::Refusal.
double distance_to_tube(const Tank& tank, const enclosure::Scene& scene, double width, double longest);

}  // namespace random_tanks
