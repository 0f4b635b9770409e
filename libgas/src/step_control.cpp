// SPDX-License-Identifier: Apache-2.0
#include "step_control.hpp"

#include <algorithm>
#include <cmath>
#include <elementary/exponential.hpp>

#include "limits.hpp"
#include "rate_slopes.hpp"
#include "require.hpp"

namespace gas {
namespace {

constexpr double kSafety = 0.9, kSmallestFactor = 0.05, kLargestFactor = 5.0;
// The first step's error constant is guessed as kFirstStep^-error_power. It affects the speed only.
constexpr double kFirstStep = 5.0;
// Knots of a curve over the overpressure that are closer than this multiple of p's tolerance count as a jump.
constexpr double kJump = 100.0;
constexpr double kBeside = 10.0;  // a jump may hold p if p is at most this multiple of that distance away

/// Describes a rise of `curve` near the overpressure that is so steep that flow may hold p there, which the
/// tolerance does not resolve. `name` and `unit` belong to its values. Empty if there is none.
std::string jump_text(const std::string& name, const std::string& unit, const Curve& curve,
                      const UniformGas& gas, double tolerance) {
  const double width = kJump * tolerance * gas.pressure;
  const auto knots = curve.knots();
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const auto &l = knots[i - 1], &r = knots[i];
    if (r.time - l.time < width && r.value > l.value && l.time - kBeside * width < gas.overpressure &&
        gas.overpressure < r.time + kBeside * width)
      return "; the curve of " + name + " jumps from " + to_text(l.value) + " to " + to_text(r.value) + unit +
             " between " + to_text(l.time) + " and " + to_text(r.time) + " Pa: set its knots " +
             to_short_text(width) + " Pa apart or more";
  }
  return {};
}

std::string jump_text(const Balance& balance, double tolerance) {
  const ControlVolumeModel& model = balance.boundary().model();
  for (std::size_t i = 0; i < model.vents.size(); ++i)
    if (const auto& curve = model.vents[i].area_of_overpressure)
      if (const std::string text =
              jump_text("vent." + std::to_string(i) + ".area", " m2", *curve, balance.gas(), tolerance);
          !text.empty())
        return text;
  for (const Fabric& fabric : model.fabrics)
    if (fabric.velocity)
      if (const std::string text =
              jump_text("the fabric's velocity", " m/s", *fabric.velocity, balance.gas(), tolerance);
          !text.empty())
        return text;
  return {};
}

}  // namespace

StepControl::StepControl(const IntegratorOptions& options)
    : options_(options),
      first_share_(kFirstStep * elementary::pow(options.relative_tolerance,
                                                options.method == Method::rosenbrock_4 ? 0.25 : 0.2)) {}

double StepControl::scaled_error(const System& system, const Vector& error, Vector& scratch) const {
  if (is_fixed()) return 0.0;
  const Balance& balance = system.balance;
  const UniformGas& gas = balance.gas();
  const Thermo& thermo = balance.boundary().model().thermo;
  system.ledger.change(error, scratch);
  const double work = error[balance.boundary().slots().work()];
  double energy = scratch.back() + work, largest = 0.0;
  for (std::size_t k = 0; k < thermo.size(); ++k) {
    if (scratch[k] == 0.0) continue;
    energy -= thermo.enthalpy(k, gas.temperature) * scratch[k];
    largest = std::max(largest, std::abs(scratch[k]));
  }
  const double energy_error = std::abs(energy) + std::abs(work);
  if (largest == 0.0 && energy_error == 0.0) return 0.0;
  const double scaled = std::max(largest / gas.mass, energy_error / (gas.capacity * gas.temperature));
  return std::isfinite(scaled) ? scaled / options_.relative_tolerance : kInfinity;
}

double StepControl::factor(double error, double error_power) const {
  if (is_fixed()) return 1.0;
  if (error == 0.0) return kLargestFactor;
  return std::clamp(kSafety * elementary::pow(error, -1.0 / error_power), kSmallestFactor, kLargestFactor);
}

double StepControl::first_step(const Balance& balance) const {
  const UniformGas& gas = balance.gas();
  if (gas.mass == 0.0) return kInfinity;
  const double fed = std::abs(balance.closed_growth()) / (gas.pressure * gas.volume);
  const double left = std::abs(balance.flow()) / gas.mass;
  return std::max(first_share_ / (fed + left), 8.0 * kEpsilon * balance.time());
}

double StepControl::limit() const {
  const bool turns = options_.method == Method::dormand_prince_5 && !is_fixed();
  return turns ? kInfinity : stability_limit(options_.method);
}

/// In a sub-step of this length the rounding of the gas that passes through equals the tolerance of the gas
/// present.
double StepControl::rounding_limit(const Balance& balance) const {
  const double passing = std::abs(balance.flow());
  return passing > 0.0 && balance.gas().mass > 0.0
             ? options_.relative_tolerance * balance.gas().mass / (100.0 * kEpsilon * passing)
             : kInfinity;
}

double StepControl::longest(const Balance& balance, double relaxation) const {
  if (is_fixed()) return options_.fixed_step;
  // The halves of a doubled step are at half of the limit, where |R| is small: damped parts stay damped.
  const double stable = relaxation > 0.0 ? limit() / relaxation : kInfinity;
  return std::min(stable, rounding_limit(balance));
}

bool StepControl::tells(const Balance& balance, double overpressure) const {
  return is_fixed() || std::abs(overpressure) > options_.relative_tolerance * balance.gas().pressure;
}

bool StepControl::is_ending(const Balance& balance, const Moment& at) const {
  return at.growth == 0.0 && !tells(balance, at.overpressure);
}

void StepControl::require_stable(const Balance& balance, double length, double relaxation) const {
  if (!is_fixed() || options_.unsafe_step) return;
  const bool fed = balance.closed_growth() * where_linear(balance).overpressure > 0.0;
  const double rate = fed ? relaxation : wall_relaxation(balance);
  if (!(length * rate > limit())) return;
  throw DomainError("the step " + to_text(options_.fixed_step) + " s is above the method's stability limit " +
                    to_text_below(limit() / rate) + " s at t = " + to_short_text(balance.absolute_time()) +
                    " s, where the gas relaxes within " + to_short_text(1.0 / rate) +
                    " s. Use a shorter gas_step, leave it out, or use Rosenbrock 4 (gas_method)");
}

void StepControl::require_motion(const Balance& balance, const Moment& begin, const Moment& end,
                                 double length) const {
  constexpr double kStill = 0.01;  // share of the motion by the smaller rate; at the limit itself the motion
                                   // is zero
  if (!is_fixed() || options_.unsafe_step || options_.method == Method::rosenbrock_4) return;
  if (!(begin.rate * end.rate > 0.0)) return;
  const double moved = std::min(std::abs(begin.rate), std::abs(end.rate)) * length;
  if (moved <= options_.relative_tolerance * balance.gas().pressure ||
      std::abs(end.overpressure - begin.overpressure) >= kStill * moved)
    return;
  throw DomainError(
      "the step " + to_text(options_.fixed_step) +
      " s is too long for the balance of flows at t = " + to_short_text(balance.absolute_time()) +
      " s: p hardly moves although its rate is large. Use a shorter gas_step, or none");
}

void StepControl::fail_crossing(const Balance& balance) const {
  throw DomainError(
      "the step " + to_text(options_.fixed_step) +
      " s is too long for the balance near ambient pressure at t = " +
      to_short_text(balance.absolute_time()) +
      " s: flow through the openings takes p past p_a, or the wrong way. Use a shorter gas_step, or none");
}

/// Advice for the user if sub-steps of `length` are too many or too short.
std::string StepControl::advice(const Balance& balance, double length) const {
  const double relaxation = gas::relaxation(balance);
  std::string text = jump_text(balance, options_.relative_tolerance);
  if (!text.empty()) return text;
  if (relaxation > 0.0) text = "; it relaxes within " + to_short_text(1.0 / relaxation) + " s";
  if (length * relaxation > 0.1 * limit()) text += "; Rosenbrock 4 (gas_method) has no such limit";
  const double rounding = rounding_limit(balance);
  if (length > 0.1 * rounding)
    text += "; it is exchanged within " + to_short_text(balance.gas().mass / std::abs(balance.flow())) +
            " s, so that rounding takes sub-steps below " + to_short_text(rounding) +
            " s; use a looser gas_tolerance";
  return text;
}

bool StepControl::is_too_short(const Balance& balance, double t, double length) const {
  constexpr double kShortest = 1e-40;  // share of the segment
  return !is_fixed() &&
         length <= std::max(2.0 * kEpsilon * t, kShortest * balance.boundary().segment().length);
}

void StepControl::fail(System& system, double t, double length, bool found_gas) const {
  Balance& balance = system.balance;
  const Thermo& thermo = balance.boundary().model().thermo;
  const double at = balance.boundary().segment().begin + t;
  const std::string where =
      "at t = " + to_short_text(at) + " s with a sub-step of " + to_short_text(length) + " s";
  // The trial's result does not matter then: events or rates need shorter sub-steps than are possible.
  const bool too_short = is_too_short(balance, t, length);
  if (system.ledger.depleted() && !too_short)
    throw DomainError("species " + thermo.species(*system.ledger.depleted()).name + " runs out " + where +
                      (is_fixed() ? ". Use a shorter gas_step, or none" : ""));
  const bool begin_has_gas = balance.locate(system.ledger.gas(), t);
  // Trials that step over an end of the range are repeated until they are too short. The gas is then on that
  // end.
  constexpr double kOnEnd = 1e-6;  // of T
  const double temperature = balance.gas().temperature;
  const bool on_end = !begin_has_gas || balance.gas().mass == 0.0 ||
                      temperature <= (1.0 + kOnEnd) * thermo.minimum_temperature() ||
                      temperature >= (1.0 - kOnEnd) * thermo.maximum_temperature();
  if (!found_gas && (!too_short || on_end))
    throw DomainError(range_text(balance.boundary().model()) + where, at);
  Vector rates(balance.boundary().slots().size());
  balance.fill_rates(rates);
  const std::string gas =
      ", p = " + to_short_text(balance.gas().pressure) + " Pa and T = " + to_short_text(temperature) + " K";
  if (is_fixed())
    throw DomainError("a fixed sub-step of " + to_text(options_.fixed_step) + " s takes more than " +
                      std::to_string(options_.maximum_steps) + " sub-steps, " + where + gas +
                      ". Use a longer gas_step, or none");
  throw TooStiff("the gas is too stiff for the integrator: " + std::to_string(system.effort.attempts) +
                 (system.effort.attempts == 1 ? " sub-step, " : " sub-steps, ") + where + gas +
                 advice(balance, length) +
                 (too_short ? "; that is below the rounding of the time since the last break point. Use a "
                              "larger volume or smaller openings"
                            : ""));
}

}  // namespace gas
