// SPDX-License-Identifier: Apache-2.0
#include "law.hpp"

#include <memory>

namespace enclosure {

/// The gas inside.
struct Law::Gas {
  Term mass, temperature;        // [kg], [K]
  std::vector<Term> fractions;   // [-] of all species
  Term gas_constant, cp, gamma;  // [J/(kg K)], [J/(kg K)], [-]
  Term pressure, overpressure;   // [Pa]
  Term density, space, growth;   // [kg/m3], V [m3], dV/dt [m3/s]
  Term energy;                   // [J/kg]
  bool high;                     // above 1000 K
};

bool Law::above(const Regime& regime, double offset) const {
  for (std::size_t i = 0; i < regime.size(); ++i)
    if (tank_.surfaces[i].kind == Surface::Kind::level && tank_.surfaces[i].offset.middle() == offset)
      return regime[i];
  return true;  // into a vacuum
}

Term Law::total(const std::vector<Term>& terms) {
  if (terms.empty()) return tape_.constant(Ball(0.0));
  Term sum = terms.front();
  for (std::size_t i = 1; i < terms.size(); ++i) sum = sum + terms[i];
  return sum;
}

Term Law::horner(const Balls& c, Term x) {
  Term value = tape_.constant(c.back());
  for (std::size_t j = c.size() - 1; j-- > 0;)
    value = j + 2 == c.size() ? x * c[j + 1] + c[j] : value * x + c[j];
  return value;
}

/// The linear piece of a curve over the overpressure that the regime selects.
Term Law::curve(const Curve& curve, Term y, const Regime& regime) {
  std::size_t below = 0;
  while (below < curve.size() && above(regime, curve[below].at)) ++below;
  if (below == 0) return tape_.constant(Ball(curve.front().value));
  if (below == curve.size()) return tape_.constant(Ball(curve.back().value));
  const Knot &a = curve[below - 1], &b = curve[below];
  return (y - Ball(a.at)) * ((Ball(b.value) - Ball(a.value)) / (Ball(b.at) - Ball(a.at))) + Ball(a.value);
}

/// (G.22) with the overpressure y > 0, as s^(3/2), s = y/sqrt(y^2 + d^2) = 1/sqrt(1 + (d/y)^2). The last form
/// has y but once: beyond the laminar range it is next to constant over a box, where the others are wide.
Term Law::laminar(Term y) {
  const Ball d = Ball(tank_.scene.laminar_share) * Ball(tank_.scene.ambient_pressure), one(1.0);
  if (arb_is_zero(d.get())) return tape_.constant(one);
  const Term ratio = wide_ ? y : d / y;
  const Term s = wide_ ? y / sqrt(y * y + d * d) : one / sqrt(ratio * ratio + one);
  return s * sqrt(s);
}

/// (G.6) of unit area [kg/(s m2)]: choked sqrt(gamma p rho) (2/(gamma+1))^((gamma+1)/(2 (gamma-1))), else
/// sqrt(2 p rho gamma/(gamma-1) r^(2/gamma) (1 - r^((gamma-1)/gamma))), r = outside/p.
Term Law::hole_flux(Term p, Term density, Term gamma, Term outside, bool choked) {
  const Ball one(1.0), two(2.0);
  if (choked)
    return sqrt(gamma * (p * density)) *
           exp((gamma + one) / (gamma - one) * log(two / (gamma + one)) * Ball(0.5));
  const Term ratio = log(outside / p);
  const Term drop = one - exp((gamma - one) / gamma * ratio);
  return sqrt(p * density * (gamma / (gamma - one)) * two * exp(ratio * two / gamma) * drop);
}

Law::Gas Law::gas(const Regime& regime) {
  const Scene& s = tank_.scene;
  const std::size_t n = tank_.species();
  const Ball joint(joint_temperature);
  const Surface *low = nullptr, *top = nullptr;
  bool high = !tank_.constant_cp;
  for (std::size_t i = 0; i < regime.size(); ++i) {
    const Surface& surface = tank_.surfaces[i];
    if (surface.kind == Surface::Kind::joint || surface.kind == Surface::Kind::joint_energy)
      high = high && regime[i];
    if (surface.kind != Surface::Kind::level) continue;
    if (regime[i]) low = &surface;
    if (!regime[i] && !top) top = &surface;
  }
  const Term mass = tape_.state(0), free_pressure = tape_.state(1);
  std::vector<Term> fractions;
  for (std::size_t k = 0; k + 1 < n; ++k) fractions.push_back(tape_.state(static_cast<int>(k) + 2));
  fractions.push_back(n == 1 ? tape_.constant(Ball(1.0)) : Ball(1.0) - total(fractions));
  const auto mixture = [&](std::size_t power) {  // of cp; power 0: of R
    std::vector<Term> terms;
    for (std::size_t k = 0; k < n; ++k) {
      const auto& a = high ? s.species[k].high : s.species[k].low;
      const Ball c = power == 0 ? tank_.gas_constants[k] : tank_.gas_constants[k] * Ball(a[power - 1]);
      terms.push_back(n == 1 ? tape_.constant(c) : fractions[k] * c);
    }
    return total(terms);
  };
  const auto volume_series = [this](slong order) -> TimeSeries {  // V or, with order 1, dV/dt
    return [this, order](const Span& span, Mode mode, arb_ptr c, slong count) {
      const arb_ptr v = _arb_vec_init(count + order);
      tank_.scene.wave ? wave_series(*tank_.scene.wave, span, v, count + order)
                       : tank_.volumes[0].series(span, mode, v, count + order);
      for (slong k = 0; k < count; ++k)
        arb_mul_ui(c + k, v + k + order, order ? static_cast<ulong>(k) + 1 : 1, bits);
      _arb_vec_clear(v, count + order);
    };
  };
  const Term space = tape_.time(volume_series(0)), growth = tape_.time(volume_series(1));
  const Term r = mixture(0), free_temperature = free_pressure * space / (mass * r);
  const Term temperature =
      tank_.constant_cp ? free_temperature
                        : tape_.within(free_temperature, high ? &joint : nullptr, high ? nullptr : &joint);
  const auto energy_per_kg = [&](bool upper_range, Term t) {
    std::vector<Term> terms;
    for (std::size_t k = 0; k < n; ++k) {
      std::vector<double> pure(n, 0.0);
      pure[k] = 1.0;
      terms.push_back(fractions[k] * horner(tank_.internal_energy(pure, upper_range), t));
    }
    return total(terms);
  };
  const Term u = energy_per_kg(high, temperature);
  Term cp = mixture(tank_.constant_cp ? 1 : 5);
  if (!tank_.constant_cp)
    for (std::size_t power = 4; power > 0; --power) cp = cp * temperature + mixture(power);
  volume = space.id;
  const Term y = tape_.within(free_pressure - Ball(s.ambient_pressure), low ? &low->offset : nullptr,
                              top ? &top->offset : nullptr);
  const Term p = y + Ball(s.ambient_pressure), gamma = cp / (cp - r);
  for (const Surface& surface : tank_.surfaces) {
    if (surface.kind == Surface::Kind::level)
      surfaces.push_back((free_pressure - (Ball(s.ambient_pressure) + surface.offset)).id);
    if (surface.kind == Surface::Kind::joint) surfaces.push_back((free_temperature - joint).id);
    if (surface.kind == Surface::Kind::joint_energy)
      surfaces.push_back(
          (energy_per_kg(high, free_temperature) - energy_per_kg(false, tape_.constant(joint))).id);
    if (surface.kind == Surface::Kind::sonic) {
      const Ball one(1.0);
      const Term ratio = exp(gamma / (gamma - one) * log(Ball(2.0) / (gamma + one)));
      surfaces.push_back((free_pressure * ratio - Ball(s.ambient_pressure)).id);
    }
  }
  return {mass, temperature, fractions, r, cp, gamma, p, y, mass / space, space, growth, u, high};
}

void Law::flows(const Gas& g, const Regime& regime) {
  const Scene& s = tank_.scene;
  const auto time = [&](const Piecewise& f) {
    return tape_.time([&f](const Span& span, Mode mode, arb_ptr c, slong n) { f.series(span, mode, c, n); });
  };
  for (const InflowFunctions& inflow : tank_.inflows) {
    in_.push_back(tape_.time([&f = inflow.flow](const Span& span, Mode mode, arb_ptr c, slong n) {
      if (mode == Mode::across_mean)
        arb_set(c, f.mean(span).get());
      else
        f.series(span, mode, c, n);
    }));
    enthalpy_in_.push_back(time(inflow.enthalpy));
  }
  bool choked = s.ambient_pressure == 0.0;
  for (std::size_t i = 0; i < regime.size(); ++i)
    if (tank_.surfaces[i].kind == Surface::Kind::sonic) choked = regime[i];
  const bool leaves = above(regime, 0.0);
  const Ball pa(s.ambient_pressure);
  const Term none = tape_.constant(Ball(0.0)), outside = tape_.constant(pa);
  const Term factor = laminar(leaves ? g.overpressure : Ball(0.0) - g.overpressure);
  Term out = none, back = none;
  if (leaves && !s.holes.empty()) out = hole_flux(g.pressure, g.density, g.gamma, outside, choked) * factor;
  if (!leaves && tank_.has_backflow) {
    const AmbientGas& a = tank_.ambient;
    const Term gamma = tape_.constant(a.gamma);
    const Ball ratio =
        exp(a.gamma / (a.gamma - Ball(1.0)) * log(Ball(2.0) / (a.gamma + Ball(1.0)))) - Ball(1.0);
    const bool sonic = !above(regime, (pa * ratio).middle());
    const Term density = tape_.constant(pa / (a.gas_constant * Ball(s.ambient_temperature)));
    back = hole_flux(outside, density, gamma, g.pressure, sonic) * factor;
  }
  for (std::size_t i = 0; i < s.holes.size(); ++i) {
    Term area = time(tank_.areas[i]) * Ball(s.holes[i].discharge_coefficient);
    if (s.holes[i].area_of_overpressure)
      area = area * curve(*s.holes[i].area_of_overpressure, g.overpressure, regime);
    out_.push_back(leaves ? area * out : none);
    back_.push_back(!leaves && s.holes[i].backflow ? area * back : none);
  }
  for (std::size_t i = 0; i < s.fabrics.size(); ++i) {
    const Fabric& fabric = s.fabrics[i];
    const Term area = time(tank_.shares[i]) * Ball(fabric.coefficient);
    if (!leaves)
      out_.push_back(none);
    else if (fabric.velocity)
      out_.push_back(g.density * curve(*fabric.velocity, g.overpressure, regime) * area);
    else
      out_.push_back(sqrt(g.density * g.overpressure * Ball(2.0)) * factor * area);
  }
}

void Law::balances(const Gas& g) {
  const Scene& s = tank_.scene;
  const Term in = total(in_), out = total(out_), back = total(back_);
  Term heat = tape_.constant(Ball(0.0)), stored = heat, constants = heat;  // of what flows in
  std::vector<Term> shares(tank_.species() - 1, heat);
  const auto enters = [&](Term flow, Term enthalpy, const std::vector<double>& fractions) {
    const Term u = horner(tank_.internal_energy(fractions, g.high), g.temperature);
    heat = heat + flow * (enthalpy - u);
    stored = stored + flow * enthalpy;
    const Balls y = shares_of(fractions);
    Ball r;
    for (std::size_t k = 0; k < tank_.species(); ++k) r = r + y[k] * tank_.gas_constants[k];
    for (std::size_t k = 0; k + 1 < tank_.species(); ++k)
      shares[k] = shares[k] + flow * (y[k] - g.fractions[k]);
    constants = constants + flow * r;
  };
  for (std::size_t i = 0; i < in_.size(); ++i) enters(in_[i], enthalpy_in_[i], s.inflators[i].mass_fractions);
  if (tank_.has_backflow) enters(back, tape_.constant(tank_.ambient.enthalpy), s.ambient_fractions);
  const Term rt = g.gas_constant * g.temperature, work = g.pressure * g.growth;
  Term other = work;
  if (s.wall_conductance > 0.0)
    other = other + (g.temperature - Ball(s.outside_temperature)) * Ball(s.wall_conductance);
  rates.push_back((in + back - out).id);
  const Term lost = out * rt, share = g.gas_constant / (g.cp - g.gas_constant);
  rates.push_back(((constants * g.temperature - lost - work + share * (heat - lost - other)) / g.space).id);
  for (const Term& change : shares) rates.push_back((change / g.mass).id);
  for (const Term& flow : in_) streams.push_back(flow.id);
  for (const Term& flow : out_) streams.push_back(flow.id);
  for (std::size_t i = 0; i < back_.size(); ++i)
    if (s.holes[i].backflow) streams.push_back(back_[i].id);
  energy_rate = (stored - out * (g.energy + rt) - other).id;
}

std::vector<int> Law::outputs() const {
  std::vector<int> all = streams;
  all.insert(all.end(), surfaces.begin(), surfaces.end());
  all.push_back(volume);
  if (wide_) all.push_back(energy_rate);
  return all;
}

Law::Law(const Tank& tank, const Regime& regime, bool wide) : tank_(tank), wide_(wide) {
  const Gas inside = gas(regime);
  flows(inside, regime);
  balances(inside);
}

}  // namespace enclosure
