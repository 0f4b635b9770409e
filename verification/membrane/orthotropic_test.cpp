// SPDX-License-Identifier: Apache-2.0
// The woven fabric's pointwise law (M.13, M.14).
#include "membrane/orthotropic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "claim.hpp"
#include "closed_form/weave.hpp"
#include "scenes.hpp"

using membrane::Compression;
using membrane::PlaneResponse;
using membrane::PlaneStrain;
using membrane::Weave;

namespace {

// Nearly isotropic, a fabric soft in shear, an unbalanced one, negative Poisson ratio, stiff in shear.
constexpr std::array<Weave, 5> kWeaves = {{{60e6, 55e6, 0.3, 22e6},
                                           {60e6, 60e6, 0.2, 0.6e6},
                                           {60e6, 6e6, 0.9, 1e6},
                                           {20e6, 60e6, -0.3, 5e6},
                                           {60e6, 60e6, 0.1, 600e6}}};

struct Principal {
  double e1, e2, angle;
};

PlaneStrain<double> strain(const Principal& p) {
  const double c = std::cos(p.angle), s = std::sin(p.angle);
  return {p.e1 * c * c + p.e2 * s * s, p.e1 * s * s + p.e2 * c * c, (p.e1 - p.e2) * c * s};
}

PlaneResponse<double> response(Compression compression, const PlaneStrain<double>& e, const Weave& w,
                               double warp = 0.0) {
  return membrane::orthotropic_response(
      compression, e, membrane::orthotropic_constants(w, std::cos(2 * warp), std::sin(2 * warp)));
}

// Random strains up to 0.3, and states at the corners of the cone: uniaxial, equal, none.
std::vector<PlaneStrain<double>> cone_strains() {
  std::vector<PlaneStrain<double>> list = {{0, 0, 0},   {-0.1, -0.1, 0}, {0.1, 0.1, 0},
                                           {0.1, 0, 0}, {0, 0, 0.1},     {-0.1, 0, 0}};
  scenes::Random random(11);
  for (int i = 0; i < 300; ++i) list.push_back(strain({0.3 * random(), 0.3 * random(), 4.0 * random()}));
  return list;
}

// The greatest stiffness of the weave in any direction is below this [Pa].
double stiffness(const Weave& w) {
  const double reciprocal = 1.0 - w.poisson * w.poisson * w.young_modulus_weft / w.young_modulus_warp;
  return 2.0 *
         std::max({w.young_modulus_warp / reciprocal, w.young_modulus_weft / reciprocal, 2.0 * w.shear});
}

double largest_difference(const PlaneResponse<double>& a, const PlaneResponse<double>& b) {
  return std::max({std::abs(a.s11 - b.s11), std::abs(a.s22 - b.s22), std::abs(a.s12 - b.s12)});
}

}  // namespace

// The oracle maximises over the direction of tension, a route without a scaled frame or Newton.
TEST(Orthotropic, relaxed_state_eq_maximum_over_tension_direction) {
  for (const auto& w : kWeaves)
    for (const auto& e : cone_strains()) {
      const auto exact = closed_form::woven_tension_field(
          {w.young_modulus_warp, w.young_modulus_weft, w.poisson, w.shear}, e.e11, e.e22, e.e12);
      const auto r = response(Compression::none, e, w);
      const double allowed = 50 * 100 * scenes::kEps * 0.5 * stiffness(w);
      const char* why = "50 operations on strains below 0.5, times the ratio of stiffnesses, 100";
      EXPECT_NEAR(r.s22, exact.s22, allowed);
      EXPECT_NEAR(r.s12, exact.s12, allowed);
      claim::expect_near({"M.14", "five weaves, 306 strains, tension field: stress along the warp [Pa]", why},
                         r.s11, exact.s11, allowed);
      claim::expect_near({"M.14", "five weaves, 306 strains, tension field: energy [J/m3]", why},
                         r.energy_density, exact.energy_density, 0.5 * allowed);
    }
}

TEST(Orthotropic, stress_eq_energy_derivative) {
  const double h = 1e-5;
  for (const auto compression : {Compression::linear, Compression::none})
    for (const auto& w : kWeaves)
      for (const auto& e : cone_strains()) {
        const auto r = response(compression, e, w, 0.4);
        const auto slope = [&](double d11, double d22, double d12) {
          const auto at = [&](double s) {
            return response(compression, {e.e11 + s * d11, e.e22 + s * d22, e.e12 + s * d12}, w, 0.4)
                .energy_density;
          };
          return (at(h) - at(-h)) / (2.0 * h);
        };
        // W has a Lipschitz derivative: a step across a border or near the tip errs by at most stiffness x h
        // / 2; rounding eps W / h is 100 times less.
        const double allowed = stiffness(w) * h;
        EXPECT_NEAR(r.s11, slope(1.0, 0.0, 0.0), allowed);
        EXPECT_NEAR(r.s22, slope(0.0, 1.0, 0.0), allowed);
        EXPECT_NEAR(2.0 * r.s12, slope(0.0, 0.0, 1.0), 2.0 * allowed);  // e12 stands twice in the tensor
      }
}

// The stress changes by no more than the stiffness times the change of strain, everywhere: it is continuous.
TEST(Orthotropic, stress_is_continuous) {
  scenes::Random random(5);
  for (const auto& w : kWeaves)
    for (const auto& e : cone_strains())
      for (int trial = 0; trial < 4; ++trial) {
        const double delta = std::pow(10.0, -3.0 - 4.0 * trial);
        const PlaneStrain<double> near{e.e11 + delta * random(), e.e22 + delta * random(),
                                       e.e12 + delta * random()};
        const double jump =
            largest_difference(response(Compression::none, e, w), response(Compression::none, near, w));
        // 2: norm of three components of at most delta each; rounding as in the comparison with the oracle.
        EXPECT_LE(jump, 2.0 * stiffness(w) * delta + 50 * 100 * scenes::kEps * stiffness(w));
      }
}

TEST(Orthotropic, relaxed_stress_has_no_compression) {
  for (const auto& w : kWeaves)
    for (const auto& e : cone_strains()) {
      const auto r = response(Compression::none, e, w, 1.1);
      const double smallest = 0.5 * (r.s11 + r.s22) - std::hypot(0.5 * (r.s11 - r.s22), r.s12);
      EXPECT_GE(smallest, -50 * scenes::kEps * stiffness(w));
      EXPECT_NEAR(r.stress_1, 0.5 * (r.s11 + r.s22) + std::hypot(0.5 * (r.s11 - r.s22), r.s12),
                  50 * scenes::kEps * stiffness(w));
    }
}

TEST(Orthotropic, isotropic_constants_give_the_isotropic_law) {
  const double young_modulus = 60e6, nu = 0.3;
  for (const auto compression : {Compression::linear, Compression::none})
    for (const double warp : {0.0, 0.6, 2.0})
      for (const auto& e : cone_strains()) {
        const auto woven = response(
            compression, e, {young_modulus, young_modulus, nu, 0.5 * young_modulus / (1.0 + nu)}, warp);
        const auto plain =
            membrane::isotropic_response(compression, e, membrane::isotropic_constants(young_modulus, nu));
        // Rounding of some 30 operations on stresses below 0.5 E / (1 - nu).
        const double allowed = 30 * scenes::kEps * young_modulus;
        EXPECT_LE(largest_difference(woven, plain), allowed);
        EXPECT_NEAR(woven.energy_density, plain.energy_density, 0.5 * allowed);
        EXPECT_NEAR(woven.strain_1, plain.strain_1, 4 * scenes::kEps);
        EXPECT_NEAR(woven.stress_1, plain.stress_1, allowed);
      }
}

// Warp, strain and stress turned together.
TEST(Orthotropic, turning_the_frame_turns_the_stress) {
  scenes::Random random(3);
  for (const auto compression : {Compression::linear, Compression::none})
    for (const auto& w : kWeaves)
      for (int trial = 0; trial < 50; ++trial) {
        const Principal p{0.3 * random(), 0.3 * random(), 3.0 * random()};
        const double turn = 3.0 * random(), c = std::cos(turn), s = std::sin(turn);
        const auto r = response(compression, strain(p), w);
        const auto t = response(compression, strain({p.e1, p.e2, p.angle + turn}), w, turn);
        const double allowed = 50 * 100 * scenes::kEps * stiffness(w);
        EXPECT_NEAR(t.s11, r.s11 * c * c + r.s22 * s * s - 2.0 * r.s12 * c * s, allowed);
        EXPECT_NEAR(t.s12, (r.s11 - r.s22) * c * s + r.s12 * (c * c - s * s), allowed);
        EXPECT_NEAR(t.energy_density, r.energy_density, allowed);
      }
}

// Along the borders themselves and to the smallest strains, the root's first round is its last.
TEST(Orthotropic, borders_and_tiny_strains_are_finite) {
  for (const auto& w : kWeaves)
    for (const double size : {1.0, 1e-8, 1e-100, 1e-200, 1e-310})
      for (const auto& e : cone_strains()) {
        const auto r = response(Compression::none, {size * e.e11, size * e.e22, size * e.e12}, w);
        for (const double value : {r.s11, r.s22, r.s12, r.energy_density, r.stress_1})
          EXPECT_LE(std::abs(value), 2.0 * size * stiffness(w));
      }
}

// A strip cut at an angle to the warp, pulled: the off-axis modulus.
TEST(Orthotropic, uniaxial_tension_eq_off_axis_modulus) {
  for (const auto& w : kWeaves)
    for (const double angle : {0.0, 0.3, 0.7, 1.2}) {
      const double modulus = closed_form::off_axis_modulus(
          {w.young_modulus_warp, w.young_modulus_weft, w.poisson, w.shear}, angle);
      // Pulled along the first axis and free to contract and wrinkle across: strongly contracted.
      const double c = std::cos(angle), s = std::sin(angle);
      const double s11 = c * c, s22 = s * s,
                   s12 = -c * s;  // unit tension seen from the warp, which lies at -angle
      const double a = 1.0 / w.young_modulus_warp, nu = w.poisson * a;
      const double e11 = a * s11 - nu * s22, e22 = s22 / w.young_modulus_weft - nu * s11,
                   e12 = 0.5 * s12 / w.shear;
      // Turned into the frame whose first axis is the tension, scaled to a stress of 1 MPa, and wrinkled
      // further across.
      const PlaneStrain<double> e{1e6 * (e11 * c * c + e22 * s * s - 2.0 * e12 * c * s),
                                  1e6 * (e11 * s * s + e22 * c * c + 2.0 * e12 * c * s) - 0.2,
                                  1e6 * ((e11 - e22) * c * s + e12 * (c * c - s * s))};
      const auto r = response(Compression::none, e, w, angle);
      EXPECT_NEAR(e.e11 * modulus, 1e6, 100 * scenes::kEps * 1e6);
      claim::expect_near({"M.13", "strips cut at angles to the warp, pulled to 1 MPa: stress [Pa]",
                          "50 operations, times the ratio of stiffnesses, 100"},
                         r.s11, 1e6, 50 * 100 * scenes::kEps * stiffness(w));
      EXPECT_NEAR(r.s12, 0.0, 50 * 100 * scenes::kEps * stiffness(w));
    }
}
