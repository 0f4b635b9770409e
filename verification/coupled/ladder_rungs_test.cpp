// SPDX-License-Identifier: Apache-2.0
// Which rungs a ladder runs, and where it stops.
#include <gtest/gtest.h>

#include <algorithm>

#include "closed_form/coupled.hpp"
#include "driver/ladder.hpp"
#include "run_case.hpp"

namespace {

using coupled::case_file;
using driver::LadderRung;
using driver::Verdict;
using Texts = std::vector<std::string>;

driver::LadderOptions options_of(const char* quantity) {
  return {quantity, 0.02, {}, 16, 1, true};
}

struct Nothing {
  const char* name;
  const char* scene;
  const char* quantity;
  Texts settings;
  const char* reason;
};

class ladder_without_size : public testing::TestWithParam<Nothing> {};

TEST_P(ladder_without_size, is_told_from_the_full_case_alone) {
  const Nothing& p = GetParam();
  const auto result = driver::run_ladder(case_file(p.scene), p.settings, options_of(p.quantity));
  EXPECT_NE(result.reason.find(p.reason), std::string::npos) << result.reason;
  EXPECT_EQ(result.rungs.size(), 1u) << "no other rung is run";
  EXPECT_EQ(result.verdict, Verdict::not_judged);
}

INSTANTIATE_TEST_SUITE_P(
    quantities, ladder_without_size,
    testing::Values(Nothing{"seed_without_contact",
                            "passenger_pendulum",
                            "first_contact",
                            {"scene.end_time=1e-4"},
                            "seed 1 of rung \"full\", to which all are compared: the run has no such event"},
                    Nothing{"pendulum_at_rest",
                            "passenger_pendulum",
                            "pendulum_angle",
                            {"scene.end_time=1e-4"},
                            "pendulum_angle_rad is 0 in the full case"},
                    Nothing{"jet_not_fired",
                            "plate_jet",
                            "jet_force",
                            {"target.columns=20", "target.rows=20", "inflator.0.start_time=5"},
                            "jet_force_N is 0 in the full case"},
                    Nothing{"tank_at_ambient_pressure",
                            "rigid_tank",
                            "pressure",
                            {"inflator.0.start_time=5"},
                            "pressure_Pa is 101325 in the full case"}),
    [](const auto& test) { return std::string(test.param.name); });

// Of the case's own constant heat capacities the full case makes NASA-7, and one rung takes that back.
TEST(ladder, case_as_it_is_runs_once) {
  const auto result = driver::run_ladder(case_file("tank_stiff"), {}, options_of("pressure"));
  const auto is_own = [](const LadderRung& r) { return r.overrides.empty(); };
  EXPECT_EQ(std::count_if(result.rungs.begin(), result.rungs.end(), is_own), 1);
  EXPECT_EQ(std::find_if(result.rungs.begin(), result.rungs.end(), is_own)->name, "as it is: cp constant");
}

// A sphere blown up slowly against its breathing: its volume follows its pressure, and so does the rung's.
TEST(ladder, bag_without_a_membrane_is_the_sphere_at_rest) {
  auto options = options_of("pressure");
  options.hold = {"cp", "compression", "mesh", "step"};
  const auto result = driver::run_ladder(case_file("sphere_inflation"), {}, options);
  const auto rung = std::find_if(result.rungs.begin(), result.rungs.end(),
                                 [](const LadderRung& r) { return r.name == "volume by pressure"; });
  ASSERT_NE(rung, result.rungs.end());
  driver::CaseDocument document(case_file("sphere_inflation"), rung->overrides);
  const driver::Scene scene = driver::read_scene(document);
  ASSERT_TRUE(scene.gas->model.volume_of_overpressure && !scene.bag);
  const auto knots = scene.gas->model.volume_of_overpressure->knots();
  const closed_form::StretchedSphere sphere{{60e6, 0.3, 0.5e-3, 620.0}, 0.3};
  // Facets: skin and volume are those of a sphere smaller by that.
  const double facets = 1.0 - closed_form::icosphere_ratios(3).volume_ratio;
  constexpr double rest = 1e-4 / 3.0;  // of the side, where the motion is taken for rest
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const double exact = closed_form::stretched_sphere(sphere, knots[i].time).stretch;
    EXPECT_NEAR(std::cbrt(knots[i].value / knots[0].value), exact, facets * (exact - 1.0) + rest)
        << knots[i].time;
  }
  const auto& model = scene.gas->model;
  const double r = model.thermo.gas_constant(scene.gas->initial_fractions),
               gamma = model.thermo.gamma(scene.gas->initial_fractions, 300.0);
  const closed_form::SphereFill fill{{r, gamma}, sphere, 101325.0, 406.0};
  const double exact = closed_form::sphere_fill(fill, closed_form::sphere_fill_stretch(fill, 0.02)).pressure;
  // The chord of a curve that bends over a factor of two in pressure, and the facets.
  EXPECT_NEAR((rung->value.mean - 101325.0) / (exact - 101325.0), 1.0, 2.0 * facets);
}

}  // namespace
