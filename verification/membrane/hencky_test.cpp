// SPDX-License-Identifier: Apache-2.0
// The pointwise Hencky law (M.25 to M.27).
#include "membrane/hencky.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "claim.hpp"
#include "closed_form/logarithmic.hpp"
#include "scenes.hpp"

using membrane::Compression;
using membrane::PlaneResponse;
using membrane::PlaneStrain;

// The names below are those of other laws too.
namespace hencky_tests {
namespace {

constexpr double kYoung = 60e6;
constexpr std::array<double, 6> kPoissons = {-0.9, -0.4, 0.0, 0.3, 0.45, 0.9};

// Green-Lagrange strain of two logarithmic strains, the first at `angle`.
PlaneStrain<double> strain(double log_1, double log_2, double angle = 0.0) {
  const double e1 = 0.5 * std::expm1(2.0 * log_1), e2 = 0.5 * std::expm1(2.0 * log_2);
  const double c = std::cos(angle), s = std::sin(angle);
  return {e1 * c * c + e2 * s * s, e1 * s * s + e2 * c * c, (e1 - e2) * c * s};
}

PlaneResponse<double> response(const PlaneStrain<double>& e, double nu) {
  return membrane::hencky_response(e, membrane::hencky_constants(kYoung, nu));
}

double spherical(double nu) {
  return kYoung / (1.0 - nu);
}
double deviator(double nu) {
  return kYoung / (1.0 + nu);
}
// Greatest stiffness of the law over all states is below this: moduli, times the ratio of stretches e, twice.
double stiffness(double nu) {
  return 6.0 * (spherical(nu) + deviator(nu));
}

// The stored energy (M.25) as it is written, of a sheet that bears compression.
double taut_energy(double log_1, double log_2, double nu) {
  const double m = 0.5 * (log_1 + log_2), r = 0.5 * (log_1 - log_2);
  return spherical(nu) * (std::exp(2.0 * m) * (m - 0.5) + 0.5) + deviator(nu) * r * r * std::exp(2.0 * m);
}

// Taut, wrinkled and slack.
std::vector<PlaneStrain<double>> strains() {
  std::vector<PlaneStrain<double>> list = {strain(0.0, 0.0),   strain(-0.1, -0.1), strain(0.1, 0.1),
                                           strain(0.1, 0.0),   strain(0.1, -0.1),  strain(0.49, 0.49),
                                           strain(0.49, -3.0), strain(0.4, 0.0),   strain(-1.0, -2.0)};
  scenes::Random random(11);
  for (int i = 0; i < 300; ++i) {
    const double log_1 = 0.2 + 0.28 * random();
    list.push_back(strain(log_1, log_1 - 0.3 - 0.3 * random(), 4.0 * random()));
  }
  return list;
}

double largest_difference(const PlaneResponse<double>& a, const PlaneResponse<double>& b) {
  return std::max({std::abs(a.s11 - b.s11), std::abs(a.s22 - b.s22), std::abs(a.s12 - b.s12)});
}

}  // namespace

TEST(Hencky, interpolated_functions_eq_those_of_the_standard_library) {
  const double end = (membrane::kEuler - 1.0) / (membrane::kEuler + 1.0);
  for (int i = -1000; i <= 1000; ++i) {
    const double y = end * i / 1000.0;
    EXPECT_NEAR(membrane::atanh_series(y), std::atanh(y), 3 * scenes::kEps * std::abs(std::atanh(y)));
  }
  // exp(2 m) through the energy of an equally stretched state, which is K (exp(2m) (m - 1/2) + 1/2).
  for (int i = 0; i < 1000; ++i) {
    const double m = 0.4999 * i / 1000.0;
    const auto r = response(strain(m, m), 0.3);
    EXPECT_NEAR(r.energy_density, spherical(0.3) * (m * std::exp(2 * m) - 0.5 * std::expm1(2 * m)),
                30 * scenes::kEps * spherical(0.3) * (m + scenes::kEps));
  }
}

// Cauchy stress K m + G r^2 +- G r at constant thickness: S_i = J sigma_i / lambda_i^2.
TEST(Hencky, taut_stress_eq_the_law_in_logarithmic_strain) {
  for (const double nu : kPoissons)
    for (const auto& [log_1, log_2] :
         {std::pair{0.1, 0.08}, {0.45, 0.44}, {0.02, 0.02}, {1e-5, 0.9e-5}, {0.3, 0.25}}) {
      const double m = 0.5 * (log_1 + log_2), r = 0.5 * (log_1 - log_2);
      const double middle = spherical(nu) * m + deviator(nu) * r * r;
      if (middle < deviator(nu) * r) continue;  // wrinkled
      const double s1 = std::exp(-2.0 * r) * (middle + deviator(nu) * r);
      const double s2 = std::exp(2.0 * r) * (middle - deviator(nu) * r);
      const auto s = response(strain(log_1, log_2), nu);
      // Strains are known to eps, times 20 operations; the stiffness covers both moduli.
      const double allowed = 20 * scenes::kEps * stiffness(nu);
      const char* why = "20 roundings of the stiffness";
      claim::expect_near({"M.25", "taut states, six Poisson ratios: largest stress [Pa]", why}, s.s11, s1,
                         allowed);
      claim::expect_near({"M.25", "taut states, six Poisson ratios: smallest stress [Pa]", why}, s.s22, s2,
                         allowed);
      claim::expect_near({"M.25", "taut states, six Poisson ratios: energy [J/m3]", why}, s.energy_density,
                         taut_energy(log_1, log_2, nu), allowed);
    }
}

TEST(Hencky, stress_eq_energy_derivative) {
  const double h = 1e-5;
  for (const double nu : kPoissons)
    for (const auto& e : strains()) {
      const auto r = response(e, nu);
      const auto slope = [&](double d11, double d22, double d12) {
        const auto at = [&](double s) {
          return response({e.e11 + s * d11, e.e22 + s * d22, e.e12 + s * d12}, nu).energy_density;
        };
        return (at(h) - at(-h)) / (2.0 * h);
      };
      // W has a Lipschitz derivative: a step across a border errs by at most stiffness x h / 2.
      const double allowed = stiffness(nu) * h;
      EXPECT_NEAR(r.s11, slope(1.0, 0.0, 0.0), allowed);
      EXPECT_NEAR(r.s22, slope(0.0, 1.0, 0.0), allowed);
      EXPECT_NEAR(2.0 * r.s12, slope(0.0, 0.0, 1.0), 2.0 * allowed);  // e12 stands twice in the tensor
    }
}

// The relaxed energy by another route: a scan over the width, of the energy of a sheet that bears
// compression.
TEST(Hencky, relaxed_energy_eq_least_energy_over_added_width) {
  for (const double nu : {-0.4, 0.0, 0.3, 0.45})
    for (const double log_1 : {0.01, 0.07, 0.2, 0.45})
      for (const double log_2 : {-0.4, -0.05, -0.001, 0.005}) {
        double least = taut_energy(log_1, log_2, nu);
        const double step = 1e-5;
        for (double width = log_2; width <= log_1; width += step)
          least = std::min(least, taut_energy(log_1, width, nu));
        // Between the points of the scan the energy is lower by curvature x step^2 / 8 at most.
        const double allowed = 0.125 * stiffness(nu) * step * step + 30 * scenes::kEps * stiffness(nu);
        claim::expect_near({"M.26", "wrinkled and taut: energy, by a scan of the width [J/m3]",
                            "curvature between points of the scan, 1e-5 apart"},
                           response(strain(log_1, log_2, 0.7), nu).energy_density, least, allowed);
      }
}

TEST(Hencky, strip_that_wrinkles_eq_closed_form) {
  for (const double nu : {-0.4, 0.0, 0.3, 0.45})
    for (const double stretch : {1.001, 1.07, 1.3, 1.6}) {
      const auto exact = closed_form::logarithmic_strip({kYoung, nu, 1.0, 1.0}, stretch);
      const double log_1 = std::log(stretch);
      const auto s = response(strain(log_1, std::log(exact.transverse_stretch) - 0.3), nu);
      const double nominal = exact.stress * exact.transverse_stretch / stretch;  // J sigma / lambda^2
      const char* why = "20 roundings of the stiffness";
      const double allowed = 20 * scenes::kEps * stiffness(nu);
      claim::expect_near({"M.26", "wrinkled strip: second Piola-Kirchhoff stress [Pa]", why}, s.s11, nominal,
                         allowed);
      claim::expect_near({"M.26", "wrinkled strip: energy [J/m3]", why}, s.energy_density,
                         exact.energy_density, allowed);
      EXPECT_NEAR(s.s22, 0.0, allowed);
    }
}

TEST(Hencky, relaxed_stress_has_no_compression) {
  for (const double nu : kPoissons)
    for (const auto& e : strains()) {
      const auto r = response(e, nu);
      const double mean = 0.5 * (r.s11 + r.s22), radius = std::hypot(0.5 * (r.s11 - r.s22), r.s12);
      EXPECT_GE(mean - radius, -20 * scenes::kEps * stiffness(nu));
      EXPECT_NEAR(r.stress_1, mean + radius, 20 * scenes::kEps * stiffness(nu));
      EXPECT_GE(r.energy_density, -20 * scenes::kEps * stiffness(nu));
    }
}

TEST(Hencky, stress_is_continuous) {
  scenes::Random random(5);
  for (const double nu : kPoissons)
    for (const auto& e : strains())
      for (const double delta : {1e-3, 1e-6, 1e-9, 1e-12}) {
        const PlaneStrain<double> near{e.e11 + delta * random(), e.e22 + delta * random(),
                                       e.e12 + delta * random()};
        // 2: norm of three components of at most delta each.
        EXPECT_LE(largest_difference(response(e, nu), response(near, nu)),
                  2.0 * stiffness(nu) * delta + 40 * scenes::kEps * stiffness(nu));
      }
}

TEST(Hencky, turning_the_frame_turns_the_stress) {
  scenes::Random random(3);
  for (const double nu : kPoissons)
    for (int trial = 0; trial < 50; ++trial) {
      const double log_1 = 0.4 * random(), log_2 = 0.4 * random(), turn = 3.0 * random();
      const double c = std::cos(turn), s = std::sin(turn);
      const auto r = response(strain(log_1, log_2), nu), t = response(strain(log_1, log_2, turn), nu);
      const double allowed = 20 * scenes::kEps * stiffness(nu);
      EXPECT_NEAR(t.s11, r.s11 * c * c + r.s22 * s * s, allowed);
      EXPECT_NEAR(t.s12, (r.s11 - r.s22) * c * s, allowed);
      EXPECT_NEAR(t.energy_density, r.energy_density, allowed);
    }
}

// To first order the laws are the same; their difference over the stress is proportional to the strain.
TEST(Hencky, approaches_st_venant_kirchhoff_with_order_1_in_the_strain) {
  for (const auto& [name, ratio] :
       {std::pair{"equal", 1.0}, {"tension along one axis", -1.0}, {"plane", 0.0}}) {
    std::vector<double> error;
    for (const double size : {0.04, 0.02, 0.01}) {
      const auto e = strain(size, ratio * size, 0.3);
      const auto svk =
          membrane::isotropic_response<Compression::none>(e, membrane::isotropic_constants(kYoung, 0.3));
      error.push_back(response(e, 0.3).stress_1 / svk.stress_1 - 1.0);
    }
    claim::expect_order({"M.25", std::string("difference to St. Venant-Kirchhoff over the stress, ") + name,
                         "the next order is the strain, 4 % at most, times a factor below 3"},
                        error, 0.88, 1.12);
  }
}

// Slack, or without a principal direction.
TEST(Hencky, no_strain_and_equal_contraction_give_no_stress) {
  for (const auto& e : {strain(0.0, 0.0), strain(-0.1, -0.1), strain(-0.1, -0.4, 0.2)}) {
    const auto r = response(e, 0.3);
    for (const double value : {r.s11, r.s22, r.s12, r.energy_density, r.stress_1}) EXPECT_EQ(value, 0.0);
  }
}

TEST(Hencky, tiny_strains_are_finite) {
  for (const double size : {1e-8, 1e-100, 1e-200, 1e-310})
    for (const auto& e : strains()) {
      const auto r = response({size * e.e11, size * e.e22, size * e.e12}, 0.3);
      for (const double value : {r.s11, r.s22, r.s12, r.energy_density, r.stress_1})
        EXPECT_LE(std::abs(value), 2.0 * size * stiffness(0.3));
    }
}

TEST(Hencky, tangent_factor_ends_with_the_law) {
  const double limit = membrane::kHenckyStrainLimit;
  EXPECT_LT(response({limit, 0.1, 0.0}, 0.3).tangent_factor, 1.5);
  EXPECT_GT(response({limit * (1.0 + 1e-15), 0.1, 0.0}, 0.3).tangent_factor, 1e300);
  EXPECT_EQ(response(strain(-0.1, -0.2), 0.3).tangent_factor, 1.0);
}

}  // namespace hencky_tests
