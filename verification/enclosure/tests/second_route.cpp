// SPDX-License-Identifier: Apache-2.0
#include "second_route.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace test {
namespace {

using enclosure::Curve;
using enclosure::Scene;
using Reals = std::vector<Real>;

/// Value at x of the piece that holds at `inside`; before and after all knots the nearest one.
Real at(const Curve& curve, Real x, Real inside) {
  if (inside <= curve.front().at) return curve.front().value;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const Real a = curve[i - 1].at, b = curve[i].at;
    if (inside < b)
      return curve[i - 1].value + (Real(curve[i].value) - curve[i - 1].value) * ((x - a) / (b - a));
  }
  return curve.back().value;
}

struct Gas {
  Real mass = 0, r = 0, cp = 0, temperature = 0, pressure = 0, volume = 0;
};

class Tank {
 public:
  explicit Tank(const Scene& scene) : s(scene) {
    for (const auto& species : s.species) r.push_back(8.31446261815324L / species.molar_mass);
  }

  std::size_t size() const { return s.species.size() + 1 + streams(); }
  std::size_t streams() const {
    std::size_t n = s.inflators.size() + s.holes.size() + s.fabrics.size();
    for (const auto& hole : s.holes) n += hole.backflow;
    return n;
  }

  Real enthalpy(std::size_t k, Real t) const {
    const auto& a = t > 1000 ? s.species[k].high : s.species[k].low;
    return r[k] * (a[5] + t * (a[0] + t * (a[1] / 2.0L +
                                           t * (a[2] / 3.0L + t * (a[3] / 4.0L + t * (a[4] / 5.0L))))));
  }
  Real heat_capacity(std::size_t k, Real t) const {
    const auto& a = t > 1000 ? s.species[k].high : s.species[k].low;
    return r[k] * (a[0] + t * (a[1] + t * (a[2] + t * (a[3] + t * a[4]))));
  }

  Real volume(Real t, Real inside) const {
    if (!s.wave) return at(s.volume, t, inside);
    return s.wave->mean +
           s.wave->amplitude * std::sin(2 * std::acos(-1.0L) * s.wave->frequency * t + s.wave->phase);
  }
  Real growth(Real t, Real inside) const {
    if (s.wave) {
      const Real w = 2 * std::acos(-1.0L) * s.wave->frequency;
      return s.wave->amplitude * w * std::cos(w * t + s.wave->phase);
    }
    return at(s.volume, inside + 1.0L, inside) - at(s.volume, inside, inside);
  }

  /// Newton's method for sum m_k u_k(T) = U, from the temperature found last.
  Gas gas(const Reals& y, Real t, Real inside) const {
    Gas g;
    const std::size_t n = r.size();
    for (std::size_t k = 0; k < n; ++k) {
      g.mass += y[k];
      g.r += y[k] * r[k];
    }
    Real x = last_;
    for (int i = 0; i < 50; ++i) {
      Real u = -y[n], cv = 0;
      for (std::size_t k = 0; k < n; ++k) {
        u += y[k] * (enthalpy(k, x) - r[k] * x);
        cv += y[k] * (heat_capacity(k, x) - r[k]);
      }
      x -= u / cv;
      if (std::abs(u / cv) < 1e-19L * x) break;
    }
    last_ = g.temperature = x;
    for (std::size_t k = 0; k < n; ++k) g.cp += y[k] * heat_capacity(k, x) / g.mass;
    g.volume = volume(t, inside);
    g.pressure = g.r * x / g.volume;
    g.r /= g.mass;
    return g;
  }

  /// (G.6) of unit area.
  static Real flux(Real p, Real density, Real gamma, Real outside) {
    const Real ratio = std::max(outside / p, std::pow(2 / (gamma + 1), gamma / (gamma - 1)));
    return std::sqrt(2 * p * density * gamma / (gamma - 1) * std::pow(ratio, 2 / gamma) *
                     -std::expm1((gamma - 1) / gamma * std::log(ratio)));
  }

  Reals rates(const Reals& y, Real t, Real inside) const {
    const std::size_t n = r.size();
    const Gas g = gas(y, t, inside);
    const Real pa = s.ambient_pressure, over = g.pressure - pa, density = g.mass / g.volume;
    const Real d = s.laminar_share * pa,
               part = d > 0 ? std::pow(std::abs(over) / std::hypot(over, d), 1.5L) : 1;
    Reals f(size());
    std::size_t j = n + 1;
    Real out = 0;
    for (const auto& inflator : s.inflators) {
      const Real since = t - inflator.start, mid = inside - inflator.start;
      const bool on = inflator.mass_flow.size() == 1
                          ? mid > 0 || inflator.start <= 0
                          : mid > inflator.mass_flow.front().at && mid < inflator.mass_flow.back().at;
      const Real w = on ? at(inflator.mass_flow, since, mid) : 0,
                 temperature = at(inflator.temperature, since, mid);
      f[j++] = w;
      for (std::size_t k = 0; k < n; ++k) {
        f[k] += w * inflator.mass_fractions[k];
        f[n] += w * inflator.mass_fractions[k] * enthalpy(k, temperature);
      }
    }
    const auto area = [&](const enclosure::Hole& hole) {
      return hole.discharge_coefficient * (hole.area_of_overpressure
                                               ? at(*hole.area_of_overpressure, over, over)
                                               : at(hole.area, t, inside));
    };
    for (const auto& hole : s.holes) {
      f[j] = over > 0 ? area(hole) * flux(g.pressure, density, g.cp / (g.cp - g.r), pa) * part : 0;
      out += f[j++];
    }
    for (const auto& fabric : s.fabrics) {
      const Real speed = fabric.velocity ? density * at(*fabric.velocity, over, over)
                                         : std::sqrt(2 * density * std::max(over, 0.0L)) * part;
      f[j] = over > 0 ? fabric.coefficient * speed : 0;
      out += f[j++];
    }
    for (const auto& hole : s.holes) {
      if (!hole.backflow) continue;
      Real ra = 0, cp = 0, h = 0;
      for (std::size_t k = 0; k < n; ++k) {
        ra += s.ambient_fractions[k] * r[k];
        cp += s.ambient_fractions[k] * heat_capacity(k, s.ambient_temperature);
        h += s.ambient_fractions[k] * enthalpy(k, s.ambient_temperature);
      }
      f[j] = over < 0
                 ? area(hole) * flux(pa, pa / (ra * s.ambient_temperature), cp / (cp - ra), g.pressure) * part
                 : 0;
      for (std::size_t k = 0; k < n; ++k) f[k] += f[j] * s.ambient_fractions[k];
      f[n] += f[j++] * h;
    }
    for (std::size_t k = 0; k < n; ++k) f[k] -= out * y[k] / g.mass;
    f[n] -= out * (y[n] / g.mass + g.r * g.temperature) + g.pressure * growth(t, inside) +
            s.wall_conductance * (g.temperature - s.outside_temperature);
    return f;
  }

  Reals start() const {
    Reals y(size());
    last_ = s.initial_temperature;
    Real sum = 0, rate = 0;
    for (std::size_t k = 0; k < r.size(); ++k) sum += s.initial_fractions[k];
    for (std::size_t k = 0; k < r.size(); ++k) rate += s.initial_fractions[k] / sum * r[k];
    const Real mass = s.initial_pressure * volume(0, 0) / (rate * s.initial_temperature);
    for (std::size_t k = 0; k < r.size(); ++k) {
      y[k] = mass * s.initial_fractions[k] / sum;
      y[r.size()] += y[k] * (enthalpy(k, s.initial_temperature) - r[k] * s.initial_temperature);
    }
    return y;
  }

  Reals knots() const {
    Reals all;
    const auto add = [&](const Curve& curve, double from) {
      for (const auto& knot : curve) all.push_back(Real(from) + knot.at);
    };
    for (const auto& inflator : s.inflators) {
      add(inflator.mass_flow, inflator.start);
      add(inflator.temperature, inflator.start);
      all.push_back(inflator.start);
    }
    for (const auto& hole : s.holes) add(hole.area, 0);
    add(s.volume, 0);
    return all;
  }

  const Scene& s;

 private:
  Reals r;
  mutable Real last_ = 300;
};

constexpr std::size_t levels = 9;  // order 18
/// Gragg's and Bulirsch's extrapolation of the midpoint rule (Hairer, Norsett and Wanner, "Solving Ordinary
/// Differential Equations I", 2nd ed., ch. II.9): y after h, and the change by the last level as the error.
Reals extrapolated(const Tank& tank, const Reals& y, Real t, Real h, Real inside, Reals& error) {
  std::vector<Reals> table;
  const Reals first = tank.rates(y, t, inside);
  for (std::size_t level = 0; level < levels; ++level) {
    const std::size_t n = 2 * (level + 1);
    const Real step = h / Real(n);
    Reals a = y, b = y;
    for (std::size_t i = 0; i < y.size(); ++i) b[i] += step * first[i];
    for (std::size_t k = 1; k <= n; ++k) {
      const Reals f = tank.rates(b, t + Real(k) * step, inside);
      if (k == n) {
        for (std::size_t i = 0; i < y.size(); ++i) a[i] = (a[i] + b[i] + step * f[i]) / 2;
        break;
      }
      for (std::size_t i = 0; i < y.size(); ++i) a[i] += 2 * step * f[i];
      std::swap(a, b);
    }
    table.push_back(a);
    for (std::size_t k = level; k-- > 0;) {
      const Real ratio = Real(n) / Real(2 * (k + 1)), weight = 1 / (ratio * ratio - 1);
      for (std::size_t i = 0; i < y.size(); ++i) {
        const Real next = table[k + 1][i], change = (next - table[k][i]) * weight;
        table[k][i] = next + change;
        if (level + 1 == levels && k == 0) error[i] = std::abs(change);
      }
    }
  }
  return table[0];
}

}  // namespace

std::vector<Real> solve(const Scene& scene, double time, Real tolerance) {
  const Tank tank(scene);
  const std::size_t n = scene.species.size();
  Reals y = tank.start(), stops = tank.knots();
  stops.push_back(time);
  std::sort(stops.begin(), stops.end());
  Real t = 0, last = time * 1e-3L;
  int tries = 0;
  for (const Real stop : stops) {
    while (t < stop && t < time) {
      if (++tries > 4000) return {};
      const Real h = std::min(last, stop - t), inside = (t + stop) / 2;
      Reals error(y.size());
      const Reals next = extrapolated(tank, y, t, h, inside, error);
      Real mass = 0, share = 0;
      for (std::size_t k = 0; k < n; ++k) mass += y[k];
      for (std::size_t i = 0; i < y.size(); ++i)
        share = std::max(share, error[i] / (i == n ? std::abs(y[n]) : mass));
      share /= tolerance;
      if (!(share < 1e30L)) share = 1e30L;
      const Real factor = 0.8L * std::pow(std::max(share, 1e-12L), -1.0L / Real(2 * levels - 1));
      const bool whole = h < last;
      if (share <= 1) {
        y = next;
        t = h < stop - t ? t + h : stop;
      }
      if (share > 1 || !whole) last = h * std::clamp(factor, 0.1L, 3.0L);
    }
  }
  const Gas g = tank.gas(y, t, t - time * 1e-15L);
  Reals columns{g.pressure, g.temperature, g.volume, g.mass};
  for (std::size_t i = 0; i < y.size(); ++i)
    if (i != n) columns.push_back(y[i]);
  return columns;
}

Tally expect_tubes_contain(unsigned first, unsigned last) {
  Tally tally;
  for (unsigned seed = first; seed <= last; ++seed) {
    const RandomScene random = random_scene(seed);
    const std::vector<Real> fine = solve(random.scene, random.end, 1e-16L),
                            coarse = solve(random.scene, random.end, 1e-15L);
    if (fine.empty() || coarse.empty()) {
      ++tally.stiff;
      continue;
    }
    enclosure::Tube tube;
    try {
      tube = enclosure::enclose(
          random.scene, {.times = {random.end}, .width = std::pow(10.0, -6.0 - seed % 4), .longest = 10.0});
    } catch (const enclosure::Refusal& refusal) {
      std::cout << "seed " << seed << ": " << refusal.what() << '\n';
      ++tally.refused;
      continue;
    }
    ++tally.compared;
    Real mass = fine[3], share = 1e-17L;
    for (std::size_t i = 3; i < fine.size(); ++i) mass = std::max(mass, fine[i]);
    const auto scale = [&](std::size_t i) { return i < 3 ? fine[i] : mass; };
    for (std::size_t i = 0; i < fine.size(); ++i)
      share = std::max(share, std::abs(fine[i] - coarse[i]) / scale(i));
    for (std::size_t i = 0; i < fine.size(); ++i) {
      const Real doubt = 10 * share * scale(i);
      const auto& b = tube.moments[0].bounds[i];
      EXPECT_GE(fine[i] + doubt, std::strtold(b.lower_text.c_str(), nullptr))
          << "seed " << seed << ' ' << tube.columns[i] << " doubt " << doubt;
      EXPECT_LE(fine[i] - doubt, std::strtold(b.upper_text.c_str(), nullptr))
          << "seed " << seed << ' ' << tube.columns[i] << " doubt " << doubt;
    }
  }
  return tally;
}

}  // namespace test
