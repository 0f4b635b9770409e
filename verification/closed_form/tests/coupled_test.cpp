// SPDX-License-Identifier: Apache-2.0
// Reference numbers: 40-digit arithmetic (mpmath), rounded to 17 digits: the definitions of
// closed_form/coupled.hpp.
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

TEST(ClosedFormCoupled, gas_spring_eq_reference) {
  const GasSpringSwing light = gas_spring({{}, 20.0, 0.03, 0.009}, 200.0);
  expect_relative(light.depth, 0.026217354327571013, 1e-12);
  expect_relative(light.period, 0.22342614589060728, 1e-12);
  expect_relative(light.peak_pressure, 115164.35688730425, 1e-12);
  const GasSpringSwing heavy = gas_spring({{296.8, 5.0 / 3.0}, 5.0, 0.05, 0.06, 9e4}, 2e4);
  expect_relative(heavy.depth, 1.061049876235483, 1e-12);
  expect_relative(heavy.period, 0.052705239494079552, 1e-12);
  expect_relative(heavy.peak_pressure, 3271746.8248345358, 1e-12);
}

// The period's next term is of the order of the amplitude, F/(2 p_a S): both forms are at the equilibrium.
TEST(ClosedFormCoupled, gas_spring_swings_like_the_linear_one_if_light) {
  const auto off = [](double load) {
    const GasSpring spring{{}, 5.0, 0.05, 0.06};
    const double force = load * spring.ambient_pressure * spring.area,
                 p = spring.ambient_pressure * (1 + load);
    const double volume = spring.volume * std::pow(1 + load, -1 / 1.4);
    const double linear = gas_piston_frequency({{}, spring.mass, spring.area, volume, p});
    return gas_spring(spring, force).period * linear / (2 * pi) - 1.0;
  };
  EXPECT_LT(std::abs(off(0.04)), 1e-3);
  EXPECT_NEAR(off(0.04) / off(0.02), 4.0, 0.2);  // of second order, the next term 0.04 of it
  EXPECT_LT(std::abs(off(1e-9)), 1e-12);         // 256 points, of which rounding takes some 100 ulp
}

TEST(ClosedFormCoupled, pressed_cylinder_has_the_work_of_its_pressure) {
  const PressedCylinder scene{{paper_fabric(), 0.15}, 6000.0};
  // Just in touch it is the free cylinder.
  const double free = 0.15 * fixed_length_cylinder(scene, scene.overpressure).hoop_stretch;
  const CylinderPress touched = pressed_cylinder(scene, free * (1 - 1e-9));
  EXPECT_NEAR(touched.flat_width, 0.0, 1e-8);
  expect_relative(touched.volume_per_length, pi * free * free, 1e-8);
  // Work of the plates, 2 int F dr, is that of the pressure and what the skin takes up.
  const auto& sheet = scene.sheet;
  const auto strain = [&](double stretch) {
    const double green = 0.5 * (stretch * stretch - 1.0);
    return pi * 0.15 * sheet.thickness * sheet.young_modulus / (1.0 - 0.09) * green * green;
  };
  const CylinderPress a = pressed_cylinder(scene, 0.14), b = pressed_cylinder(scene, 0.08);
  const auto force = [&](double r) { return 2.0 * pressed_cylinder(scene, r).force_per_length; };
  expect_relative(
      test::integrate(force, 0.08, 0.14),
      6000.0 * (a.volume_per_length - b.volume_per_length) + strain(b.hoop_stretch) - strain(a.hoop_stretch),
      1e-11);
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
      expect_relative(sphere_fill_by_mass(scene, s.inflow_mass).stretch, stretch, kAlgebra);
    }
  }
}

TEST(ClosedFormCoupled, sphere_fill_is_a_rigid_tank_when_stiff) {
  Sheet stiff = paper_fabric();
  stiff.young_modulus = 1e15;
  const SphereFill scene{{}, {stiff, 0.3}, 101325.0, 700.0};
  const double volume = 4.0 / 3.0 * pi * 0.027;
  const GasState tank = tank_fill({{}, volume, 101325.0, 293.15, 1.0, 700.0}, 0.05);
  const SphereFillState s = sphere_fill_by_mass(scene, 0.05);
  expect_relative(s.pressure, tank.pressure, 1e-6);
}

PressedBalloon pressed(double indenter_radius) {
  return {{paper_fabric(), 0.3}, 2e4, indenter_radius};
}

// The potential U - p V falls by what the indenters' forces do on their way.
TEST(ClosedFormCoupled, force_on_a_pressed_balloon_eq_slope_of_its_potential) {
  for (const double indenter : {0.3, 3.0, 300.0})
    for (const double angle : {0.05, 0.2, 0.5}) {
      const PressedBalloon scene = pressed(indenter);
      const double step = 2e-3 * angle;
      const BalloonPress less = pressed_balloon(scene, angle - step),
                         more = pressed_balloon(scene, angle + step);
      const double potential =
          more.strain_energy - less.strain_energy - scene.overpressure * (more.volume - less.volume);
      const double slope = -potential / (more.centre_height - less.centre_height);
      // Central difference: (2e-3)^2 = 4e-6 of the curves' bend over their size. The integration's 1e-13 of
      // 3 kJ is 1e-7 of the smallest difference of potentials, 6 mJ.
      expect_relative(2.0 * pressed_balloon(scene, angle).force, slope, 1e-5);
    }
}

TEST(ClosedFormCoupled, force_on_a_balloon_eq_patch_times_pressure_under_a_plate) {
  for (const double angle : {0.02, 0.3, 0.5}) {
    const BalloonPress plate = pressed_balloon(pressed(3e5), angle);
    // What is left, 2 T/(p r), is the stretched balloon's radius over the indenter's, 1e-6, or less.
    expect_relative(plate.force, 2e4 * plate.patch_area, 1.1e-6);
  }
}

// A small patch leaves the tension at p R/2: F = p (1 + R/r) pi a^2 with the radius R of the inflated
// balloon, but for a term of the order of angle^2 times its logarithm.
TEST(ClosedFormCoupled, force_on_a_small_patch_eq_pressure_and_tension_over_it) {
  const double radius = 0.3 * stretched_sphere({paper_fabric(), 0.3}, 2e4).stretch;
  for (const double indenter : {0.3, 3.0}) {
    const auto left = [&](double angle) {
      const BalloonPress b = pressed_balloon(pressed(indenter), angle);
      const double limit = 2e4 * (1.0 + radius / indenter) * b.patch_area;
      return (b.force / limit - 1.0) / (angle * angle * std::log(angle));
    };
    EXPECT_LT(std::abs(left(2e-3)), 5.0);            // of 1e-5
    EXPECT_NEAR(left(1e-2) / left(2e-3), 1.0, 0.2);  // the next term lacks the logarithm, 1/5 of this one
  }
}

TEST(ClosedFormCoupled, bad_parameters_are_refused_by_name) {
  expect_refused([] { gas_piston_frequency({}); }, "mass");
  expect_refused([] { gas_spring({{}, 20.0, 0.03}, 200.0); }, "volume");
  expect_refused([] { gas_spring({{}, 20.0, 0.03, 0.009}, 0.0); }, "force");
  expect_refused([] { pressed_cylinder({{paper_fabric(), 0.15}}, 0.1); }, "overpressure");
  expect_refused([] { pressed_cylinder({{paper_fabric(), 0.15}, 6e3}, 0.17); }, "half_distance");
  expect_refused([] { pendulum_gas_spring_frequency({{}, paper_pendulum()}); }, "pressure");
  expect_refused([] { sphere_fill({{}, {paper_fabric(), 0.3}}, 1.1); }, "inflow_temperature");
  expect_refused([] { sphere_fill({{}, {paper_fabric(), 0.3}, 1e5, 700.0}, 0.9); }, "stretch");
  expect_refused([] { pressed_balloon({{paper_fabric(), 0.3}, 2e4}, 0.1); }, "indenter_radius");
  expect_refused([] { pressed_balloon(pressed(0.2), 0.1); }, "indenter_radius");
  expect_refused([] { pressed_balloon({{paper_fabric(), 0.3}, 0.0, 0.3}, 0.1); }, "overpressure");
  for (const double stiff : {1e-3, 1e9})  // as good as rigid; burst
    expect_refused([&] { pressed_balloon({{paper_fabric(), 0.3}, stiff, 0.3}, 0.1); }, "overpressure");
  for (const double angle : {0.0, 0.99e-4, 0.7, std::nan("")})
    expect_refused([&] { pressed_balloon(pressed(0.3), angle); }, "patch_angle");
  // A plate this wide would leave the hoops slack.
  expect_refused([] { pressed_balloon({{paper_fabric(), 0.3}, 100.0, 3e3}, 0.6); }, "patch_angle");
}

}  // namespace
