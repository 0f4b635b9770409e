// SPDX-License-Identifier: Apache-2.0
// Force of an expanded jet on plane targets: one thrust mdot V0 + (pe - p) A, and e mdot V0, (J.6), (J.12).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "claim.hpp"
#include "closed_form/jet.hpp"
#include "jet/field.hpp"
#include "models.hpp"
#include "plates.hpp"

namespace {

const double kRatios[] = {1.0, 1.3, 2.0, 3.2, 5.0};  // pe/p
const double kRestitutions[] = {-0.5, 0.0, 0.3, 1.0, 4.0};

closed_form::ExpandedOutlet outlet_of(const jet::JetModel& model, double pressure_ratio) {
  return {{}, 700.0, jet::outlet_area(model), 101325.0, pressure_ratio};
}

jet::OutletState state_of(const closed_form::ExpandedOutlet& outlet) {
  return jet::outlet_state(
      {jet::OutletLaw::expanded, jet::OutletTemperature::stagnation, outlet.area},
      {closed_form::expanded_outlet(outlet).mass_flow, outlet.stagnation_temperature,
       closed_form::specific_heat_cp(outlet.gas), outlet.gas.gas_constant, outlet.bag_pressure});
}

Eigen::Vector3d force(const jet::JetModel& model, const plates::Target& target,
                      const jet::OutletState& outlet) {
  const jet::JetField field(model, target.count());
  jet::FieldState state = field.make_state();
  field.evaluate(target.area_vectors, target.centroids, outlet, state);
  return jet::jet_force(state, target.area_vectors);
}

const char* const kSum = "4600 positive terms with exp; the state's 64 eps";

TEST(expanded_force, on_a_plate_eq_thrust_and_what_is_turned_back) {
  jet::JetModel model = models::round(0.02, 0.08);
  model.cut_off = 0.0;
  for (const double n : kRatios) {
    const auto exact = outlet_of(model, n);
    const jet::OutletState outlet = state_of(exact);
    for (const double z : {0.05, 0.4, 1.5}) {
      const double width = jet::section(jet::widened(model, outlet.area_ratio), z).width;
      const plates::Target plate = models::normal_plate(z, 0.25 * width, 48);  // the rule errs by 4e-34 here
      for (const double e : kRestitutions) {
        model.restitution = e;
        const Eigen::Vector3d f = force(model, plate, outlet);
        const double load = closed_form::plate_load(exact, e);
        claim::expect_relative({"J.12", "plate, round expanded jet of pe/p up to 5: force [N]", kSum},
                               f.dot(models::kAxis), load, 1e-13);
        EXPECT_LT((f - f.dot(models::kAxis) * models::kAxis).norm(), 1e-13 * load);
      }
    }
  }
}

TEST(expanded_force, on_a_plate_in_a_rectangular_jet_eq_thrust_and_what_is_turned_back) {
  jet::JetModel model = models::rectangular(0.02, 0.2, 0.11);
  model.cut_off = 0.0;
  for (const double n : kRatios) {
    const auto exact = outlet_of(model, n);
    const jet::OutletState outlet = state_of(exact);
    for (const double z : {0.05, 0.3, 1.0}) {
      const double width = jet::section(jet::widened(model, outlet.area_ratio), z).width;
      const plates::Target plate =
          plates::plate(models::kCentre + z * models::kAxis, models::kLong * 0.2 / 16,
                        0.25 * width * models::kAcross, 20, 48);
      for (const double e : kRestitutions) {
        model.restitution = e;
        claim::expect_relative({"J.12", "plate, rectangular expanded jet of pe/p up to 5: force [N]", kSum},
                               force(model, plate, outlet).dot(models::kAxis),
                               closed_form::plate_load(exact, e), 1e-13);
      }
    }
  }
}

TEST(expanded_force, on_a_disc_converges_with_second_order) {
  jet::JetModel model = models::round(0.02, 0.08);
  model.cut_off = 0.0;
  model.restitution = 0.3;
  const auto exact = outlet_of(model, 3.2);
  const jet::OutletState outlet = state_of(exact);
  const double z = 0.4, width = jet::section(jet::widened(model, outlet.area_ratio), z).width;
  for (const double ratio : {0.25, 0.5, 2.0}) {
    const double caught =
        closed_form::disc_fraction(ratio * width, width) * closed_form::plate_load(exact, 0.3);
    std::vector<double> errors;
    for (const int rings : {32, 64, 128, 256})
      errors.push_back(force(model,
                             plates::disc(models::kCentre + z * models::kAxis, models::kLong, models::kAcross,
                                          ratio * width, rings),
                             outlet)
                           .dot(models::kAxis) -
                       caught);
    std::ostringstream what;
    what << "disc of " << ratio << " jet radii, expanded jet: force [N]";
    claim::expect_order(
        {"J.12", what.str(), "centroid rule and the rim's polygon; the next term h^4 is 1e-3 of it"}, errors,
        1.9, 2.1);
    EXPECT_LT(std::abs(errors.back()), 1e-3 * caught);
  }
}

// Points in and about the jet, none of them within rounding of its bounds.
TEST(expanded_force, field_eq_that_of_the_widened_model) {
  constexpr int count = 4000;
  std::mt19937_64 engine(3);
  const auto random = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
  };
  Eigen::Matrix3Xd centroids(3, count), areas(3, count);
  for (int e = 0; e < count; ++e) {
    centroids.col(e) = models::kCentre + random(-0.1, 1.0) * models::kAxis +
                       random(-0.3, 0.3) * models::kLong + random(-0.3, 0.3) * models::kAcross;
    areas.col(e) =
        1e-4 * (models::kAxis + random(-1.0, 1.0) * models::kAcross + random(-1.0, 1.0) * models::kLong);
  }
  for (jet::JetModel model : {models::round(0.04, 0.08), models::rectangular(0.02, 0.3, 0.11)})
    for (const auto direction : {jet::Direction::axial, jet::Direction::radial})
      for (const auto spread : {jet::Spread::momentum, jet::Spread::cone}) {
        model.direction = direction;
        model.spread = spread;
        model.cone_initial_width = 0.05;
        model.cone_half_angle = 0.3;
        for (const double ratio : {0.6, 1.37, 4.0}) {
          const jet::JetField field(model, count), other(jet::widened(model, ratio), count);
          jet::FieldState state = field.make_state(), expected = other.make_state();
          field.evaluate(areas, centroids, {410.0, 0.97, 1.17e5, 406.0, ratio, 0.8}, state);
          other.evaluate(areas, centroids, {410.0, 0.97, 1.17e5, 406.0, 1.0, 0.8}, expected);
          ASSERT_EQ(state.candidates, expected.candidates);
          ASSERT_GT(state.candidates.size(), 100u);
          for (const int e : state.candidates) {
            const auto k = static_cast<std::size_t>(e);
            // exp of up to 7 with two roundings of the width
            ASSERT_NEAR(state.overpressure[k], expected.overpressure[k], 1e-13 * expected.overpressure[k]);
          }
        }
      }
}

TEST(expanded_force, damping_rate_is_the_slope_of_the_overpressure) {
  jet::JetModel model = models::round(0.02, 0.08);
  model.relative_to_skin = true;
  const plates::Target plate = models::normal_plate(0.3, 0.02, 8);
  const std::vector<double> masses(static_cast<std::size_t>(plate.count()), 3e-4);
  const jet::OutletState outlet = state_of(outlet_of(model, 3.2));
  const jet::JetField field(model, plate.count());
  for (const double e : {-0.5, 0.3, 4.0}) {
    const auto overpressure_at = [&](double speed) {
      jet::FieldState state = field.make_state();
      state.restitution = e;
      Eigen::Matrix3Xd velocities = (speed * models::kAxis).replicate(1, plate.count());
      const jet::Points points(velocities);
      field.evaluate(plate.area_vectors, plate.centroids, outlet, state, &points);
      return state;
    };
    const double speed = 7.0, h = 1e-3;
    const jet::FieldState state = overpressure_at(speed), slow = overpressure_at(speed - h),
                          fast = overpressure_at(speed + h);
    double exact = 0.0;  // the overpressure is a square: the central difference is its slope
    for (std::size_t k = 0; k < masses.size(); ++k)
      exact = std::max(exact, (slow.overpressure[k] - fast.overpressure[k]) / (2.0 * h) *
                                  plate.area_vectors.col(static_cast<Eigen::Index>(k)).norm() / masses[k]);
    // 1e5 Pa with 1e-16 over 1e-3 m/s
    claim::expect_relative({"J.9", "expanded jet by restitution: rate at which it damps the skin [1/s]",
                            "difference of overpressures over 2 mm/s: rounding of 1e-16 over 1e-5"},
                           jet::damping_rate(field.model(), outlet, state, plate.area_vectors, masses), exact,
                           1e-9);
  }
}

}  // namespace
