// SPDX-License-Identifier: Apache-2.0
// When a run looks at its skin, and what it says of it.
#include "results/skin_checks.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "case_folder.hpp"
#include "engine/run.hpp"
#include "results/summary.hpp"
#include "run_case.hpp"

namespace {

using driver::SkinCheck;

struct Seen {
  driver::RunOutcome outcome;
  driver::State state;
  std::vector<SkinCheck> checks;
};

Seen checked(const driver::Scene& scene, bool with_checks = true) {
  Seen run{.outcome = {}, .state = driver::make_state(scene), .checks = {}};
  driver::SkinChecks checks(scene);
  std::vector<driver::LevelView> views;
  if (with_checks) views.push_back(checks.view());
  run.outcome = driver::run_scene(
      scene, run.state, [](bool, const driver::State&) {}, views);
  run.checks = checks.found();
  return run;
}

std::vector<double> times(const Seen& run) {
  std::vector<double> list;
  for (const SkinCheck& check : run.checks) list.push_back(check.time);
  return list;
}

// The start of a sphere whose halves have passed through each other by `depth` [m] each.
void push_through(driver::Scene& scene, double depth) {
  for (auto x : scene.bag->initial_position.colwise()) x(0) += x(0) > 0.0 ? -depth : depth;
}

TEST(skin_checks, are_at_the_start_at_the_end_and_three_times_between) {
  const driver::Scene scene = coupled::scene_of("passenger_pendulum", {"scene.end_time=0.03"});
  const Seen run = checked(scene);
  const auto& checks = run.checks;
  ASSERT_EQ(checks.size(), 5u);
  EXPECT_EQ(checks.front().time, 0.0);
  EXPECT_EQ(checks.back().time, scene.time.end);
  const double initial = checks.front().volume,
               design = mesh::enclosed_volume(scene.bag->mesh.nodes, scene.bag->mesh.elements);
  double before = 0.0;
  for (std::size_t k = 1; k <= 3; ++k) {
    const double way = (checks[k].volume - initial) / (design - initial);
    EXPECT_GE(way, 0.25 * static_cast<double>(k));
    EXPECT_LT(way, 0.25 * static_cast<double>(k) + 0.01) << "the first level past it";
    EXPECT_GT(checks[k].time, before);
    before = checks[k].time;
  }
}

TEST(skin_checks, change_no_bit_of_a_run) {
  const driver::Scene scene = coupled::scene_of(
      "passenger_pendulum", {"scene.end_time=0.012", "output.self_intersection_every=1e-3"});
  const Seen with = checked(scene), without = checked(scene, false);
  EXPECT_GT(with.checks.size(), 10u);
  EXPECT_TRUE(without.checks.empty());
  EXPECT_EQ(with.state.steps, without.state.steps);
  EXPECT_EQ(with.state.bag->position.map(), without.state.bag->position.map());
  EXPECT_EQ(with.state.gas.internal_energy, without.state.gas.internal_energy);
}

TEST(skin_checks, come_at_multiples_too) {
  const driver::Scene scene =
      coupled::scene_of("sphere_inflation", {"scene.end_time=0.001", "output.self_intersection_every=3e-4",
                                             "output.history_every=1e-4", "output.history_exact=true"});
  EXPECT_EQ(times(checked(scene)).size(), 5u) << "0, 0.3, 0.6, 0.9 and 1 ms";
}

TEST(skin_checks, of_a_sheet_have_no_volume) {
  const Seen run = checked(coupled::scene_of("clamped_disc", {"scene.end_time=1e-3"}));
  EXPECT_EQ(times(run), (std::vector<double>{0.0, 1e-3}));
  for (const SkinCheck& look : run.checks) {
    EXPECT_EQ(look.volume, 0.0);
    EXPECT_EQ(look.crossing.pairs, 0u);
  }
}

TEST(skin_checks, warn_of_a_start_that_passes_through_itself) {
  driver::Scene scene = coupled::scene_of("sphere_inflation");
  driver::add_skin_warning(scene);
  EXPECT_TRUE(scene.warnings.empty());
  push_through(scene, 0.1 * scene.bag->initial_position.rowwise().maxCoeff()(0));
  driver::add_skin_warning(scene);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("membrane: the skin passes through itself at the start: "),
            std::string::npos);
  EXPECT_NE(scene.warnings[0].find(" are counted twice or inside out"), std::string::npos)
      << scene.warnings[0];
}

TEST(skin_checks, refuse_layers_that_cross_at_the_start_if_the_skin_touches_itself) {
  driver::CaseDocument document(coupled::case_file("sphere_inflation"),
                                {"membrane.self_contact.thickness=1e-3"});
  driver::Scene scene = driver::load_scene(document);
  EXPECT_NO_THROW(driver::require_separate_layers(document, scene));
  push_through(scene, 0.5 * scene.bag->initial_position.rowwise().maxCoeff()(0));
  try {
    driver::require_separate_layers(document, scene);
    ADD_FAILURE() << "accepted";
  } catch (const driver::CaseError& error) {
    const std::string message = error.what();
    for (const char* word : {"membrane.self_contact: layers cross at the start, ", " that are no neighbours",
                             "the first near [", "elements ", " (from 0)", "counted twice or inside out"})
      EXPECT_NE(message.find(word), std::string::npos) << message;
  }
}

TEST(skin_checks, name_neighbours_that_cross_at_the_start_in_spite_of_contact) {
  driver::Scene scene = coupled::scene_of("sphere_inflation", {"membrane.self_contact.thickness=1e-3"});
  push_through(scene, 0.1 * scene.bag->initial_position.rowwise().maxCoeff()(0));
  driver::add_skin_warning(scene);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(
      scene.warnings[0].find("membrane: neighbours, which self_contact does not part, cross at the start: "),
      std::string::npos)
      << scene.warnings[0];
}

TEST(skin_checks, warn_of_any_layers_that_cross_in_spite_of_contact) {
  SkinCheck check{.time = 0.01, .volume = 0.03, .crossing = {}};
  check.crossing.pairs = 3;
  check.crossing.elements = 5;
  EXPECT_EQ(driver::note_of_crossing({check}, true), "") << "neighbours, and no volume";
  check.crossing.layers = 2;
  EXPECT_EQ(driver::note_of_crossing({check}), "");
  const std::string note = driver::note_of_crossing({check}, true);
  EXPECT_NE(
      note.find("at 0.01 s 5 elements cross in 3 pairs, 2 of these pairs of elements that are no neighbours"),
      std::string::npos)
      << note;
}

TEST(skin_checks, warn_above_a_hundredth_of_the_volume) {
  const auto note = [](double time, double twice, double inside_out) {
    SkinCheck check{.time = time, .volume = 0.03, .crossing = {}};
    check.crossing.pairs = 601;
    check.crossing.elements = 402;
    check.crossing.volumes.counted_twice.value = twice;
    check.crossing.volumes.inside_out.value = inside_out;
    return driver::note_of_crossing(
        {SkinCheck{}, check, SkinCheck{.time = 1.0, .volume = 0.03, .crossing = {}}});
  };
  EXPECT_EQ(note(0.011, 2.9e-4, 0.0), "");
  EXPECT_NE(note(0.011, 2.9e-4, 0.2e-4), "") << "both count";
  EXPECT_EQ(note(0.0, 5.6e-4, 0.0), "") << "the start has its own warning";
  EXPECT_NE(note(0.011, 5.6e-4, 0.0)
                .find("at 0.011 s 402 elements cross in 601 pairs, 0.00056 of 0.03 m3 (1.9 %) are "
                      "counted twice or inside out; above 1 %"),
            std::string::npos)
      << note(0.011, 5.6e-4, 0.0);
}

TEST(skin_checks, stand_in_the_summary) {
  driver::Scene scene = coupled::scene_of("sphere_inflation", {"scene.end_time=1e-4"});
  push_through(scene, 0.1 * scene.bag->initial_position.rowwise().maxCoeff()(0));
  const Seen run = checked(scene);
  const auto json =
      nlohmann::json::parse(driver::summary_text(scene, run.state, run.outcome, run.checks, {}));
  const auto& own = json.at("self_intersection");
  ASSERT_EQ(own.at("looks").size(), run.checks.size());
  const auto& first = own["looks"][0];
  EXPECT_EQ(first.at("time_s"), 0.0);
  EXPECT_GT(first.at("pairs"), 0);
  EXPECT_GT(first.at("inside_out_m3"), 0.0);
  EXPECT_GT(first.at("inside_out_standard_error_m3"), 0.0);
  for (const char* key : {"pairs", "elements", "counted_twice_m3", "inside_out_m3"})
    for (const auto& look : own["looks"]) EXPECT_GE(own.at("largest").at(key), look.at(key)) << key;
}

TEST(skin_checks, need_a_membrane) {
  EXPECT_NE(coupled::message_of(coupled::case_file("rigid_tank"), {"output.self_intersection_every=1e-3"})
                .find("output.self_intersection_every: the scene has no membrane"),
            std::string::npos);
}

}  // namespace
