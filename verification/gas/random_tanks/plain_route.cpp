// SPDX-License-Identifier: Apache-2.0
#include "plain_route.hpp"

#include <algorithm>
#include <cmath>

#include "plain_network.hpp"
#include "plain_rates.hpp"
#include "radau.hpp"

namespace random_tanks {
namespace {

constexpr double kOnLevel = 1e-12;  // some thousand roundings
constexpr int kMostSteps = 20000, kMostSwitchings = 400;

/// The line of a table at x, on the piece that holds around `inside`.
Line line_at(const Table& table, double inside, double x) {
  const auto& [xs, ys] = table;
  if (!(inside > xs.front()) || !(inside < xs.back())) return {table.at(inside), 0.0};
  const auto i = static_cast<std::size_t>(std::ranges::upper_bound(xs, inside) - xs.begin());
  const double slope = (ys[i] - ys[i - 1]) / (xs[i] - xs[i - 1]);
  return {ys[i - 1] + slope * (x - xs[i - 1]), slope};
}

class Run {
 public:
  Run(const Tank& tank, const std::string& csv, const Options& options)
      : tank_(tank),
        options_(options),
        slack_(1e-13 * tank.times.back()),
        rates_(tank, csv),
        network_(tank),
        radau_(rates_, options.tolerance),
        y_(rates_.start(options.perturbation)),
        middle_(y_.size()),
        next_(y_.size()) {}

  Outcome outcome() {
    set_stretch(tank_.times[1]);
    record();
    for (; call_ + 1 < tank_.times.size() && t_ < options_.until; ++call_) {
      if (!advance(std::min(tank_.times[call_ + 1], options_.until))) break;
      record();
    }
    outcome_.switchings = network_.switchings();
    return std::move(outcome_);
  }

 private:
  double firing(const Pulse& pulse) const { return network_.first(pulse.node) + pulse.start; }

  /// Lines of the curves between now and `end`.
  void set_stretch(double end) {
    Stretch& stretch = rates_.stretch;
    const double begin = tank_.times[call_];
    stretch.length = tank_.times[call_ + 1] - begin;
    stretch.since = t_ - begin;
    stretch.bulge = tank_.bulges[call_];
    const auto in_call = [&](const std::vector<double>& v) {
      const double slope = (v[call_ + 1] - v[call_]) / stretch.length;
      return Line{v[call_] + slope * stretch.since, slope};
    };
    stretch.volume = in_call(tank_.volumes);
    stretch.leak = in_call(tank_.leak_areas);
    stretch.flows.clear();
    stretch.temperatures.clear();
    stretch.areas.clear();
    const double middle = 0.5 * (t_ + end);
    for (const Pulse& pulse : tank_.pulses) {
      const double start = firing(pulse), tau = middle - start;
      const bool flows = tau > 0.0 && tau < pulse.mass_flow.x.back();
      stretch.flows.push_back(flows ? line_at(pulse.mass_flow, tau, t_ - start) : Line{});
      stretch.temperatures.push_back(flows ? line_at(pulse.temperature, tau, t_ - start) : Line{300.0, 0.0});
    }
    for (const Hole& hole : tank_.holes) stretch.areas.push_back(area_of(hole, middle));
  }

  Line area_of(const Hole& hole, double middle) const {
    if (!network_.is_on(hole.node)) return {};
    const double since = network_.since(hole.node), cd = hole.discharge_coefficient;
    Line area{hole.area_of_overpressure.empty() ? hole.area : 1.0, 0.0};
    if (!hole.area_of_time.empty()) area = line_at(hole.area_of_time, middle - since, t_ - since);
    return {cd * area.value, cd * area.slope};
  }

  double next_break() const {
    double next = network_.next_break(t_);
    const auto add = [&](double time) {
      if (time > t_ + slack_) next = std::min(next, time);
    };
    for (const Pulse& pulse : tank_.pulses) {
      const double start = firing(pulse);
      const auto& [x, y] = pulse.temperature;
      for (const double knot : pulse.mass_flow.x) add(start + knot);
      for (const double knot : x) add(start + knot);
      for (std::size_t i = 0; i + 1 < x.size(); ++i)
        if ((y[i] < kJoint) != (y[i + 1] < kJoint))
          add(start + x[i] + (kJoint - y[i]) * (x[i + 1] - x[i]) / (y[i + 1] - y[i]));
    }
    for (const Hole& hole : tank_.holes)
      for (const double knot : hole.area_of_time.x) add(network_.since(hole.node) + knot);
    return next;
  }

  bool advance(double end) {
    while (t_ < end) {
      set_stretch(end);
      network_.update(t_, overpressure(y_, 0.0));
      if (network_.switchings() > kMostSwitchings) return fail("keeps switching", 0.0);
      double next = next_break();
      if (next > end - slack_) next = end;
      set_stretch(next);
      if (!stretch_to(next)) return false;
    }
    return true;
  }

  /// Steps to `end`, or to where a pressure sensor switches. A step across a corner is repeated up to just
  /// beyond it.
  bool stretch_to(double end) {
    const double length = end - t_;
    radau_.begin_anew();
    const bool empty = std::ranges::all_of(y_, [](double v) { return v == 0.0; });
    double h = std::min(h_ > 0.0 && !empty ? h_ : (empty ? 1e-6 : 1e-3) * length, length);
    bool landing = false;
    for (double tau = 0.0; tau < length;) {
      const bool last = tau + h * (1.0 + 1e-9) >= length;
      if (last) h = length - tau;
      if (++outcome_.steps > kMostSteps) return fail("too many steps", tau);
      levels_ = rates_.levels(tau, y_);
      const double error = radau_.pair(tau, h, y_, middle_, next_);
      const double factor = error < kInfinity ? 0.9 * std::pow(std::max(error, 1e-6), -1.0 / 6.0) : 0.2;
      if (!landing || error > 1.0) h_ = h * std::clamp(factor, 0.1, 5.0);
      if (!(error <= 1.0)) {
        if (h <= 1e-15 * tau) return fail("no step", tau);
        h = h_;
        landing = false;
        continue;
      }
      // The step that `corner` found, not the pair, which may end short of it by a rounding.
      if (landing) std::ranges::copy(radau_.single(), next_.begin());
      const bool early = passes(middle_, tau + 0.5 * h), late = passes(next_, tau + h);
      const bool shortest = landing && h <= 1e-15 * (t_ + tau);
      if ((early && !shortest) || (late && !landing)) {
        h_ = 0.25 * h;
        h = corner(tau, early ? 0.5 * h : h);
        landing = true;
        continue;
      }
      y_.swap(next_);
      tau = last ? length : tau + h;
      late ? radau_.begin_anew() : radau_.go_on();
      h = h_;
      landing = false;
      look(tau);
      if (late && network_.switches(overpressure(y_, tau))) {
        t_ += tau;
        return true;
      }
    }
    t_ = end;
    return true;
  }

  /// Whether a pressure sensor or a level of the rates changes between the begin of the step and y.
  bool passes(const std::vector<double>& y, double tau) const {
    if (network_.switches(overpressure(y, tau))) return true;
    const std::vector<double> levels = rates_.levels(tau, y);
    for (std::size_t i = 0; i < levels.size(); ++i)
      if (std::abs(levels[i]) > kOnLevel && std::abs(levels_[i]) > kOnLevel && levels[i] * levels_[i] < 0.0)
        return true;
    return false;
  }

  /// Length of the step from `tau` that ends just beyond the first corner within h.
  double corner(double tau, double h) {
    double low = 0.0, high = h;
    for (double half = 0.5 * h; half > low && half < high; half = 0.5 * (low + high)) {
      if (!radau_.step(tau, half, y_, next_)) return 0.5 * half;
      (passes(next_, tau + half) ? high : low) = half;
      if (high - low <= 1e-16 * (t_ + tau)) break;
    }
    return high;
  }

  /// At `tau` since the begin of the stretch.
  double overpressure(const std::vector<double>& y, double tau) const {
    PlainState<double> gas;
    return rates_.locate(tau, y, gas) ? gas.place.overpressure : -tank_.ambient_pressure;
  }

  void look(double tau) {
    PlainState<double> gas;
    if (!rates_.locate(tau, y_, gas) || !(gas.mass > 0.0)) return;
    outcome_.coldest = std::min(outcome_.coldest, gas.temperature);
    outcome_.hottest = std::max(outcome_.hottest, gas.temperature);
  }

  /// The gas at the end of the call, which is that of the stretch.
  void record() {
    PlainState<double> gas;
    rates_.locate(t_ - tank_.times[call_] - rates_.stretch.since, y_, gas);
    outcome_.samples.push_back({t_,
                                gas.place.pressure,
                                gas.temperature,
                                gas.mass,
                                gas.place.overpressure,
                                {y_.begin(), y_.end() - 1}});
    look(0.0);
  }

  bool fail(const char* why, double tau) {
    outcome_.failure = why + (" at t = " + std::to_string(t_ + tau));
    return false;
  }

  const Tank& tank_;
  const Options options_;
  const double slack_;  // [s] what counts as the same time
  PlainRates rates_;
  PlainNetwork network_;
  Radau radau_;
  std::vector<double> y_, middle_, next_, levels_;
  std::size_t call_ = 0;
  double t_ = 0.0, h_ = 0.0;
  Outcome outcome_;
};

}  // namespace

Range range_of(const Tank& tank, const std::string& csv) {
  const PlainRates rates(tank, csv);
  return {rates.minimum(), rates.maximum()};
}

Outcome plain_route(const Tank& tank, const std::string& csv, const Options& options) {
  return Run(tank, csv, options).outcome();
}

}  // namespace random_tanks
