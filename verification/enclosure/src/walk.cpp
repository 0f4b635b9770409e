// SPDX-License-Identifier: Apache-2.0
// Steps of a walk: how long they are to be.
#include "walk.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "work.hpp"

namespace enclosure {
namespace {

constexpr int parts_of_length = 32;

/// The first part of the length in which a polynomial changes its sign, computed in doubles; 0: none.
int part_with_root(const Balls& c, double length) {
  std::vector<double> middle;
  for (const Ball& x : c) middle.push_back(x.middle());
  for (int i = 1; i <= parts_of_length; ++i) {
    double value = 0.0;
    for (std::size_t k = c.size(); k-- > 0;) value = value * (length * i / parts_of_length) + middle[k];
    if ((value > 0.0) != (middle[0] > 0.0)) return i;
  }
  return 0;
}

}  // namespace

Walk::Work& Walk::work(const Regime& regime) {
  auto& entry = works_[regime];
  if (!entry) entry = std::make_unique<Work>(tank_, regime);
  return *entry;
}

Walk::Walk(const Tank& tank, const Ball& start, const Balls& box, double tolerance)
    : tank_(tank),
      unknowns_(tank.species() + 1),
      streams_(box.size() - unknowns_),
      tolerance_(tolerance),
      time_(start),
      set_(box) {
  hold(box);
}

Walk::Walk(const Tank& tank, const Place& place, double tolerance)
    : tank_(tank),
      unknowns_(tank.species() + 1),
      streams_(place.set.centre().size() - unknowns_),
      tolerance_(tolerance),
      time_(place.time),
      set_(place.set) {}

Walk::~Walk() = default;

Ball Walk::volume(const Span& span) const {
  Ball space;
  tank_.scene.wave ? wave_series(*tank_.scene.wave, span, space.get(), 1)
                   : tank_.volumes[0].series(span, Mode::across, space.get(), 1);
  return space;
}

Ball Walk::gas_constant(const Balls& box) const {
  Ball r = tank_.gas_constants.back();
  for (std::size_t k = 0; k + 1 < tank_.species(); ++k)
    r = r + box[k + 2] * (tank_.gas_constants[k] - tank_.gas_constants.back());
  return r;
}

/// m R/V.
Ball Walk::pressure_of_kelvin(const Balls& box, const Span& span) const {
  return box[0] * gas_constant(box) / volume(span);
}

/// Makes the set one of pressures p = m R T/V, from a box with T in their place.
void Walk::hold(const Balls& box) {
  const Span now{time_, time_};
  const Ball factor = pressure_of_kelvin(box, now), share = factor * box[1] / gas_constant(box);
  set_ = MovingSet(box);
  Balls image = set_.centre();
  image[1] = image[1] * pressure_of_kelvin(image, now);
  Matrix slopes = Matrix::identity(box.size());
  slopes.at(1, 0) = factor * box[1] / box[0];
  slopes.at(1, 1) = factor;
  for (std::size_t k = 0; k + 1 < tank_.species(); ++k)
    slopes.at(1, k + 2) = share * (tank_.gas_constants[k] - tank_.gas_constants.back());
  set_.advance(image, slopes, scales(image));
}

/// T = p V/(m R) of the set: narrower than of its box.
Ball Walk::temperature() const {
  const Span now{time_, time_};
  const Balls box = set_.box(), centre = set_.centre();
  const Ball t = box[1] / pressure_of_kelvin(box, now), r = gas_constant(box);
  Balls slopes{Ball(0.0) - t / box[0], t / box[1]};
  for (std::size_t k = 0; k + 1 < tank_.species(); ++k)
    slopes.push_back(t / r * (tank_.gas_constants.back() - tank_.gas_constants[k]));
  return centre[1] / pressure_of_kelvin(centre, now) + set_.deviation(slopes);
}

/// What widths are relative to: the mass that is and was there, the pressure, 1 for mass fractions.
std::vector<double> Walk::scales(const Balls& box) const {
  double mass = box[0].middle();
  for (std::size_t j = 0; j < streams_; ++j) mass = std::max(mass, std::abs(box[unknowns_ + j].middle()));
  std::vector<double> result(box.size(), mass);
  result[0] = box[0].middle();
  result[1] = box[1].middle();
  std::fill(result.begin() + 2, result.begin() + static_cast<long>(unknowns_), 1.0);
  return result;
}

Walk::Sides Walk::sides(const Balls& box, const Span& span) {
  Sides result(tank_.surfaces.size(), 0);
  bool first = true;
  const Ball temperature = box[1] / pressure_of_kelvin(box, span);
  const Ball below = Ball(joint_temperature) - temperature;
  for (const bool high : {false, true}) {
    if (tank_.constant_cp ? high : high ? below.is_positive() : (below + Ball(1.0)).is_negative()) continue;
    Regime any(tank_.surfaces.size(), true);
    for (std::size_t i = 0; i < any.size(); ++i)
      if (tank_.surfaces[i].kind == Surface::Kind::joint ||
          tank_.surfaces[i].kind == Surface::Kind::joint_energy)
        any[i] = high;
    Work& w = work(any);
    w.across.run(core(box), span, 0, Mode::across);
    for (std::size_t i = 0; i < result.size(); ++i) {
      const Ball g = w.across.value(w.wide.surfaces[i]);
      const int side = g.is_positive() ? 1 : g.is_negative() ? -1 : 0;
      result[i] = first || result[i] == side ? side : 0;
    }
    first = false;
  }
  return result;
}

Regime Walk::regime(const Sides& sides) {
  Regime result;
  for (int side : sides) result.push_back(side > 0);
  return result;
}

/// Length of a step whose last coefficients are a tenth of the tolerance.
template <class Number>
Ball Walk::first_length(const Work& w, const SeriesOf<Number>& boxed, const Ball& end) const {
  const std::vector<double> scale = scales(set_.box());
  double length = w.in_units(end - time_).middle();
  for (std::size_t i = 0; i < unknowns_; ++i)
    for (slong k = taylor_order - 2; k < taylor_order; ++k) {
      const double size = std::abs(w.coefficient(boxed, i, k).middle()) / scale[i];
      if (size > 0.0)
        length = std::min(length, std::pow(0.1 * tolerance_ / size, 1.0 / static_cast<double>(k)));
    }
  return rounded_down(w.in_seconds(Ball(length)));
}

/// Where g of the centre's solution vanishes within the length, about; none if it does not.
std::optional<Ball> Walk::root(Work& w, std::size_t surface, const Ball& length) const {
  Balls c;
  for (slong k = 0; k < taylor_order; ++k) c.push_back(midpoint(w.thin.value(w.law.surfaces[surface], k)));
  const double end = w.in_units(length).middle();
  const int part = part_with_root(c, end);
  if (part == 0) return std::nullopt;
  const bool sign = c[0].is_positive();
  Ball a(end * (part - 1) / parts_of_length), b(end * part / parts_of_length);
  for (int tries = 0; tries < 100; ++tries) {
    const Ball middle = midpoint((a + b) * Ball(0.5));
    (midpoint(polynomial(c, middle)).is_positive() == sign ? a : b) = middle;
  }
  return w.in_seconds(a);
}

/// The first of the roots of all surfaces within the length, and how uncertain it is. `boxed` shows which
/// have one.
template <class Number>
std::optional<Ball> Walk::first_root(Work& w, const SeriesOf<Number>& boxed, const Ball& length, Ball& margin,
                                     bool& is_watched) const {
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < tank_.surfaces.size(); ++i) {
    Balls c;
    for (slong k = 0; k < taylor_order; ++k) c.push_back(boxed.value(w.law.surfaces[i], k));
    if (part_with_root(c, w.in_units(length).middle()) > 0) candidates.push_back(i);
  }
  if (candidates.empty()) return std::nullopt;
  w.thin.run(core(set_.centre()), {time_, time_}, taylor_order - 1, Mode::series, w.unit);
  w.across.run(core(set_.box()), {time_, time_}, 0, Mode::across);
  std::optional<Ball> first;
  for (std::size_t i : candidates) {
    const std::optional<Ball> at = root(w, i, first ? *first : length);
    if (!at) continue;
    first = at;
    is_watched = tank_.surfaces[i].watched;
    const Ball g = w.across.value(w.wide.surfaces[i]), slope = w.thin.value(w.law.surfaces[i], 1);
    margin = *at * Ball(0x1p-60) + w.in_seconds(Ball(16.0 * g.radius() / std::abs(slope.middle())));
  }
  return first;
}

/// A step that is proved with these series, or a crossing.
template <class Number>
bool Walk::taylor_with(Work& w, SetSeries<Number>& series, const Regime& regime, const Ball& end, int most) {
  series.boxed.run(core(set_.box()), {time_, time_}, taylor_order - 1, Mode::series, w.unit);
  Ball length = first_length(w, series.boxed, end);
  if (last_length_.is_positive() && (length - last_length_ * Ball(2.0)).is_positive())
    length = last_length_ * Ball(2.0);
  Ball margin;
  bool is_watched = false;  // the time at which a sensor switches is wanted exactly
  if (const std::optional<Ball> at = first_root(w, series.boxed, length, margin, is_watched)) {
    if (!(is_watched && (*at - margin).is_positive()) && cross(*at + *at + margin, end)) return true;
    length = rounded_down(*at - margin);
    if (length.is_positive() && try_length(w, series, regime, length)) {
      const bool is_close =
          !(*at - length - margin * Ball(4.0)).is_positive();  // but for few digits of length
      if (is_close || !is_watched) approach_ = margin;
      return true;
    }
    length = rounded_down(*at * Ball(0.7));
  }
  for (int tries = 0; tries < most && length.is_positive(); ++tries) {
    const bool last = arf_cmp(arb_midref(exact_sum(time_, length).get()), arb_midref(end.get())) >= 0;
    if (last) length = exact_difference(end, time_);
    if (!try_length(w, series, regime, length)) continue;
    if (!last) last_length_ = length;
    return true;
  }
  return false;
}

bool Walk::taylor(const Regime& regime, const Ball& end) {
  Work& w = work(regime);
  w.unit = std::ilogb((last_length_.is_positive() ? last_length_ : end - time_).middle());
  return taylor_with(w, w.quick, regime, end, 8) || taylor_with(w, w.exact(), regime, end, 200);
}

void Walk::step(const Ball& end) {
  met_.clear();
  const Sides now = sides(set_.box(), {time_, time_});
  const bool decided = std::find(now.begin(), now.end(), 0) == now.end();
  if (approach_.is_positive()) {
    const Ball margin = approach_;
    approach_ = Ball(0.0);
    if (cross(margin + margin, end)) return;
  }
  if (decided && taylor(regime(now), end)) {
    undecided_ = 0;
    return;
  }
  if (!decided && rest(now, end)) return;
  if (++undecided_ < 100 && cross((end - time_) * Ball(0x1p-80), end)) return;
  char text[200];
  std::snprintf(text, sizeof text,
                "at t = %.6g s the tube cannot be continued: it stays within its width of a switch of "
                "the law, or its width grows without bound",
                time_.middle());
  throw Refusal(text);
}

}  // namespace enclosure
