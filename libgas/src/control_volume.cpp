// SPDX-License-Identifier: Apache-2.0
#include "gas/control_volume.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "gas/orifice.hpp"
#include "inflow_segment.hpp"
#include "require.hpp"

namespace gas {
namespace {

// A sum of mass fractions may differ from 1 by the rounding of fractions written with nine digits or more.
constexpr double kFractionTolerance = 1e-9;

bool is_in_range(const Thermo& thermo, double temperature) {
  return temperature > 0.0 && std::isfinite(temperature) && temperature >= thermo.minimum_temperature() &&
         temperature <= thermo.maximum_temperature();
}

std::string range_text(const Thermo& thermo) {
  return "must be positive, finite and in " + to_text(thermo.minimum_temperature()) + " to " +
         to_text(thermo.maximum_temperature()) + " K";
}

void require_fractions(const Thermo& thermo, std::span<const double> fractions) {
  require(fractions.size() == thermo.size(), "number of mass_fractions",
          static_cast<double>(fractions.size()), "must be one per species");
  double sum = 0.0;
  for (const double f : fractions) {
    require(f >= 0.0 && f <= 1.0, "mass_fractions", f, "must be 0 to 1");
    sum += f;
  }
  require(std::abs(sum - 1.0) <= kFractionTolerance, "sum of mass_fractions", sum, "must be 1");
}

void validate(const Thermo& thermo, const Inflow& inflow) {
  require_fractions(thermo, inflow.mass_fractions);
  require(inflow.mass_flow.minimum() >= 0.0, "inflow.mass_flow [kg/s]", inflow.mass_flow.minimum(),
          "must not be negative");
  for (const double t : {inflow.temperature.minimum(), inflow.temperature.maximum()})
    require(is_in_range(thermo, t), "inflow.temperature [K]", t, range_text(thermo));
  require(inflow.temperature.outside() == Outside::kHeld, "inflow.temperature [K]", 0.0,
          "must be held outside its knots");
  require(inflow.start_time > -std::numeric_limits<double>::infinity(), "inflow.start_time [s]",
          inflow.start_time, "must be finite, or infinity for never");
}

double mass_flow(const Inflow& inflow, double time) {
  const double tau = local_time(inflow, time);
  return tau >= 0.0 ? inflow.mass_flow.value(tau) : 0.0;
}

}  // namespace

void validate(const ControlVolumeModel& model) {
  const double p_a = model.ambient.pressure, t_a = model.ambient.temperature;
  require(std::isfinite(p_a) && p_a >= 0.0, "ambient.pressure [Pa]", p_a, "must be finite and not negative");
  require(std::isfinite(t_a) && t_a > 0.0, "ambient.temperature [K]", t_a, "must be finite and positive");
  for (const Inflow& inflow : model.inflows) validate(model.thermo, inflow);
  for (const Orifice& vent : model.vents) {
    require(vent.discharge_coefficient >= 0.0 && vent.discharge_coefficient <= 1.0,
            "vent.discharge_coefficient", vent.discharge_coefficient, "must be 0 to 1");
    require(std::isfinite(vent.area) && vent.area >= 0.0, "vent.area [m2]", vent.area,
            "must be finite and not negative");
  }
}

ControlVolumeState make_state(const Thermo& thermo, std::span<const double> mass_fractions, double pressure,
                              double temperature, double volume) {
  require_fractions(thermo, mass_fractions);
  require(std::isfinite(pressure) && pressure >= 0.0, "pressure [Pa]", pressure,
          "must be finite and not negative");
  require(is_in_range(thermo, temperature), "temperature [K]", temperature, range_text(thermo));
  require(std::isfinite(volume) && volume > 0.0, "volume [m3]", volume, "must be finite and positive");
  const double mass = pressure * volume / (thermo.gas_constant(mass_fractions) * temperature);
  ControlVolumeState state{{mass_fractions.begin(), mass_fractions.end()}, 0.0, temperature};
  for (double& m : state.masses) m *= mass;
  state.internal_energy = thermo.mixture(state.masses).internal_energy(temperature);
  return state;
}

GasPoint evaluate(const ControlVolumeModel& model, const ControlVolumeState& state, double volume,
                  double leak_area, double time) {
  if (!(volume > 0.0)) throw DomainError("volume = " + to_text(volume) + " m3: must be positive");
  GasPoint point{};
  point.temperature = state.temperature;
  for (const Inflow& inflow : model.inflows) point.inflow += mass_flow(inflow, time);
  const Mixture mixture = model.thermo.mixture(state.masses);
  if (mixture.mass == 0.0) return point;
  point.temperature = mixture.temperature(state.internal_energy, state.temperature);
  point.mass = mixture.mass;
  point.density = mixture.mass / volume;
  point.gas_constant = mixture.gas_constant_sum / mixture.mass;
  point.cp = mixture.cp(point.temperature) / mixture.mass;
  point.gamma = point.cp / (point.cp - point.gas_constant);
  point.pressure = mixture.gas_constant_sum * point.temperature / volume;
  for (const Orifice& vent : model.vents)
    point.vent_mass_flow +=
        orifice_mass_flow(vent.discharge_coefficient * vent.area, point.pressure, point.temperature,
                          point.gas_constant, point.cp, point.gamma, model.ambient.pressure);
  point.fabric_mass_flow = fabric_mass_flow(leak_area, point.density, point.pressure, model.ambient.pressure);
  return point;
}

InflatorPoint inflator_point(const ControlVolumeModel& model, std::size_t i, double time) {
  const Inflow& inflow = model.inflows.at(i);
  const double temperature = inflow.temperature.value(local_time(inflow, time));
  const Mixture gas = model.thermo.mixture(inflow.mass_fractions);
  const double cp = gas.cp(temperature);
  return {mass_flow(inflow, time), temperature, cp / gas.mass, cp / gas.cv(temperature),
          gas.gas_constant_sum / gas.mass};
}

}  // namespace gas
