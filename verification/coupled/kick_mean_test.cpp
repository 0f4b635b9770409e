// SPDX-License-Identifier: Apache-2.0
// Loads that a case gives over time: their impulse on what does not move, or moves freely, is that of the
// curve, however short a pulse is and wherever it lies between the steps (J.11), (K.41), (K.42).
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "case_folder.hpp"
#include "claim.hpp"
#include "engine/step.hpp"
#include "run_case.hpp"

namespace {

using coupled::scene_of_text;
using Numbers = std::vector<double>;

// Of one pulse: the knots of mass flow and temperature after the firing.
struct Pulse {
  const char* what;
  Numbers time, flow, heated, temperature;
  double start;  // [s] of the firing
};

const Pulse kPulses[] = {
    {"rectangle in 4 ms", {0.0, 4e-3, 4e-3, 0.05}, {1.25, 1.25, 0.0, 0.0}, {0.0}, {406.0}, 0.004},
    {"rectangle in 0.2 ms", {0.0, 2e-4, 2e-4, 0.05}, {25.0, 25.0, 0.0, 0.0}, {0.0}, {406.0}, 0.00407},
    {"rectangle in 50 us", {0.0, 5e-5}, {100.0, 100.0}, {0.0}, {406.0}, 0.004013},
    {"rectangle in 1 ns", {0.0, 1e-9}, {5e6, 5e6}, {0.0}, {406.0}, 0.0041},
    {"from the start", {0.0, 1e-5}, {500.0, 500.0}, {0.0}, {406.0}, 0.0},
    {"whole run from the start", {0.0, 0.02}, {0.5, 0.5}, {0.0}, {406.0}, 0.0},
    {"triangle in 30 us", {0.0, 1e-5, 3e-5}, {0.0, 333.0, 0.0}, {0.0}, {600.0}, 0.003},
    {"two teeth in one step",
     {0.0, 5e-6, 1e-5, 1e-5, 1.5e-5},
     {0.0, 400.0, 0.0, 300.0, 10.0},
     {0.0},
     {500.0},
     0.0051},
    {"ramps of flow and heat",
     {0.0, 2e-4, 3e-3},
     {0.0, 3.0, 0.5},
     {0.0, 1e-3, 2e-3},
     {300.0, 900.0, 350.0},
     0.0023},
    {"heat that jumps in a pulse",
     {0.0, 1e-5},
     {10.0, 400.0},
     {0.0, 5e-6, 5e-6, 2e-5},
     {300.0, 400.0, 1500.0, 900.0},
     0.006}};

// int mdot sqrt(T) dt from knot to knot, Simpson's rule in the root u of T, of a polynomial of degree four:
// by 2048 panels, to 1e-14 of it.
double rooted_impulse(const Pulse& p, double end) {
  const gas::Curve flow = [&] {
    std::vector<gas::Curve::Knot> knots;
    for (std::size_t i = 0; i < p.time.size(); ++i) knots.push_back({p.time[i], p.flow[i]});
    return gas::Curve(knots, gas::Outside::zero);
  }();
  std::vector<gas::Curve::Knot> knots;
  for (std::size_t i = 0; i < p.heated.size(); ++i) knots.push_back({p.heated[i], p.temperature[i]});
  const gas::Curve heat(knots, gas::Outside::held);
  Numbers breaks{0.0, end};
  for (const Numbers* list : {&p.time, &p.heated})
    for (const double t : *list)
      if (t > 0.0 && t < end) breaks.push_back(t);
  std::ranges::sort(breaks);
  double sum = 0.0;
  constexpr int panels = 2048;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double a = breaks[i], h = breaks[i + 1] - a;
    if (!(h > 0.0)) continue;
    const auto m = flow.piece(a + 0.5 * h), t = heat.piece(a + 0.5 * h);
    const double low = std::sqrt(t.at(a)), high = std::sqrt(t.at(a + h));
    const auto integrand = [&](double s) {  // dt = h 2 u du / (T_b - T_a), without the difference
      const double u = low + s * (high - low), share = s * (low + u) / (low + high);
      return h * m.at(a + share * h) * u * 2.0 * u / (low + high);
    };
    for (int k = 0; k < panels; ++k)
      sum += (integrand(double(k) / panels) + 4.0 * integrand((k + 0.5) / panels) +
              integrand(double(k + 1) / panels)) /
             (6.0 * panels);
  }
  return sum;
}

std::vector<std::string> overrides_of(const Pulse& p) {
  return {fmt::format("inflator.0.mass_flow={{time=[{}],value=[{}]}}", fmt::join(p.time, ","),
                      fmt::join(p.flow, ",")),
          p.heated.size() == 1 ? fmt::format("inflator.0.temperature={}", p.temperature[0])
                               : fmt::format("inflator.0.temperature={{time=[{}],value=[{}]}}",
                                             fmt::join(p.heated, ","), fmt::join(p.temperature, ",")),
          fmt::format("inflator.0.start_time={}", p.start)};
}

std::string held_sphere() {
  return R"(
[scene]
name = "held"
end_time = 0.01
[gas]
thermodynamics = "constant"
initial = { composition = { N2 = 1.0 } }
[[inflator]]
composition = { N2 = 1.0 }
mass_flow = 1.0
temperature = 406.0
[inflator.jet]
shape = "round"
centre = [-0.13, 0.0, 0.0]
axis = [1.0, 0.0, 0.0]
radius = 0.02
decay_coefficient = 0.08
subdivisions = 2
[fabric]
young_modulus = 60e6
poisson_ratio = 0.3
density = 620.0
thickness = 0.5e-3
leak_law = "none"
[membrane]
mesh = { generator = "icosphere", radius = 0.3, levels = 2 }
flatten = 0.5
fixed_panels = ["sphere"]
)";
}

struct Impulse {
  double thrust = 0.0, skin = 0.0;  // [N s] of rho0 V0^2 A, and of the force on the skin
};

// The run ends at half a step after its last level: up to there the kicks reach.
Impulse impulse_of(const driver::Scene& scene) {
  driver::State state = driver::make_state(scene);
  Impulse sum;
  const auto step = [&](const driver::StepRequest& request) {
    driver::evaluate_level(scene, state, request);
    const double kick = 0.5 * (state.step.before + state.step.after);
    const auto& run = state.jets.front();
    sum.thrust += kick * jet::momentum_flux(run.outlet, scene.jets.front().outlet.area);
    sum.skin += kick * run.force.norm();
    driver::advance_level(scene, state, request);
  };
  while (state.time < scene.time.end) {
    step({});
    state.time += state.step.after;
    ++state.steps;
  }
  step({.last = true});
  return sum;
}

// Without a step of its own, steps are those of (M.12), which vary with the gas.
TEST(kick_mean, held_skin_gets_the_impulse_of_any_pulse) {
  const coupled::Folder folder;
  double share = 0.0;  // of the thrust that the skin catches: the same for each pulse
  for (const Pulse& p : kPulses)
    for (const char* relative : {"false", "true"}) {
      auto overrides = overrides_of(p);
      overrides.push_back(std::string("inflator.0.jet.relative_to_skin=") + relative);
      const auto scene = scene_of_text(folder, held_sphere(), overrides);
      const auto& thermo = scene.gas->model.thermo;
      const std::vector<double> nitrogen{1.0};
      const double cp = thermo.cp(nitrogen, 300.0), gamma = thermo.gamma(nitrogen, 300.0);
      const Impulse got = impulse_of(scene);
      const double end = std::min(p.time.back(), scene.time.end - p.start);
      const double exact = std::sqrt((gamma - 1.0) * cp) * rooted_impulse(p, end);
      if (p.time.back() < scene.time.end - p.start)
        claim::expect_relative(
            {"J.11", fmt::format("held skin, {}, relative {}: impulse of the jet [N s]", p.what, relative),
             "rounding: some 300 steps, ends of kicks to 1e-18 s of a pulse of 1 ns or more"},
            got.thrust, exact, 1e-12 + 1e-18 / p.time.back());
      if (share == 0.0) share = got.skin / got.thrust;
      EXPECT_NEAR(got.skin / got.thrust, share, 1e-12 * share) << p.what;
    }
}

// What fires within a step is in the next kick, all of it.
TEST(kick_mean, firing_within_a_step_loses_nothing) {
  const coupled::Folder folder;
  const Pulse& p = kPulses[1];
  std::mt19937 random(7);
  for (int i = 0; i < 12; ++i) {
    const double on = 0.002 + 0.004 * std::generate_canonical<double, 53>(random),
                 delay = i % 3 == 0 ? 3e-4 : 0.0;
    auto overrides = overrides_of({p.what, p.time, p.flow, p.heated, p.temperature, delay});
    const auto text = held_sphere() + fmt::format("[[sensor]]\nname=\"s\"\ntime={}\n", on);
    overrides.emplace_back("inflator.0.trigger=s");
    const auto scene = scene_of_text(folder, text, overrides);
    const double cp = scene.gas->model.thermo.cp(0, 300.0), r = scene.gas->model.thermo.gas_constant(0);
    const double exact = std::sqrt(r / (cp - r) * cp) * rooted_impulse(p, 2e-4);
    EXPECT_NEAR(impulse_of(scene).thrust, exact, 1e-12 * exact) << on;
  }
}

// The pressure behind a rigid target is ambient: the outlet's own law is integrated alone.
TEST(kick_mean, matched_outlet_has_the_impulse_of_its_law) {
  for (const char* every : {"output.history_every=1e-3", "output.history_every=2.3e-4"}) {
    const auto scene = coupled::scene_of(
        "plate_jet",
        {"inflator.0.mass_flow={time=[0.0,0.004,0.0041,0.01],value=[0.0,4.0,3.0,0.0]}",
         "inflator.0.temperature={time=[0.0,0.01],value=[500.0,300.0]}",
         "inflator.0.jet.outlet=pressure_matched", "inflator.0.jet.temperature=stagnation", every});
    const auto& part = scene.jets.front();
    double exact = 0.0;
    constexpr int panels = 200000;
    for (int i = 0; i < panels; ++i) {  // the midpoint rule, to 1e-9 of it
      const double t = 0.01 * (i + 0.5) / panels;
      const auto gas = gas::inflator_point(scene.gas->model, 0, t);
      const auto outlet = jet::outlet_state(
          part.outlet, {gas.mass_flow, gas.temperature, gas.cp, gas.gas_constant, scene.ambient.pressure});
      exact += 0.01 / panels * jet::momentum_flux(outlet, part.outlet.area);
    }
    EXPECT_NEAR(impulse_of(scene).thrust, exact, 1e-8 * exact) << every;
  }
}

// A bag that two jets drive apart; the pulse begins and ends off the steps.
TEST(kick_mean, jets_move_a_bag_with_order_2) {
  std::vector<double> work;
  for (const char* step : {"time.step=8e-6", "time.step=4e-6", "time.step=2e-6", "time.step=1e-6"}) {
    const auto run = coupled::run_case(
        "jet_bag",
        {step, "gas.initial.pressure=121325.0", "membrane.mesh.levels=2", "scene.end_time=0.0016",
         "inflator.0.jet.relative_to_skin=false", "inflator.1.jet.relative_to_skin=false",
         "inflator.0.mass_flow={time=[0.00031,0.0007,0.0011,0.00123],value=[0.0,1.0,1.0,0.0]}",
         "inflator.1.start_time=1.0", "inflator.0.jet.jet_work=external", "inflator.1.jet.jet_work=external",
         "inflator.0.jet.radius=0.08", "inflator.1.jet.radius=0.08"});
    work.push_back(run.energy.back().at("jet_work_J"));
  }
  std::vector<double> differences;
  for (std::size_t i = 0; i + 1 < work.size(); ++i) differences.push_back(std::abs(work[i + 1] - work[i]));
  claim::expect_order({"J.11", "pulse of a jet in a bag: its work, differences between steps [J]",
                       "elements that cross the jet's cut-off; kinks off the steps"},
                      differences, 1.7, 2.3);
}

}  // namespace
