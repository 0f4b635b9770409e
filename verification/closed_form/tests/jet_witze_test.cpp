// SPDX-License-Identifier: Apache-2.0
// Witze's centreline law. Reference numbers: the formula in 40-digit arithmetic (mpmath), rounded to 17
// digits.
#include <cmath>
#include <numbers>

#include "check.hpp"
#include "closed_form/jet.hpp"

namespace {

using namespace closed_form;
using test::expect_refused;
using test::expect_relative;
using test::kAlgebra;

const CompressibleJet kJets[] = {{0.0, 1.0}, {0.376, 0.5669}, {0.513, 1.0526}, {0.985, 1.1976}, {1.0, 0.4}};

TEST(WitzeJet, centreline_eq_reference) {
  struct Row {
    CompressibleJet jet;
    double core, constant, at_6, at_8, at_20, at_200;
  };
  for (const Row& r : {Row{{0.0, 1.0},
                           4.375,
                           6.25,
                           0.97863826082499295,
                           0.82167328454384686,
                           0.3296799539643607,
                           0.031443908331707829},
                       Row{{0.376, 0.5669},
                           3.971055350128819,
                           5.6729362144697414,
                           0.93894641983441588,
                           0.75537900116435261,
                           0.29806765966840064,
                           0.028524547833976686},
                       Row{{0.985, 1.1976},
                           5.4624440244365475,
                           7.8034914634807822,
                           0.99999950396129776,
                           0.95381959638028309,
                           0.41537316536642211,
                           0.039319155923550173}}) {
    expect_relative(witze_core_length(r.jet), r.core, kAlgebra);
    expect_relative(witze_decay_constant(r.jet), r.constant, kAlgebra);
    expect_relative(witze_centreline_ratio(r.jet, 6.0), r.at_6, kAlgebra);
    expect_relative(witze_centreline_ratio(r.jet, 8.0), r.at_8, kAlgebra);
    expect_relative(witze_centreline_ratio(r.jet, 20.0), r.at_20, kAlgebra);
    expect_relative(witze_centreline_ratio(r.jet, 200.0), r.at_200, kAlgebra);
  }
}

// The law read backwards: it is u where t = -1/ln(1 - u), that is at core (1 + t/0.70).
TEST(WitzeJet, core_ends_and_given_ratios_stand_where_the_inverse_says) {
  for (const CompressibleJet& jet : kJets) {
    const double core = witze_core_length(jet);
    EXPECT_EQ(witze_centreline_ratio(jet, 0.0), 1.0);
    EXPECT_EQ(witze_centreline_ratio(jet, 0.999999 * core), 1.0);
    EXPECT_LT(witze_centreline_ratio(jet, 1.1 * core), 1.0);  // exp(-1/t) of t = 0.07 is 6e-7
    EXPECT_GT(witze_centreline_ratio(jet, 1.1 * core), 1.0 - 1e-6);
    for (const double u : {0.99, 0.5, 0.1})
      expect_relative(witze_centreline_ratio(jet, core * (1.0 - 1.0 / (0.70 * std::log1p(-u)))), u,
                      10 * kAlgebra);  // where t is small its difference loses a digit
  }
}

// u' = -(1 - u) ln(1 - u)^2 growth, with growth = 1/decay_constant: no exponential of the law itself.
TEST(WitzeJet, centreline_solves_its_differential_equation) {
  for (const CompressibleJet& jet : kJets) {
    const double constant = witze_decay_constant(jet);
    const auto rate = [constant](double, const std::vector<double>& u) {
      const double log = std::log1p(-u[0]);
      return std::vector<double>{-(1.0 - u[0]) * log * log / constant};
    };
    const double start = witze_core_length(jet) + constant / std::numbers::ln2 / 2.0;  // u = 3/4
    const double end = test::integrate_ode(rate, {0.75}, start, 30.0)[0];
    expect_relative(witze_centreline_ratio(jet, 30.0), end, test::kIntegrated);
  }
}

// 1/(1 - exp(-1/t)) = t + 1/2 + 1/(12 t) - ..., t = z/B - 0.70: far out, where exp itself is of no use.
TEST(WitzeJet, far_field_falls_as_one_over_the_distance) {
  for (const CompressibleJet& jet : kJets)
    for (const double x : {1e4, 1e6}) {
      const double b = witze_decay_constant(jet);
      // The 0.70 left out of the last term: 0.70 b^2/(12 x^2) of x/b.
      expect_relative(1.0 / witze_centreline_ratio(jet, x), x / b - 0.20 + b / (12.0 * x),
                      0.1 * std::pow(b / x, 3) + kAlgebra);
    }
}

// Density and Mach number stretch the distance: by rho^(1/2 - 0.22) and 1/(1 - 0.16 M).
TEST(WitzeJet, density_and_mach_number_stretch_the_distance) {
  for (const double x : {5.0, 9.0, 25.0})
    for (const double q : {0.2, 0.5669, 1.1976, 3.0}) {
      const double by_density = std::sqrt(q) / std::pow(q, 0.22);
      expect_relative(witze_centreline_ratio({0.5, q}, x * by_density), witze_centreline_ratio({0.5, 1.0}, x),
                      10 * kAlgebra);
      expect_relative(witze_centreline_ratio({1.0, q}, x / 0.84), witze_centreline_ratio({0.0, q}, x),
                      10 * kAlgebra);
    }
  EXPECT_GT(witze_core_length({0.9, 1.2}), witze_core_length({0.9, 0.6}));  // a dense jet goes farther
  EXPECT_GT(witze_core_length({0.9, 1.2}), witze_core_length({0.1, 1.2}));
}

TEST(WitzeJet, bad_parameters_are_refused_by_name) {
  expect_refused([] { witze_core_length({}); }, "mach");
  expect_refused([] { witze_core_length({1.01, 1.0}); }, "mach");
  expect_refused([] { witze_core_length({0.5, 0.0}); }, "density_ratio");
  expect_refused([] { witze_centreline_ratio({0.5, 1.0}, -1.0); }, "distance_over_diameter");
}

}  // namespace
