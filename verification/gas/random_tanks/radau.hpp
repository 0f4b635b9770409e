// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace random_tanks {

/// dy/dt = f(t, y), of which a trial point may be outside.
class Ode {
 public:
  virtual ~Ode() = default;
  virtual std::size_t size() const = 0;
  virtual bool rates(double t, std::span<const double> y, std::span<double> dydt) const = 0;
  virtual bool jacobian(double t, std::span<const double> y, std::span<double> dydt,
                        std::span<double> jacobian) const = 0;
  /// Sizes against which errors of the unknowns count.
  virtual void sizes(double t, std::span<const double> y, std::span<double> size) const = 0;
};

/// Radau IIA of order 5 (Hairer and Wanner, Solving Ordinary Differential Equations II, sec. IV.5), by
/// Newton's method on all stages at once; never evaluates the rates at the start of a step. Error by step
/// doubling.
class Radau {
 public:
  Radau(const Ode& ode, double tolerance);

  /// One step of length h from (t, y) to `end`; false if Newton's method fails.
  bool step(double t, double h, std::span<const double> y, std::span<double> end);

  /// Two steps of h / 2 from (t, y) to `end`, by way of `middle`; the difference to one step of h in
  /// tolerances, infinite if a step fails.
  double pair(double t, double h, std::span<const double> y, std::span<double> middle, std::span<double> end);

  /// End of the one step of the last pair, as step() gives it.
  std::span<const double> single() const { return whole_; }

  /// The next step begins where the last pair ended, and guesses its stages from there; or does not.
  void go_on();
  void begin_anew() { before_.length = 0.0; }

 private:
  /// The changes at the stages of a step: a polynomial in time.
  struct Course {
    double length = 0.0;  // [s]; 0: none
    std::vector<double> changes;
  };
  bool step_guessed(double t, double h, std::span<const double> y, std::span<double> end,
                    const Course& course, double from);
  void guess(const Course& course, double from, double h);
  bool newton(double t, double h, std::span<const double> y, std::span<double> end, bool full);
  bool fill_matrix(double t, double h, std::span<const double> y, bool full);
  bool decompose();
  void solve(std::vector<double>& b) const;

  const Ode& ode_;
  const std::size_t n_;
  const double tolerance_;
  std::vector<double> z_, rate_, right_, matrix_, block_, point_, size_, whole_;
  std::vector<std::size_t> pivots_;
  Course before_, pair_end_;
};

}  // namespace random_tanks
