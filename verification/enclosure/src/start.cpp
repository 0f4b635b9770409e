// SPDX-License-Identifier: Apache-2.0
#include "start.hpp"

#include <algorithm>

#include "enclosure/enclose.hpp"

namespace enclosure {
namespace {

std::size_t stream_count(const Scene& s) {
  const auto back =
      std::count_if(s.holes.begin(), s.holes.end(), [](const Hole& hole) { return hole.backflow; });
  return s.inflators.size() + s.holes.size() + s.fabrics.size() + static_cast<std::size_t>(back);
}

Ball mean_gas_constant(const Tank& tank, const std::vector<double>& fractions) {
  Ball r, sum;
  for (std::size_t k = 0; k < tank.species(); ++k) {
    r = r + Ball(fractions[k]) * tank.gas_constants[k];
    sum = sum + Ball(fractions[k]);
  }
  return r / sum;
}

/// First time of a piece of the inflows in which anything flows.
Ball first_flow(const Tank& tank) {
  Balls times = tank.breaks();
  times.insert(times.begin(), Ball(0.0));
  std::sort(times.begin(), times.end(), [](const Ball& a, const Ball& b) { return a.middle() < b.middle(); });
  for (const Ball& t : times)
    for (const InflowFunctions& inflow : tank.inflows) {
      Balls w(2);
      const Ball at = upper(t);
      arb_ptr c = _arb_vec_init(2);
      inflow.flow.series({at, at}, Mode::series, c, 2);
      const bool flows = !arb_is_zero(c) || !arb_is_zero(c + 1);
      _arb_vec_clear(c, 2);
      if (flows && !at.is_negative()) return at;
    }
  throw Refusal("the tank is evacuated and nothing ever flows in");
}

}  // namespace

/// While the tank holds next to nothing, nothing leaves (p < p_a) and U is what flowed in, so with adiabatic
/// walls T is the root of sum m_k u_k(T) = int sum w_i h_i dt, in which the integrals are those of
/// polynomials.
static Start evacuated(const Tank& tank) {
  const Scene& s = tank.scene;
  if (s.wall_conductance > 0.0)
    throw Refusal(
        "an evacuated start with heat loss is not enclosed: the temperature of its first gas is singular");
  if (s.ambient_pressure <= 0.0) throw Refusal("an evacuated start into a vacuum is not enclosed");
  if (tank.has_backflow) throw Refusal("an evacuated start with backflow is not enclosed");
  if (s.wave || s.volume.size() > 1)
    throw Refusal("an evacuated start of a volume that moves is not enclosed");
  if (!tank.constant_cp) throw Refusal("an evacuated start is enclosed with constant cp only");
  Start start;
  start.empty_until = first_flow(tank);
  const Ball length(0x1p-40);
  start.time = exact_sum(start.empty_until, length);
  Balls masses(tank.species()), streams(stream_count(s));
  Ball energy, heat;
  constexpr slong n = 16;
  const arb_ptr w = _arb_vec_init(n), h = _arb_vec_init(n), product = _arb_vec_init(n);
  const auto integral = [&](arb_srcptr c) {
    Ball sum;
    for (slong k = n; k-- > 0;) {
      Ball term;
      arb_div_si(term.get(), c + k, k + 1, bits);
      sum = sum * length + term;
    }
    return sum * length;
  };
  for (std::size_t i = 0; i < tank.inflows.size(); ++i) {
    const Span at{start.empty_until, start.empty_until};
    tank.inflows[i].flow.series(at, Mode::series, w, n);
    tank.inflows[i].enthalpy.series(at, Mode::series, h, n);
    for (slong k = 0; k < n; ++k) arb_dot(product + k, nullptr, 0, w, 1, h + k, -1, k + 1, bits);
    streams[i] = integral(w);
    energy = energy + integral(product);
    for (std::size_t k = 0; k < tank.species(); ++k)
      masses[k] = masses[k] + streams[i] * Ball(s.inflators[i].mass_fractions[k]);
  }
  _arb_vec_clear(w, n);
  _arb_vec_clear(h, n);
  _arb_vec_clear(product, n);
  Ball mass;
  for (std::size_t k = 0; k < tank.species(); ++k) {
    std::vector<double> pure(tank.species(), 0.0);
    pure[k] = 1.0;
    mass = mass + masses[k];
    heat = heat + masses[k] * tank.internal_energy(pure, false)[1];
  }
  if (!mass.is_positive()) throw Refusal("what first flows into the evacuated tank is too little to enclose");
  start.unknowns = {mass, energy / heat};
  Ball pressure, volume;
  for (std::size_t k = 0; k < tank.species(); ++k)
    pressure = pressure + masses[k] * tank.gas_constants[k] * start.unknowns[1];
  tank.volumes[0].series({start.time, start.time}, Mode::series, volume.get(), 1);
  bool simple = (Ball(s.ambient_pressure) * volume - pressure).is_positive();
  for (const Ball& t : tank.breaks())
    simple = simple && !((t - start.empty_until).is_positive() && (start.time - t).is_positive());
  if (!simple)
    throw Refusal(
        "what flows into the evacuated tank changes, or fills it, within a picosecond of its begin");
  for (std::size_t k = 0; k + 1 < tank.species(); ++k) start.unknowns.push_back(masses[k] / mass);
  start.unknowns.insert(start.unknowns.end(), streams.begin(), streams.end());
  return start;
}

Start start_of(const Tank& tank) {
  const Scene& s = tank.scene;
  if (s.initial_pressure == 0.0) return evacuated(tank);
  Ball sum;
  for (double y : s.initial_fractions) sum = sum + Ball(y);
  Ball volume;
  const Span zero{Ball(0.0), Ball(0.0)};
  s.wave ? wave_series(*s.wave, zero, volume.get(), 1)
         : tank.volumes[0].series(zero, Mode::series, volume.get(), 1);
  const Ball temperature(s.initial_temperature);
  Start start;
  start.empty_until = Ball(-1.0);
  start.unknowns = {
      Ball(s.initial_pressure) * volume / (mean_gas_constant(tank, s.initial_fractions) * temperature),
      temperature};
  for (std::size_t k = 0; k + 1 < tank.species(); ++k)
    start.unknowns.push_back(Ball(s.initial_fractions[k]) / sum);
  start.unknowns.resize(start.unknowns.size() + stream_count(s));
  return start;
}

}  // namespace enclosure
