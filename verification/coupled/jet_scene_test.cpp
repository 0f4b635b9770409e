// SPDX-License-Identifier: Apache-2.0
// A jet on a fixed plate: force against momentum.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "claim.hpp"
#include "closed_form/jet.hpp"
#include "jet/jet.hpp"
#include "jet_tree/tree_route.hpp"
#include "run_case.hpp"

namespace {

const bool kTreeAdded = jet::add_tree_route();

// The case's outlet: 2 kg/s of the model nitrogen at 406 K through 5e-3 m2.
const auto kOutlet = closed_form::sonic_outlet({{}, 406.0, false, 2.0, 5e-3});

TEST(jet_scene, plate_force_eq_twice_momentum) {
  const auto run = coupled::run_case("plate_jet");
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done);
  const auto scene = coupled::scene_of("plate_jet");
  const double exact = closed_form::plate_force(2.0, kOutlet.momentum_flux);
  const double loss = jet::momentum_loss(scene.jets.front().field.model());
  // The centre rule on elements of 10 mm against a jet 76 mm wide is spectrally accurate, and so is the
  // plate's edge: exp(-2 (0.6/0.076)^2).
  EXPECT_LE(run.history.back().at("jet_force_N"), exact * (1.0 + 1e-9));
  claim::expect_relative({"J.6", "case plate_jet: force, twice the momentum flux [N]",
                          "the cut-off's share of the momentum, which is left out"},
                         run.history.back().at("jet_force_N"), exact, loss + 1e-5);
}

TEST(jet_scene, plate_force_scales_with_restitution_and_mass_flow) {
  const double full = coupled::run_case("plate_jet").history.back().at("jet_force_N");
  const double deflected =
      coupled::run_case("plate_jet", {"inflator.0.jet.restitution=0.0"}).history.back().at("jet_force_N");
  const double half =
      coupled::run_case("plate_jet", {"inflator.0.mass_flow=1.0"}).history.back().at("jet_force_N");
  EXPECT_NEAR(deflected / full, 0.5, 1e-14);  // (1 + 0) / (1 + 1), one rounding
  EXPECT_NEAR(half / full, 0.5, 1e-14);
}

TEST(jet_scene, attachment_behind_the_outlet_never_blocks) {
  // An outlet in the plane of the elements around it is before or behind them by luck of the last bit. Put it
  // behind them on purpose: named as attachment they do not block, not named they hide everything.
  const std::vector<std::string> behind{"scene.end_time=2e-4", "inflator.0.jet.centre=[-1e-18, 0.0, 0.0]"};
  const auto named = coupled::run_case("passenger_pendulum", behind);
  ASSERT_EQ(named.outcome.status, driver::RunStatus::done) << named.outcome.message;
  EXPECT_GT(named.history.back().at("jet_lit_elements"), 10.0);
  EXPECT_EQ(named.history.back().at("jet_hidden_elements"), 0.0);
  auto overrides = behind;
  overrides.push_back("inflator.0.jet.attachment_panels=[]");
  const auto blocked = coupled::run_case("passenger_pendulum", overrides);
  ASSERT_EQ(blocked.outcome.status, driver::RunStatus::done) << blocked.outcome.message;
  EXPECT_EQ(blocked.history.back().at("jet_lit_elements"), 0.0);
  EXPECT_EQ(blocked.history.back().at("jet_hidden_elements"), named.history.back().at("jet_lit_elements"));
}

void expect_same_runs(const coupled::CaseRun& a, const coupled::CaseRun& b) {
  ASSERT_EQ(a.outcome.status, driver::RunStatus::done) << a.outcome.message;
  ASSERT_EQ(b.outcome.status, driver::RunStatus::done) << b.outcome.message;
  ASSERT_EQ(a.history.size(), b.history.size());
  for (std::size_t i = 0; i < a.history.size(); ++i) {
    EXPECT_EQ(a.history[i].at("jet_force_N"), b.history[i].at("jet_force_N"));
    EXPECT_EQ(a.history[i].at("jet_hidden_elements"), b.history[i].at("jet_hidden_elements"));
    EXPECT_EQ(a.history[i].at("pressure_Pa"), b.history[i].at("pressure_Pa"));
  }
}

TEST(jet_scene, routes_give_the_same_run) {
  const auto with = [](const char* end, const char* route) {
    return coupled::run_case("passenger_pendulum", {std::string("scene.end_time=") + end,
                                                    std::string("inflator.0.jet.visibility=") + route});
  };
  // The bag folds over itself from 3 ms on: the routes have to agree on every hidden element, bit for bit.
  const auto fast = with("0.008", "fast");
  expect_same_runs(fast, with("0.008", "cgal_tree"));
  EXPECT_GT(fast.state.jets.front().total.hidden, 100u);
  expect_same_runs(with("5e-4", "fast"), with("5e-4", "brute_force"));
}

TEST(jet_scene, fast_route_eq_cgal_tree_at_every_step_of_the_run) {
  // The paper's scene with 688 elements: unfolds, folds over itself, fills; the fast route keeps what it
  // remembers from step to step, the tree is built anew at each.
  const driver::Scene scene = coupled::scene_of(
      "passenger_pendulum",
      {"membrane.mesh.depth_cells=10", "membrane.mesh.width_cells=6", "membrane.mesh.height_cells=7",
       "membrane.mesh.attachment_width_cells=4", "membrane.mesh.attachment_height_cells=3",
       "membrane.mesh.vent_depth_cell=3", "membrane.mesh.vent_height_cell=3",
       "contact.stiffness_share=4.0"});  // large elements are soft
  const driver::JetPart& part = scene.jets.front();
  const jet::RaySource source = jet::ray_source(part.field.model());
  jet::VisibilityQuery query = *part.query;
  jet::FieldState field = part.field.make_state();
  std::size_t steps = 0, differ = 0, other_candidates = 0;
  std::vector<std::uint8_t> lit;
  const auto compare = [&](const driver::State& state) {
    const driver::JetRun& run = state.jets.front();
    membrane::BagState bag = *state.bag;
    membrane::update_geometry(scene.bag->model, bag);  // all elements, not only those that the run looked at
    part.field.evaluate(bag.area_vector.map(), bag.centroid.map(), run.outlet, field);
    other_candidates += field.candidates != run.field.candidates;
    lit.resize(run.field.candidates.size());
    if (lit.empty()) return;
    const auto counters = query.query(jet::VisibilityRoute::cgal_tree, state.bag->position.map(), source,
                                      run.field.candidates, lit);
    differ += !std::equal(lit.begin(), lit.end(), run.lit.begin()) || counters.hidden != run.counters.hidden;
    ++steps;
  };
  driver::State state = driver::make_state(scene);
  while (state.time < 0.08) {  // the jet blows until then
    driver::evaluate_level(scene, state, {});
    compare(state);
    driver::advance_level(scene, state, {});
    state.time += state.step.after;
  }
  EXPECT_EQ(other_candidates, 0u);  // of a field that looks at all elements
  EXPECT_EQ(differ, 0u);
  EXPECT_GT(steps, 500u);
  EXPECT_GT(state.jets.front().total.hidden, steps);
  EXPECT_EQ(state.jets.front().total.tree_builds, 0u);
}

/// Two jets against each other: column and summary's peak are of the resultant of both, over all steps.
/// A jet whose inflator waits for a trigger is the jet of one that starts at that time; before it there is
/// none.
TEST(jet_scene, triggered_inflator_eq_one_that_starts_then) {
  const std::vector<std::string> coarse{"membrane.mesh.levels=2", "scene.end_time=8e-3", "time.step=2e-5"};
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = coarse;
    all.insert(all.end(), more.begin(), more.end());
    return coupled::run_case("jet_bag", all);
  };
  const auto triggered = run({"sensor=[{name=\"clock\",time=0.003}]", "inflator.0.trigger=clock"});
  expect_same_runs(run({"inflator.0.start_time=0.003"}), triggered);
  EXPECT_GT(triggered.history.back().at("jet_force_N"), 0.0);
  const auto never = run(
      {"sensor=[{name=\"high\",overpressure=1e9}]", "inflator.0.trigger=high", "inflator.1.trigger=high"});
  ASSERT_EQ(never.outcome.status, driver::RunStatus::done) << never.outcome.message;
  EXPECT_EQ(never.history.back().at("jet_force_N"), 0.0);
}

TEST(jet_scene, peak_force_is_the_greatest_of_all_steps) {
  const auto scene = coupled::scene_of("jet_bag", {"output.history_every=2e-9"});
  const auto columns = driver::history_columns(scene);
  driver::State state = driver::make_state(scene);
  double greatest = 0.0;
  driver::run_scene(scene, state, [&](bool recorded, const driver::State& now) {
    ASSERT_TRUE(recorded);
    const double force = (now.jets.at(0).force + now.jets.at(1).force).norm();
    EXPECT_EQ(coupled::row_of(columns, scene, now).at("jet_force_N"), force) << now.time;
    greatest = std::max(greatest, force);
  });
  EXPECT_EQ(state.peaks.jet_force, greatest);
}

// The inflators of the case jet_bag, anew: flow [kg/s] at the peak, and TOML of the jets.
std::string inflator(double flow, const std::string& jets) {
  return "{ composition = { N2 = 1.0 }, temperature = 600.0, mass_flow = { time = [0.0, 0.005, 0.015], value "
         "= "
         "[0.0, " +
         std::to_string(flow) + ", 0.0] }, jet = " + jets + " }";
}
std::string outlet(const std::string& axis, const std::string& more = "") {
  return "{ shape = 'round', centre = [0, 0, 0], radius = 0.02, outlet_type = 'contracting_nozzle', outlet = "
         "'pressure_matched', temperature = 'stagnation', jet_work = 'from_gas', axis = " +
         axis + more + " }";
}
std::vector<coupled::Row> history_with(const std::string& inflators) {
  const auto run = coupled::run_case("jet_bag", {"inflator=[" + inflators + "]"});
  EXPECT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  return run.history;
}

TEST(jet_scene, outlets_of_one_inflator_eq_inflators_with_their_shares_and_a_ring) {
  const auto one = history_with(inflator(
      1.0, '[' + outlet("[1, 0, 0]", ", share = 0.5") + ", " + outlet("[-1, 0, 0]", ", share = 0.5") + ']'));
  const auto apart =
      history_with(inflator(0.5, outlet("[1, 0, 0]")) + ", " + inflator(0.5, outlet("[-1, 0, 0]")));
  const auto ring =
      history_with(inflator(1.0, outlet("[0, 0, 1]", ", ring = { holes = 2, first = [1, 0, 0] }")));
  ASSERT_EQ(one.size(), apart.size());
  ASSERT_EQ(one.size(), ring.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_NEAR(one[i].at("pressure_Pa"), apart[i].at("pressure_Pa"), 1e-6) << i;
    EXPECT_NEAR(one[i].at("pressure_Pa"), ring[i].at("pressure_Pa"), 1e-6) << i;
  }
  EXPECT_GT(one.back().at("pressure_Pa"), 1.1e5);
  EXPECT_EQ(coupled::scene_of("ring_jet").jets.size(), 7u);
}

TEST(jet_scene, outlets_that_are_none_are_refused_where_they_stand) {
  for (const auto& [jets, says] : std::initializer_list<std::pair<std::string, const char*>>{
           {'[' + outlet("[1, 0, 0]", ", share = 0.5") + ", " + outlet("[-1, 0, 0]", ", share = 0.6") + ']',
            "inflator.0.jet.1.share: the shares of all outlets sum to 1.1, needed: 1"},
           {'[' + outlet("[1, 0, 0]") + ']', "inflator.0.jet.0.share: is missing"},
           {outlet("[1, 0, 0]", ", share = 0.5"), "share"},
           {outlet("[1, 0, 0]", ", ring = { holes = 1 }"), "ring.holes"},
           {outlet("[1, 0, 0]", ", ring = { first = [2, 0, 0] }"), "ring.first: is along the axis"}})
    try {
      coupled::scene_of("jet_bag", {"inflator=[" + inflator(1.0, jets) + ']'});
      ADD_FAILURE() << says;
    } catch (const driver::CaseError& error) {
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
    }
}

}  // namespace
