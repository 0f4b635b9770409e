// SPDX-License-Identifier: Apache-2.0
#include "radioss_injection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gas_at_start.hpp"
#include "vent_curves.hpp"

namespace driver::imported {

double start_of_sensor(RadiossContext& c, long sensor, Place at) {
  if (sensor == 0) return 0.0;
  const DeckCard& card = *entry_of(c.tables.sensors, sensor, "sensor", at);
  if (!card.keyword.starts_with("/SENSOR/TIME"))
    throw DeckFault(card.at, "this kind of sensor has no counterpart, allowed: /SENSOR/TIME");
  c.report.became(card, {"inflator.start_time"}, Mapping::exact);
  return c.twenties(card, 1).real(0, "Tdelay") * c.units.time;
}

void inject(RadiossContext& c, BagInflator& inflator, long function, double factor, double time_unit,
            bool is_flow, Place at) {
  Knots knots = c.curve(function, time_unit, factor * (is_flow ? c.units.mass_flow() : c.units.mass),
                        "inflator.mass_flow", at);
  extend_to(knots, c.bag.end_time);
  if (!is_flow) {
    inflator.at_once = std::max(value_at(knots, 0.0), 0.0);
    knots = flow_of_mass(knots, moment_of(c.bag));
    if (knots.empty()) throw DeckFault(at, "the function of mass has one point only");
    c.report.note(fmt::format("{}: cumulative mass as a mass flow that is constant between its knots",
                              c.text.where(at)));
  }
  not_below_zero(knots, "inflator.mass_flow", c.report);
  inflator.mass_flow = std::move(knots);
}

void require_plain_volume(RadiossContext& c, const DeckFields& scales, double viscosity) {
  for (std::size_t i = 0; i < 5; ++i)
    if (or_one(scales.real(i, "a scale")) != 1.0)
      throw DeckFault(scales.at(), "scales of abscissas other than 1 have no counterpart");
  constexpr double none = 1e-6;
  if (viscosity > none)
    c.report.note(fmt::format(
        "Mu = {:g}: a viscous pressure against the change of the volume has no counterpart", viscosity));
}

long injectors_of(RadiossContext& c, std::size_t line) {
  const long jets = c.tens(c.volume, line).whole(0, "Njet");
  constexpr long most = 100;
  if (jets < 0 || jets > most)
    throw DeckFault(c.volume.at, fmt::format("Njet = {}, allowed: 0 to {}", jets, most));
  return jets;
}

}  // namespace driver::imported
