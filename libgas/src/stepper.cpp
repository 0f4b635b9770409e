// SPDX-License-Identifier: Apache-2.0
#include "stepper.hpp"

#include <boost/numeric/odeint/stepper/euler.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4_classic.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <limits>

namespace gas {
namespace {

namespace odeint = boost::numeric::odeint;
using Vector = Stepper::Vector;

// Steps up to a sixteenth of the time since the onset: each further term of sqrt(t) is less than a sixteenth
// of the last.
constexpr double kRootShare = 1.0 / 16.0;

class DormandPrinceStepper : public Stepper {
 public:
  explicit DormandPrinceStepper(std::size_t unknowns) { method_.adjust_size(Vector(unknowns)); }
  void step(Rates& rates, const Vector& y, const Vector& dydx, double x, double h, bool,
            Trial& out) override {
    method_.do_step([&](const Vector& a, Vector& b, double s) { rates(a, b, s); }, y, dydx, x, out.end,
                    out.end_rate, h, out.error);
  }
  double error_power() const override { return 5.0; }
  double stability_limit() const override { return gas::stability_limit(Method::kDormandPrince5); }

 private:
  odeint::runge_kutta_dopri5<Vector> method_;
};

/// A method without an error estimate of its own: two half steps, compared with the whole one.
template <class Method, int Order>
class DoublingStepper : public Stepper {
 public:
  DoublingStepper(std::size_t unknowns, double limit)
      : middle_(unknowns), middle_rate_(unknowns), limit_(limit) {
    method_.adjust_size(middle_);
  }
  void step(Rates& rates, const Vector& y, const Vector& dydx, double x, double h, bool estimate,
            Trial& out) override {
    const auto system = [&](const Vector& a, Vector& b, double s) { rates(a, b, s); };
    if (!estimate) {
      method_.do_step(system, y, dydx, x, out.end, h);
      rates(out.end, out.end_rate, x + h);
      return;
    }
    method_.do_step(system, y, dydx, x, out.error, h);
    method_.do_step(system, y, dydx, x, middle_, 0.5 * h);
    rates(middle_, middle_rate_, x + 0.5 * h);
    method_.do_step(system, middle_, middle_rate_, x + 0.5 * h, out.end, 0.5 * h);
    rates(out.end, out.end_rate, x + h);
    constexpr double kShare = 1.0 / ((1 << Order) - 1);  // Richardson
    for (std::size_t i = 0; i < middle_.size(); ++i) out.error[i] = kShare * (out.end[i] - out.error[i]);
  }
  double error_power() const override { return Order + 1.0; }
  double stability_limit() const override { return limit_; }

 private:
  Method method_;
  Vector middle_, middle_rate_;
  double limit_;
};

}  // namespace

void Rates::operator()(const Vector& y, Vector& dydx, double x) {
  balance.locate(y, time(x));
  fill(dydx, x);
}

void Rates::of_gas(const FlowBalance::Gas& gas, Vector& dydx, double x) {
  balance.locate_gas(gas, time(x));
  fill(dydx, x);
}

void Rates::of_gas(const FlowBalance::Gas& gas, Vector& dydx, double x, const FlowBalance::Point& at,
                   double change) {
  balance.locate_gas(gas, time(x));
  balance.move_pressure(at, change);
  fill(dydx, x);
}

void Rates::gas_rates(const Vector& dydx, FlowBalance::Gas& rates, double x) const {
  balance.gas_change(dydx, rates);
  balance.add_inflow_rates(time_slope(x), time(x), rates);
}

void Rates::gas_slope(const Vector& slope, FlowBalance::Gas& gas_slope, double x) const {
  balance.gas_change(slope, gas_slope);
  const double dtdx = time_slope(x);
  if (root) balance.add_inflow_rates(2.0, time(x), gas_slope);
  balance.add_inflow_slopes(dtdx * dtdx, time(x), gas_slope);
}

void Rates::fill(Vector& dydx, double x) {
  balance.fill_rates(dydx, time(x));
  if (valid && !balance.point().valid) depleted = balance.point().depleted;
  valid = valid && balance.point().valid;
  ++evaluations;
  if (root)
    for (double& rate : dydx) rate *= time_slope(x);
}

bool Rates::leave_root(double t, double& x, double& h) {
  const double length = time(x + h) - t;
  if (!root || length > kRootShare * (t - origin)) return false;
  root = false;
  x = t;
  h = length;
  return true;
}

double stability_limit(Method method) {
  switch (method) {
    case Method::kEuler:
      return 2.0;
    case Method::kRungeKutta4:
      return 2.7852935634;
    case Method::kDormandPrince5:
      return 3.3065678926;
    case Method::kRosenbrock4:
      break;
  }
  return std::numeric_limits<double>::infinity();
}

std::unique_ptr<Stepper> make_stepper(Method method, const FlowBalance& balance) {
  const std::size_t n = balance.unknowns();
  switch (method) {
    case Method::kEuler:
      return std::make_unique<DoublingStepper<odeint::euler<Vector>, 1>>(n, stability_limit(method));
    case Method::kRungeKutta4:
      return std::make_unique<DoublingStepper<odeint::runge_kutta4_classic<Vector>, 4>>(
          n, stability_limit(method));
    case Method::kRosenbrock4:
      return make_rosenbrock_stepper(balance);
    case Method::kDormandPrince5:
      break;
  }
  return std::make_unique<DormandPrinceStepper>(n);
}

}  // namespace gas
