// SPDX-License-Identifier: Apache-2.0
#include "gas/control_volume.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

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
  require(inflow.temperature.outside() == Outside::held, "inflow.temperature [K]", 0.0,
          "must be held outside its knots");
  require(inflow.start_time > -std::numeric_limits<double>::infinity(), "inflow.start_time [s]",
          inflow.start_time, "must be finite, or infinity for never");
}

void require_trigger(const std::optional<std::size_t>& trigger, const TriggerModel& model) {
  if (trigger)
    require(*trigger < model.size(), "trigger", static_cast<double>(*trigger),
            "must be a node of the triggers");
}

void require_area(const Curve& curve, const char* name) {
  require(curve.minimum() >= 0.0, name, curve.minimum(), "must not be negative");
  require(curve.outside() == Outside::held, name, 0.0, "must be held outside its knots");
}

void require_no_jump(const Curve& curve, const char* name) {
  if (const auto jump = curve.first_jump())
    require(false, name, *jump, "is the overpressure of a jump: must have one value at each overpressure");
}

void validate(const Vent& vent) {
  require(vent.discharge_coefficient >= 0.0 && vent.discharge_coefficient <= 1.0,
          "vent.discharge_coefficient", vent.discharge_coefficient, "must be 0 to 1");
  require(std::isfinite(vent.area) && vent.area >= 0.0, "vent.area [m2]", vent.area,
          "must be finite and not negative");
  require(!(vent.area_of_time && vent.area_of_overpressure), "number of area curves", 2.0, "must be 0 or 1");
  if (vent.area_of_time) require_area(*vent.area_of_time, "vent.area_of_time [m2]");
  if (!vent.area_of_overpressure) return;
  require_area(*vent.area_of_overpressure, "vent.area_of_overpressure [m2]");
  require_no_jump(*vent.area_of_overpressure, "knot of vent.area_of_overpressure [Pa]");
}

void validate(const std::vector<Fabric>& fabrics) {
  double sum = 0.0;
  for (const auto& [share, velocity] : fabrics) {
    require(share >= 0.0 && share <= 1.0, "fabric.share", share, "must be 0 to 1");
    sum += share;
    if (!velocity) continue;
    require_area(*velocity, "fabric.velocity [m/s]");
    require_no_jump(*velocity, "knot of fabric.velocity [Pa]");
    require(velocity->value(0.0) == 0.0, "fabric.velocity [m/s] at p = p_a", velocity->value(0.0),
            "must be 0");
  }
  if (!fabrics.empty())
    require(std::abs(sum - 1.0) <= kFractionTolerance, "sum of fabric.share", sum, "must be 1");
}

void require_volume(const Curve& curve, double ambient_pressure) {
  const char* name = "volume_of_overpressure [m3]";
  const auto knots = curve.knots();
  require(knots.size() >= 2, "number of knots of volume_of_overpressure", static_cast<double>(knots.size()),
          "must be at least 2");
  require(curve.outside() == Outside::held, name, 0.0, "must be held outside its knots");
  require(knots.front().time >= -ambient_pressure, "first overpressure of volume_of_overpressure [Pa]",
          knots.front().time, "must not be below -ambient.pressure");
  require(knots.front().value > 0.0, name, knots.front().value, "must be positive");
  require_no_jump(curve, "knot of volume_of_overpressure [Pa]");
  constexpr double steepest = 1e100;  // [m3/Pa] squares are finite
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const double rise = knots[i].value - knots[i - 1].value;
    require(rise >= 0.0, name, knots[i].value, "must not fall with the overpressure");
    require(rise <= steepest * (knots[i].time - knots[i - 1].time), name, knots[i].value,
            "must not rise by more than 1e100 m3/Pa");
  }
}

/// Each level of a sensor is located to 2e-12 of p. Two levels must be farther apart than that.
void require_apart(const Sensor& sensor, double ambient_pressure) {
  constexpr double kApart = 1e-11;
  if (sensor.kind != SensorKind::pressure || !sensor.reset) return;
  const double width = kApart * (ambient_pressure + std::max(0.0, sensor.threshold));
  require(sensor.threshold - *sensor.reset >= width, "sensor.reset [Pa]", *sensor.reset,
          "must be " + to_short_text(1.01 * width) + " Pa or more below the threshold");
}

}  // namespace

void validate(const ControlVolumeModel& model) {
  const double p_a = model.ambient.pressure, t_a = model.ambient.temperature;
  require(std::isfinite(p_a) && p_a >= 0.0, "ambient.pressure [Pa]", p_a, "must be finite and not negative");
  require(std::isfinite(t_a) && t_a > 0.0, "ambient.temperature [K]", t_a, "must be finite and positive");
  for (const Inflow& inflow : model.inflows) validate(model.thermo, inflow);
  for (const Inflow& inflow : model.inflows) require_trigger(inflow.trigger, model.triggers);
  bool backflow = false;
  for (const Vent& vent : model.vents) {
    validate(vent);
    require_trigger(vent.trigger, model.triggers);
    backflow = backflow || vent.backflow;
  }
  if (backflow) {
    require_fractions(model.thermo, model.ambient.mass_fractions);
    require(is_in_range(model.thermo, t_a), "ambient.temperature [K]", t_a, range_text(model.thermo));
  }
  const HeatLoss& heat = model.heat_loss;
  require(std::isfinite(heat.conductance) && heat.conductance >= 0.0, "heat_loss.conductance [W/K]",
          heat.conductance, "must be finite and not negative");
  require(std::isfinite(heat.outside_temperature) && heat.outside_temperature > 0.0,
          "heat_loss.outside_temperature [K]", heat.outside_temperature, "must be finite and positive");
  require(model.laminar_share >= 0.0 && model.laminar_share <= 1e-3, "laminar_share", model.laminar_share,
          "must be 0 to 1e-3");
  validate(model.fabrics);
  if (model.volume_of_overpressure) require_volume(*model.volume_of_overpressure, p_a);
  validate(model.triggers);
  for (const Sensor& sensor : model.triggers.sensors) require_apart(sensor, p_a);
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

ControlVolumeState make_state(const ControlVolumeModel& model, std::span<const double> mass_fractions,
                              double pressure, double temperature, double volume) {
  ControlVolumeState state = make_state(model.thermo, mass_fractions, pressure, temperature, volume);
  state.triggers.resize(model.triggers.size());
  return state;
}

double firing_time(const Inflow& inflow, const TriggerState& triggers) {
  return inflow.trigger ? triggers.at(*inflow.trigger).first_on + inflow.start_time : inflow.start_time;
}

}  // namespace gas
