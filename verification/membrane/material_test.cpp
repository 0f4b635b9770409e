// SPDX-License-Identifier: Apache-2.0
// The pointwise fabric law (M.2, M.3).
#include "membrane/material.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "claim.hpp"
#include "closed_form/membrane.hpp"
#include "scenes.hpp"

using membrane::Compression;
using membrane::PlaneResponse;
using membrane::PlaneStrain;

namespace {

constexpr double kYoung = 60e6;
constexpr std::array<double, 4> kPoissons = {-0.4, 0.0, 0.3, 0.45};

// Principal strains e1 >= e2 with the first direction at `angle`.
PlaneStrain<double> strain(double e1, double e2, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {e1 * c * c + e2 * s * s, e1 * s * s + e2 * c * c, (e1 - e2) * c * s};
}

PlaneResponse<double> response(Compression compression, const PlaneStrain<double>& e, double nu) {
  return membrane::isotropic_response(compression, e, membrane::isotropic_constants(kYoung, nu));
}

double energy(Compression compression, const PlaneStrain<double>& e, double nu) {
  return response(compression, e, nu).energy_density;
}

// Taut, wrinkled and slack strains, none at a border.
std::vector<PlaneStrain<double>> strains() {
  std::vector<PlaneStrain<double>> list;
  for (const double angle : {0.0, 0.3, 1.2, 2.5})
    for (const auto& [e1, e2] :
         {std::pair{0.1, 0.05}, {0.02, 0.02}, {0.1, -0.02}, {0.1, -0.2}, {1e-3, -0.3}, {-0.1, -0.2}})
      list.push_back(strain(e1, e2, angle));
  return list;
}

// For a function with |W''| <= k: central difference over 2h errs by rounding eps W / h, W ~ k e^2 / 2 with e
// ~ 0.3, and by h^2 W''' / 6 with W''' ~ k / radius, radius >= 0.02 (0 where taut).
constexpr double kStep = 1e-5;
constexpr double kTolerance = 2.0 * kYoung * (scenes::kEps * 0.1 / kStep + kStep * kStep / 0.02);

}  // namespace

TEST(Material, stress_eq_energy_derivative) {
  for (const auto compression : {Compression::linear, Compression::none})
    for (const double nu : kPoissons)
      for (const auto& e : strains()) {
        const auto r = response(compression, e, nu);
        const auto slope = [&](double d11, double d22, double d12) {
          const auto at = [&](double h) {
            return energy(compression, {e.e11 + h * d11, e.e22 + h * d22, e.e12 + h * d12}, nu);
          };
          return (at(kStep) - at(-kStep)) / (2.0 * kStep);
        };
        EXPECT_NEAR(r.s11, slope(1.0, 0.0, 0.0), kTolerance);
        EXPECT_NEAR(r.s22, slope(0.0, 1.0, 0.0), kTolerance);
        EXPECT_NEAR(2.0 * r.s12, slope(0.0, 0.0, 1.0), kTolerance);  // e12 stands twice in the tensor
      }
}

TEST(Material, principal_values_eq_eigenvalues) {
  for (const auto compression : {Compression::linear, Compression::none})
    for (const auto& e : strains()) {
      const auto r = response(compression, e, 0.3);
      const auto largest = [](double a, double b, double c) {
        return 0.5 * (a + b) + std::hypot(0.5 * (a - b), c);
      };
      EXPECT_NEAR(r.strain_1, largest(e.e11, e.e22, e.e12), 8 * scenes::kEps);
      EXPECT_NEAR(r.stress_1, largest(r.s11, r.s22, r.s12), 32 * scenes::kEps * kYoung);
    }
}

TEST(Material, relaxed_stress_has_no_compression) {
  for (const auto& e : strains()) {
    const auto r = response(Compression::none, e, 0.3);
    const double smallest = 0.5 * (r.s11 + r.s22) - std::hypot(0.5 * (r.s11 - r.s22), r.s12);
    EXPECT_GE(smallest,
              -32 * scenes::kEps * kYoung);  // rounding of a handful of operations on stresses below E
  }
}

// The relaxed energy is the minimum over added wrinkle strains P >= 0, reached at a known P.
TEST(Material, relaxed_energy_eq_minimum_over_wrinkle_strain) {
  scenes::Random random(7);
  const double nu = 0.3;
  for (const auto& e : strains()) {
    const double relaxed = energy(Compression::none, e, nu);
    for (int trial = 0; trial < 200; ++trial) {
      const double a = 0.4 * random(), b = 0.4 * random(), c = 0.4 * random();
      const PlaneStrain<double> widened{e.e11 + a * a, e.e22 + b * b + c * c, e.e12 + a * b};  // P = L L^T
      EXPECT_LE(relaxed, energy(Compression::linear, widened, nu) * (1.0 + 1e-12) + 1e-9);
    }
  }
  for (const double angle : {0.1, 1.0}) {
    const double wrinkled = energy(Compression::none, strain(0.1, -0.2, angle), nu);
    claim::expect_near(
        {"M.3", "wrinkled: energy of the minimising wrinkle strain [J/m3]", "4500 roundings of E"}, wrinkled,
        energy(Compression::linear, strain(0.1, -nu * 0.1, angle), nu), 1e-12 * kYoung);
    EXPECT_EQ(energy(Compression::none, strain(-0.1, -0.2, angle), nu), 0.0);
  }
}

// Across both borders the stress changes by no more than the taut stiffness times the change of strain.
TEST(Material, relaxed_stress_continuous_at_borders) {
  const double delta = 1e-9;
  for (const double nu : kPoissons)
    for (const double angle : {0.0, 0.7, 2.0}) {
      const auto jump = [&](double e1, double e2, double d1, double d2) {
        const auto p = response(Compression::none, strain(e1 + d1, e2 + d2, angle), nu);
        const auto m = response(Compression::none, strain(e1 - d1, e2 - d2, angle), nu);
        return std::max({std::abs(p.s11 - m.s11), std::abs(p.s22 - m.s22), std::abs(p.s12 - m.s12)});
      };
      const double allowed = 2.0 * delta * kYoung / (1.0 - nu) + 32 * scenes::kEps * kYoung;
      EXPECT_LE(jump(0.1, -nu * 0.1, 0.0, delta), allowed);  // taut - wrinkled
      EXPECT_LE(jump(0.0, -0.1, delta, 0.0), allowed);       // wrinkled - slack
    }
}

TEST(Material, element_states_eq_closed_form) {
  const closed_form::Sheet sheet = closed_form::paper_fabric();
  const double allowed = 16 * scenes::kEps * kYoung;
  const char* why = "16 roundings of E";
  const auto uniaxial = closed_form::uniaxial_tension(sheet, 1.2);
  const double e1 = 0.5 * (1.2 * 1.2 - 1.0);
  const double e2 = 0.5 * (uniaxial.transverse_stretch * uniaxial.transverse_stretch - 1.0);
  const auto shear = closed_form::simple_shear(sheet, 0.1);
  for (const auto compression : {Compression::linear, Compression::none}) {
    const auto tension = response(compression, {e1, e2, 0.0}, 0.3);
    claim::expect_near({"M.2", "uniaxial tension, stretch 1.2, both laws: stress [Pa]", why}, tension.s11,
                       uniaxial.stress, allowed);
    EXPECT_NEAR(tension.s22, 0.0, allowed);
  }
  const auto sheared = response(Compression::linear, {0.0, 0.005, 0.05}, 0.3);
  EXPECT_NEAR(sheared.s11, shear.s11, allowed);
  EXPECT_NEAR(sheared.s22, shear.s22, allowed);
  claim::expect_near({"M.2", "simple shear of 0.1: shear stress [Pa]", why}, sheared.s12, shear.s12, allowed);
}

// No direction is principal here: the wrinkled branch divides by a vanishing radius.
TEST(Material, equal_contraction_is_slack) {
  const auto r = response(Compression::none, {-0.1, -0.1, 0.0}, 0.3);
  EXPECT_EQ(r.s11, 0.0);
  EXPECT_EQ(r.s12, 0.0);
  EXPECT_EQ(r.energy_density, 0.0);
}

TEST(Material, no_strain_gives_no_stress) {
  for (const auto compression : {Compression::linear, Compression::none}) {
    const auto r = response(compression, {0.0, 0.0, 0.0}, 0.3);
    EXPECT_EQ(r.s11, 0.0);
    EXPECT_EQ(r.s12, 0.0);
    EXPECT_EQ(r.energy_density, 0.0);
  }
}
