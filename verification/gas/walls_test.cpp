// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "bisection.hpp"
#include "cases.hpp"
#include "claim.hpp"
#include "real_axis_limit.hpp"
#include "rosenbrock_step.hpp"

// Heat through the walls: where each method fails, and the first gas of an evacuated volume, which has no
// heat capacity.
namespace {

using namespace cases;

struct Limit {
  gas::Method method;
  const char* name;
  double value;  // of h lambda
};
const Limit kLimits[] = {
    {gas::Method::euler, "explicit Euler", support::real_axis_limit(support::kEulerPolynomial)},
    {gas::Method::runge_kutta_4, "Runge-Kutta 4", support::real_axis_limit(support::kRungeKutta4Polynomial)},
    {gas::Method::dormand_prince_5, "Dormand-Prince 5",
     support::real_axis_limit(support::kDormandPrince5Polynomial)}};

/// Gas at rest: dT/dt = -(hA/(m cv)) (T - T_ext), whose growth is the method's stability function.
TEST(walls, threshold_eq_their_relaxation_rate) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.heat_loss = {200.0, 400.0};
  const gas::ControlVolumeState start = gas::make_state(model, kPure, 2e5, 400.001, 0.06);
  const double rate = 200.0 / (start.masses[0] * 742.0);
  const auto growth = [&](gas::Method method, double h, bool unsafe) {
    gas::ControlVolumeState state = start;
    gas::GasIntegrator(model, {1e-10, 100000, method, h, unsafe}).advance(state, 0.0, 50.0 * h, rigid(0.06));
    return std::abs(state.temperature - 400.0) / 1e-3;
  };
  for (const auto& [method, name, limit] : kLimits) {
    const double h = limit / rate;
    const double measured = claim::largest_passing(
        0.5 * h, 1.02 * h, 1e-4, [&, m = method](double step) { return growth(m, step, true) < 1.0; });
    claim::expect_threshold(
        {"G.16", name, "bisection to 1e-4; the disturbance, 2e-6 of T, changes the rate by as much"},
        {"explicit stepper, by order", "h λ_w = 2, 2.785, 3.307 by order 1, 4, 5", h, measured, "s",
         "fixed sub-steps: error with step and limit; error control: smaller sub-steps; Rosenbrock: no "
         "limit"},
        1.0 - 2e-4, 1.0 + 2e-4);
    EXPECT_LT(growth(method, 0.99 * h, false), 1.0) << static_cast<int>(method);
    EXPECT_THROW(growth(method, 1.01 * h, false), gas::DomainError) << static_cast<int>(method);
  }
}

/// u after one step of u' = -z u from 1: the method's stability function.
double rosenbrock_growth(double z) {
  const auto rates = [&](const std::array<double, 2>& u, std::array<double, 2>& rate, double) {
    rate = {-z * u[0], 0.0};
  };
  return rosenbrock_step(rates, {1.0, 1.0}, 1.0)[0];
}

/// The implicit method has no limit: in one step a disturbance falls to |R(-z)|, below 1 at any z = h lambda.
TEST(walls, implicit_method_damps_at_any_step) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.heat_loss = {200.0, 400.0};
  const gas::ControlVolumeState start = gas::make_state(model, kPure, 2e5, 401.0, 0.06);
  const double rate = 200.0 / (start.masses[0] * 742.0);
  for (const double z : {1.0, 10.0, 100.0, 1e4}) {
    const double h = z / rate, predicted = rosenbrock_growth(z);
    EXPECT_LT(std::abs(predicted), 1.0);
    gas::ControlVolumeState state = start;
    gas::GasIntegrator(model, {1e-10, 100000, gas::Method::rosenbrock_4, h})
        .advance(state, 0.0, h, rigid(0.06));
    std::ostringstream name;
    name << "Rosenbrock 4, h λ_w = " << z;
    claim::expect_threshold({"G.16", name.str(), "linear: a hundred roundings of 400 K, of 9e-4 K or more"},
                            {"implicit stepper", "|R(−h λ_w)| of a step, below 1 for any",
                             std::abs(predicted), std::abs(state.temperature - 400.0), "", "no limit"},
                            1.0 - 1e-8, 1.0 + 1e-8);
  }
}

/// Evacuated tank filled at a flow that is constant or grows from zero, of an inflator or through a vent that
/// opens to ambient gas; hA = ratio mdot cv.
struct Fill {
  double ratio;
  bool ramp;
  bool vent = false;
};

/// Area [m2] through which gas at 101325 Pa and 700 K flows at 2 kg/s into a vacuum.
double sonic_area() {
  return 2.0 / (101325.0 * std::sqrt(1.4 / (0.4 * 742.0 * 700.0)) * std::pow(2.0 / 2.4, 3.0));
}

double temperature(const Fill& fill, gas::Method method, double tolerance, double h) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.inflows.push_back(steady_inflow(model.thermo, 1.0, 700.0));
  if (fill.ramp) model.inflows[0].mass_flow = gas::Curve({{0.0, 0.0}, {1e-3, 2.0}}, gas::Outside::zero);
  if (fill.vent) {
    model.inflows.clear();
    model.ambient = {kAmbientPressure, 700.0, kPure};
    model.vents = {{.discharge_coefficient = 1.0,
                    .area = 0.0,
                    .area_of_time = gas::Curve({{0.0, 0.0}, {1e-3, sonic_area()}}, gas::Outside::held),
                    .backflow = true}};
  }
  model.heat_loss = {fill.ratio * 742.0, 300.0};
  gas::ControlVolumeState state = gas::make_state(model, kPure, 0.0, 300.0, 0.06);
  const double end = h > 0.0 && !fill.ramp ? 20.0 * h : 1e-3;
  gas::GasIntegrator(model, {tolerance, 10000000, method, h}).advance(state, 0.0, end, rigid(0.06));
  return state.temperature;
}

/// There is no scale of time: hA/(mdot cv) alone decides, for any step.
TEST(walls, evacuated_fill_has_a_threshold_without_scale) {
  const auto error = [](gas::Method method, double ratio, double h) {
    return relative(temperature({ratio, false}, method, 1e-10, h),
                    (1.4 * 700.0 + ratio * 300.0) / (1.0 + ratio));
  };
  for (const auto& [method, name, limit] : kLimits) {
    for (const double h : {1e-9, 1e-6, 1e-3}) {
      claim::expect_near(
          {"G.16", "evacuated fill with heat loss, 1 % below the limit of each explicit method: T",
           "exact solution linear in time: rounding, hardly amplified"},
          error(method, 0.99 * limit, h), 0.0, 1e-12);
      EXPECT_THROW(error(method, 1.01 * limit, h), gas::DomainError) << static_cast<int>(method);
    }
    const auto right = [&, m = method](double ratio) {
      try {
        return error(m, ratio, 1e-6) < 1e-12;
      } catch (const gas::DomainError&) {
        return false;
      }
    };
    claim::expect_threshold({"G.16", name, "bisection to 1e-4 on what is accepted, and then right to 1e-12"},
                            {"evacuated tank with walls", "hA/(ṁ c_v) = 2, 2.785, 3.307, whatever the step",
                             limit, claim::largest_passing(0.5 * limit, 2.0 * limit, 1e-4, right), "",
                             "fixed sub-steps: error with step and limit; error control and Rosenbrock: "
                             "right to their tolerance"},
                            1.0 - 1e-4, 1.0 + 1e-4);
  }
  // Error control takes as many sub-steps as it needs; Rosenbrock has no limit.
  for (const gas::Method method : kMethods) EXPECT_LT(error(method, 100.0, 0.0), 1e-8);
  for (const double h : {1e-9, 1e-6, 1e-3}) EXPECT_LT(error(gas::Method::rosenbrock_4, 100.0, h), 1e-6);
}

/// A flow that grows from zero, mdot = s t: dT/dt = (2/t) (gamma T_in - T) - (a/t^2) (T - T_ext), a = 2 hA/(s
/// cv), so T = int_0^t exp(a/t - a/x) (2 gamma T_in x + a T_ext) dx/t^2; by Simpson's rule, 1e-12 at this
/// number of points.
double ramp_fill(double ratio, double t) {
  const double a = 2.0 * ratio * 742.0 / (2000.0 * 742.0);
  const int n = 20000;
  double sum = 0.0;
  for (int i = 1; i <= n; ++i) {
    const double x = t * i / n, weight = i == n ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    sum += weight * std::exp(a / t - a / x) * (2.0 * 1.4 * 700.0 * x + a * 300.0);
  }
  return sum * t / (3.0 * n) / (t * t);
}

TEST(walls, evacuated_fill_from_zero_flow_eq_quadrature) {
  for (const double ratio : {0.1, 1.0, 10.0})
    for (const auto& [method, tolerance] :
         std::vector<std::pair<gas::Method, double>>{{gas::Method::dormand_prince_5, 1e-8},
                                                     {gas::Method::runge_kutta_4, 1e-8},
                                                     {gas::Method::rosenbrock_4, 1e-8},
                                                     {gas::Method::euler, 1e-5}})
      for (const bool vent : {false, true})
        claim::expect_relative(
            {"G.11",
             vent ? "evacuated fill by a vent that opens from zero, each method: temperature [K]"
                  : "evacuated fill from zero flow, each method: temperature [K]",
             "some hundred sub-steps (Euler: a thousand), most of them forgotten"},
            temperature({ratio, true, vent}, method, tolerance, 0.0), ramp_fill(ratio, 1e-3),
            100.0 * tolerance);
}

}  // namespace
