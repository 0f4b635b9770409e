// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <memory>
#include <optional>

#include "flow_balance.hpp"

namespace gas {

/// The right-hand side as a stepper sees it: dy/dx with t = x, or t = origin + x^2 from the moment when
/// outflow starts at p = p_a, where mdot ~ sqrt(t - origin) is no smooth function of t but one of x.
struct Rates {
  FlowBalance& balance;
  bool root = false;
  double origin = 0.0;                    // [s]
  bool valid = true;                      // every evaluation so far met a valid gas
  std::optional<std::size_t> depleted{};  // species that the first invalid one lacked
  int evaluations = 0;

  double time(double x) const { return root ? origin + x * x : x; }
  double time_slope(double x) const { return root ? 2.0 * x : 1.0; }  // dt/dx
  double position(double t) const { return root ? std::sqrt(t - origin) : t; }
  void operator()(const FlowBalance::Vector& y, FlowBalance::Vector& dydx, double x);
  /// The same for a gas; and the rates of the gas, d(gas)/dx, that go with dydx.
  void of_gas(const FlowBalance::Gas& gas, FlowBalance::Vector& dydx, double x);
  /// The same for a gas as if it were at `change` [Pa] more than the pressure of `at`.
  void of_gas(const FlowBalance::Gas& gas, FlowBalance::Vector& dydx, double x, const FlowBalance::Point& at,
              double change);
  void gas_rates(const FlowBalance::Vector& dydx, FlowBalance::Gas& rates, double x) const;
  /// The derivative of those with x that goes with the flows'.
  void gas_slope(const FlowBalance::Vector& slope, FlowBalance::Gas& gas_slope, double x) const;
  /// As operator() where the balance has located the gas.
  void fill(FlowBalance::Vector& dydx, double x);
  /// From steps in the root to the same in t, once h is short against the time since the origin: there t is
  /// as smooth, and a balance that is steady in t is not in the root. True if so; the rates are then to be
  /// filled anew.
  bool leave_root(double t, double& x, double& h);
};

/// One step of a method: y at x to `end` at x + h, `end_rate` there; the balance is left at the end. With
/// `estimate` also the local error of `end`.
class Stepper {
 public:
  using Vector = FlowBalance::Vector;
  struct Trial {
    Vector end, end_rate, error;
    double reversed = 0.0;  // [kg] that would have flowed the wrong way
  };

  virtual ~Stepper() = default;
  virtual void step(Rates& rates, const Vector& y, const Vector& dydx, double x, double h, bool estimate,
                    Trial& out) = 0;
  /// The error of a step grows as h to this power.
  virtual double error_power() const = 0;
  /// That of its Method.
  virtual double stability_limit() const = 0;
};

std::unique_ptr<Stepper> make_stepper(Method method, const FlowBalance& balance);
std::unique_ptr<Stepper> make_rosenbrock_stepper(const FlowBalance& balance);

}  // namespace gas
