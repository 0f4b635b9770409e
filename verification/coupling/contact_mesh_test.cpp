// SPDX-License-Identifier: Apache-2.0
// Force, energy and patch of a sphere pressed into a flat plate: convergence with the mesh to the integral
// over the plane, for elements from a tenth of the sphere to three times it.
#include <gtest/gtest.h>

#include <cmath>

#include "claim.hpp"
#include "closed_form/pendulum.hpp"
#include "scenes.hpp"

namespace {

using Eigen::Vector3d;

using scenes::kRadius;
using scenes::kStiffness;

struct Errors {
  double force = 0.0, energy = 0.0, area = 0.0, side = 0.0;  // relative, root mean square over positions
};

// `size` elements of the sphere's radius, sphere at 144 places of the middle cell and at depths within a
// sixth of the mean: one place, or one depth alone, would show how its circle happens to lie on the lattice.
Errors plate_errors(double size, double mean_depth) {
  const int cells = 2 * static_cast<int>(std::ceil(1.2 / size)) + 1;
  const auto skin = scenes::plate(cells, size * kRadius);
  const auto model = scenes::contact(skin, kRadius, kStiffness);
  const int places = 144;
  Errors e;
  for (int i = 0; i < places; ++i) {
    // Even coverage: multiples of the powers of the plastic number's inverse.
    const double x = (std::fmod(0.7548776662 * i, 1.0) - 0.5) * size * kRadius;
    const double y = (std::fmod(0.5698402910 * i, 1.0) - 0.5) * size * kRadius;
    const double depth = mean_depth * (1.0 + (i + 0.5 - 0.5 * places) / (3.0 * places));
    const auto exact = closed_form::sphere_plane_contact(kRadius, depth, kStiffness);
    const double patch = closed_form::sphere_plane_cut(kRadius, depth).patch_area;
    const auto t = scenes::touch(model, skin.nodes, {x, y, kRadius - depth}).result;
    e.force += std::pow(t.force.z() / exact.force - 1.0, 2);
    e.side += std::pow(std::hypot(t.force.x(), t.force.y()) / exact.force, 2);
    e.energy += std::pow(t.energy / exact.energy - 1.0, 2);
    e.area += std::pow(t.area / patch - 1.0, 2);
  }
  for (double* value : {&e.force, &e.side, &e.energy, &e.area}) *value = std::sqrt(*value / places);
  return e;
}

// Whatever the elements' size, points are at most r/4 apart: the force is that of the plane within the
// scatter of a lattice of that spacing (next test: 0.3 % at this depth) and does not grow with the elements.
TEST(ContactMesh, force_eq_plane_integral_for_elements_from_tenth_to_three_times_the_sphere) {
  for (const double size : {0.1, 0.2, 0.5, 1.0, 2.0, 3.0}) {
    const Errors e = plate_errors(size, 0.2 * kRadius);
    claim::expect_near(
        {"K.11", "sphere in a plate, elements from 0.1 to 3 r: error of the force, root mean square [-]",
         "points r/4 apart or less at a depth of r/5: 3e-3 by the lattice"},
        e.force, 0.0, 5e-3);
    EXPECT_LT(e.side, 5e-3) << size;
    EXPECT_LT(e.energy, 2e-3) << size;
    EXPECT_LT(e.area, 3e-2) << size;  // area has a jump at the patch's edge, force a kink, energy neither
  }
}

// A lattice sum of a function whose derivative of order k jumps on a circle is off by h^(k + 3/2) in the root
// mean square over positions (Kendall 1948: k = 0): area 3/2, force 5/2, energy 7/2. Elements below r/4 hold
// one point each, so this is convergence with the mesh.
TEST(ContactMesh, area_force_and_energy_converge_at_orders_3_2_5_2_and_7_2) {
  std::vector<double> area, force, energy;
  for (int i = 0; i < 4; ++i) {
    const Errors e = plate_errors(0.16 / (1 << i), 0.3 * kRadius);
    area.push_back(e.area), force.push_back(e.force), energy.push_back(e.energy);
  }
  const char* why = "144 places know a root mean square to 6 %, an order to 0.12; twice that";
  claim::expect_order({"K.10", "sphere in a plate: area of the patch, root mean square over places", why},
                      area, 1.25, 1.75);
  claim::expect_order({"K.11", "sphere in a plate: force, root mean square over places", why}, force, 2.25,
                      2.75);
  claim::expect_order({"K.10", "sphere in a plate: energy, root mean square over places", why}, energy, 3.25,
                      3.75);
}

TEST(ContactMesh, force_follows_depth) {
  for (const double depth : {0.02, 0.05, 0.1, 0.3, 0.42}) {
    const Errors e = plate_errors(0.04, depth * kRadius);
    EXPECT_LT(e.force, 1e-2 * std::pow(0.04 / depth, 1.5)) << depth;  // spacing over the patch's radius
  }
}

// In the stiff limit a flat skin under pressure p lies on the sphere: patch area times pressure is the force.
TEST(ContactMesh, patch_eq_circle_cut_from_the_sphere) {
  const double depth = 0.01;  // [m]
  const auto skin = scenes::plate(61, 0.02 * kRadius * 2.0);
  const auto t =
      scenes::touch(scenes::contact(skin, kRadius, kStiffness), skin.nodes, {0.0, 0.0, kRadius - depth});
  EXPECT_NEAR(closed_form::sphere_plane_cut(kRadius, depth).patch_area, 0.0022619467105846511, 1e-15);
  claim::expect_relative(
      {"K.18", "sphere 10 mm in a plate: area of the patch [m2]", "order 3/2 from elements of 0.04 r"},
      t.result.area, 0.0022619467105846511, 5e-3);
}

TEST(ContactMesh, points_are_never_farther_apart_than_a_quarter_radius) {
  for (const double size : {0.01, 0.17, 0.18, 1.0, 30.0}) {
    const auto skin = scenes::plate(1, size * kRadius);
    const auto model = scenes::contact(skin, kRadius, kStiffness);
    const double edge = size * kRadius * std::sqrt(2.0);
    EXPECT_LE(edge / model.subdivision(0), 0.25 * kRadius * (1.0 + 1e-12)) << size;
    if (model.subdivision(0) > 1) {
      EXPECT_GT(edge / (model.subdivision(0) - 1), 0.25 * kRadius) << size;
    }
  }
}

}  // namespace
