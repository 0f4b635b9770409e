// SPDX-License-Identifier: Apache-2.0
// Reference numbers: 40-digit arithmetic (mpmath), rounded to 17 digits: eigenvalues of 6 x 6 element
// matrices, logarithms of one step of the volume work, and the explicit formulas.
#include "closed_form/stability.hpp"

#include <numbers>

#include "check.hpp"

namespace {

using namespace closed_form;
using std::numbers::pi;
using test::expect_refused;
using test::expect_relative;
using test::kAlgebra;

TEST(ClosedFormStability, central_difference_eq_reference) {
  struct Row {
    double w, ratio, amplitude;
  };
  for (const Row& r : {Row{0.1, 1.0004171361154003, 0.0025}, Row{0.5, 1.0107210205683146, 0.0625},
                       Row{1.0, 1.0471975511965977, 0.25}, Row{1.9, 1.3191956815825003, 0.9025},
                       Row{1.99, 1.4781453398827704, 0.990025}}) {
    expect_relative(central_difference(r.w).frequency_ratio, r.ratio, kAlgebra);
    expect_relative(central_difference(r.w).energy_amplitude, r.amplitude, kAlgebra);
    EXPECT_EQ(central_difference(r.w).growth_per_step, 1.0);
  }
  // W^2 - 4 = 0.004: 2.001 itself is known to 1e-16/0.001.
  expect_relative(central_difference(2.001).growth_per_step, 1.0652855851326756, kAlgebra);
  expect_relative(critical_time_step(2.8084668044552369), 0.71213232672975937, kAlgebra);
}

// x_{n+1} = 2 x_n - x_{n-1} - W^2 x_n, run for many steps.
TEST(ClosedFormStability, central_difference_eq_recursion) {
  for (const double w : {0.3, 1.2, 1.95}) {
    const double phase = w * central_difference(w).frequency_ratio;
    double before = std::cos(-phase);
    double now = 1.0;
    for (int n = 1; n <= 100; ++n) {
      const double next = (2.0 - w * w) * now - before;
      before = now;
      now = next;
      EXPECT_NEAR(now, std::cos(n * phase), 1e-11);  // 100 steps, condition 1/sin(phase) < 5
    }
  }
  for (const double w : {2.001, 2.2}) {
    double before = 1.0;
    double now = 1.1;
    double ratio = 0.0;
    for (int n = 0; n < 1000; ++n) {
      const double next = (2.0 - w * w) * now - before;
      ratio = std::abs(next / now);
      before = now / std::abs(next);
      now = next / std::abs(next);
    }
    expect_relative(ratio, central_difference(w).growth_per_step, 1e-12);
  }
}

TEST(ClosedFormStability, triangle_steps_eq_reference) {
  const Sheet fabric = paper_fabric();
  const double c = wave_speeds(fabric).plane;
  const double equilateral = equilateral_triangle_frequency(fabric, 0.01);
  expect_relative(equilateral * equilateral, 8294930875.5760369, kAlgebra);
  expect_relative(critical_time_step(equilateral), 2.1959558789334139e-5, kAlgebra);
  expect_relative(critical_time_step(equilateral) * c / 0.01, 0.71611487403943288, kAlgebra);
  const double right = right_triangle_frequency(fabric, 0.01);
  expect_relative(right * right, 9976066963.0011274, kAlgebra);
  expect_relative(critical_time_step(right), 2.0023976082126998e-5, kAlgebra);
  expect_relative(critical_time_step(right) * c / (0.01 / std::sqrt(2.0)), 0.92347342032033057, kAlgebra);
  expect_relative(critical_time_step(triangle_frequency(fabric, 1.0, 0.5, 0.1)) * c / 0.1,
                  0.94223693789539509, 1e-13);
  expect_relative(critical_time_step(triangle_frequency(fabric, 1.0, 0.5, 0.01)) * c / 0.01,
                  0.94280338409229738, 1e-12);
}

TEST(ClosedFormStability, triangle_frequency_eq_special_shapes) {
  for (const Sheet& sheet : {paper_fabric(), Sheet{2e8, 0.45, 1e-3, 900.0}, Sheet{1e7, 0.0, 1e-3, 300.0}})
    for (const double a : {0.003, 0.02}) {
      expect_relative(triangle_frequency(sheet, a, 0.5 * a, std::sqrt(0.75) * a),
                      equilateral_triangle_frequency(sheet, a), 1e-13);
      expect_relative(triangle_frequency(sheet, a, 0.0, a), right_triangle_frequency(sheet, a), 1e-13);
      // The unbounded meshes reach dt = h_min/c exactly.
      const double c = wave_speeds(sheet).plane;
      expect_relative(critical_time_step(equilateral_mesh_frequency(sheet, a)), std::sqrt(0.75) * a / c,
                      kAlgebra);
      expect_relative(critical_time_step(right_mesh_frequency(sheet, a)), std::sqrt(0.5) * a / c, kAlgebra);
    }
  const double m_point = equilateral_mesh_frequency(paper_fabric(), 0.01);
  expect_relative(m_point * m_point * 620.0 * 1e-4 / 60e6, 5.8608058608058608, kAlgebra);
}

TEST(ClosedFormStability, gas_breathing_eq_reference) {
  const double R = 0.30598317419458695;
  const EnclosedGas sphere{{}, 121325.0, 4.0 / 3.0 * pi * R * R * R, 4.0 * pi * R * R, 0.31};
  expect_relative(gas_breathing_frequency(sphere), 2317.7691364952587, kAlgebra);
  expect_relative(critical_time_step(gas_breathing_frequency({{}, 101325.0, 1e-4, 1.2, 0.31})),
                  2.6989689948728304e-5, kAlgebra);
  expect_relative(critical_time_step(gas_breathing_frequency({{}, 101325.0, 0.12, 1.2, 0.31})),
                  0.0009349502854345694, kAlgebra);
  // The sphere's closed form without membrane stiffness is the same number.
  EXPECT_NEAR(std::pow(gas_breathing_frequency(sphere), 2) + std::pow(1718.4947617911246, 2),
              std::pow(2885.355786795367, 2), 1e-6);
}

TEST(ClosedFormStability, lagged_pressure_eq_reference_and_recursion) {
  expect_relative(lagged_pressure_growth(0.0, 0.01), 1.0000499987500625, kAlgebra);
  expect_relative(lagged_pressure_growth(0.0, 0.1), 1.004987562112089, kAlgebra);
  expect_relative(lagged_pressure_growth(0.0, 0.5), 1.1180339887498948, kAlgebra);
  expect_relative(std::pow(lagged_pressure_growth(0.0, 0.1), 2 * 2 * pi / 0.1), 1.8686153950949946, 1e-12);
  for (const double ws : {0.5, 1.5, 2.5})
    for (const double wg : {0.2, 0.8}) {
      double before = 1.0;
      double now = 0.7;
      double growth = 0.0;
      for (int n = 0; n < 4000; ++n) {
        const double next = (2.0 - ws * ws) * now - before * (1.0 + wg * wg);
        const double size = std::hypot(next, now);
        growth += std::log(size / std::hypot(now, before));
        before = now / size;
        now = next / size;
      }
      // The bounded oscillation of the norm leaves 1/n.
      EXPECT_NEAR(std::exp(growth / 4000), lagged_pressure_growth(ws, wg), 2e-3);
    }
}

TEST(ClosedFormStability, volume_work_drift_eq_reference_and_leading_term) {
  // Sums of terms of size delta: absolute error 1e-18 for Euler, 1e-21 in extended precision.
  EXPECT_NEAR(euler_volume_work_drift(1.4, 0.01), -2.788905627158521e-5, 1e-17);
  EXPECT_NEAR(euler_volume_work_drift(1.4, -0.001), -2.8011210647801941e-7, 1e-18);
  EXPECT_NEAR(trapezoid_volume_work_drift(1.4, 0.01), -1.1034151156301334e-7, 1e-19);
  EXPECT_NEAR(trapezoid_volume_work_drift(1.4, 0.001), -1.1183221746399152e-10, 1e-19);
  EXPECT_NEAR(trapezoid_volume_work_drift(1.4, -0.001), 1.1216821799263225e-10, 1e-19);
  for (const double gamma : {1.25, 1.4, 5.0 / 3.0}) {
    expect_relative(euler_volume_work_drift(gamma, 1e-5), -gamma * (gamma - 1) * 0.5e-10, 1e-4);
    expect_relative(trapezoid_volume_work_drift(gamma, 1e-3), -gamma * (gamma * gamma - 1) / 12e9, 1e-2);
  }
}

TEST(ClosedFormStability, vent_equalisation_eq_reference) {
  const VentEqualisation vent{{}, 0.06, 1e-3, 101325.0, 400.0};
  expect_relative(vent_equalisation_rate(vent), 1809.5977085160853, kAlgebra);
  expect_relative(vent_eigenvalue(vent, 1000.0), -57.22450407532307, kAlgebra);
  expect_relative(vent_eigenvalue(vent, 1e-3), -57224.50407532307, kAlgebra);
  for (const double dt : {1e-3, 1e-4, 1e-5})
    expect_relative(vent_chatter_amplitude(vent, dt), 3.2746438666666667 * dt * dt * 1e6, kAlgebra);
  VentEqualisation larger = vent;
  larger.volume *= 2.0;
  larger.temperature *= 4.0;
  expect_relative(vent_equalisation_rate(larger), vent_equalisation_rate(vent), kAlgebra);
}

TEST(ClosedFormStability, node_contact_eq_reference) {
  expect_relative(node_contact_time_step(paper_fabric(), 1e-4, 1e5), 3.5213633723318018e-5, kAlgebra);
  expect_relative(node_contact_time_step(paper_fabric(), 4e-4, 1e5), 2 * 3.5213633723318018e-5, kAlgebra);
}

TEST(ClosedFormStability, bad_parameters_are_refused_by_name) {
  expect_refused([] { central_difference(0.0); }, "omega_dt");
  expect_refused([] { triangle_frequency(paper_fabric(), 1.0, 0.0, -1.0); }, "height");
  expect_refused([] { euler_volume_work_drift(1.4, -1.0); }, "delta");
  expect_refused([] { gas_breathing_frequency({}); }, "pressure");
}

}  // namespace
