// SPDX-License-Identifier: Apache-2.0
// A jet that widens and narrows from call to call, over points that move or rest: what is not examined every
// time must not show.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "jet/field.hpp"
#include "models.hpp"
#include "plates.hpp"

namespace {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 engine_;
};

std::vector<jet::JetModel> jets() {
  std::vector<jet::JetModel> result;
  for (const double cut_off : {0.0, 1e-3, 0.5})
    for (jet::JetModel model : {models::round(0.04, 0.08), models::rectangular(0.06, 0.3, 0.11)}) {
      model.cut_off = cut_off;
      result.push_back(model);
      model.direction = jet::Direction::radial;
      model.spread = jet::Spread::cone;
      model.cone_initial_width = 0.05;
      for (const double angle : {0.0, 0.6}) {
        model.cone_half_angle = angle;
        result.push_back(jet::validated(model));
      }
    }
  return result;
}

// Ratios as a jet has them: slow for a while, at times as before, at times a jump; some steps without flow.
jet::OutletState next_outlet(const jet::OutletState& last, Random& random) {
  jet::OutletState outlet = models::kOutlet;
  outlet.area_ratio = last.area_ratio;
  const double kind = random(0.0, 1.0);
  if (kind < 0.6) outlet.area_ratio *= random(0.97, 1.03);
  if (kind > 0.95) outlet.area_ratio = random(0.5, 3.0);
  outlet.area_ratio = std::clamp(outlet.area_ratio, 0.3, 4.0);
  outlet.reflected = random(0.6, 1.0);
  if (kind > 0.9 && kind < 0.93) outlet.density = 0.0;
  return outlet;
}

struct Points {
  static constexpr int count = 3999;
  Eigen::Matrix3Xd centroids{3, count}, areas{3, count}, ways{3, count};
  explicit Points(Random& random) {
    for (int e = 0; e < count; ++e) {
      if (e % 4 == 0) {
        const Eigen::Vector3d off = random(-0.3, 0.3) * models::kLong + random(-0.3, 0.3) * models::kAcross;
        centroids.col(e) = models::kCentre + random(-0.05, 0.4) * models::kAxis + off;
        ways.col(e) = (off + random(-0.1, 0.1) * models::kAxis).normalized();
        if (random(0.0, 1.0) < 0.5) ways.col(e) *= -1.0;
      } else {
        centroids.col(e) = centroids.col(e - 1) + random(-0.003, 0.003) * models::kAcross;
        ways.col(e) = ways.col(e - 1);
      }
      areas.col(e) = 1e-4 * (models::kAxis + 0.5 * models::kAcross);
    }
  }
};

// `stride`: the most that a point moves in a step [m].
void expect_same_as_all(const jet::JetModel& model, double stride, unsigned seed) {
  Random random(seed);
  Points at(random);
  const Eigen::Matrix3Xd nowhere =
      Eigen::Matrix3Xd::Constant(3, Points::count, std::numeric_limits<double>::quiet_NaN());
  const jet::JetField field(model, Points::count, std::vector<int>{7, 800, 801});
  jet::FieldState carried = field.make_state(), given_few = field.make_state();
  jet::OutletState outlet = models::kOutlet;
  double displacement_bound = 0.0;
  std::size_t needed = 0, changes = 0;
  for (int step = 0; step < 80; ++step) {
    outlet = next_outlet(outlet, random);
    jet::FieldState fresh = field.make_state();
    for (jet::FieldState* state : {&carried, &given_few, &fresh})
      state->restitution = std::min(4.0, -0.5 + 0.1 * step);
    const std::vector<int> before = carried.candidates;
    field.evaluate(at.areas, at.centroids, outlet, carried, nullptr, displacement_bound);
    field.evaluate(at.areas, at.centroids, outlet, fresh);
    ASSERT_EQ(carried.candidates, fresh.candidates) << step;
    ASSERT_EQ(carried.overpressure, fresh.overpressure) << step;
    changes += carried.candidates != before;
    Eigen::Matrix3Xd few_areas = nowhere, few_centroids = nowhere;
    for (const int e : field.needed(outlet, displacement_bound, given_few)) {
      few_areas.col(e) = at.areas.col(e);
      few_centroids.col(e) = at.centroids.col(e);
      ++needed;
    }
    field.evaluate(few_areas, few_centroids, outlet, given_few, nullptr, displacement_bound);
    ASSERT_EQ(given_few.candidates, fresh.candidates) << step;
    ASSERT_EQ(given_few.overpressure, fresh.overpressure) << step;
    const double moved = random(0.0, stride);
    displacement_bound += moved;
    at.centroids += (1.0 - 1e-9) * moved * at.ways;
  }
  EXPECT_GT(changes, model.cut_off > 0.0 ? 20u : 1u);
  if (model.cut_off > 0.0) {
    EXPECT_LT(needed, 60u * Points::count) << "nothing is shown where all are examined";
  }
}

TEST(expanded_field, what_rests_is_examined_when_the_jet_reaches_it) {
  for (const jet::JetModel& model : jets())
    for (const unsigned seed : {1u, 2u}) expect_same_as_all(model, 0.0, seed);
}

TEST(expanded_field, what_moves_is_examined_when_it_may_have_met_a_jet_that_moves) {
  for (const jet::JetModel& model : jets()) expect_same_as_all(model, 0.004, 3);
}

// Two points at the same distance inside and outside, and a jet that grows or shrinks by just more.
TEST(expanded_field, outline_is_followed_to_its_last_millimetre) {
  jet::JetModel model = models::round(0.04, 0.08);
  const double edge = 0.04 * std::sqrt(2.0) * std::sqrt(-0.5 * std::log(model.cut_off));  // in the core
  const double gap = 1e-3, larger = std::pow((edge + 1.01 * gap) / edge, 2), smaller = 1.0 / larger;
  Eigen::Matrix3Xd centroids(3, 8), areas = (1e-4 * models::kAxis).replicate(1, 8);
  for (int e = 0; e < 8; ++e)
    centroids.col(e) =
        models::kCentre + 0.1 * models::kAxis + (edge + (e < 4 ? -gap : gap)) * models::kAcross;
  const jet::JetField field(model, 8);
  for (const double ratio : {larger, smaller}) {
    jet::FieldState state = field.make_state();
    jet::OutletState outlet = models::kOutlet;
    field.evaluate(areas, centroids, outlet, state, nullptr, 0.0);
    EXPECT_EQ(state.candidates, (std::vector<int>{0, 1, 2, 3}));
    outlet.area_ratio = ratio;
    field.evaluate(areas, centroids, outlet, state, nullptr, 0.0);
    EXPECT_EQ(state.candidates.size(), ratio > 1.0 ? 8u : 0u);
  }
}

}  // namespace
