// SPDX-License-Identifier: Apache-2.0
// A field that could not be evaluated: what its state holds, and the next call.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "jet/field.hpp"
#include "models.hpp"
#include "plates.hpp"

namespace {

TEST(field, refused_evaluation_leaves_no_overpressure) {
  const jet::JetModel model = models::round(0.05, 0.08);
  const plates::Target near = models::normal_plate(0.2, 0.001, 4), far = models::normal_plate(-9.0, 0.001, 4);
  const jet::JetField field(model, near.count());
  for (const double displacement_bound : {jet::kMotionUnknown, 0.0}) {
    for (int e = 0; e < near.count(); ++e) {
      jet::FieldState state = field.make_state(), fresh = field.make_state();
      field.evaluate(near.area_vectors, near.centroids, models::kOutlet, fresh);
      ASSERT_FALSE(fresh.candidates.empty());
      Eigen::Matrix3Xd broken = near.area_vectors;
      broken(2, e) = std::numeric_limits<double>::quiet_NaN();
      EXPECT_THROW(
          field.evaluate(broken, near.centroids, models::kOutlet, state, nullptr, displacement_bound),
          jet::DomainError);
      EXPECT_TRUE(state.candidates.empty());
      EXPECT_EQ(std::count(state.overpressure.begin(), state.overpressure.end(), 0.0), near.count());
      jet::FieldState again = state;
      field.evaluate(near.area_vectors, near.centroids, models::kOutlet, again, nullptr, displacement_bound);
      EXPECT_EQ(again.candidates, fresh.candidates);
      EXPECT_EQ(again.overpressure, fresh.overpressure);
      field.evaluate(far.area_vectors, far.centroids, models::kOutlet, state, nullptr,
                     displacement_bound + 20.0);
      EXPECT_TRUE(state.candidates.empty());
      EXPECT_EQ(std::count(state.overpressure.begin(), state.overpressure.end(), 0.0), near.count());
    }
  }
}

TEST(field, outlet_that_is_negative_or_no_number_is_refused) {
  const plates::Target plate = models::normal_plate(0.2, 0.001, 4);
  const jet::JetField field(models::round(0.05, 0.08), plate.count());
  for (const auto member : {&jet::OutletState::density, &jet::OutletState::velocity})
    for (const double bad :
         {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      jet::FieldState state = field.make_state();
      field.evaluate(plate.area_vectors, plate.centroids, models::kOutlet, state);
      jet::OutletState outlet = models::kOutlet;
      outlet.*member = bad;
      EXPECT_THROW(field.evaluate(plate.area_vectors, plate.centroids, outlet, state), jet::DomainError);
      EXPECT_TRUE(state.candidates.empty());
      EXPECT_EQ(std::count(state.overpressure.begin(), state.overpressure.end(), 0.0), plate.count());
    }
}

TEST(field, ratios_and_restitution_out_of_range_are_refused_and_forgotten) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  const plates::Target plate = models::normal_plate(0.2, 0.001, 4);
  const jet::JetField field(models::round(0.05, 0.08), plate.count());
  const auto expect_refused = [&](const jet::OutletState& outlet, double restitution) {
    jet::FieldState state = field.make_state(), fresh = field.make_state();
    field.evaluate(plate.area_vectors, plate.centroids, models::kOutlet, fresh, nullptr, 0.0);
    const jet::FieldState before = fresh;
    state = fresh;
    state.restitution = restitution;
    EXPECT_THROW(field.needed(outlet, 0.0, state), jet::DomainError);
    EXPECT_THROW(field.evaluate(plate.area_vectors, plate.centroids, outlet, state, nullptr, 0.0),
                 jet::DomainError);
    EXPECT_TRUE(state.candidates.empty());
    EXPECT_EQ(std::count(state.overpressure.begin(), state.overpressure.end(), 0.0), plate.count());
    EXPECT_EQ(state.size_ratio, before.size_ratio);
    EXPECT_EQ(state.outline_motion, before.outline_motion);
    state.restitution = 1.0;
    field.evaluate(plate.area_vectors, plate.centroids, models::kOutlet, state, nullptr, 0.0);
    EXPECT_EQ(state.overpressure, before.overpressure);
  };
  for (const auto member : {&jet::OutletState::area_ratio, &jet::OutletState::reflected})
    for (const double bad : {0.0, -1.0, nan, infinity}) {
      jet::OutletState outlet = models::kOutlet;
      outlet.*member = bad;
      expect_refused(outlet, 1.0);
    }
  for (const double bad : {std::nextafter(-0.5, -1.0), std::nextafter(4.0, 5.0), nan})
    expect_refused(models::kOutlet, bad);
  for (const double end : {-0.5, 4.0}) {  // each to a rounding of (1 + e) of the load with 0
    jet::FieldState state = field.make_state(), zero = state;
    state.restitution = end;
    zero.restitution = 0.0;
    field.evaluate(plate.area_vectors, plate.centroids, models::kOutlet, state);
    field.evaluate(plate.area_vectors, plate.centroids, models::kOutlet, zero);
    for (const int e : state.candidates)
      EXPECT_DOUBLE_EQ(state.overpressure[static_cast<std::size_t>(e)],
                       (1.0 + end) * zero.overpressure[static_cast<std::size_t>(e)]);
  }
}

TEST(field, force_needs_one_area_vector_an_element) {
  const plates::Target plate = models::normal_plate(0.2, 0.001, 4);
  const jet::JetField field(models::round(0.05, 0.08), plate.count());
  jet::FieldState state = field.make_state();
  EXPECT_EQ(jet::jet_force(state, plate.area_vectors), Eigen::Vector3d(0, 0, 0));
  field.evaluate(plate.area_vectors, plate.centroids, models::kOutlet, state);
  EXPECT_GT(jet::jet_force(state, plate.area_vectors).norm(), 0.0);
  for (const Eigen::Index count : {Eigen::Index{0}, plate.area_vectors.cols() - 1})
    EXPECT_THROW(jet::jet_force(state, Eigen::Matrix3Xd(plate.area_vectors.leftCols(count))),
                 std::invalid_argument);
}

}  // namespace
