// SPDX-License-Identifier: Apache-2.0
// Steps across switches of the law, and across changes of functions of time at uncertain times.
#include <algorithm>
#include <cmath>

#include "work.hpp"

namespace enclosure {
namespace {

/// Encloses the T of every u in the ball, by the interval Newton method (R. E. Moore, "Interval Analysis",
/// 1966, ch. 7): u(T) rises, so T lies in middle + (u - u(middle))/u'(guess) if that lies in the guess. Not
/// finite if it cannot.
Ball temperature_on(const Balls& u_of_t, const Ball& u) {
  Balls slope;
  for (std::size_t j = 1; j < u_of_t.size(); ++j) slope.push_back(u_of_t[j] * Ball(static_cast<double>(j)));
  Ball t(joint_temperature);
  for (int i = 0; i < 60; ++i) t = midpoint(t - (polynomial(u_of_t, t) - midpoint(u)) / polynomial(slope, t));
  const Ball residual = u - polynomial(u_of_t, t);
  double reach = 2.0 * (residual / polynomial(slope, t)).radius() + 1e-30;
  for (int i = 0; i < 60; ++i, reach *= 2.0) {
    const Ball guess = wider(t, reach), improved = t + residual / polynomial(slope, guess);
    if (guess.contains(improved)) return improved;
  }
  Ball unknown;
  arb_indeterminate(unknown.get());
  return unknown;
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
    w.across.run(core(box), span, mode);
    Balls f;
    for (int id : w.law.rates) f.push_back(w.across.value(id));
    for (int id : w.law.streams) f.push_back(w.across.value(id));
    f.push_back(w.across.value(w.law.energy_rate));
    for (std::size_t i = 0; i < f.size(); ++i) f[i] = all.empty() ? f[i] : hull(all[i], f[i]);
    all = f;
  }
  return all;
}

/// Temperature of the mass and fractions in `box` with internal energy U [J]. Between the energies of the two
/// ranges at 1000 K it is 1000 K; of two temperatures it is the lower.
Ball Walk::temperature_of(const Balls& box, const Ball& energy) const {
  Balls low(6), high(6);
  Ball last(1.0);
  for (std::size_t k = 0; k < tank_.species(); ++k) {
    std::vector<double> pure(tank_.species(), 0.0);
    pure[k] = 1.0;
    const Ball y = k + 1 < tank_.species() ? box[k + 2] : last;
    last = last - y;
    const Balls a = tank_.internal_energy(pure, false), b = tank_.internal_energy(pure, true);
    for (std::size_t j = 0; j < a.size(); ++j) {
      low[j] = low[j] + y * a[j];
      high[j] = high[j] + y * b[j];
    }
  }
  const Ball u = energy / box[0], joint(joint_temperature);
  const Ball to_low = u - polynomial(low, joint), to_high = u - polynomial(high, joint);
  if (to_low.is_negative()) return temperature_on(low, u);
  if (to_low.is_positive() && to_high.is_positive()) return temperature_on(high, u);
  return hull(hull(at_most(temperature_on(low, u), joint_temperature), joint),
              at_least(temperature_on(high, u), joint_temperature));
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
      Sides unused;
      Ball energy;
      bool first = true;
      for (const Regime& regime : regimes(sides(box, {time_, time_}))) {
        Work& w = work(regime);
        w.across.run(core(box), {time_, time_}, Mode::across);
        energy = first ? w.across.value(w.law.energy) : hull(energy, w.across.value(w.law.energy));
        first = false;
      }
      next[1] = hull(box[1], temperature_of(next, energy + all * f.back()));
      result.end[1] = temperature_of(result.end, energy + length * mean.back());
    }
    bool proved = true;
    for (std::size_t i = 0; i < unknowns_; ++i) proved = proved && reached[i].contains(next[i]);
    if (proved) {
      for (std::size_t i = 0; i < box.size(); ++i) {
        const double added =
            result.at_joint && i == 1 ? result.end[1].radius() - box[1].radius() : result.step[i].radius();
        result.width = std::max(result.width, added / std::max(scale[i], 0.1 * box[i].radius() / tolerance_));
      }
      const Sides after = sides(result.end, {end, end});
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
  if (crossing.at_joint)
    set_ = MovingSet(crossing.end);
  else
    set_.add(crossing.step);
  time_ = end;
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
    if (last) break;
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
  w.across.run(core(box), now, Mode::across);
  Balls result{w.across.value(w.law.pressure), w.across.value(w.law.volume)};
  result.insert(result.begin() + 1, box[1]);
  result.push_back(box[0]);
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
