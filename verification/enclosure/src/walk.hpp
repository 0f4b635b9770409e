// SPDX-License-Identifier: Apache-2.0
// The tube of a tank, step by step.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "enclosure/enclose.hpp"
#include "law.hpp"
#include "moving_set.hpp"

namespace enclosure {

template <class Number>
class SeriesOf;
template <class Number>
struct SetSeries;

/// What holds over a span that may reach over switches.
struct Crossing {
  Balls end;              // unknowns at its end, as a box; at the joint with T in place of p
  Balls step;             // what was added to the unknowns and stream totals
  std::vector<int> seen;  // side of each surface all along, 0: not one
  double width = 0.0;     // [-] largest width added; up to a tenth of the set's it counts as the tolerance
  bool decided = false;   // every surface has a side at the end
  bool at_joint = false;  // the temperature comes from the energy
};

/// Where a walk is.
struct Place {
  Ball time;
  MovingSet set;
};

/// Moves a set of states through time. The unknowns are those of Law, then the total of each stream.
class Walk {
 public:
  /// Starts at time `start` in a box of mass, temperature, mass fractions and totals; `tolerance` is the
  /// width that a step may add.
  Walk(const Tank& tank, const Ball& start, const Balls& box, double tolerance);
  /// Goes on from where a walk is, of the same scene after other events.
  Walk(const Tank& tank, const Place& place, double tolerance);
  Walk(const Walk&) = delete;
  Walk& operator=(const Walk&) = delete;
  ~Walk();

  /// Takes one step, at most to the exact time `end`. No function of time changes its formula before `end`.
  void step(const Ball& end);
  /// Steps to `end` at once, across changes of functions of time at uncertain times.
  void cross_to(const Ball& end);

  const Ball& time() const { return time_; }
  Place place() const { return {time_, set_}; }
  /// Side of each surface now: 1 above, -1 below, 0 undecided.
  std::vector<int> sides_now() { return sides(set_.box(), {time_, time_}); }
  /// True if the last step may have been on both sides of a surface.
  bool met(std::size_t surface) const { return !met_.empty() && met_[surface] == 0; }
  Ball temperature() const;
  /// Pressure, temperature, volume, mass, mass fractions of all species, totals of the streams.
  Balls values();
  long steps = 0, crossings = 0;

 private:
  struct Work;
  using Sides = std::vector<int>;  // 1 above, -1 below, 0 undecided

  Work& work(const Regime& regime);
  Ball volume(const Span& span) const;
  Ball gas_constant(const Balls& box) const;
  Ball pressure_of_kelvin(const Balls& box, const Span& span) const;
  std::vector<double> scales(const Balls& box) const;
  Sides sides(const Balls& box, const Span& span);
  std::vector<Regime> regimes(const Sides& sides) const;
  static Regime regime(const Sides& sides);
  Balls core(const Balls& x) const { return {x.begin(), x.begin() + static_cast<long>(unknowns_)}; }

  bool taylor(const Regime& regime, const Ball& end);
  template <class Number>
  bool taylor_with(Work& work, SetSeries<Number>& series, const Regime& regime, const Ball& end, int most);
  template <class Number>
  bool try_length(Work& work, SetSeries<Number>& series, const Regime& regime, Ball& length);
  std::optional<Ball> root(Work& work, std::size_t surface, const Ball& length) const;
  template <class Number>
  std::optional<Ball> first_root(Work& work, const SeriesOf<Number>& boxed, const Ball& length, Ball& margin,
                                 bool& is_watched) const;
  template <class Number>
  slong first_narrow(const Work& work, const SeriesOf<Number>& boxed, const Ball& h,
                     const std::vector<double>& scale) const;
  template <class Number>
  Ball first_length(const Work& work, const SeriesOf<Number>& boxed, const Ball& end) const;

  std::optional<Crossing> crossing(const Ball& end);
  Balls rates_over(const Balls& box, const Span& span, Mode mode, Sides& seen);
  struct Energies;
  Energies energies(const Balls& box) const;
  Ball energy();
  Ball temperature_of(const Balls& box, const Ball& energy) const;
  void hold(const Balls& box);
  bool cross(const Ball& first, const Ball& end);
  bool is_fed(const Ball& end) const;
  std::optional<Balls> lifted(const Balls& box, bool high, Ball& inflow);
  bool rest(const Sides& now, const Ball& end);
  void apply(const Crossing& crossing, const Ball& end);

  const Tank& tank_;
  const std::size_t unknowns_, streams_;
  const double tolerance_;
  Ball time_;
  MovingSet set_;
  std::map<Regime, std::unique_ptr<Work>> works_;
  Ball approach_;     // [s] > 0: the set is this close before a switch
  Ball last_length_;  // [s] of the last step
  int undecided_ = 0;
  Sides met_;  // of the last crossing; none of a step by series
};

}  // namespace enclosure
