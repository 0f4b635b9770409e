// SPDX-License-Identifier: Apache-2.0
// Rest at ambient pressure.
#include <cmath>

#include "work.hpp"

namespace enclosure {

/// False if until `end` nothing flows in by inflators, the walls take no heat and the volume is still.
bool Walk::is_fed(const Ball& end) const {
  const Span span{time_, end};
  const Scene& s = tank_.scene;
  if (s.wall_conductance > 0.0 || s.wave) return true;
  const arb_ptr c = _arb_vec_init(2);
  tank_.volumes[0].series(span, Mode::series, c, 2);
  bool fed = !arb_is_zero(c + 1);
  for (const InflowFunctions& inflow : tank_.inflows) {
    inflow.flow.series(span, Mode::series, c, 2);
    fed = fed || !arb_is_zero(c) || !arb_is_zero(c + 1);
  }
  _arb_vec_clear(c, 2);
  return fed;
}

/// Core of `box`, p < p_a in part of it, once backflow has lifted the pressure to p_a. Of a mass dm that
/// flows in
///   m dY_k = (Y_ak - Y_k) dm,  m cv dT = (h_a - u_a(T)) dm,  V dp = (R_a T + R/cv (h_a - u_a(T))) dm,
/// so that with a positive factor of the last the pressure rises, and the mass that it takes is bounded.
/// `inflow` encloses that. If the end is within what was assumed for the factors, it holds (Peano's theorem,
/// as in `crossing`, with the mass for time). None: not proved.
std::optional<Balls> Walk::lifted(const Balls& box, bool high, Ball& inflow) {
  const Span now{time_, time_};
  Balls begin = core(box), energy = tank_.internal_energy(tank_.scene.ambient_fractions, high);
  begin[1] = temperature();
  Balls guess = begin;
  for (std::size_t i = 0; i < guess.size(); ++i)
    guess[i] = wider(guess[i], 0.01 * (i < 2 ? guess[i].middle() : 1.0));
  const Ball &m = guess[0], &t = guess[1];
  Ball last(1.0), r, cv;
  for (std::size_t k = 0; k < tank_.species(); ++k) {
    std::vector<double> pure(tank_.species(), 0.0);
    pure[k] = 1.0;
    const Ball y = k + 1 < tank_.species() ? guess[k + 2] : last;
    last = last - y;
    r = r + y * tank_.gas_constants[k];
    Balls slope;
    const Balls u = tank_.internal_energy(pure, high);
    for (std::size_t j = 1; j < u.size(); ++j) slope.push_back(u[j] * Ball(static_cast<double>(j)));
    cv = cv + y * polynomial(slope, t);
  }
  const Ball heat = tank_.ambient.enthalpy - polynomial(energy, t);
  const Ball rise = tank_.ambient.gas_constant * t + r / cv * heat;
  const Ball outside(tank_.scene.ambient_pressure), lack = outside - lower(box[1]);
  const Ball above = t - Ball(joint_temperature);
  if (!tank_.constant_cp && !(high ? above : Ball(0.0) - above).is_positive()) return {};
  if (!rise.is_positive() || !cv.is_positive()) return {};
  inflow = hull(Ball(0.0), volume(now) * lack / rise);
  Balls end = begin;
  end[0] = end[0] + inflow;
  end[1] = end[1] + inflow * heat / (m * cv);
  for (std::size_t k = 0; k + 1 < tank_.species(); ++k)
    end[k + 2] = end[k + 2] + inflow * (shares_of(tank_.scene.ambient_fractions)[k] - guess[k + 2]) / m;
  for (std::size_t i = 0; i < end.size(); ++i)
    if (!guess[i].contains(end[i])) return {};
  end[1] = hull(box[1], outside);
  return end;
}

/// Rest at ambient pressure. If nothing else feeds the gas, it leaves while p > p_a, which lowers p, and
/// never passes p_a. On the way its state follows d ln m = d ln p/gamma, d ln T = (1 - 1/gamma) d ln p, gamma
/// > 1 (the isentrope, whatever the law of the flow): with q = p_a/p <= 1 at the begin, mass and temperature
/// stay within [q, 1] of theirs. From p < p_a backflow lifts it, if there is any. (At 1000 K T may jump.)
bool Walk::rest(const Sides& now, const Ball& end) {
  bool high = !tank_.constant_cp;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (tank_.surfaces[i].kind < Surface::Kind::joint) continue;
    if (now[i] == 0) return false;
    high = high && now[i] > 0;
  }
  if (is_fed(end) || tank_.scene.ambient_pressure == 0.0) return false;
  const Ball q = Ball(tank_.scene.ambient_pressure) / set_.box()[1], left = hull(Ball(0.0), Ball(1.0) - q);
  if (!(q.radius() <= 1e3 * tolerance_)) return false;
  Balls box = set_.box();
  const Ball mass = box[0];
  Ball inflow;
  const std::optional<Balls> below = tank_.has_backflow ? lifted(box, high, inflow) : core(box);
  if (!below) return false;
  box[0] = mass * q;
  box[1] = box[1] * q;
  for (std::size_t i = 0; i < unknowns_; ++i) box[i] = hull(box[i], (*below)[i]);
  // The gas stays in one range of its law.
  const Ball above = box[1] / pressure_of_kelvin(box, {time_, time_}) - Ball(joint_temperature);
  if (!tank_.constant_cp && !(high ? above : Ball(0.0) - above).is_positive()) return false;
  const std::size_t in = tank_.inflows.size(), out = tank_.scene.holes.size() + tank_.scene.fabrics.size();
  for (std::size_t j = in; j < streams_; ++j)
    box[unknowns_ + j] = box[unknowns_ + j] + (j < in + out ? mass * left : inflow);
  set_ = MovingSet(box);
  time_ = end;
  ++crossings;
  return true;
}

}  // namespace enclosure
