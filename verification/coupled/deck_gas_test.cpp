// SPDX-License-Identifier: Apache-2.0
// The gas of a deck, what becomes of triggers, and what is said of parts and keys that a deck has not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "export/deck.hpp"
#include "export/deck_fabric.hpp"
#include "export/feature.hpp"
#include "export/lsdyna.hpp"
#include "export/radioss.hpp"
#include "results/load_scene.hpp"

namespace {

using driver::DeckFormat;
using driver::Mapping;
using Settings = std::vector<std::string>;

constexpr DeckFormat kFormats[]{DeckFormat::radioss, DeckFormat::lsdyna};

/// A case, its scene and its deck with what becomes of the keys.
struct Exported {
  driver::CaseDocument document;
  driver::Scene scene;
  driver::Deck deck;
  std::vector<driver::UsedFeature> used;

  Exported(const std::string& name, const Settings& settings, DeckFormat format)
      : document(GASJET_SOURCE_DIR "/cases/" + name + ".toml", settings),
        scene(driver::load_scene(document)),
        deck(driver::make_deck(scene, format)) {
    if (format == DeckFormat::lsdyna) driver::leave_out_lsdyna_vents(deck);
    used = driver::used_features(document, deck);
  }
  std::string mapping(const std::string& key) const {
    const auto found = std::ranges::find(used, key, &driver::UsedFeature::path);
    return found == used.end() ? "no such key" : driver::name_of(found->outcome.mapping);
  }
  std::string note(const std::string& key) const {
    const auto found = std::ranges::find(deck.notes, key, &driver::DeckNote::key);
    return found == deck.notes.end() ? "" : found->text;
  }
};

const Settings kHot{"gas.thermodynamics=\"nasa7\"", "gas.initial.composition={N2=1.0}",
                    "gas.initial.pressure=3e5", "gas.initial.temperature=900.0"};

// What comes in with h(T_in) = u(T_0) leaves the gas at T_0. The heat capacity is that of the case below
// 1000 K in the first format; in the second one it is off by its misfit.
TEST(deck_gas, initial_overpressure_comes_in_with_the_internal_energy_of_the_start) {
  for (const DeckFormat format : kFormats) {
    const Exported hot("sphere_inflation", kHot, format);
    const driver::DeckInflator& inflator = hot.deck.inflators.back();
    const gas::Thermo& thermo = hot.scene.gas->model.thermo;
    const auto& fractions = hot.scene.gas->initial_fractions;
    const double T = inflator.temperature.front()[1], u = thermo.internal_energy(fractions, 900.0);
    const double missed = (thermo.enthalpy(fractions, T) - u) / (thermo.cp(fractions, T) * 900.0);
    EXPECT_LT(std::abs(missed), format == DeckFormat::radioss ? 1e-12 : inflator.gas.parabola_misfit);
  }
}

// Its temperature is held before, its flow is not.
TEST(deck_gas, constant_flow_that_begins_later_is_zero_before) {
  const std::string flow =
      "inflator=[{composition={N2=1.0},mass_flow=1.0,temperature=500.0,start_time=0.005}]";
  for (const DeckFormat format : kFormats) {
    const driver::DeckInflator made = Exported("sphere_inflation", {flow}, format).deck.inflators.front();
    ASSERT_EQ(made.mass_flow.size(), 4u);
    EXPECT_EQ(made.mass_flow[0][1], 0.0);
    EXPECT_EQ(made.mass_flow[1][1], 0.0);
    EXPECT_NEAR(made.mass_flow[1][0], 0.005, 1e-6 * 0.06 * (1.0 + 1e-9));
    EXPECT_EQ(made.mass_flow[2][0], 0.005);
    EXPECT_EQ(made.mass_flow[2][1], 1.0);
    for (const auto& [time, temperature] : made.temperature) EXPECT_EQ(temperature, 500.0) << time;
  }
}

// 40 g in 20 ms, then 16 g in 40 ms, of which 0.75 is used: the deck has rates, with jumps of a millionth of
// the end (60 ms).
TEST(deck_gas, cumulative_curve_in_other_units_is_a_rate) {
  const Settings settings{
      "inflator.0.mass_flow={ time = [0, 20, 60], value = [0, 40, 56], cumulative = true, units = { time = "
      "\"ms\", value = \"g\" }, scale = 0.75 }"};
  for (const DeckFormat format : kFormats) {
    const Exported made("sphere_inflation", settings, format);
    const auto& flow = made.deck.inflators.front().mass_flow;
    double mass = 0.0;
    for (std::size_t i = 1; i < flow.size(); ++i)
      mass += 0.5 * (flow[i][0] - flow[i - 1][0]) * (flow[i][1] + flow[i - 1][1]);
    EXPECT_NEAR(mass, 0.75 * 0.056, 2.0 * 1.5 * 1e-6 * 0.06);  // two jumps of at most 1.5 kg/s
    EXPECT_NEAR(std::ranges::max(flow, {}, [](const auto& point) { return point[1]; })[1], 1.5, 1e-12);
    EXPECT_EQ(made.mapping("inflator.0.mass_flow.scale"), "exact");
    EXPECT_EQ(made.mapping("inflator.0.mass_flow.units.value"), "exact");
  }
}

TEST(deck_gas, initial_overpressure_is_there_at_once_or_within_a_pulse) {
  const Exported radioss("sphere_inflation", kHot, DeckFormat::radioss),
      lsdyna("sphere_inflation", kHot, DeckFormat::lsdyna);
  const driver::DeckInflator &mass = radioss.deck.inflators.back(), &flow = lsdyna.deck.inflators.back();
  ASSERT_TRUE(mass.of_mass);
  double sum = 0.0;
  for (std::size_t k = 1; k < flow.mass_flow.size(); ++k)
    sum += 0.5 * (flow.mass_flow[k][0] - flow.mass_flow[k - 1][0]) *
           (flow.mass_flow[k][1] + flow.mass_flow[k - 1][1]);
  EXPECT_NEAR(sum / mass.mass_flow.front()[1], 1.0, 1e-14);
  EXPECT_EQ(mass.mass_flow.front()[1], mass.mass_flow.back()[1]);
  EXPECT_NE(lsdyna.note("gas.initial.pressure").find("breathes as fast"), std::string::npos);
}

TEST(deck_gas, misfit_is_that_of_the_highest_temperature) {
  Settings hotter = kHot;
  hotter.back() = "gas.initial.temperature=1200.0";
  const Exported hot("sphere_inflation", hotter, DeckFormat::radioss);
  const driver::DeckGas& gas = hot.deck.initial_gas;
  double cp = 0.0;
  for (std::size_t j = gas.cp.size(); j-- > 0;) cp = cp * 1200.0 + gas.cp[j];
  const double misfit =
      std::abs(cp / hot.scene.gas->model.thermo.cp(hot.scene.gas->initial_fractions, 1200.0) - 1.0);
  EXPECT_NEAR(gas.misfit, misfit, 1e-12);
  EXPECT_NE(hot.note("gas.thermodynamics").find(" % "), std::string::npos);
  const Exported constant("sphere_inflation", {"gas.initial.temperature=1200.0"}, DeckFormat::radioss);
  EXPECT_EQ(constant.note("gas.thermodynamics"), "");
}

const Settings kTriggers{
    "sensor=[{name=\"crash\",signal={time=[0.0,0.004,0.01],value=[0.0,8.0,20.0]},above=10.0},"
    "{name=\"p\",overpressure=5e3,reset=2e3},{name=\"wave\",signal={time=[0.0,0.01,0.02],value=[0.0,1.0,0.0]}"
    ","
    "above=0.5}]",
    "trigger=[{name=\"late\",all=[\"crash\"],delay=0.003},{name=\"either\",any=[\"p\",\"late\"]}]",
    "gas.species=[{name=\"mine\",molar_mass=0.04,cp=700.0}]",
    "inflator=[{composition={N2=1.0},mass_flow={time=[0.0,0.01],value=[1.0,0.0]},temperature=500.0,"
    "trigger=\"late\",start_time=0.001},{composition={mine=1.0},mass_flow=1.0,temperature=500.0,trigger="
    "\"either\"}]",
    "vent=[{area=1e-3,trigger=\"wave\"},{area=2e-3,trigger=\"p\",backflow=true},"
    "{area={time=[0.0,0.01],value=[1e-3,2e-3]},trigger=\"crash\"}]"};

TEST(deck_gas, triggers_of_time_and_signal_become_times) {
  for (const DeckFormat format : kFormats) {
    const Exported made("sphere_inflation", kTriggers, format);
    ASSERT_EQ(made.deck.inflators.size(), 1u);
    // 10 is passed at 5 ms, 3 ms delay, 1 ms of its own.
    const driver::DeckCurve& flow = made.deck.inflators[0].mass_flow;
    EXPECT_EQ(driver::value_on(flow, 0.0089), 0.0);
    EXPECT_NEAR(driver::value_on(flow, 0.014), 0.5, 1e-12);
    // On from 5 ms to 15 ms; a curve of the time since it opens.
    ASSERT_EQ(made.deck.vents.size(), 2u);
    const driver::DeckCurve &wave = *made.deck.vents[0].of_time, &curve = *made.deck.vents[1].of_time;
    for (const auto& [t, open] : {std::pair{0.0049, 0.0}, {0.0051, 1.0}, {0.0149, 1.0}, {0.0151, 0.0}})
      EXPECT_EQ(driver::value_on(wave, t), open) << t;
    EXPECT_EQ(driver::value_on(curve, 0.0049), 0.0);
    EXPECT_NEAR(driver::value_on(curve, 0.010), 1.5e-3, 1e-15);
  }
}

TEST(deck_gas, what_is_left_out_is_said_to_be_and_so_is_what_serves_it_alone) {
  for (const DeckFormat format : kFormats) {
    const Exported made("sphere_inflation", kTriggers, format);
    for (const char* key : {"inflator.1.mass_flow", "inflator.1.trigger", "vent.1.area", "gas.species.0.cp",
                            "sensor.1.overpressure", "trigger.1.any"})
      EXPECT_EQ(made.mapping(key), "left out") << key;
    for (const char* key : {"inflator.0.start_time", "sensor.0.above"})
      EXPECT_EQ(made.mapping(key), "exact") << key;
    EXPECT_EQ(made.mapping("ambient.temperature"), "no counterpart");
    const std::string text = driver::export_markdown(made.deck, made.used, "title");
    EXPECT_NE(text.find("- `vent.1` is left out: its trigger depends on the run"), std::string::npos);
  }
  // Beside one of time, a vent with a curve of overpressure needs the place that leaking fabric takes.
  const Settings two{
      "vent=[{area={overpressure=[0.0,1e4],value=[0.0,1e-3]}},{area={time=[0.0,0.01],value=[0.0,1e-3]}}]",
      "fabric.porosity=0.1", "fabric.leak_law=\"printed\""};
  EXPECT_EQ(Exported("sphere_inflation", two, DeckFormat::lsdyna).mapping("vent.0.area.value"), "left out");
  EXPECT_EQ(Exported("sphere_inflation", two, DeckFormat::radioss).mapping("vent.0.area.value"), "exact");
}

TEST(deck_gas, an_effect_that_the_deck_has_not_gets_a_note) {
  const Exported made("sphere_inflation",
                      {"gas.heat_loss={coefficient=5.0,area=1.0}",
                       "vent=[{area=1e-3,backflow=true},{area=1e-3,backflow=false}]"},
                      DeckFormat::radioss);
  Settings keys;
  for (const auto& note : driver::notes_of_lost(made.used)) keys.push_back(note.key);
  std::ranges::sort(keys);
  EXPECT_EQ(keys, (Settings{"gas.heat_loss.coefficient", "vent.0.backflow"}));
}

TEST(deck_gas, histories_reach_the_end_of_the_scene) {
  const Exported made("sphere_inflation", {"output.history_every=1e-3"}, DeckFormat::lsdyna);
  // A row at the first step past a multiple of the interval, if steps are below a hundredth of the run.
  EXPECT_GE(driver::run_end(made.scene), 1.01 * made.scene.time.end + 1e-3);
}

TEST(deck_gas, a_mesh_too_coarse_for_the_impactor_gets_a_note) {
  const Exported coarse("contact_vent", {}, DeckFormat::radioss),
      fine("contact_vent", {"membrane.mesh.levels=5"}, DeckFormat::radioss);
  EXPECT_NE(coarse.note("membrane.mesh").find("sinks in"), std::string::npos);
  EXPECT_EQ(fine.note("membrane.mesh"), "");
}

}  // namespace
