// SPDX-License-Identifier: Apache-2.0
// Restitution of a jet as a curve over injected by contained mass, and what a case may say of it.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/step.hpp"
#include "fault.hpp"
#include "run_case.hpp"

namespace {

using coupled::Fault;
using Overrides = std::vector<std::string>;

// Case jet_bag with one jet; the skin's own velocity does not count.
const Overrides kOneJet{"inflator.1.start_time=1.0", "inflator.0.jet.relative_to_skin=false",
                        "inflator.1.jet.relative_to_skin=false", "membrane.mesh.levels=2",
                        "scene.end_time=0.006"};

Overrides with(const std::string& restitution) {
  Overrides all = kOneJet;
  all.push_back("inflator.0.jet.restitution=" + restitution);
  return all;
}

// e falls from 0.8 to -0.2 at a ratio of 0.025, rises to 3 at 0.05, and is held.
TEST(restitution, curve_is_read_at_the_ratio_of_masses) {
  const auto scene = coupled::scene_of("jet_bag", with("{mass_ratio=[0.0,0.025,0.05],value=[0.8,-0.2,3.0]}"));
  EXPECT_EQ(scene.jets.front().field.model().restitution, 0.8);
  driver::State state = driver::make_state(scene);
  const jet::JetField& field = scene.jets.front().field;
  jet::FieldState number = field.make_state();
  double first = 0.0, largest = 0.0;
  int loaded = 0;
  while (state.time < scene.time.end) {
    driver::evaluate_level(scene, state, {});
    if (state.time == 0.0) first = state.gas_point.mass;
    const double in = state.flows.mass_in, held = state.gas_point.mass;
    EXPECT_NEAR(held, first + in, 1e-12 * held) << "nothing leaves the bag";
    const double ratio = in / held;
    const double exact = ratio < 0.025  ? 0.8 - 40.0 * ratio
                         : ratio < 0.05 ? -0.2 + 128.0 * (ratio - 0.025)
                                        : 3.0;
    const driver::JetRun& run = state.jets.front();
    EXPECT_NEAR(run.field.restitution, exact,
                1e-14 * 4.0);  // 4 eps of each of two routes, with slopes of up to 128
    largest = std::max(largest, ratio);
    // The load is that of a jet with this number.
    membrane::BagState bag = *state.bag;
    membrane::update_geometry(scene.bag->model, bag);
    number.restitution = run.field.restitution;
    field.evaluate(bag.area_vector.map(), bag.centroid.map(), run.outlet, number);
    EXPECT_EQ(number.candidates, run.field.candidates);
    for (const int e : run.field.candidates) {
      const auto k = static_cast<std::size_t>(e);
      if (run.field.overpressure[k] == 0.0) continue;  // hidden
      EXPECT_EQ(run.field.overpressure[k], number.overpressure[k]);
      ++loaded;
    }
    driver::advance_level(scene, state, {});
    state.time += state.step.after;
    ++state.steps;
  }
  EXPECT_GT(largest, 0.06);
  EXPECT_GT(loaded, 200);
}

TEST(restitution, constant_curve_has_the_bits_of_the_number) {
  const auto number = coupled::run_case("jet_bag", with("0.3"));
  const auto curve = coupled::run_case("jet_bag", with("{mass_ratio=[0.0,1.0],value=[0.3,0.3]}"));
  ASSERT_EQ(number.outcome.status, driver::RunStatus::done) << number.outcome.message;
  ASSERT_EQ(curve.outcome.status, driver::RunStatus::done) << curve.outcome.message;
  EXPECT_EQ(number.history, curve.history);
  EXPECT_EQ(number.energy, curve.energy);
  const auto other = coupled::run_case("jet_bag", with("{mass_ratio=[0.0,1.0],value=[0.3,0.4]}"));
  EXPECT_NE(number.history, other.history);
}

// With pieces and a skin that moves, the elements' damping has the curve's value.
TEST(restitution, curve_reaches_the_damping_of_pieces) {
  Overrides all = with("{mass_ratio=[0.0,0.5],value=[-0.4,3.0]}");
  all.insert(all.end(), {"inflator.0.jet.relative_to_skin=true", "inflator.0.jet.subdivisions=2"});
  const auto scene = coupled::scene_of("jet_bag", all);
  driver::State state = driver::make_state(scene);
  for (int i = 0; i < 40; ++i) {
    driver::evaluate_level(scene, state, {});
    const driver::JetRun& run = state.jets.front();
    EXPECT_EQ(run.load().restitution, run.field.restitution);
    driver::advance_level(scene, state, {});
    state.time += state.step.after;
    ++state.steps;
  }
  EXPECT_GT(state.jets.front().field.restitution, -0.4);
}

TEST(restitution, curve_comes_from_a_file) {
  const coupled::Folder folder;
  std::ofstream(folder.path / "e.csv") << "mass_ratio,value\n0,0.8\n0.1,-0.2\n";
  const auto text = coupled::read(coupled::case_file("jet_bag"));
  const auto scene =
      coupled::scene_of_text(folder, text, {"inflator.0.jet.restitution={file=\"e.csv\",column=\"value\"}"});
  const auto& curve = scene.jets.front().restitution;
  ASSERT_TRUE(curve.has_value());
  EXPECT_NEAR(curve->value(0.05), 0.3, 1e-15);
}

class bad_restitution : public testing::TestWithParam<Fault> {};

TEST_P(bad_restitution, is_refused_where_it_stands) {
  coupled::expect_refused_where_it_stands(GetParam());
}

const char* const kPlateLine = "restitution = 1.0             # complete reflection";
const char* const kBagLine = "relative_to_skin = true";
const Fault kFaults[] = {
    {"number_too_small", "plate_jet", kPlateLine, "restitution = -0.51", "inflator.0.jet.restitution",
     "-0.5 to 4"},
    {"number_too_large", "plate_jet", kPlateLine, "restitution = 4.01", "inflator.0.jet.restitution",
     "-0.5 to 4"},
    {"curve_without_a_bag", "plate_jet", kPlateLine,
     "restitution = { mass_ratio = [0.0, 1.0], value = [0.0, 1.0] }", "inflator.0.jet.restitution",
     "no volume of gas"},
    {"value_too_large", "jet_bag", kBagLine, "restitution = { mass_ratio = [0.0, 1.0], value = [0.0, 4.1] }",
     "inflator.0.jet.restitution", "-0.5 to 4", "value = [0.0, 4.1"},
    {"value_too_small", "jet_bag", kBagLine, "restitution = { mass_ratio = [0.0, 1.0], value = [-0.6, 1.0] }",
     "inflator.0.jet.restitution", "-0.5 to 4", "value = [-0.6"},
    {"unordered_knots", "jet_bag", kBagLine,
     "restitution = { mass_ratio = [0.0, 0.5, 0.4], value = [0.0, 1.0, 1.0] }", "inflator.0.jet.restitution",
     "strictly rising order"},
    {"jump", "jet_bag", kBagLine, "restitution = { mass_ratio = [0.0, 0.5, 0.5], value = [0.0, 1.0, 2.0] }",
     "inflator.0.jet.restitution", "strictly rising order"},
    {"one_knot", "jet_bag", kBagLine, "restitution = { mass_ratio = [0.0], value = [0.0] }",
     "inflator.0.jet.restitution", "2 or more"},
    {"curve_of_time", "jet_bag", kBagLine, "restitution = { time = [0.0, 1.0], value = [0.0, 1.0] }",
     "inflator.0.jet.restitution", "mass_ratio", "{ time = [0.0, 1.0]"},
    {"expanded_cone", "jet_slot_plate", "spread = \"cone\"",
     "outlet = \"expanded\"\ntemperature = \"stagnation\"\nspread = \"cone\"", "inflator.0.jet.spread",
     "momentum", "spread ="},
    {"expanded_static", "plate_jet", kPlateLine, "outlet = \"expanded\"", "inflator.0.jet.temperature",
     "stagnation", "[inflator.jet]"},
    {"no_such_outlet", "plate_jet", kPlateLine, "outlet = \"expandet\"", "inflator.0.jet.outlet",
     "\"expanded\""}};

INSTANTIATE_TEST_SUITE_P(faults, bad_restitution, testing::ValuesIn(kFaults),
                         [](const auto& fault) { return std::string(fault.param.name); });

}  // namespace
