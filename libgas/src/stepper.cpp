// SPDX-License-Identifier: Apache-2.0
#include "stepper.hpp"

#include <boost/numeric/odeint/stepper/euler.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4_classic.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include "limits.hpp"

namespace gas {
namespace {

namespace odeint = boost::numeric::odeint;

class DormandPrince : public Stepper {
 public:
  explicit DormandPrince(std::size_t size) : zero_(size, 0.0) { method_.adjust_size(zero_); }
  void step(System& system, const Vector& dydx, double x, double h, bool, Trial& out) override {
    method_.do_step([&](const Vector& y, Vector& rate, double s) { system.rates(y, rate, s); }, zero_, dydx,
                    x, out.end, out.end_rate, h, out.error);
  }
  double error_power() const override { return 5.0; }

 private:
  const Vector zero_;
  odeint::runge_kutta_dopri5<Vector> method_;
};

/// Error estimate for a method that has none: two half steps are compared with one whole step.
template <class Method, int Order>
class Doubling : public Stepper {
 public:
  explicit Doubling(std::size_t size) : zero_(size, 0.0), middle_(size), middle_rate_(size) {
    method_.adjust_size(zero_);
  }
  void step(System& system, const Vector& dydx, double x, double h, bool estimate, Trial& out) override {
    const auto rates = [&](const Vector& y, Vector& rate, double s) { system.rates(y, rate, s); };
    Vector& whole = estimate ? out.error : out.end;
    method_.do_step(rates, zero_, dydx, x, whole, h);
    if (estimate) {
      method_.do_step(rates, zero_, dydx, x, middle_, 0.5 * h);
      system.rates(middle_, middle_rate_, x + 0.5 * h);
      method_.do_step(rates, middle_, middle_rate_, x + 0.5 * h, out.end, 0.5 * h);
      constexpr double kShare = 1.0 / ((1 << Order) - 1);  // Richardson
      for (std::size_t i = 0; i < middle_.size(); ++i) out.error[i] = kShare * (out.end[i] - whole[i]);
    }
    system.rates(out.end, out.end_rate, x + h);
  }
  double error_power() const override { return Order + 1.0; }

 private:
  const Vector zero_;
  Method method_;
  Vector middle_, middle_rate_;
};

}  // namespace

void System::rates(const Vector& y, Vector& dydx, double x) {
  valid = valid && ledger.gas_at(y, clock.time(x), gas);
  rates_of(gas, dydx, x);
}

void System::rates_of(const Vector& amount, Vector& dydx, double x) {
  ++effort.evaluations;
  valid = valid && balance.locate(amount, clock.time(x));
  if (!valid) {
    std::ranges::fill(dydx, 0.0);
    return;
  }
  balance.fill_rates(dydx);
  if (clock.root)
    for (double& rate : dydx) rate *= clock.slope(x);
}

double stability_limit(Method method) {
  switch (method) {
    case Method::euler:
      return 2.0;
    case Method::runge_kutta_4:
      return 2.7852935634;
    case Method::dormand_prince_5:
      return 3.3065678926;
    case Method::rosenbrock_4:
      break;
  }
  return kInfinity;
}

std::unique_ptr<Stepper> make_explicit(Method method, const Slots& slots) {
  if (method == Method::euler) return std::make_unique<Doubling<odeint::euler<Vector>, 1>>(slots.size());
  if (method == Method::runge_kutta_4)
    return std::make_unique<Doubling<odeint::runge_kutta4_classic<Vector>, 4>>(slots.size());
  return std::make_unique<DormandPrince>(slots.size());
}

}  // namespace gas
