// SPDX-License-Identifier: Apache-2.0
// Forces of a jet on plane targets (J.6) against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <vector>

#include "claim.hpp"
#include "closed_form/jet.hpp"
#include "jet/field.hpp"
#include "models.hpp"
#include "plates.hpp"
#include "rounding.hpp"

namespace {

using models::kAcross;
using models::kOutlet;
using models::normal_plate;
using models::tilted_plate;
using support::kEps;

double flux(const jet::JetModel& model) {
  return jet::momentum_flux(kOutlet, jet::outlet_area(model));
}

Eigen::Vector3d force(const jet::JetModel& model, const plates::Target& target) {
  const jet::JetField field(model, target.count());
  jet::FieldState state = field.make_state();
  field.evaluate(target.area_vectors, target.centroids, kOutlet, state);
  return jet::jet_force(state, target.area_vectors);
}

/// Relative error of the centroid rule on two triangles a square cell, a node on the axis, for exp(-2
/// r^2/R^2): Poisson sum over the reciprocal lattice, the two centroid lattices being shifted by (2/3, 1/3)
/// and (1/3, 2/3) cells.
double lattice_error(double h_over_width) {
  const double q = 0.5 * std::pow(std::numbers::pi / h_over_width, 2);
  double sum = 0.0;
  for (int i = -6; i <= 6; ++i) {
    for (int j = -6; j <= 6; ++j) {
      if (i != 0 || j != 0) {
        sum += std::exp(-q * (i * i + j * j)) * std::cos(2.0 * std::numbers::pi * (2 * i + j) / 3.0);
      }
    }
  }
  return sum;
}

TEST(plate_force, error_of_the_centroid_rule_eq_lattice_sum) {
  jet::JetModel model = models::round(0.02, 0.08);
  model.cut_off = 0.0;
  for (const double e : {0.0, 0.5, 1.0}) {
    model.restitution = e;
    for (const double z : {0.05, 0.4, 1.5}) {
      const double width = jet::section(model, z).width;
      const double exact = closed_form::plate_force(1.0 + e, flux(model));
      for (const double h : {1.5, 1.0, 0.75, 0.5, 0.25}) {
        const Eigen::Vector3d f = force(model, normal_plate(z, h * width, 2 * static_cast<int>(6.0 / h)));
        claim::expect_near(
            {"J.6", "plate by distance and mesh: error of the centroid rule, a lattice sum [-]",
             "3000 positive terms with exp; erfc(7.8) lies beyond the plate"},
            f.dot(models::kAxis) / exact - 1.0, lattice_error(h), 1e-13);
        EXPECT_LT((f - f.dot(models::kAxis) * models::kAxis).norm(), 1e-13 * exact);
      }
    }
  }
}

TEST(plate_force, cut_off_costs_its_stated_share) {
  for (const double cut_off : {1e-1, 1e-2, 1e-3}) {
    jet::JetModel model = models::round(0.02, 0.08);
    model.cut_off = cut_off;
    const double z = 0.4, width = jet::section(model, z).width, h = 0.02 * width;
    const double exact = 2.0 * flux(model) * (1.0 - jet::momentum_loss(model));
    const double radius = std::sqrt(-0.5 * std::log(cut_off));
    const double ring = 4.0 * radius * (h / width) * cut_off;
    claim::expect_relative({"J.6", "plate, jet cut off at 0.1 to 0.001 of its density: force [N]",
                            "elements across the cut circle count whole or not: a ring one element wide"},
                           force(model, normal_plate(z, h, 300)).dot(models::kAxis), exact, ring);
    EXPECT_GT(jet::momentum_loss(model), 3.0 * ring) << "the tolerance must not hide the loss";
  }
}

TEST(plate_force, rectangular_jet_eq_momentum_flux) {
  jet::JetModel model = models::rectangular(0.02, 0.2, 0.11);
  model.cut_off = 0.0;
  for (const double z : {0.05, 0.3, 1.0}) {
    const double width = jet::section(model, z).width;
    // The cells fit the long side; across, the rule is spectral: 2 exp(-pi^2 R^2 / (2 h^2)) is 5e-35 at h = R
    // / 4.
    const plates::Target target = plates::plate(models::kCentre + z * models::kAxis, models::kLong * 0.2 / 16,
                                                0.25 * width * kAcross, 20, 48);
    claim::expect_relative({"J.6", "plate in a rectangular jet: force, twice the momentum flux [N]",
                            "900 positive terms with exp"},
                           force(model, target).dot(models::kAxis), 2.0 * flux(model), 1e-13);
  }
  const jet::OutletState simple{400.0, 1.0, 1e5, 300.0};
  EXPECT_DOUBLE_EQ(jet::momentum_flux(simple, jet::outlet_area(model)), 640.0);
}

TEST(plate_force, rectangular_cut_off_costs_its_stated_share) {
  for (const double cut_off : {1e-1, 1e-3}) {
    jet::JetModel model = models::rectangular(0.02, 0.2, 0.11);
    model.cut_off = cut_off;
    const double z = 0.3, width = jet::section(model, z).width, h = 0.004 * width;
    const plates::Target target =
        plates::plate(models::kCentre + z * models::kAxis, models::kLong * 0.2 / 4, h * kAcross, 4, 1200);
    const double exact = 2.0 * flux(model) * (1.0 - jet::momentum_loss(model));
    // Strips across the two cut lines count whole or not at all: density sqrt(2/pi)/b cut_off each, width h.
    const double strips = 2.0 * std::sqrt(2.0 / std::numbers::pi) * cut_off * h / width;
    EXPECT_NEAR(force(model, target).dot(models::kAxis) / exact, 1.0, strips);
    EXPECT_GT(jet::momentum_loss(model), 3.0 * strips);
  }
}

const char* const kDiscOrder = "centroid rule and the rim's polygon; the next term h^4 is 1e-3 of it";

TEST(disc_force, converges_to_the_closed_fraction_with_second_order) {
  jet::JetModel model = models::round(0.02, 0.08);
  model.cut_off = 0.0;
  const double z = 0.4, width = jet::section(model, z).width;
  for (const double ratio : {0.25, 0.5, 2.0}) {
    const double exact = closed_form::disc_fraction(ratio * width, width);
    std::vector<double> errors;
    for (const int rings : {32, 64, 128, 256}) {
      const plates::Target target =
          plates::disc(models::kCentre + z * models::kAxis, models::kLong, kAcross, ratio * width, rings);
      errors.push_back(force(model, target).dot(models::kAxis) / (2.0 * flux(model)) - exact);
    }
    std::ostringstream what;
    what << "disc of " << ratio << " jet radii: share of the momentum";
    claim::expect_order({"J.6", what.str(), kDiscOrder}, errors, 1.9, 2.1);
    EXPECT_LT(std::abs(errors.back()), 1e-3 * exact);
  }
}

TEST(disc_force, off_the_axis_converges_to_marcum_with_second_order) {
  jet::JetModel model = models::round(0.02, 0.08);
  model.cut_off = 0.0;
  const double z = 0.4, width = jet::section(model, z).width;
  const Eigen::Vector3d centre = models::kCentre + z * models::kAxis;
  for (const double offset : {0.3, 1.0}) {
    const double exact = closed_form::off_axis_disc_fraction(0.7 * width, offset * width, width);
    std::vector<double> errors;
    for (const int rings : {32, 64, 128}) {
      const plates::Target target =
          plates::disc(centre + offset * width * kAcross, models::kLong, kAcross, 0.7 * width, rings);
      errors.push_back(force(model, target).dot(models::kAxis) / (2.0 * flux(model)) - exact);
    }
    std::ostringstream what;
    what << "disc " << offset << " jet radii off the axis, Marcum's function: share of the momentum";
    claim::expect_order({"J.6", what.str(), kDiscOrder}, errors, 1.9, 2.1);
    EXPECT_LT(std::abs(errors.back()), 1e-3 * exact);
  }
}

TEST(inclined_plate_force, without_spreading_eq_cosine) {
  jet::JetModel model = models::round(0.02, 1e-3);  // the core is 670 radii long: the width is constant
  model.cut_off = 0.0;
  const double width = jet::section(model, 2.0).width;
  for (const double degrees : {0.0, 30.0, 60.0}) {
    const double theta = degrees * std::numbers::pi / 180.0;
    const plates::Target target = tilted_plate(2.0, theta, 0.25 * width, 48);
    const Eigen::Vector3d normal = target.area_vectors.col(0).normalized();
    const double fraction = force(model, target).dot(normal) / (2.0 * flux(model));
    claim::expect_near({"J.6", "inclined plates, jet of constant width: share of the force, cos(theta)",
                        "2300 positive terms with exp"},
                       fraction, closed_form::inclined_plate_fraction(theta), 1e-13);
  }
}

TEST(inclined_plate_force, with_spreading_eq_series) {
  jet::JetModel model = models::round(0.02, 0.08);
  model.cut_off = 0.0;
  const double z = 2.0, width = jet::section(model, z).width;  // beyond the core over the whole plate
  const double slope = std::numbers::sqrt2 * 0.08 / 0.96;
  for (const double degrees : {30.0, 60.0}) {
    const double theta = degrees * std::numbers::pi / 180.0;
    const plates::Target target = tilted_plate(z, theta, 0.125 * width, 96);  // |x| <= 6 R(z)
    const Eigen::Vector3d normal = target.area_vectors.col(0).normalized();
    const double fraction = force(model, target).dot(normal) / (2.0 * flux(model));
    // The plate's own extent, by quadrature of the overpressure; the plate sums 18432 terms. Along the tilt
    // it reaches 6 R(z), where the closed form ends at s extent < 1.
    const double extent = std::min(6.0, 0.99 / (slope * std::tan(theta)));
    claim::expect_near({"J.6", "inclined plates, spreading jet: share of the force [-]",
                        "what lies outside the plate with the spreading"},
                       fraction, closed_form::inclined_plate_fraction(theta, slope, extent), 1e-7);
    const double s = slope * std::tan(theta);
    // The series goes on with less than s^6; outside the plate lies less than 1e-7 with the spreading.
    EXPECT_NEAR(fraction, std::cos(theta) * (1.0 + s * s / 4 + 3.0 * std::pow(s, 4) / 16),
                std::pow(s, 6) + 1e-7);
    EXPECT_GT(std::abs(fraction - std::cos(theta)), 50 * (std::pow(s, 6) + 1e-7));
  }
}

}  // namespace
