// SPDX-License-Identifier: Apache-2.0
#include "start.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "enclosure/enclose.hpp"

namespace enclosure {
namespace {

std::size_t stream_count(const Scene& s) {
  const auto back =
      std::count_if(s.holes.begin(), s.holes.end(), [](const Hole& hole) { return hole.backflow; });
  return s.inflators.size() + s.holes.size() + s.fabrics.size() + static_cast<std::size_t>(back);
}

Ball mean_gas_constant(const Tank& tank, const Balls& shares) {
  Ball r;
  for (std::size_t k = 0; k < tank.species(); ++k) r = r + shares[k] * tank.gas_constants[k];
  return r;
}

constexpr slong terms = 16;  // of polynomials in time

/// One of the streams that fill an evacuated tank, as polynomials in the time since their begin.
struct Inlet {
  std::size_t stream;  // number among the totals
  const std::vector<double>* fractions;
  Balls flow, enthalpy;  // [kg/s], [J/kg]
};

/// Flow of ambient gas into what is next to a vacuum [kg/(s m2)], (G.6) with (G.22): choked, and the laminar
/// factor next to 1 for all pressures at which it is.
Ball choked_backflow(const Tank& tank) {
  const Scene& s = tank.scene;
  const Ball one(1.0), pa(s.ambient_pressure), &g = tank.ambient.gamma;
  const Ball density = pa / (tank.ambient.gas_constant * Ball(s.ambient_temperature));
  const Ball drop = one - exp(g / (g - one) * log(Ball(2.0) / (g + one)));  // (p_a - p)/p_a, at least
  const Ball ratio = Ball(s.laminar_share) / hull(drop, one);
  const Ball factor = exp(Ball(-0.75) * log(one + ratio * ratio));
  Ball root;
  arb_sqrt(root.get(), (g * pa * density).get(), bits);
  return root * exp((g + one) / (g - one) * log(Ball(2.0) / (g + one)) * Ball(0.5)) * factor;
}

Balls polynomial_of(const Piecewise& f, const Ball& at) {
  Balls c(terms);
  f.series({at, at}, Mode::series, c.front().get(), terms);
  return c;
}

bool is_zero(const Balls& c) {
  return std::all_of(c.begin(), c.end(), [](const Ball& x) { return arb_is_zero(x.get()); });
}

std::vector<Inlet> inlets_at(const Tank& tank, const Ball& at) {
  const Scene& s = tank.scene;
  std::vector<Inlet> all;
  const auto add = [&](std::size_t stream, const std::vector<double>& fractions, Balls flow, Balls enthalpy) {
    if (!is_zero(flow)) all.push_back({stream, &fractions, std::move(flow), std::move(enthalpy)});
  };
  for (std::size_t i = 0; i < s.inflators.size(); ++i)
    add(i, s.inflators[i].mass_fractions, polynomial_of(tank.inflows[i].flow, at),
        polynomial_of(tank.inflows[i].enthalpy, at));
  std::size_t stream = s.inflators.size() + s.holes.size() + s.fabrics.size();
  for (std::size_t i = 0; i < s.holes.size(); ++i) {
    if (!s.holes[i].backflow) continue;
    const auto& curve = s.holes[i].area_of_overpressure;
    if (curve && curve->front().at < 0.0)
      throw Refusal(
          "an evacuated start with backflow through an area that opens below ambient pressure is not "
          "enclosed");
    Balls flow = polynomial_of(tank.areas[i], at);
    const Ball factor = choked_backflow(tank) * Ball(s.holes[i].discharge_coefficient) *
                        Ball(curve ? curve->front().value : 1.0);
    for (Ball& c : flow) c = c * factor;
    add(stream++, s.ambient_fractions, std::move(flow), {tank.ambient.enthalpy});
  }
  return all;
}

/// Times at which a function of time changes, from 0 on, in order.
Balls changes(const Tank& tank) {
  Balls times = tank.breaks();
  times.insert(times.begin(), Ball(0.0));
  std::erase_if(times, [](const Ball& t) { return upper(t).is_negative(); });
  std::sort(times.begin(), times.end(), [](const Ball& a, const Ball& b) { return a.middle() < b.middle(); });
  return times;
}

/// What flows into an evacuated tank from `begin` on, until `length` later.
class Filling {
 public:
  Filling(const Tank& tank, const Ball& begin, const Ball& length)
      : tank_(tank),
        begin_(begin),
        length_(length),
        all_(hull(Ball(0.0), length)),
        inlets_(inlets_at(tank, begin)) {
    for (const Inlet& inlet : inlets_)
      if (!arb_is_zero(inlet.flow[0].get())) power_ = 0;
    const Span span{begin, exact_sum(begin, length)};
    Balls v(2);
    tank.scene.wave ? wave_series(*tank.scene.wave, span, v.front().get(), 2)
                    : tank.volumes[0].series(span, Mode::series, v.front().get(), 2);
    volume_ = v[0];
    growth_ = v[1];
  }

  /// None if it cannot be proved.
  std::optional<Start> start() const;
  /// [s] until the walls' losses lag: h A length = 25 m cv or so; 0: they do not depend on it.
  double lag() const {
    if (power_ == 0 || !(tank_.scene.wall_conductance > 0.0)) return 0.0;
    return tank_.scene.wall_conductance / (25.0 * slope_of_energy(hottest() / 10.0).middle());
  }

 private:
  double hottest() const { return std::min(tank_.maximum_temperature, 20000.0); }
  /// w/t^q over the span.
  Ball flow(const Inlet& inlet) const {
    return polynomial(Balls(inlet.flow.begin() + power_, inlet.flow.end()), all_);
  }
  Ball slope_of_energy(double t) const;
  Ball heating(double t, bool high) const;
  Ball loss(double t) const;
  bool has_sign(double t, bool cools) const;
  std::optional<Ball> temperature() const;

  const Tank& tank_;
  Ball begin_, length_, all_, volume_, growth_;
  std::vector<Inlet> inlets_;
  long power_ = 1;  // q: the flow begins as t^q
};

/// sum w_i cv_i/t^q.
Ball Filling::slope_of_energy(double t) const {
  Ball sum;
  for (const Inlet& inlet : inlets_) {
    const Balls u = tank_.internal_energy(*inlet.fractions, t > joint_temperature && !tank_.constant_cp);
    for (std::size_t j = 1; j < u.size(); ++j)
      sum = sum +
            flow(inlet) * u[j] * Ball(static_cast<double>(j)) * Ball(std::pow(t, static_cast<double>(j - 1)));
  }
  return sum;
}

/// (sum w_i (h_i - u_i(T)) - p V')/t^q over the span, p with any temperature up to the hottest.
Ball Filling::heating(double t, bool high) const {
  Ball sum, mass;
  for (const Inlet& inlet : inlets_) {
    sum = sum + flow(inlet) * (polynomial(inlet.enthalpy, all_) -
                               polynomial(tank_.internal_energy(*inlet.fractions, high), Ball(t)));
    mass = mass + hull(Ball(0.0), flow(inlet)) * mean_gas_constant(tank_, shares_of(*inlet.fractions));
  }
  return sum - all_ * mass * hull(Ball(0.0), Ball(hottest())) * growth_ / volume_;
}

/// h A (T - T_ext)/t^q at the end of the span, where it is smallest.
Ball Filling::loss(double t) const {
  const Ball loss = Ball(tank_.scene.wall_conductance) * (Ball(t) - Ball(tank_.scene.outside_temperature));
  return power_ == 0 ? loss : loss / length_;
}

/// True if gas at T, or beyond it, cools (or warms) at each time of the span: the sum falls as T rises, in
/// each range of cp.
bool Filling::has_sign(double t, bool cools) const {
  const auto holds = [&](const Ball& rate) { return cools ? rate.is_negative() : rate.is_positive(); };
  const bool high = !tank_.constant_cp && t > joint_temperature;
  const bool outside = cools ? t < tank_.scene.outside_temperature : t > tank_.scene.outside_temperature;
  if (power_ == 1 && tank_.scene.wall_conductance > 0.0 && outside) return false;
  if (!holds(heating(t, high) - loss(t))) return false;
  if (tank_.constant_cp || high == cools) return true;
  return holds(heating(joint_temperature, !high) - loss(joint_temperature));
}

/// Between a temperature at which the gas cools throughout and one at which it warms; of the same range.
std::optional<Ball> Filling::temperature() const {
  double low = std::max(tank_.minimum_temperature, 1.0), high = hottest();
  for (int i = 0; i < 100; ++i) {
    const double t = 0.5 * (low + high);
    ((heating(t, !tank_.constant_cp && t > joint_temperature) - loss(t)).middle() > 0.0 ? low : high) = t;
  }
  const double t = 0.5 * (low + high);
  for (double reach = 1e-14 * t; reach < 0.5 * t; reach *= 2.0) {
    if (!has_sign(t + reach, true) || !has_sign(t - reach, false)) continue;
    if (!tank_.constant_cp && (t + reach > joint_temperature) != (t - reach > joint_temperature)) return {};
    return hull(Ball(t - reach), Ball(t + reach));
  }
  return {};
}

std::optional<Start> Filling::start() const {
  Start start{exact_sum(begin_, length_), {}, begin_};
  Balls masses(tank_.species()), streams(stream_count(tank_.scene));
  Ball mass, product;
  for (const Inlet& inlet : inlets_) {
    Balls integral{Ball(0.0)};
    for (std::size_t k = 0; k < inlet.flow.size(); ++k)
      integral.push_back(inlet.flow[k] / Ball(static_cast<double>(k + 1)));
    const Ball total = polynomial(integral, length_);
    streams[inlet.stream] = total;
    mass = mass + total;
    const Balls y = shares_of(*inlet.fractions);
    for (std::size_t k = 0; k < tank_.species(); ++k) {
      const Ball part = total * y[k];
      masses[k] = masses[k] + part;
      product = product + part * tank_.gas_constants[k];
    }
  }
  const std::optional<Ball> t = temperature();
  if (!mass.is_positive() || !t) return {};
  for (const Surface& surface : tank_.surfaces) {  // levels rise
    if (surface.kind != Surface::Kind::level) continue;
    const Ball limit = Ball(tank_.scene.ambient_pressure) + surface.offset;
    if (!(limit * volume_ - product * *t).is_positive()) return {};
  }
  start.unknowns = {mass, *t};
  for (std::size_t k = 0; k + 1 < tank_.species(); ++k) start.unknowns.push_back(masses[k] / mass);
  start.unknowns.insert(start.unknowns.end(), streams.begin(), streams.end());
  return start;
}

}  // namespace

/// While the tank holds next to nothing, nothing leaves and backflow is choked (p far below p_a), so the
/// masses are integrals of polynomials. With them t m^ cv T' = (what `heating` and `loss` enclose), m^ =
/// m/t^(q+1) > 0. If that is negative for T above T_1 and positive below T_0 throughout, T lies between:
/// beyond them it would, going back in time, run away as log t, and leave the range of temperatures.
static Start evacuated(const Tank& tank) {
  if (tank.scene.ambient_pressure <= 0.0) throw Refusal("an evacuated start into a vacuum is not enclosed");
  const Balls times = changes(tank);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Ball begin = upper(times[i]);
    if (inlets_at(tank, begin).empty()) continue;
    double span = 1.0;
    for (const Ball& t : times)
      if ((t - begin).is_positive()) span = std::min(span, lower(t - begin).middle());
    Ball length(std::ldexp(1.0, std::ilogb(span) - 26));
    const double lag = Filling(tank, begin, length).lag();
    if (lag > length.middle()) length = Ball(std::ldexp(1.0, std::ilogb(std::min(lag, 0.25 * span))));
    for (int tries = 0; tries < 8; ++tries, length = length * Ball(0x1p-4))
      if (const auto start = Filling(tank, begin, length).start()) return *start;
    throw Refusal(
        "what first flows into the evacuated tank cannot be enclosed: it fills at once, or near 1000 K");
  }
  throw Refusal("the tank is evacuated and nothing ever flows in");
}

Start start_of(const Tank& tank) {
  const Scene& s = tank.scene;
  if (s.initial_pressure == 0.0) return evacuated(tank);
  const Balls shares = shares_of(s.initial_fractions);
  Ball volume;
  const Span zero{Ball(0.0), Ball(0.0)};
  s.wave ? wave_series(*s.wave, zero, volume.get(), 1)
         : tank.volumes[0].series(zero, Mode::series, volume.get(), 1);
  const Ball temperature(s.initial_temperature);
  Start start;
  start.empty_until = Ball(-1.0);
  start.unknowns = {Ball(s.initial_pressure) * volume / (mean_gas_constant(tank, shares) * temperature),
                    temperature};
  for (std::size_t k = 0; k + 1 < tank.species(); ++k) start.unknowns.push_back(shares[k]);
  start.unknowns.resize(start.unknowns.size() + stream_count(s));
  return start;
}

}  // namespace enclosure
