// SPDX-License-Identifier: Apache-2.0
// Overpressure over a sequence of steps: what is not looked at every time must not show in any of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "jet/field.hpp"
#include "models.hpp"
#include "plates.hpp"

namespace {

using models::kOutlet;
using models::normal_plate;

/// Points that fly about a jet, as far in each step as is told; some straight towards its axis.
TEST(field, far_elements_are_left_out_only_while_they_stay_outside) {
  constexpr int count = 1602;
  constexpr double stride = 0.013;  // [m]
  jet::JetModel cone = models::round(0.02, 0.08);
  cone.spread = jet::Spread::cone;
  cone.cone_initial_width = 0.03;
  cone.cone_half_angle = 0.6;
  jet::JetModel all = models::round(0.02, 0.08);
  all.cut_off = 0.0;
  const Eigen::Matrix3Xd nowhere =
      Eigen::Matrix3Xd::Constant(3, count, std::numeric_limits<double>::quiet_NaN());
  for (const jet::JetModel& model :
       {models::round(0.02, 0.08), models::rectangular(0.04, 0.3, 0.11), jet::validated(cone), all}) {
    std::mt19937_64 engine(5);
    const auto random = [&] {
      const auto one = [&] { return static_cast<double>(engine() >> 11) * 0x1p-52 - 1.0; };
      const double x = one(), y = one(), z = one();
      return Eigen::Vector3d(x, y, z);
    };
    Eigen::Matrix3Xd centroids(3, count), areas(3, count);
    for (int e = 0; e < count; ++e) {
      centroids.col(e) = models::kCentre + random();
      areas.col(e) = 1e-4 * (random() + 2.0 * models::kAxis);
    }
    const jet::JetField field(model, count);
    jet::FieldState carried = field.make_state(), fresh = field.make_state(), given_few = carried;
    std::size_t changes = 0, needed = 0;
    for (int step = 0; step < 60; ++step) {
      const std::vector<int> before = carried.candidates;
      field.evaluate(areas, centroids, kOutlet, carried, nullptr, stride * step);
      field.evaluate(areas, centroids, kOutlet, fresh);
      EXPECT_EQ(carried.candidates, fresh.candidates);
      EXPECT_EQ(carried.overpressure, fresh.overpressure);
      changes += carried.candidates != before;
      // The same from the columns that it needs alone.
      Eigen::Matrix3Xd few_areas = nowhere, few_centroids = nowhere;
      for (const int e : field.needed(kOutlet, stride * step, given_few)) {
        few_areas.col(e) = areas.col(e);
        few_centroids.col(e) = centroids.col(e);
        ++needed;
      }
      field.evaluate(few_areas, few_centroids, kOutlet, given_few, nullptr, stride * step);
      EXPECT_EQ(given_few.candidates, fresh.candidates);
      EXPECT_EQ(given_few.overpressure, fresh.overpressure);
      // Without flow a motion told anew holds too.
      const double strides = step == 30 ? 10.0 : 1.0;
      if (step == 30)
        for (jet::FieldState* state : {&carried, &given_few}) {
          EXPECT_TRUE(field.needed({}, stride * (step - 9), *state).empty());
          field.evaluate(areas, centroids, {}, *state, nullptr, stride * (step - 9));
        }
      for (int e = 0; e < count; ++e) {
        const Eigen::Vector3d aim =
            e % 3 == 0 ? Eigen::Vector3d(models::kCentre + 0.5 * models::kAxis - centroids.col(e)) : random();
        centroids.col(e) += 0.999 * strides * stride * aim.normalized();
      }
    }
    EXPECT_LT(needed, 60u * count);
    EXPECT_GT(changes, model.cut_off > 0.0 ? 40u : 10u);
    const auto left_out =
        std::count_if(carried.slack.begin(), carried.slack.end(), [&](double s) { return s > 60 * stride; });
    EXPECT_GT(left_out, 0) << "something must be left out";
  }
}

/// Groups of four points that cross the bounds of a jet together, from inside and from outside, by small
/// steps straight through them: outwards and inwards, along the axis, along the long side, and in between.
TEST(field, groups_keep_their_side_of_the_jet_only_while_none_can_cross) {
  constexpr int groups = 1000, count = 4 * groups - 1;
  std::mt19937_64 engine(11);
  const auto random = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
  };
  std::vector<jet::JetModel> jets;
  for (const double cut_off : {0.0, 1e-3, 0.5}) {
    for (jet::JetModel model : {models::round(0.04, 0.08), models::rectangular(0.08, 0.3, 0.11)}) {
      model.cut_off = cut_off;
      jets.push_back(model);
      model.direction = jet::Direction::radial;
      model.spread = jet::Spread::cone;
      for (const double angle : {0.0, 0.3, 1.0}) {
        model.cone_initial_width = random(0.02, 0.1);
        model.cone_half_angle = angle;
        jets.push_back(jet::validated(model));
      }
    }
  }
  for (const jet::JetModel& model : jets) {
    Eigen::Matrix3Xd centroids(3, count), areas(3, count), ways(3, count);
    for (int e = 0; e < count; ++e) {
      if (e % 4 == 0) {
        const Eigen::Vector3d off = random(-0.3, 0.3) * models::kLong + random(-0.3, 0.3) * models::kAcross;
        const Eigen::Vector3d ways_out[] = {off.normalized() - random(0.0, 2.0) * models::kAxis,
                                            models::kAxis, models::kLong,
                                            models::kAcross - random(0.0, 2.0) * models::kAxis,
                                            random(-1.0, 1.0) * models::kAcross + models::kLong};
        centroids.col(e) = models::kCentre + random(-0.05, 0.4) * models::kAxis + off;
        ways.col(e) = (engine() % 2 == 0 ? -1.0 : 1.0) * ways_out[e / 4 % 5].normalized();
        areas.col(e) = 1e-4 * (models::kAxis + 0.5 * models::kAcross);
      } else {
        centroids.col(e) = centroids.col(e - 1) + random(-0.01, 0.01) * models::kAcross;
        ways.col(e) = ways.col(e - 1);
        areas.col(e) = areas.col(e - 1);
      }
    }
    const std::vector<int> null = {7, 800, 801};
    const jet::JetField field(model, count, null);
    jet::FieldState carried = field.make_state(), fresh = field.make_state();
    double displacement_bound = random(0.0, 3.0);
    std::size_t kept_inside = 0, crossings = 0;
    for (int step = 0; step < 80; ++step) {
      const std::vector<int> before = carried.candidates;
      const std::vector<double> slack = carried.slack;
      field.evaluate(areas, centroids, kOutlet, carried, nullptr, displacement_bound);
      field.evaluate(areas, centroids, kOutlet, fresh);
      ASSERT_EQ(carried.candidates, fresh.candidates);
      ASSERT_EQ(carried.overpressure, fresh.overpressure);
      crossings += carried.candidates != before;
      for (std::size_t g = 0; g < groups; ++g)
        kept_inside += carried.inside[g] != 0 && displacement_bound < slack[g];
      const double stride = random(0.0, 0.006);
      displacement_bound += stride;
      centroids += (1.0 - 1e-9) * stride * ways;
    }
    EXPECT_GT(kept_inside, 500u) << "nothing is shown where every group is looked at";
    EXPECT_GT(crossings, 20u);
  }
}

TEST(field, point_that_is_no_number_is_found_inside_and_forgotten_with_its_group) {
  const jet::JetModel model = models::round(0.02, 0.08);
  plates::Target target = normal_plate(0.3, 0.001, 4);
  const jet::JetField field(model, target.count());
  jet::FieldState state = field.make_state(), fresh = field.make_state();
  const plates::Target sound = target;
  for (int e = 0; e < 4; ++e) {
    field.evaluate(sound.area_vectors, sound.centroids, kOutlet, state, nullptr, 0.0);
    ASSERT_GT(state.slack[0], 0.001);
    target.centroids(1, e) = std::numeric_limits<double>::quiet_NaN();
    // Its group need not be looked at, then it must be.
    for (const double displacement_bound : {0.0, 1.0}) {
      EXPECT_THROW(
          field.evaluate(target.area_vectors, target.centroids, kOutlet, state, nullptr, displacement_bound),
          jet::DomainError);
      EXPECT_EQ(state.slack[0] > displacement_bound, displacement_bound == 0.0);
    }
    target.centroids.col(e) = sound.centroids.col(e) - 9.0 * models::kAxis;
    field.evaluate(target.area_vectors, target.centroids, kOutlet, state, nullptr, 1.0);
    field.evaluate(target.area_vectors, target.centroids, kOutlet, fresh);
    EXPECT_EQ(state.overpressure, fresh.overpressure);
    target = sound;
  }
}

}  // namespace
