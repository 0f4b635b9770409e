// SPDX-License-Identifier: Apache-2.0
// Overpressure element by element (J.6): moving skin, who takes load, mask, errors.
#include "jet/field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "claim.hpp"
#include "models.hpp"
#include "plates.hpp"
#include "rounding.hpp"

namespace {

using models::kOutlet;
using models::normal_plate;
using models::tilted_plate;
using support::kEps;

TEST(field, overpressure_eq_twice_density_times_normal_velocity_squared) {
  for (jet::JetModel model : {models::round(0.02, 0.08), models::rectangular(0.02, 0.2, 0.11)}) {
    for (const auto direction : {jet::Direction::axial, jet::Direction::radial}) {
      model.direction = direction;
      const plates::Target target = tilted_plate(0.3, 0.4, 0.01, 20);
      const jet::JetField field(model, target.count());
      jet::FieldState state = field.make_state();
      field.evaluate(target.area_vectors, target.centroids, kOutlet, state);
      ASSERT_GT(state.candidates.size(), 20u);
      for (const int e : state.candidates) {
        const Eigen::Vector3d velocity = 410.0 * jet::relative_velocity(model, target.centroids.col(e));
        const double normal = velocity.dot(target.area_vectors.col(e).normalized());
        const double exact = 2.0 * 0.97 * normal * normal;
        claim::expect_relative(
            {"J.6", "elements of a tilted plate, round and rectangular jets: overpressure [Pa]",
             "64 eps: exp, two projections and a square"},
            state.overpressure[static_cast<std::size_t>(e)], exact, 64 * kEps);
      }
    }
  }
}

TEST(field, moving_skin_feels_the_relative_velocity) {
  jet::JetModel model = models::round(0.02, 0.08);
  model.relative_to_skin = true;
  const plates::Target target = normal_plate(0.3, 0.01, 20);
  const jet::JetField field(model, target.count());
  jet::FieldState state = field.make_state();
  for (const double speed : {-30.0, 0.0, 100.0, 500.0}) {
    const Eigen::Matrix3Xd velocity = (speed * models::kAxis).replicate(1, target.count());
    const jet::Points view(velocity);
    field.evaluate(target.area_vectors, target.centroids, kOutlet, state, &view);
    for (const int e : state.candidates) {
      const double relative = 410.0 * jet::relative_velocity(model, target.centroids.col(e)).norm() - speed;
      // The difference of the two speeds loses at most their ratio to it; eps of 410 m/s over the smallest
      // kept.
      EXPECT_NEAR(std::sqrt(state.overpressure[static_cast<std::size_t>(e)] / (2.0 * 0.97)), relative, 1e-11);
      EXPECT_GT(relative, 0.0);
    }
    EXPECT_EQ(state.candidates.empty(), speed > 410.0);
  }
  EXPECT_THROW(field.evaluate(target.area_vectors, target.centroids, kOutlet, state), std::invalid_argument);
}

jet::JetModel radial_jet(bool relative_to_skin) {
  jet::JetModel model = models::round(0.02, 0.08);
  model.direction = jet::Direction::radial;
  model.relative_to_skin = relative_to_skin;
  return model;
}

TEST(field, skin_that_turns_its_back_feels_no_jet_however_it_moves) {
  plates::Target target = normal_plate(0.3, 0.01, 8);
  target.area_vectors *= -1.0;
  const Eigen::Matrix3Xd velocity = (900.0 * models::kAxis).replicate(1, target.count());  // v . n = -900
  const jet::Points view(velocity);
  const jet::JetField field(radial_jet(true), target.count());
  jet::FieldState state = field.make_state();
  field.evaluate(target.area_vectors, target.centroids, kOutlet, state, &view);
  EXPECT_TRUE(state.candidates.empty());
}

TEST(field, element_without_area_takes_no_load) {
  for (const auto direction : {jet::Direction::axial, jet::Direction::radial}) {
    jet::JetModel model = radial_jet(false);
    model.direction = direction;
    plates::Target target = normal_plate(0.3, 0.01, 4);
    target.triangles(2, 9) = target.triangles(1, 9);
    target = plates::finish(target.nodes, target.triangles);
    ASSERT_EQ(target.area_vectors.col(9).norm(), 0.0);
    const jet::JetField field(model, target.count());
    jet::FieldState state = field.make_state();
    field.evaluate(target.area_vectors, target.centroids, kOutlet, state);
    EXPECT_EQ(state.candidates.size(), 31u);
    EXPECT_EQ(state.overpressure[9], 0.0);
  }
}

TEST(field, null_elements_and_elements_that_face_the_outlet_take_no_load) {
  const jet::JetModel model = models::round(0.02, 0.08);
  plates::Target target = normal_plate(0.3, 0.01, 4);
  const std::vector<int> null = {3, 15, 16};
  jet::FieldState state = jet::JetField(model, target.count(), null).make_state();
  jet::JetField(model, target.count(), null).evaluate(target.area_vectors, target.centroids, kOutlet, state);
  EXPECT_EQ(state.candidates.size(), static_cast<std::size_t>(target.count()) - null.size());
  for (const int e : null) EXPECT_EQ(state.overpressure[static_cast<std::size_t>(e)], 0.0);
  target.area_vectors *= -1.0;
  jet::JetField(model, target.count()).evaluate(target.area_vectors, target.centroids, kOutlet, state);
  EXPECT_TRUE(state.candidates.empty());
  for (const double dp : state.overpressure) EXPECT_EQ(dp, 0.0);
}

TEST(field, load_begins_strictly_downstream_of_the_outlet_plane) {
  for (jet::JetModel model : {models::round(0.02, 0.08), models::rectangular(0.02, 0.2, 0.11)}) {
    model.centre = {0.1, -0.2, 0.0};
    model.axis = {0.0, 0.0, 1.0};
    model.long_direction = {1.0, 0.0, 0.0};
    for (const auto direction : {jet::Direction::axial, jet::Direction::radial}) {
      model.direction = direction;
      for (const double z : {-1e-300, -0.0, 0.0, 1e-300}) {
        const plates::Target target =
            plates::plate(model.centre + z * model.axis, {1e-3, 0.0, 0.0}, {0.0, 1e-3, 0.0}, 2, 2);
        const jet::JetField field(model, target.count());
        jet::FieldState state = field.make_state();
        field.evaluate(target.area_vectors, target.centroids, kOutlet, state);
        EXPECT_EQ(state.candidates.size(), z > 0.0 ? 8u : 0u) << z;
        EXPECT_EQ(jet::jet_force(state, target.area_vectors).z() > 0.0, z > 0.0) << z;
        EXPECT_EQ(jet::relative_velocity(model, target.centroids.col(0)).norm() > 0.0, z > 0.0) << z;
      }
    }
  }
}

TEST(field, mask_removes_the_hidden_share_of_the_force) {
  const jet::JetModel model = models::round(0.02, 0.08);
  const plates::Target target = normal_plate(0.3, 0.01, 8);
  const jet::JetField field(model, target.count());
  jet::FieldState state = field.make_state();
  field.evaluate(target.area_vectors, target.centroids, kOutlet, state);
  const Eigen::Vector3d whole = jet::jet_force(state, target.area_vectors);
  std::vector<std::uint8_t> lit(state.candidates.size(), 1), dark(lit.size(), 0);
  lit[2] = 0;
  const int hidden = state.candidates[2];
  const Eigen::Vector3d share =
      state.overpressure[static_cast<std::size_t>(hidden)] * target.area_vectors.col(hidden);
  jet::apply_mask(lit, state);
  EXPECT_NEAR((jet::jet_force(state, target.area_vectors) + share - whole).norm(), 0.0, 1e-13 * whole.norm());
  jet::apply_mask(dark, state);
  EXPECT_EQ(jet::jet_force(state, target.area_vectors).norm(), 0.0);
  EXPECT_THROW(jet::apply_mask(std::span(dark).first(1), state), std::invalid_argument);
}

TEST(field, non_finite_geometry_is_an_error_not_a_number) {
  const jet::JetModel model = models::round(0.02, 0.08);
  plates::Target target = normal_plate(0.3, 0.01, 4);
  target.centroids(1, 5) = std::numeric_limits<double>::quiet_NaN();
  const jet::JetField field(model, target.count());
  jet::FieldState state = field.make_state();
  EXPECT_THROW(field.evaluate(target.area_vectors, target.centroids, kOutlet, state), jet::DomainError);
}

}  // namespace
