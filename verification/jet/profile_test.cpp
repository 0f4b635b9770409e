// SPDX-License-Identifier: Apache-2.0
// Centreline decay, width and the integrals of the velocity profile, (J.3) to (J.5).
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "claim.hpp"
#include "closed_form/jet.hpp"
#include "jet/centreline.hpp"
#include "models.hpp"
#include "rounding.hpp"

namespace {

using support::kEps;
constexpr double kRoundCoefficients[] = {0.066, 0.076, 0.08, 0.089};
constexpr double kPlaneCoefficients[] = {0.09, 0.1, 0.108, 0.11, 0.12};
constexpr double kDistances[] = {0.0, 1.0, 5.0, 8.4, 10.0, 20.0, 40.0, 100.0, 1e4};

TEST(centreline, decay_eq_closed_form) {
  const char* why = "four operations on either side: 8 eps";
  for (const double x : kDistances) {
    for (const double a : kRoundCoefficients)
      claim::expect_relative({"J.3", "round jet by coefficient and distance: centreline decay [-]", why},
                             jet::round_decay(x, a), closed_form::round_centreline_ratio(a, x), 8 * kEps);
    for (const double a : kPlaneCoefficients)
      claim::expect_relative(
          {"J.4", "rectangular jet by coefficient and distance: centreline decay [-]", why},
          jet::plane_decay(x, a), closed_form::plane_centreline_ratio(a, x), 8 * kEps);
  }
  EXPECT_NEAR(jet::round_decay(20.0, 0.08), 0.50793650793650794, 8 * kEps);
  EXPECT_NEAR(jet::plane_decay(40.0, 0.11), 0.54715290310506384, 8 * kEps);
}

TEST(centreline, core_ends_where_the_decay_starts) {
  const double step = 1e-6;  // relative; large against rounding, so the sides are told apart
  for (const double a : kRoundCoefficients) {
    const double core = jet::round_core_length(a);
    EXPECT_NEAR(core, closed_form::round_core_length(a), 8 * kEps * core);
    EXPECT_EQ(jet::round_decay(core * (1.0 - step), a), 1.0);
    EXPECT_LT(jet::round_decay(core * (1.0 + step), a), 1.0);
  }
  for (const double a : kPlaneCoefficients) {
    const double core = jet::plane_core_length(a);
    EXPECT_NEAR(core, closed_form::plane_core_length(a), 8 * kEps * core);
    EXPECT_EQ(jet::plane_decay(core * (1.0 - step), a), 1.0);
    EXPECT_LT(jet::plane_decay(core * (1.0 + step), a), 1.0);
  }
}

TEST(centreline, velocity_has_its_pole_at_the_virtual_origin) {
  for (const double a : kRoundCoefficients) {
    // V_max (z + z_v) is constant beyond the core.
    const double x = 20.0, z = jet::round_virtual_origin(a);
    EXPECT_NEAR(jet::round_decay(x, a) * (x + z), jet::round_decay(3 * x, a) * (3 * x + z), 1e-13);
  }
  for (const double a : kPlaneCoefficients) {
    const double x = 20.0, z = jet::plane_virtual_origin(a);
    EXPECT_NEAR(jet::plane_decay(x, a) * std::sqrt(x + z), jet::plane_decay(3 * x, a) * std::sqrt(3 * x + z),
                1e-13);
  }
}

// The tables give the angle between the jet's edges beside each coefficient. Those edges are Tollmien's, so
// the angle is 2 atan(edge a): an independent check of every row. The tables' own edges are rounded to 3.4
// and 2.44 (0.9 % off for the plane jet) and their coefficients to three digits: 0.4 degrees.
TEST(centreline, outlet_types_eq_their_tabulated_spread_angles) {
  using Type = jet::OutletType;
  struct Row {
    Type type;
    double degrees;
  };
  const auto angle = [](double edge, double a) { return 360.0 / std::numbers::pi * std::atan(edge * a); };
  const char* why = "coefficients of three digits, edges rounded in the tables";
  for (const Row& row : {Row{Type::contracting_nozzle, 25.0 + 20.0 / 60.0}, Row{Type::guide_vane_fan, 44.5}})
    claim::expect_near({"J.3", "tabulated round outlets: angle between the jet's edges [deg]", why},
                       angle(closed_form::tollmien_round().edge, jet::decay_coefficient(row.type)),
                       row.degrees, 0.4);
  // The table's 29 degrees of the tube belong to the lower end of its range, 0.076 to 0.08.
  EXPECT_NEAR(
      angle(closed_form::tollmien_round().edge, jet::decay_coefficient(Type::cylindrical_tube) - 0.004), 29.0,
      0.4);
  for (const Row& row : {Row{Type::plane_nozzle, 29.5}, Row{Type::sharp_slot, 32.0 + 10.0 / 60.0},
                         Row{Type::rounded_slot, 41.0 + 20.0 / 60.0}})
    claim::expect_near({"J.4", "tabulated slots: angle between the jet's edges [deg]", why},
                       angle(closed_form::tollmien_plane().edge, jet::decay_coefficient(row.type)),
                       row.degrees, 0.4);
}

/// Integral of |V/V0|^power over the plane at z, by the midpoint rule in the outlet's frame. The Gaussian
/// makes it spectrally accurate across; along the long side the integrand is constant and the cells fit the
/// outlet.
double plane_integral(const jet::JetModel& model, double z, double power) {
  const jet::Section section = jet::section(model, z);
  const Eigen::Vector3d l =
      model.shape == jet::OutletShape::round ? model.axis.unitOrthogonal() : model.long_direction;
  const Eigen::Vector3d across = model.axis.cross(l);
  const int n = 60;
  const double h = 12.0 * section.width / n;
  const double along = model.shape == jet::OutletShape::round ? h : model.long_side / n;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Eigen::Vector3d point =
          model.centre + z * model.axis + (i + 0.5 - n / 2) * h * across + (j + 0.5 - n / 2) * along * l;
      sum += std::pow(jet::relative_velocity(model, point).norm(), power);
    }
  }
  return sum * h * along;
}

TEST(profile, momentum_flux_is_the_same_in_every_plane) {
  for (const jet::JetModel& model :
       {models::round(0.02, 0.08), models::round(0.05, 0.066), models::rectangular(0.02, 0.2, 0.11),
        models::rectangular(0.01, 0.05, 0.09)}) {
    const double area = jet::outlet_area(model);
    for (const double z : {0.01, 0.05, 0.1, 0.3, 1.0, 5.0}) {
      claim::expect_relative(
          {"J.5", "momentum flux in planes along four jets, over rho0 V0^2 [m2]",
           "exp and a sum of 3600 positive terms; the rule's own error is exp(-pi^2 5^2 / 2)"},
          plane_integral(model, z, 2.0), area, 1e-13);
    }
  }
}

TEST(profile, volume_and_energy_flux_eq_closed_form) {
  for (const double z : {0.05, 0.3, 1.0}) {
    closed_form::RoundJet round;
    round.radius = 0.02;
    const jet::JetModel model = models::round(0.02, round.spread);
    const closed_form::JetSection exact = closed_form::round_jet_section(round, z);
    const char* why = "sums of 3600 positive terms with exp";
    claim::expect_relative({"J.5", "round jet: volume flux over the outlet's [-]", why},
                           plane_integral(model, z, 1.0) / jet::outlet_area(model), exact.volume_flux_ratio,
                           1e-13);
    claim::expect_relative({"J.5", "round jet: energy flux over the outlet's [-]", why},
                           plane_integral(model, z, 3.0) / jet::outlet_area(model), exact.energy_flux_ratio,
                           1e-13);
    claim::expect_relative({"J.5", "round jet: width [m]", "16 eps: some ten operations"},
                           jet::section(model, z).width, exact.width, 16 * kEps);
    closed_form::PlaneJet plane;
    plane.half_width = 0.01;
    plane.length = 0.2;
    const jet::JetModel wedge = models::rectangular(0.02, 0.2, plane.spread);
    const closed_form::JetSection slot = closed_form::plane_jet_section(plane, z);
    claim::expect_relative({"J.5", "rectangular jet: volume flux over the outlet's [-]", why},
                           plane_integral(wedge, z, 1.0) / jet::outlet_area(wedge), slot.volume_flux_ratio,
                           1e-13);
    claim::expect_relative({"J.5", "rectangular jet: width [m]", "16 eps: some ten operations"},
                           jet::section(wedge, z).width, slot.width, 16 * kEps);
  }
}

TEST(profile, entrainment_far_downstream_eq_closed_form) {
  for (const double a : kRoundCoefficients) {
    const jet::JetModel model = models::round(0.5, a);  // distances are in diameters
    const double outlet = jet::outlet_area(model);
    const double slope =
        (plane_integral(model, 60.0, 1.0) - plane_integral(model, 40.0, 1.0)) / outlet / 20.0;
    claim::expect_near({"J.5", "round jet, 40 to 60 diameters: entrainment per diameter [-]",
                        "Q/Q0 of 20 and its difference of 7, each to 1e-13"},
                       slope, closed_form::round_far_field(a).entrainment_slope, 1e-12);
  }
}

TEST(profile, velocity_falls_to_one_over_e_at_the_width) {
  for (const jet::JetModel& model : {models::round(0.02, 0.08), models::rectangular(0.02, 0.2, 0.11)}) {
    for (const double z : {0.02, 0.2, 2.0}) {
      const jet::Section section = jet::section(model, z);
      const Eigen::Vector3d across = model.axis.cross(models::kLong);
      const Eigen::Vector3d edge = model.centre + z * model.axis + section.width * across;
      // The squared radius carries a few eps of (|centre| + z)^2 / width^2, at most 1e5 here.
      EXPECT_NEAR(jet::relative_velocity(model, edge).norm(), section.decay / std::numbers::e, 1e-10);
    }
  }
}

TEST(profile, cone_widens_by_its_angle_and_keeps_the_decay) {
  jet::JetModel model = models::round(0.02, 0.08);
  const jet::Section momentum = jet::section(model, 0.4);
  model.spread = jet::Spread::cone;
  model.cone_initial_width = 0.03;
  model.cone_half_angle = std::numbers::pi / 6;
  const jet::Section cone = jet::section(jet::validated(model), 0.4);
  EXPECT_EQ(cone.decay, momentum.decay);
  EXPECT_NEAR(cone.width, 0.03 + 0.4 / std::sqrt(3.0), 8 * kEps);
}

TEST(profile, radial_velocity_keeps_the_speed_and_points_from_the_virtual_origin) {
  for (jet::JetModel model : {models::round(0.02, 0.08), models::rectangular(0.02, 0.2, 0.11)}) {
    const bool round = model.shape == jet::OutletShape::round;
    const Eigen::Vector3d across = model.axis.cross(models::kLong);
    const Eigen::Vector3d point = model.centre + 0.3 * model.axis + 0.02 * across + 0.05 * models::kLong;
    const double speed = jet::relative_velocity(model, point).norm();
    model.direction = jet::Direction::radial;
    const Eigen::Vector3d velocity = jet::relative_velocity(model, point);
    EXPECT_NEAR(velocity.norm(), speed, 8 * kEps);
    const double z = 0.3 + (round ? 0.02 * 0.29 / 0.08 : 0.01 * 0.41 / 0.11);
    const Eigen::Vector3d expected = (z * model.axis + 0.02 * across + (round ? 0.05 : 0.0) * models::kLong);
    EXPECT_NEAR(velocity.normalized().dot(expected.normalized()), 1.0, 1e-14);
    EXPECT_GT(velocity.cross(model.axis).norm(), 0.01 * speed);
  }
}

TEST(profile, nothing_flows_upstream_or_beside_the_wedge) {
  const jet::JetModel wedge = models::rectangular(0.02, 0.2, 0.11);
  EXPECT_EQ(jet::relative_velocity(wedge, wedge.centre - 0.01 * wedge.axis).norm(), 0.0);
  EXPECT_EQ(jet::relative_velocity(wedge, wedge.centre + 0.1 * wedge.axis + 0.101 * models::kLong).norm(),
            0.0);
  EXPECT_GT(jet::relative_velocity(wedge, wedge.centre + 0.1 * wedge.axis + 0.099 * models::kLong).norm(),
            0.5);
}

}  // namespace
