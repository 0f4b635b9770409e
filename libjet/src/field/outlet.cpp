// SPDX-License-Identifier: Apache-2.0
#include "jet/outlet.hpp"

#include <cmath>

#include "refuse.hpp"

namespace jet {
namespace {

void check_positive(const char* name, double value) {
  if (!(value > 0.0) || !std::isfinite(value)) refuse_value<DomainError>(name, value, "finite and > 0");
}

void check(const OutletModel& model, const OutletInput& input) {
  if (!(input.mass_flow >= 0.0) || !std::isfinite(input.mass_flow)) {
    refuse_value<DomainError>("outlet mass_flow", input.mass_flow, "finite and >= 0");
  }
  check_positive("outlet temperature", input.temperature);
  check_positive("outlet gas_constant", input.gas_constant);
  if (!(input.cp > input.gas_constant) || !std::isfinite(input.cp)) {
    refuse_value<DomainError>("outlet cp", input.cp, "finite and > gas_constant");
  }
  if (model.law != OutletLaw::sonic) check_positive("outlet bag_pressure", input.bag_pressure);
}

OutletState sonic_state(const OutletModel& model, const OutletInput& input) {
  const double gamma = input.cp / (input.cp - input.gas_constant);
  OutletState state;
  state.temperature = input.temperature;
  if (model.temperature == OutletTemperature::stagnation) state.temperature *= 2.0 / (gamma + 1.0);
  state.velocity = std::sqrt((gamma - 1.0) * input.cp * state.temperature);
  state.density = input.mass_flow / (model.area * state.velocity);
  state.pressure = state.density * input.gas_constant * state.temperature;
  return state;
}

OutletState subsonic_state(const OutletModel& model, const OutletInput& input) {
  const double b = model.area * input.bag_pressure / input.gas_constant;
  const double c = 2.0 * input.mass_flow * input.temperature;
  OutletState state;
  // This form of the root does not cancel as the flow goes to zero.
  state.velocity = c / (b + std::sqrt(b * b + input.mass_flow * c / input.cp));
  state.temperature = input.temperature - state.velocity * state.velocity / (2.0 * input.cp);
  state.pressure = input.bag_pressure;
  state.density = state.pressure / (input.gas_constant * state.temperature);
  return state;
}

// The notional nozzle (J.12). T > T_s / gamma^2, its value far above bag pressure.
OutletState expanded_state(const OutletModel& model, const OutletInput& input, const OutletState& sonic) {
  OutletState state;
  state.velocity = sonic.velocity + (sonic.pressure - input.bag_pressure) * model.area / input.mass_flow;
  state.temperature = input.temperature - state.velocity * state.velocity / (2.0 * input.cp);
  state.pressure = input.bag_pressure;
  state.density = state.pressure / (input.gas_constant * state.temperature);
  state.area_ratio = input.mass_flow / (state.density * state.velocity * model.area);
  state.reflected = sonic.velocity / state.velocity;
  return state;
}

}  // namespace

void validate(const OutletModel& model) {
  if (!(model.area > 0.0) || !std::isfinite(model.area)) {
    refuse_value("outlet area", model.area, "finite and > 0 [m2]");
  }
  if (model.law != OutletLaw::sonic && model.law != OutletLaw::pressure_matched &&
      model.law != OutletLaw::expanded)
    refuse_value("outlet law", static_cast<double>(model.law), "an enumerator");
  if (model.temperature != OutletTemperature::static_value &&
      model.temperature != OutletTemperature::stagnation)
    refuse_value("outlet temperature", static_cast<double>(model.temperature), "an enumerator");
  if (model.law != OutletLaw::sonic && model.temperature != OutletTemperature::stagnation) {
    throw std::invalid_argument(
        "outlet temperature is static, allowed for the pressure-matched or expanded outlet: stagnation");
  }
}

OutletState outlet_state(const OutletModel& model, const OutletInput& input) {
  check(model, input);
  const OutletState sonic = sonic_state(model, input);
  if (model.law == OutletLaw::sonic) return sonic;
  if (sonic.pressure < input.bag_pressure) return subsonic_state(model, input);
  const bool expands = model.law == OutletLaw::expanded && sonic.pressure > input.bag_pressure;
  return expands ? expanded_state(model, input, sonic) : sonic;
}

double momentum_flux(const OutletState& state, double area) {
  return state.density * state.velocity * state.velocity * area * state.area_ratio;
}

}  // namespace jet
