// SPDX-License-Identifier: Apache-2.0
#include "first_gas.hpp"

#include <algorithm>
#include <numeric>

#include "gas/error.hpp"
#include "limits.hpp"
#include "require.hpp"

namespace gas {
namespace {

/// Temperature of the gas that flows in at the rates (m_k [kg/s], H [W]), in balance with the walls: h A adds
/// to its heat capacity; work against its pressure is of second order in its mass. Empty if it is out of
/// range.
std::optional<double> balance_with_walls(const ControlVolumeModel& model, const Vector& rates) {
  const HeatLoss& walls = model.heat_loss;
  Mixture sum = model.thermo.mixture(std::span(rates).first(model.thermo.size()));
  sum.low[0] += walls.conductance;
  sum.high[0] += walls.conductance;
  return sum.find_temperature(rates.back() + walls.conductance * walls.outside_temperature,
                              walls.outside_temperature);
}

}  // namespace

double fill_first(System& system, const IntegratorOptions& options, Vector& y, double t, double b) {
  const Balance& balance = system.balance;
  const Boundary& boundary = balance.boundary();
  const Slots& s = boundary.slots();
  const Upstream<double> empty = balance.gas().upstream();
  // Ambient gas enters an empty volume at the speed of sound, so its flow is linear in time, as areas are.
  const auto set_backflow = [&](double factor, double at) {
    std::ranges::fill(y, 0.0);
    for (std::size_t j = 0; j < s.backflows; ++j) y[s.back(j)] = factor * boundary.back(j, empty, at);
  };
  const auto mass_until = [&](double end) {
    set_backflow(end - t, 0.5 * (t + end));
    return boundary.inflows().mass(t, end) + std::accumulate(y.begin(), y.end(), 0.0);
  };
  const double all = mass_until(b), fixed = options.fixed_step;
  if (!(all > 0.0)) return t;
  double length = fixed > 0.0 ? std::min(fixed, b - t) : b - t;
  while (fixed == 0.0 && length > 0.0 && mass_until(t + length) > options.relative_tolerance * all)
    length *= 0.5;
  const double end = length == b - t ? b : t + length;
  set_backflow(1.0, end);
  system.ledger.change(y, system.gas);
  boundary.inflows().add(
      1.0, [&](const InflowSegment& in) { return in.rate(end); }, system.gas);
  if (std::accumulate(system.gas.begin(), system.gas.end() - 1, 0.0) == 0.0) return t;
  const auto temperature = balance_with_walls(boundary.model(), system.gas);
  if (!temperature) {
    const double at = boundary.segment().begin + t;
    throw DomainError(range_text(boundary.model()) + "at t = " + to_short_text(at) +
                          " s, where its first gas is in balance with the walls",
                      at);
  }
  set_backflow(end - t, 0.5 * (t + end));
  system.ledger.gas_at(y, end, system.gas);
  const Mixture mixture = boundary.model().thermo.mixture(std::span(system.gas).first(s.species));
  y[s.heat()] = system.gas.back() - mixture.internal_energy(*temperature) -
                work_at(boundary.model(), mixture, *temperature);
  system.ledger.accept(y, end);
  ++system.effort.accepted;
  return end;
}

}  // namespace gas
