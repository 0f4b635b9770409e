// SPDX-License-Identifier: Apache-2.0
// Steps across switches of the law, and across changes of functions of time at uncertain times.
#include <algorithm>
#include <array>
#include <cmath>

#include "work.hpp"

namespace enclosure {
namespace {

Balls derivative(const Balls& c) {
  Balls slope;
  for (std::size_t j = 1; j < c.size(); ++j) slope.push_back(c[j] * Ball(static_cast<double>(j)));
  return slope;
}

Ball at_most(const Ball& a, double limit) {
  Ball c;
  arb_min(c.get(), a.get(), Ball(limit).get(), bits);
  return c;
}

Ball at_least(const Ball& a, double limit) {
  Ball c;
  arb_max(c.get(), a.get(), Ball(limit).get(), bits);
  return c;
}

}  // namespace

std::vector<Regime> Walk::regimes(const Sides& sides) const {
  std::vector<Regime> all{{}};
  for (int side : sides) {
    const std::size_t count = all.size();
    if (side == 0 && count > 8) return {};
    for (std::size_t i = 0; i < count; ++i) {
      if (side == 0) {
        all.push_back(all[i]);
        all.back().push_back(true);
      }
      all[i].push_back(side > 0);
    }
  }
  return all;
}

/// Hull of the rates of unknowns, totals and internal energy over a box and a span, of every law that may
/// hold there. Empty: too many laws.
Balls Walk::rates_over(const Balls& box, const Span& span, Mode mode, Sides& seen) {
  seen = sides(box, span);
  Balls all;
  for (const Regime& regime : regimes(seen)) {
    Work& w = work(regime);
    w.across.run(core(box), span, 0, mode);
    Balls f;
    for (int id : w.wide.rates) f.push_back(w.across.value(id));
    for (int id : w.wide.streams) f.push_back(w.across.value(id));
    f.push_back(w.across.value(w.wide.energy_rate));
    for (std::size_t i = 0; i < f.size(); ++i) f[i] = all.empty() ? f[i] : hull(all[i], f[i]);
    all = f;
  }
  return all;
}

/// Internal energy per mass, of the lower or the upper range.
struct Walk::Energies {
  Balls fractions;
  std::array<std::vector<Balls>, 2> powers;  // of T, of each species

  Ball slope(bool high, const Ball& t) const {
    Ball sum;
    for (std::size_t k = 0; k < fractions.size(); ++k)
      sum = sum + fractions[k] * polynomial(derivative(powers[high][k]), t);
    return sum;
  }
  /// By the mean value theorem: Horner's scheme over a ball is wide. Near 1000 K each species adds little.
  Ball at(bool high, const Ball& t) const {
    Ball sum = slope(high, t) * spread(t);
    for (std::size_t k = 0; k < fractions.size(); ++k)
      sum = sum + fractions[k] * polynomial(powers[high][k], midpoint(t));
    return sum;
  }
  /// Encloses the T of every u in the ball, by the interval Newton method (R. E. Moore, "Interval Analysis",
  /// 1966, ch. 7): u(T) rises, so T lies in middle + (u - u(middle))/u'(guess) if that lies in the guess. Not
  /// finite if it cannot.
  Ball temperature(bool high, const Ball& u) const {
    Ball t(joint_temperature);
    for (int i = 0; i < 60; ++i) t = midpoint(t - (at(high, t) - midpoint(u)) / slope(high, t));
    const Ball residual = u - at(high, t);
    double reach = 2.0 * (residual / slope(high, t)).radius() + 1e-30;
    for (int i = 0; i < 60; ++i, reach *= 2.0) {
      const Ball guess = wider(t, reach), improved = t + residual / slope(high, guess);
      if (guess.contains(improved)) return improved;
    }
    Ball unknown;
    arb_indeterminate(unknown.get());
    return unknown;
  }
};

Walk::Energies Walk::energies(const Balls& box) const {
  Energies u;
  Ball last(1.0);
  for (std::size_t k = 0; k < tank_.species(); ++k) {
    std::vector<double> pure(tank_.species(), 0.0);
    pure[k] = 1.0;
    u.fractions.push_back(k + 1 < tank_.species() ? box[k + 2] : last);
    last = last - u.fractions.back();
    for (const bool high : {false, true}) u.powers[high].push_back(tank_.internal_energy(pure, high));
  }
  return u;
}

/// Internal energy [J] of the set, in whichever range.
Ball Walk::energy() {
  const Balls box = set_.box();
  const Energies u = energies(box);
  const Ball t = temperature();
  std::optional<Ball> all;
  for (const Regime& regime : regimes(sides(box, {time_, time_}))) {
    bool high = true;
    for (std::size_t i = 0; i < regime.size(); ++i)
      high = high && (regime[i] || tank_.surfaces[i].kind < Surface::Kind::joint);
    const Ball one = box[0] * u.at(high, t);
    all = all ? hull(*all, one) : one;
  }
  return *all;
}

/// Temperature of the mass and fractions in `box` with internal energy U [J]. Between the energies of the two
/// ranges at 1000 K it is 1000 K; of two temperatures it is the lower.
Ball Walk::temperature_of(const Balls& box, const Ball& energy) const {
  const Energies mixture = energies(box);
  const Ball u = energy / box[0], joint(joint_temperature);
  const Ball to_low = u - mixture.at(false, joint), to_high = u - mixture.at(true, joint);
  if (to_low.is_negative()) return mixture.temperature(false, u);
  if (to_low.is_positive() && to_high.is_positive()) return mixture.temperature(true, u);
  return hull(hull(at_most(mixture.temperature(false, u), joint_temperature), joint),
              at_least(mixture.temperature(true, u), joint_temperature));
}

/// All solutions from the set over [time, end], whatever laws hold on the way: if x + [0,h] F(Y) lies in Y, F
/// the hull of the rates over Y of all laws that may hold there, each solution exists over the span and stays
/// in Y, and its end is in x + h F(Y) (Peano's theorem with the Picard box, for a right-hand side that jumps
/// by Filippov's definition: A. F. Filippov, "Differential Equations with Discontinuous Righthand Sides",
/// 1988, ch. 2, theorem 1).
std::optional<Crossing> Walk::crossing(const Ball& end) {
  const Span span{time_, end};
  const Ball length = exact_difference(end, time_), all = hull(Ball(0.0), length);
  const Balls box = set_.box();
  const std::vector<double> scale = scales(box);
  Balls reached = box;
  for (int tries = 0; tries < 40; ++tries) {
    Sides seen;
    const Balls f = rates_over(reached, span, Mode::across, seen),
                mean = rates_over(reached, span, Mode::across_mean, seen);
    if (f.empty() || !std::all_of(f.begin(), f.end(), [](const Ball& x) { return x.is_finite(); })) return {};
    Crossing result;
    for (std::size_t i = 0; i < seen.size(); ++i)
      result.at_joint = result.at_joint || (seen[i] == 0 && tank_.surfaces[i].kind >= Surface::Kind::joint);
    Balls next;
    for (std::size_t i = 0; i < box.size(); ++i) {
      next.push_back(box[i] + all * f[i]);
      result.step.push_back(length * mean[i]);
      result.end.push_back(box[i] + result.step[i]);
    }
    if (result.at_joint) {
      const Ball begin = energy();
      next[1] = hull(box[1], temperature_of(next, begin + all * f.back()) * pressure_of_kelvin(next, span));
      result.end[1] = temperature_of(result.end, begin + length * mean.back());
    }
    bool proved = true;
    for (std::size_t i = 0; i < unknowns_; ++i) proved = proved && reached[i].contains(next[i]);
    if (proved) {
      const Ball kelvin = pressure_of_kelvin(result.end, {end, end});
      for (std::size_t i = 0; i < box.size(); ++i) {
        double added = result.step[i].radius();
        if (result.at_joint && i == 1)
          added = (result.end[1].radius() - temperature().radius()) * kelvin.middle();
        result.width = std::max(result.width, added / std::max(scale[i], 0.1 * box[i].radius() / tolerance_));
      }
      Balls there = result.end;
      if (result.at_joint) there[1] = there[1] * kelvin;
      const Sides after = sides(there, {end, end});
      result.seen = seen;
      result.decided = std::find(after.begin(), after.end(), 0) == after.end();
      return result;
    }
    for (std::size_t i = 0; i < unknowns_; ++i) {
      const Ball both = hull(reached[i], next[i]);
      reached[i] = wider(both, 0.2 * both.radius() + 1e-36 * scale[i]);
    }
  }
  return {};
}

void Walk::apply(const Crossing& crossing, const Ball& end) {
  time_ = end;
  met_ = crossing.seen;
  crossing.at_joint ? hold(crossing.end) : set_.add(crossing.step);
  ++crossings;
}

/// Crosses by the longest span, `first` or a doubling of it, that adds little width; one whose end is on a
/// side of every surface if there is any. False: none.
bool Walk::cross(const Ball& first, const Ball& end) {
  std::optional<Crossing> best;
  Ball best_end, length;
  arf_set_round(arb_midref(length.get()), arb_midref(first.get()), 30, ARF_RND_CEIL);
  for (int i = 0; i < 200 && length.is_positive(); ++i) {
    Ball to = exact_sum(time_, length);
    const bool last = arf_cmp(arb_midref(to.get()), arb_midref(end.get())) >= 0;
    if (last) to = end;
    const std::optional<Crossing> trial = crossing(to);
    if (!trial || !(trial->width <= tolerance_)) break;
    if (!best || trial->decided || !best->decided) {
      best = trial;
      best_end = to;
    }
    bool is_watched = false;
    for (std::size_t k = 0; k < trial->seen.size(); ++k)
      is_watched = is_watched || (trial->seen[k] == 0 && tank_.surfaces[k].watched);
    if (last || (is_watched && trial->decided)) break;
    arb_mul_2exp_si(length.get(), length.get(), 1);
  }
  if (!best) return false;
  apply(*best, best_end);
  return true;
}

void Walk::cross_to(const Ball& end) {
  const std::optional<Crossing> whole = crossing(end);
  if (!whole) throw Refusal("a change at an uncertain time cannot be crossed: its time is too uncertain");
  apply(*whole, end);
}

Balls Walk::values() {
  const Balls box = set_.box();
  const Span now{time_, time_};
  Work& w = work(regime(sides(box, now)));  // p and V are the same in all
  w.across.run(core(box), now, 0, Mode::across);
  Balls result{box[1], temperature(), w.across.value(w.wide.volume), box[0]};
  Ball last(1.0);
  for (std::size_t k = 0; k < tank_.species(); ++k) {
    const Ball y = k + 1 < tank_.species() ? box[k + 2] : last;
    last = last - y;
    result.push_back(box[0] * y);
  }
  result.insert(result.end(), box.begin() + static_cast<long>(unknowns_), box.end());
  return result;
}

}  // namespace enclosure
