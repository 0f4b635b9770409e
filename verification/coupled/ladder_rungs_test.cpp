// SPDX-License-Identifier: Apache-2.0
// Which rungs a ladder runs, and where it stops.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>

#include "base/progress.hpp"
#include "closed_form/coupled.hpp"
#include "many_runs/ladder.hpp"
#include "membrane/stages.hpp"
#include "results/load_scene.hpp"
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
    testing::Values(
        Nothing{"seed_without_contact",
                "passenger_pendulum",
                "first_contact",
                {"scene.end_time=1e-4"},
                "seed 1 of rung \"full\", the reference of all others: the run has no such event"},
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
  const driver::Scene scene = driver::load_scene(document);
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
  const double exact = closed_form::sphere_fill_by_mass(fill, 0.02).pressure;
  // The chord of a curve that bends over a factor of two in pressure, and the facets.
  EXPECT_NEAR((rung->value.mean - 101325.0) / (exact - 101325.0), 1.0, 2.0 * facets);
}

bool has_rung(const driver::LadderResult& result, const char* name) {
  return std::any_of(result.rungs.begin(), result.rungs.end(),
                     [&](const LadderRung& r) { return r.name == name && r.failure.empty(); });
}

// In a process of its own, since an interrupt stays.
TEST(ladder, interrupted_has_no_volume_that_was_not_found) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto interrupt = [] {
    driver::catch_interrupt();
    std::raise(SIGINT);
    const auto result = driver::run_ladder(case_file("sphere_inflation"), {}, options_of("pressure"));
    std::exit(has_rung(result, "rigid tank") && !has_rung(result, "volume by pressure") ? 0 : 1);
  };
  EXPECT_EXIT(interrupt(), testing::ExitedWithCode(0), "");
}

struct Leak {
  const char* name;
  const char* scene;
  Texts settings;
};

class ladder_leak : public testing::TestWithParam<Leak> {};

// The gas of a bag without its membrane leaks through what the skin as cut would: sums over the skin's
// elements by the membrane's own route.
TEST_P(ladder_leak, without_a_membrane_eq_that_of_the_skin_as_cut) {
  const auto file = case_file(GetParam().scene);
  Texts texts = GetParam().settings;
  const driver::Scene bag = coupled::scene_of(GetParam().scene, texts);
  auto state = membrane::make_state(bag.bag->model, bag.bag->model.description.reference);
  membrane::update_skin(bag.bag->model, state);
  const bool printed = bag.bag->leak_law == driver::LeakLaw::printed;
  const double area = printed ? state.surface.porosity_squared_area : state.surface.porosity_area;
  ASSERT_GT(area, 0.0);

  const auto plan = driver::plan_ladder(file, texts, "peak_pressure", {});
  ASSERT_TRUE(plan.no_membrane.has_value());
  texts.insert(texts.end(), plan.no_membrane->begin(), plan.no_membrane->end());
  texts.emplace_back("tank.volume=1");
  const driver::Scene tank = coupled::scene_of(GetParam().scene, texts);
  EXPECT_NEAR(tank.gas->tank_leak_area / area, 1.0, 2e3 * 2.2e-16);  // a rounding for each element
  const auto velocity = [](const driver::Scene& scene) {
    const auto& model = scene.gas->model;
    EXPECT_EQ(model.fabric_count(), 1u);
    return model.fabrics.empty() ? std::nullopt : model.fabrics.front().velocity;
  };
  const auto skin = velocity(bag), wall = velocity(tank);
  ASSERT_EQ(wall.has_value(), skin.has_value());
  if (!skin) return;
  ASSERT_EQ(wall->knots().size(), skin->knots().size());
  for (std::size_t i = 0; i < skin->knots().size(); ++i) {
    EXPECT_EQ(wall->knots()[i].time, skin->knots()[i].time);
    EXPECT_EQ(wall->knots()[i].value, skin->knots()[i].value);
  }
}

// Channel classes are of the pendulum, which goes with the membrane.
TEST(ladder_plan, leaves_the_membrane_out_of_a_case_with_channel_classes) {
  const auto plan = driver::plan_ladder(case_file("passenger_pendulum"), {"output.channel_classes=[60,180]"},
                                        "peak_pressure", {});
  EXPECT_TRUE(plan.no_membrane.has_value()) << testing::PrintToString(plan.left_out);
}

INSTANTIATE_TEST_SUITE_P(
    fabrics, ladder_leak,
    testing::Values(Leak{"panels", "driver_bag", {}},
                    Leak{"panels_as_a_screen", "driver_bag", {"fabric.leak_law=\"screen\""}},
                    Leak{"table", "bag_leak_table", {"fabric.porosity=0.5"}},
                    Leak{"table_from_a_file", "bag_from_files", {}}),
    [](const auto& test) { return std::string(test.param.name); });

// Flat as sewn, with panels that leak and straps: no tank of its design volume, but a volume by its pressure.
TEST(ladder, flat_bag_has_a_volume_by_pressure_alone) {
  auto options = options_of("pressure");
  options.hold = {"cp", "compression", "mesh", "step", "porosity"};
  const Texts small{"membrane.mesh.rings=6", "membrane.mesh.inflator_rings=1", "membrane.mesh.vent_ring=3",
                    "scene.end_time=1e-3"};
  const auto result = driver::run_ladder(case_file("driver_bag"), small, options);
  EXPECT_TRUE(has_rung(result, "volume by pressure"));
  EXPECT_FALSE(has_rung(result, "rigid tank"));
  EXPECT_EQ(result.plan.left_out, Texts{"rigid tank: the design shape is flat"});
}

}  // namespace
