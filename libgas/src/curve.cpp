// SPDX-License-Identifier: Apache-2.0
#include "gas/curve.hpp"

#include <algorithm>
#include <cmath>

#include "limits.hpp"
#include "require.hpp"

namespace gas {
namespace {

/// Calls visit(a, b) for each interval of [a, b] without a knot of f or g inside.
template <class Visit>
void for_each_piece(const Curve& f, const Curve& g, double a, double b, Visit visit) {
  while (a < b) {
    const double next = std::min({f.next_knot(a), g.next_knot(a), b});
    visit(a, next);
    a = next;
  }
}

double midpoint(double a, double b) {
  return a + 0.5 * (b - a);
}

}  // namespace

Curve::Curve(std::vector<Knot> knots, Outside outside) : knots_(std::move(knots)), outside_(outside) {
  require(outside == Outside::zero || outside == Outside::held, "outside", static_cast<double>(outside),
          "must be one of its enumerators");
  const std::size_t least = outside == Outside::zero ? 2 : 1;
  require(knots_.size() >= least, "number of knots of a curve", static_cast<double>(knots_.size()),
          "must be at least 1, and 2 for a curve that is zero outside its knots");
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    require(std::isfinite(knots_[i].time), "time or overpressure of a knot", knots_[i].time,
            "must be finite");
    require(std::isfinite(knots_[i].value), "value of a knot", knots_[i].value, "must be finite");
    require(i == 0 || knots_[i].time >= knots_[i - 1].time, "time or overpressure of a knot", knots_[i].time,
            "must not be below that of the knot before");
    require(i < 2 || knots_[i].time > knots_[i - 2].time, "time or overpressure of three knots",
            knots_[i].time, "must belong to at most two knots, the values before and after a jump");
    if (i == 0 || knots_[i].time == knots_[i - 1].time) continue;
    const double slope = (knots_[i].value - knots_[i - 1].value) / (knots_[i].time - knots_[i - 1].time);
    require(std::isfinite(slope), "slope of a curve", slope,
            "must be finite; for a jump use two knots at one place");
  }
}

Curve Curve::constant(double value) {
  return Curve({{0.0, value}}, Outside::held);
}

Curve::Piece Curve::piece(double time) const {
  const auto right = std::ranges::upper_bound(knots_, time, {}, &Knot::time);
  if (right == knots_.begin() || right == knots_.end()) {
    const Knot& knot = right == knots_.begin() ? knots_.front() : knots_.back();
    return {knot.time, outside_ == Outside::zero ? 0.0 : knot.value, 0.0};
  }
  const Knot &l = *(right - 1), &r = *right;
  return {l.time, l.value, (r.value - l.value) / (r.time - l.time)};
}

double Curve::value(double time, Side side) const {
  require(side == Side::before || side == Side::after, "side", static_cast<double>(side),
          "must be one of its enumerators");
  if (side == Side::before)
    if (const auto first = std::ranges::lower_bound(knots_, time, {}, &Knot::time);
        first != knots_.end() && first->time == time)
      return first->value;
  if (time == knots_.back().time) return knots_.back().value;
  const Piece p = piece(time);
  return p.slope == 0.0 ? p.value : p.at(time);  // also at an infinite time: before an inflow that has not
                                                 // fired
}

std::optional<double> Curve::first_jump() const {
  const auto jump = std::ranges::adjacent_find(knots_, {}, &Knot::time);
  return jump == knots_.end() ? std::nullopt : std::optional(jump->time);
}

double Curve::next_knot(double time) const {
  if (is_constant()) return kInfinity;
  const auto next = std::ranges::upper_bound(knots_, time, {}, &Knot::time);
  return next == knots_.end() ? kInfinity : next->time;
}

double Curve::nearest_knot(double time) const {
  if (is_constant()) return kInfinity;
  const auto right = std::ranges::lower_bound(knots_, time, {}, &Knot::time);
  if (right == knots_.begin()) return right->time;
  const double before = (right - 1)->time;
  return right == knots_.end() || time - before < right->time - time ? before : right->time;
}

double Curve::integral(double a, double b) const {
  double sum = 0.0;
  for_each_piece(*this, *this, a, b,
                 [&](double l, double r) { sum += (r - l) * piece(midpoint(l, r)).at(midpoint(l, r)); });
  return sum;
}

double Curve::minimum() const {
  return std::ranges::min_element(knots_, {}, &Knot::value)->value;
}

double Curve::maximum() const {
  return std::ranges::max_element(knots_, {}, &Knot::value)->value;
}

double product_integral(const Curve& f, const Curve& g, double a, double b) {
  double sum = 0.0;
  for_each_piece(f, g, a, b, [&](double l, double r) {
    const double middle = midpoint(l, r), h = r - l;
    const Curve::Piece pf = f.piece(middle), pg = g.piece(middle);
    sum += h * (pf.at(middle) * pg.at(middle) + pf.slope * pg.slope * h * h / 12.0);
  });
  return sum;
}

}  // namespace gas
