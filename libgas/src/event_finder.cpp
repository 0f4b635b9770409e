// SPDX-License-Identifier: Apache-2.0
#include "event_finder.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <elementary/exponential.hpp>

#include "gas/orifice.hpp"
#include "limits.hpp"

namespace gas {
namespace {

// A step that passes a kink of the rates and ends at the relative distance d from it has an error of d^2; at
// the sonic switch, where slopes are continuous, of d^3. With these shares the errors are a ten thousandth
// and a thousandth of the tolerance, as kinks may be steep.
constexpr double kKnotShare = 0.01, kSonicShare = 0.1;
constexpr double kSensorNear = 1e-12;  // share of p: the time at which a sensor switches is a result in
                                       // itself
// p_a is landed on within a tenth of the laminar range, or, without one, within some thousand roundings.
constexpr double kLaminarNear = 0.1, kAmbientNear = 1e-12;
constexpr double kRounding = 1e-13;  // share of p: some hundred roundings
constexpr double kEqual = 1e-7;      // share of p_a: ten times the laminar range
// An excursion may go this many times as far as its cubic.
constexpr double kExcursion = 1.5;

/// True if flow through the openings causes more than half of dp/dt.
bool is_led_by_flow(const Moment& at) {
  return std::abs(at.growth) < 0.5 * std::abs(at.rate);
}

/// Overpressures [Pa] at which an area, a fabric's velocity or the volume has a knot, rising.
std::vector<double> overpressure_knots(const ControlVolumeModel& model) {
  std::vector<double> knots;
  const auto add = [&](const std::optional<Curve>& curve) {
    if (!curve || curve->is_constant()) return;
    for (const Curve::Knot& knot : curve->knots()) knots.push_back(knot.time);
  };
  for (const Vent& vent : model.vents) add(vent.area_of_overpressure);
  for (const Fabric& fabric : model.fabrics) add(fabric.velocity);
  add(model.volume_of_overpressure);
  std::ranges::sort(knots);
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  return knots;
}

}  // namespace

EventFinder::EventFinder(const Boundary& boundary, double tolerance) : boundary_(boundary) {
  const ControlVolumeModel& model = boundary.model();
  const double p_a = model.ambient.pressure;
  ambient_near_ = std::max(kLaminarNear * model.laminar_share, kAmbientNear) * p_a;
  sonic_near_ = kSonicShare * elementary::pow(tolerance, 1.0 / 3.0) * p_a;
  const auto add = [&](double level, double near) {
    levels_.push_back({level, near * (p_a + std::max(0.0, level))});
  };
  for (const double knot : overpressure_knots(model)) add(knot, kKnotShare * std::sqrt(tolerance));
  for (const Sensor& sensor : model.triggers.sensors) {
    if (sensor.kind != SensorKind::pressure) continue;
    add(sensor.threshold, kSensorNear);
    if (sensor.reset) add(*sensor.reset, kSensorNear);
  }
}

Moment EventFinder::moment(const Balance& balance, double slope) const {
  const UniformGas& gas = balance.gas();
  const double p_a = boundary_.model().ambient.pressure, rate = balance.pressure_rate() * slope;
  Moment m{gas.overpressure, rate, gas.compliance(), -p_a, 0.0, balance.closed_growth() / gas.volume,
           balance.flow()};
  if (gas.mass > 0.0 && gas.overpressure > 0.0 && boundary_.has_open_vent()) {
    const double ratio = critical_pressure_ratio(gas.gamma);
    m.sonic = ratio * gas.pressure - p_a;
    m.sonic_rate = ratio * rate;
  } else if (gas.overpressure < 0.0 && boundary_.has_backflow()) {
    m.sonic = critical_pressure_ratio(boundary_.ambient().gamma) * p_a - gas.pressure;
    m.sonic_rate = -rate;
  }
  return m;
}

double EventFinder::Course::at(double s) const {
  const double rise = end - begin, u = 1.0 - s;
  return begin + s * (rise + u * (begin_slope * u - end_slope * s + rise * (2.0 * s - 1.0)));
}

/// Place of its extremum inside the trial, if it has one.
std::optional<double> EventFinder::Course::turn() const {
  if (!(begin_slope * end_slope < 0.0)) return {};
  // The slope is a s^2 + b s + c; one of its two zeros lies inside.
  const double rise = end - begin, a = 3.0 * (begin_slope + end_slope - 2.0 * rise),
               b = 2.0 * (3.0 * rise - 2.0 * begin_slope - end_slope), c = begin_slope;
  const double q = -0.5 * (b + std::copysign(std::sqrt(std::max(0.0, b * b - 4.0 * a * c)), b));
  for (const double s : {q / a, c / q})
    if (s > 0.0 && s < 1.0) return s;
  return {};
}

std::optional<double> EventFinder::Course::passing(double begin_near, double end_near, bool again) const {
  if (std::abs(end) <= end_near) return {};
  // If it starts on a level, its slope decides to which side it leaves.
  Course course = *this;
  if (std::abs(begin) <= begin_near)
    course.begin = begin_slope == 0.0 ? end : std::copysign(2.0 * begin_near, begin_slope);
  if (course.begin * end < 0.0) {
    boost::uintmax_t iterations = 60;
    const auto value = [&](double s) { return course.at(s); };
    const boost::math::tools::eps_tolerance<double> close(40);
    const auto [low, high] =
        boost::math::tools::toms748_solve(value, 0.0, 1.0, course.begin, end, close, iterations);
    // Beyond the level p may follow another law, which misleads the cubic. Then the slope at the start is
    // used.
    const double curved = 0.5 * (low + high), straight = -begin / begin_slope;
    if (std::abs(begin) <= begin_near || !(straight > 0.0 && straight < 1.0)) return curved;
    return again                                                ? std::min(curved, straight)
           : straight < 2.0 * curved && curved < 2.0 * straight ? curved
                                                                : straight;
  }
  const auto turned = course.turn();
  if (!turned) return {};
  const double nearer = course.begin > 0.0 ? std::min(course.begin, end) : std::max(course.begin, end);
  const double farthest = nearer + kExcursion * (course.at(*turned) - nearer);
  return nearer * farthest < 0.0 ? turned : std::nullopt;
}

std::optional<double> EventFinder::landing(const Moment& begin, const Moment& end, double h,
                                           bool again) const {
  std::optional<double> first;
  const auto watch = [&](const Course& course, double begin_near, double end_near) {
    const auto share = course.passing(begin_near, end_near, again);
    if (share && !(first && *first <= *share)) first = share;
  };
  const auto watch_level = [&](double level, double near) {
    watch({begin.overpressure - level, h * begin.rate, end.overpressure - level, h * end.rate},
          near / begin.compliance, near / end.compliance);
  };
  if (boundary_.is_open() && !is_on_ambient(begin)) watch_level(0.0, ambient_near_);
  for (const Level& level : levels_) watch_level(level.overpressure, level.near);
  if (begin.overpressure * end.overpressure > 0.0)
    watch({begin.sonic, h * begin.sonic_rate, end.sonic, h * end.sonic_rate}, sonic_near_, sonic_near_);
  return first;
}

bool EventFinder::is_on_ambient(const Moment& at) const {
  return std::abs(at.overpressure) <= ambient_near_ / at.compliance;
}

bool EventFinder::is_led(const Moment& at, double side) const {
  const bool opens = side > 0.0 ? boundary_.is_open() : boundary_.has_backflow();
  return side * at.flow > 0.0 || (opens && is_on_ambient(at) && side * at.growth > 0.0);
}

bool EventFinder::is_onset(const Balance& balance, const Moment& at) const {
  return at.growth != 0.0 && is_led(at, at.growth) && balance.pressure_rate() / at.growth >= 0.5;
}

std::optional<double> EventFinder::switches(const Moment& begin, const Moment& end, double h) const {
  // A trial may end just short of the switch; the next trial then passes it.
  const bool starts_on = std::abs(begin.sonic) <= sonic_near_, ends_on = std::abs(end.sonic) <= sonic_near_;
  if ((begin.sonic > 0.0) == (end.sonic > 0.0) || !(starts_on || ends_on)) return {};
  const Course course{begin.sonic, h * begin.sonic_rate, end.sonic, h * end.sonic_rate};
  return course.passing(0.0, 0.0, false).value_or(starts_on ? 0.0 : 1.0);
}

std::optional<double> EventFinder::equalises(const Moment& begin, const Moment& end) const {
  const double size = kEqual * boundary_.model().ambient.pressure;
  const double from = std::abs(begin.overpressure), to = std::abs(end.overpressure);
  if (!(from > size && to <= size) || begin.flow == 0.0 || !is_led_by_flow(begin)) return {};
  return (std::sqrt(from) - std::sqrt(size)) / (std::sqrt(from) - std::sqrt(to));  // p - p_a is proportional
                                                                                   // to its square
}

double EventFinder::until_ambient(const Moment& begin) const {
  const double laminar = 3.0 * laminar_overpressure(boundary_.model());
  if (begin.flow == 0.0 || begin.overpressure * begin.rate >= 0.0 || std::abs(begin.overpressure) <= laminar)
    return kInfinity;
  return -2.0 * begin.overpressure / begin.rate;
}

double EventFinder::time_kept(const Moment& begin, const Moment& end) const {
  const double before = until_ambient(begin), after = until_ambient(end);
  return before < kInfinity && is_led_by_flow(end) ? std::min(1.0, after / before) : 1.0;
}

bool EventFinder::crosses_against_flow(const Moment& begin, const Moment& end, double duration) const {
  const double from = begin.overpressure, to = end.overpressure;
  const double up = std::max({0.0, begin.growth, end.growth}),
               down = std::max({0.0, -begin.growth, -end.growth});
  if (up + down == 0.0) {
    // Flow out that is not fed leaves p above p_a, and flow in leaves it below. Beyond p_a rest may be
    // unstable, if cold ambient gas lowers p. A stage beyond p_a that drives p farther away is such an error,
    // too.
    if (begin.flow == 0.0) return false;
    const double rounding = kRounding * boundary_.model().ambient.pressure;
    return (from * to < 0.0 && std::abs(to) > rounding) ||
           (from * begin.rate < 0.0 && from * to > 0.0 && std::abs(to) > std::abs(from) + rounding);
  }
  // Change of p beyond p_a that cooling, expansion, inflow or compression could cause.
  const double near = ambient_near_ / end.compliance;
  return (is_led(begin, 1.0) && from > -near && -to > near + down * duration) ||
         (is_led(begin, -1.0) && from < near && to > near + up * duration);
}

}  // namespace gas
