// SPDX-License-Identifier: Apache-2.0
// A fold pressed by its ridge: the sharper it is, the less it bears before the sphere is half a radius deep,
// where contact ends.
#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "bisection.hpp"
#include "claim.hpp"
#include "scenes.hpp"

namespace {

using scenes::kRadius;
using scenes::kStiffness;

// A roof with its ridge along y through the origin, each side at `half` [rad] from straight down.
scenes::Skin roof(double half) {
  scenes::Skin skin = scenes::plate(120, 0.02 * kRadius);
  for (Eigen::Index a = 0; a < skin.nodes.cols(); ++a) {
    const double s = skin.nodes(0, a);
    skin.nodes(0, a) = s * std::sin(half);
    skin.nodes(2, a) = -std::abs(s) * std::cos(half);
  }
  return skin;
}

// The force of the continuum, by the midpoint rule on both sides of the ridge.
double roof_force(double half, double depth) {
  const double height = kRadius - depth, step = kRadius / 400.0;
  double force = 0.0;
  for (double s = 0.5 * step; s < kRadius; s += step)
    for (double y = 0.5 * step; y < kRadius; y += step) {
      const double z = height + s * std::cos(half);
      const double distance = std::sqrt(z * z + std::pow(s * std::sin(half), 2) + y * y);
      if (distance < kRadius) force += 4.0 * step * step * kStiffness * (kRadius - distance) * z / distance;
    }
  return force;
}

double press(double half, double depth) {
  const auto skin = roof(half);
  return scenes::touch(scenes::contact(skin, kRadius, kStiffness), skin.nodes,
                       {0.0003, 0.0002, kRadius - depth})
      .result.force.z();
}

TEST(ContactFold, force_of_a_ridge_eq_integral_and_falls_with_its_sharpness) {
  double blunter = std::numeric_limits<double>::infinity();
  for (const double degrees : {90.0, 60.0, 30.0, 10.0}) {
    const double half = degrees * std::numbers::pi / 180.0;
    const double exact = roof_force(half, 0.4 * kRadius);
    claim::expect_relative({"K.11", "ridges of four angles pressed by the sphere: force [N]",
                            "points r/50 apart, the patch a few of them wide"},
                           press(half, 0.4 * kRadius), exact, 1e-2);
    EXPECT_LT(exact, 0.95 * blunter) << degrees;
    blunter = exact;
  }
}

// What a fold can bear ends at r/2, whatever its angle; past it the error names the limit.
TEST(ContactFold, ridge_deeper_than_half_the_radius_is_refused) {
  for (const double degrees : {90.0, 30.0, 5.0}) {
    const double half = degrees * std::numbers::pi / 180.0;
    const auto passes = [&](double depth) {
      try {
        return press(half, depth) > 0.0;
      } catch (const coupling::ContactError& error) {
        EXPECT_NE(std::string(error.what()).find("exceeds half the sphere's radius"), std::string::npos);
        return false;
      }
    };
    const double deepest = claim::largest_passing(0.2 * kRadius, 0.8 * kRadius, 1e-3, passes);
    claim::expect_threshold(
        {"K.24", "ridge at " + std::to_string(static_cast<int>(degrees)) + " degrees from straight down",
         "the nearest point is up to 0.014 r off the ridge: as much depth, where it is sharp"},
        {"sharp fold", "depth r/2, at any angle", 0.5 * kRadius, deepest, "m",
         "exit 3, naming element, depth and limit; the force up to there falls with the angle"},
        1.0 - 1e-3, 1.0 + 0.014 / 0.5 + 1e-3);
  }
}

}  // namespace
