// SPDX-License-Identifier: Apache-2.0
// Foresees gas that leaves the temperatures of its data.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/plausibility.hpp"

namespace driver {
namespace {

/// Where gas that expands from the start to ambient pressure would be colder than its data reach: by entropy,
/// which stays in the gas that a vent leaves behind.
void warn_of_expansion(Scene& scene) {
  const GasPart& part = *scene.gas;
  const gas::Thermo& thermo = part.model.thermo;
  const double lowest = thermo.minimum_temperature(), p_a = scene.ambient.pressure;
  const auto& y = part.initial_fractions;
  const bool open = !part.model.vents.empty() || part.tank_leak_area > 0.0;
  if (!open || !(lowest > 0.0) || !(p_a > 0.0) || !(part.initial_pressure > p_a)) return;
  if (thermo.entropy(y, lowest, p_a) > thermo.entropy(y, part.initial_temperature, part.initial_pressure))
    scene.warnings.push_back(fmt::format(
        "gas that expands from {:.4g} Pa and {:.4g} K to ambient pressure falls below {:.4g} K, the end of "
        "its data: unless it is warmed the run stops there (thermodynamics = \"constant\" has no such limit)",
        part.initial_pressure, part.initial_temperature, lowest));
}

double smallest_volume(const TankVolume& volume, double end) {
  const double last = volume.table ? end : std::min(end, 1.0 / volume.frequency);
  double smallest = std::min(volume.at(0.0), volume.at(last));
  for (double t = volume.piece_end(0.0); t < last; t = volume.piece_end(t))
    smallest = std::min(smallest, volume.at(t));
  return smallest;
}

/// Where gas would be hotter than its data reach: compressed by a tank that shrinks, by entropy at the same
/// mass, or let into an empty volume, where its enthalpy becomes internal energy.
void warn_of_heat(Scene& scene) {
  const GasPart& part = *scene.gas;
  const gas::Thermo& thermo = part.model.thermo;
  const double highest = thermo.maximum_temperature(), t = part.initial_temperature;
  if (!std::isfinite(highest)) return;
  constexpr const char* ending =
      "rises above {:.4g} K, the end of its data: unless it is cooled the run stops there";
  const auto& y = part.initial_fractions;
  if (part.tank_volume && part.initial_pressure > 0.0) {
    const double squeeze = part.tank_volume->at(0.0) / smallest_volume(*part.tank_volume, scene.time.end);
    const double p = part.initial_pressure * squeeze * highest / t;
    if (thermo.entropy(y, highest, p) < thermo.entropy(y, t, part.initial_pressure))
      scene.warnings.push_back(
          fmt::format("gas at {:.4g} K that [tank] volume compresses {:.4g}-fold ", t, squeeze) +
          fmt::format(ending, highest));
  }
  for (const gas::Inflow& inflow : part.model.inflows)
    if (const double in = inflow.temperature.maximum();
        part.initial_pressure == 0.0 &&
        thermo.enthalpy(inflow.mass_fractions, in) > thermo.internal_energy(inflow.mass_fractions, highest))
      scene.warnings.push_back(fmt::format("gas of an inflator at {:.4g} K that fills an empty volume ", in) +
                               fmt::format(ending, highest));
}

}  // namespace

void warn_of_range(Scene& scene) {
  warn_of_expansion(scene);
  warn_of_heat(scene);
}

}  // namespace driver
