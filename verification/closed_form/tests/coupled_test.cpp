// SPDX-License-Identifier: Apache-2.0
#include "closed_form/coupled.hpp"

#include <numbers>

#include "check.hpp"
#include "closed_form/gas.hpp"

namespace {

using namespace closed_form;
using std::numbers::pi;
using test::expect_refused;
using test::expect_relative;
using test::kAlgebra;

TEST(ClosedFormCoupled, gas_piston_eq_reference) {
  const GasPiston piston{{}, 5.0, 0.05, 0.06, 1.5e5, 2e4};
  expect_relative(gas_piston_frequency(piston), 75.828754440515506, kAlgebra);
  expect_relative(gas_piston_isothermal_frequency(piston), 72.456883730947193, kAlgebra);
}

TEST(ClosedFormCoupled, gas_piston_eq_slope_of_the_adiabat) {
  const GasPiston piston{{208.13, 5.0 / 3.0}, 2.0, 0.01, 0.003, 2e5, 500.0};
  const AdiabaticPiston gas{piston.gas, piston.pressure, 300.0, piston.volume};
  const double dx = 1e-6;  // V changes by 3e-6: truncation 1e-11, round-off 1e-16/3e-6
  const double up = adiabatic_piston(gas, piston.volume + piston.area * dx).state.pressure;
  const double down = adiabatic_piston(gas, piston.volume - piston.area * dx).state.pressure;
  const double stiffness = piston.stiffness + piston.area * (down - up) / (2 * dx);
  expect_relative(gas_piston_frequency(piston), std::sqrt(stiffness / piston.mass), 1e-9);
}

TEST(ClosedFormCoupled, pendulum_gas_spring_reduces_to_its_parts) {
  PendulumGasSpring scene{{}, paper_pendulum(), 0.01, 0.02, 1.2e5};
  const double both = pendulum_gas_spring_frequency(scene);
  const PendulumConstants c = pendulum_constants(scene.pendulum);
  // Effective mass on the gas alone, and the swing alone.
  const double gas = gas_piston_frequency({scene.gas, c.effective_mass, 0.01, 0.02, 1.2e5});
  expect_relative(both * both, gas * gas + c.angular_frequency * c.angular_frequency, kAlgebra);
  scene.area = 1e-12;
  expect_relative(pendulum_gas_spring_frequency(scene), c.angular_frequency, kAlgebra);
}

TEST(ClosedFormCoupled, sphere_fill_balances_energy) {
  for (const double gamma : {1.3, 1.4}) {
    const SphereFill scene{{296.8, gamma}, {paper_fabric(), 0.3}, 9e4, 650.0};
    const SphereFillState start = sphere_fill(scene, 1.0);
    EXPECT_EQ(start.inflow_mass, 0.0);
    EXPECT_EQ(start.pressure, 9e4);
    for (const double stretch : {1.001, 1.1, 1.4}) {
      const SphereFillState s = sphere_fill(scene, stretch);
      const auto work = [&scene](double x) {  // p dV along the path, absolute pressure
        return (9e4 + stretched_sphere_pressure(scene.sphere, x)) * 4 * pi * 0.027 * x * x;
      };
      const double done = test::integrate(work, 1.0, stretch);
      expect_relative(s.strain_energy + s.ambient_work, done, 1e-11);
      const double gas = (s.pressure * s.volume - start.pressure * start.volume) / (gamma - 1);
      // dU = h dm - p dV, a difference of terms 300 times larger at the smallest stretch.
      expect_relative(s.inflow_mass * specific_heat_cp(scene.gas) * 650.0, gas + done, 1e-11);
      expect_relative(sphere_fill_stretch(scene, s.inflow_mass), stretch, kAlgebra);
    }
  }
}

TEST(ClosedFormCoupled, sphere_fill_is_a_rigid_tank_when_stiff) {
  Sheet stiff = paper_fabric();
  stiff.youngs_modulus = 1e15;
  const SphereFill scene{{}, {stiff, 0.3}, 101325.0, 700.0};
  const double volume = 4.0 / 3.0 * pi * 0.027;
  const GasState tank = tank_fill({{}, volume, 101325.0, 293.15, 1.0, 700.0}, 0.05);
  // Stretch of 5e-8: bisected to 2e-16, so the overpressure is good to 1e-8.
  const SphereFillState s = sphere_fill(scene, sphere_fill_stretch(scene, 0.05));
  expect_relative(s.pressure, tank.pressure, 1e-6);
}

TEST(ClosedFormCoupled, bad_parameters_are_refused_by_name) {
  expect_refused([] { gas_piston_frequency({}); }, "mass");
  expect_refused([] { pendulum_gas_spring_frequency({{}, paper_pendulum()}); }, "pressure");
  expect_refused([] { sphere_fill({{}, {paper_fabric(), 0.3}}, 1.1); }, "inflow_temperature");
  expect_refused([] { sphere_fill({{}, {paper_fabric(), 0.3}, 1e5, 700.0}, 0.9); }, "stretch");
}

}  // namespace
