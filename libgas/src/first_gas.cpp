// SPDX-License-Identifier: Apache-2.0
// The first gas of an evacuated volume, which has no heat capacity.
#include <algorithm>

#include "pressure_volume.hpp"
#include "substepper.hpp"

namespace gas {
namespace {

/// `to` plus factor times the amount `from`.
void add(double factor, const Mixture& from, Mixture& to) {
  to.constant_cp = from.constant_cp;
  to.minimum_temperature = from.minimum_temperature;
  to.maximum_temperature = from.maximum_temperature;
  to.gas_constant_sum += factor * from.gas_constant_sum;
  for (std::size_t j = 0; j < to.low.size(); ++j) {
    to.low[j] += factor * from.low[j];
    to.high[j] += factor * from.high[j];
  }
}

}  // namespace

/// The temperature at which inflow and walls balance while an evacuated volume begins to fill, sum mdot_i
/// (h_i - u_i(T)) = h A (T - T_ext), which is the equation of a mixture with h A added to its cp: work
/// against its pressure is of second order in its mass. None without inflow.
std::optional<double> FlowBalance::temperature_of_first_gas(double t) const {
  const HeatLoss& loss = model_.heat_loss;
  Mixture sum;
  double energy = loss.conductance * loss.outside_temperature, flow = 0.0;
  for (const InflowSegment& segment : segments_) {
    const auto [mass_flow, temperature] = segment.flow(t);
    if (!(mass_flow > 0.0)) continue;
    energy += mass_flow * segment.gas().enthalpy(temperature);
    add(mass_flow, segment.gas(), sum);
    flow += mass_flow;
  }
  if (point_.back > 0.0) {
    energy += point_.back * air_enthalpy_;
    add(point_.back, air_, sum);
    flow += point_.back;
  }
  if (flow == 0.0) return {};
  sum.low[0] += loss.conductance;
  sum.high[0] += loss.conductance;
  return sum.find_temperature(energy, loss.outside_temperature);
}

void FlowBalance::fill_backflow(Vector& dydt, double t) {
  std::fill_n(dydt.begin() + static_cast<std::ptrdiff_t>(back_slot(0)), backflows(), 0.0);
  point_.back = 0.0;
  if (regime_ == Regime::kBack || regime_ == Regime::kBackSonic) backflow_rates(dydt, t, point_.overpressure);
}

double FlowBalance::first_backflow(std::size_t vent, const FirstFlow& flow) const {
  return 0.5 * (flow.begin_rate[back_slot(vent)] + flow.end_rate[back_slot(vent)]) * (flow.end - flow.begin);
}

void FlowBalance::fill_until(Vector& y, const FirstFlow& flow) {
  const double end = flow.end;
  for (std::size_t j = 0; j < backflows(); ++j) y[back_slot(j)] += first_backflow(j, flow);
  collect(y, end);
  model_.thermo.mixture(masses_, mixture_);
  const auto temperature = temperature_of_first_gas(end);
  if (!temperature) return;
  double heat = energy_ - mixture_.internal_energy(*temperature);
  if (volume_by_pressure_)
    heat -= volume_by_pressure_->place(mixture_.gas_constant_sum * *temperature).work - work_begin_;
  y[heat_slot()] += heat;
}

double FlowBalance::mass_in(const FirstFlow& flow) const {
  double mass = 0.0;
  for (const InflowSegment& segment : segments_) mass += segment.delivered_until(flow.end).mass;
  for (std::size_t j = 0; j < backflows(); ++j) mass += first_backflow(j, flow);
  return mass;
}

/// Behind walls the first gas of an evacuated volume has no heat capacity to be stepped with: it is at its
/// balance with them. So it is for one fixed step, or until a share of the segment's gas is there that will
/// be forgotten at its end, or as long as it relaxes so often that it lags behind that balance by less than
/// 1e-4 of its distance from the walls' temperature, which is forgotten as fast; and below all switches and
/// levels. Returns the time reached.
double Substepper::fill_first(Rates& rates, double a, double b) {
  FlowBalance& balance = rates.balance;
  const auto flow_until = [&](double end) {
    balance.fill_backflow(trial_.end_rate, end);
    return FlowBalance::FirstFlow{begin_rate_, trial_.end_rate, a, end};
  };
  constexpr double kRelaxations = 1e4;  // an explicit method takes a third as many sub-steps after them
  const double all = balance.mass_in(flow_until(b)), fixed = options_.fixed_step;
  if (!(all > 0.0)) return a;
  double lowest = 0.4 * balance.ambient_pressure();  // below the sonic switch of every gas
  for (const double level : levels_)
    if (const double p = balance.ambient_pressure() + level; p > 0.0) lowest = std::min(lowest, 0.5 * p);
  for (double step = fixed > 0.0 ? std::min(fixed, b - a) : b - a;; step *= 0.5) {
    const double end = step == b - a ? b : a + step;
    const FlowBalance::FirstFlow flow = flow_until(end);
    trial_.end = zero_;
    balance.fill_until(trial_.end, flow);
    balance.locate(trial_.end, end);
    if (fixed == 0.0 && balance.mass_in(flow) > options_.relative_tolerance * all &&
        !(balance.heat_rate() * step > kRelaxations))
      continue;
    if (lowest > 0.0 && balance.point().pressure > lowest) continue;
    balance.accept(trial_.end, end);
    ++accepted_;
    return end;
  }
}

}  // namespace gas
