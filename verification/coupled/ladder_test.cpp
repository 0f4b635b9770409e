// SPDX-License-Identifier: Apache-2.0
// Ladders where the answer is known.
#include "many_runs/ladder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "case_folder.hpp"
#include "closed_form/jet.hpp"
#include "many_runs/quantities.hpp"
#include "results/load_scene.hpp"
#include "run_case.hpp"

namespace {

using coupled::case_file;
using coupled::Folder;
using driver::LadderResult;
using driver::LadderRung;
using driver::Verdict;
using Texts = std::vector<std::string>;

driver::LadderOptions options_of(const char* quantity, double tolerance, Texts hold = {}) {
  return {quantity, tolerance, std::move(hold), 16, true};
}

const LadderRung& rung_of(const LadderResult& result, const std::string& name) {
  const auto found = std::find_if(result.rungs.begin(), result.rungs.end(), [&](const LadderRung& r) {
    return r.name.find(name) != std::string::npos;
  });
  if (found == result.rungs.end()) throw std::runtime_error("no rung " + name);
  return *found;
}

Texts axis_names(const LadderResult& result) {
  Texts names;
  for (const auto& axis : result.plan.axes) names.push_back(axis.name);
  return names;
}

std::string refusal(const char* name, const char* quantity, const Texts& hold) {
  try {
    driver::plan_ladder(case_file(name), {}, quantity, hold);
  } catch (const driver::CaseError& error) {
    return error.what();
  }
  return "accepted";
}

// What the paper's model leaves out of a tank has no rung; the pressure is linear in time, which every
// stepper gets right to rounding.
TEST(ladder, rigid_tank_has_gas_rungs_alone_and_its_closed_form) {
  const auto result = driver::run_ladder(case_file("rigid_tank"), {}, options_of("pressure", 1e-6));
  EXPECT_EQ(axis_names(result), Texts{"gas"});
  EXPECT_FALSE(result.plan.no_membrane.has_value());
  EXPECT_FALSE(result.chaotic);
  // p0 + gamma R T_in mdot t / V, of the case's own numbers.
  const double exact = 101325.0 + 1.4 * 296.8 * 700.0 * 1.0 * 0.1 / 0.06;
  // 100 intervals of some ten roundings each, all of one size.
  EXPECT_NEAR(result.reference.value / exact, 1.0, 1e3 * 2.2e-16);
  for (const LadderRung& rung : result.rungs) {
    EXPECT_NEAR(rung.error / exact, 0.0, 1e3 * 2.2e-16) << rung.name;
    EXPECT_EQ(rung.verdict, Verdict::inside) << rung.name;
  }
  EXPECT_TRUE(result.cheapest.has_value());
}

// Fixed steps of the fourth-order method in a tank that relaxes: half a relaxation time, so that much is
// left.
TEST(ladder, fixed_steps_show_their_order_and_the_reference_is_closer_than_the_finest) {
  const Texts settings{"time.gas_method=runge_kutta", "time.gas_step=5e-4", "scene.end_time=2e-3",
                       "output.history_every=2e-3", "gas.initial.pressure=200e3"};
  const auto result =
      driver::run_ladder(case_file("tank_fixed_steps"), settings, options_of("pressure", 1e-6));
  auto exactly = settings;
  exactly.erase(exactly.begin() + 1);
  exactly.front() = "time.gas_method=dormand_prince";
  exactly.emplace_back("unset time.gas_step");
  exactly.emplace_back("time.gas_tolerance=1e-13");
  const double exact = coupled::run_case("tank_fixed_steps", exactly).history.back().at("pressure_Pa");
  const auto& rest = result.reference.remainders.front().second;
  ASSERT_TRUE(rest.order.has_value());
  EXPECT_GT(*rest.order, 3.7);  // of fourth order; h times the rate is 0.3 and less
  EXPECT_LT(*rest.order, 4.3);
  const double finest = result.rungs[result.finest].value.mean;
  EXPECT_LT(std::abs(result.reference.value - exact), 0.5 * std::abs(finest - exact));
  EXPECT_LE(std::abs(result.reference.value - exact), result.reference.uncertainty);
}

// The central difference is of second order: half a per mille of the period in a step, and less.
TEST(ladder, fixed_step_is_tried_twice_as_long_and_shows_its_order) {
  const auto result = driver::run_ladder(case_file("pendulum_swing"), {}, options_of("pendulum_angle", 1e-5));
  const auto& rest = result.reference.remainders.front().second;
  ASSERT_TRUE(rest.order.has_value());
  EXPECT_GT(*rest.order, 1.9);
  EXPECT_LT(*rest.order, 2.1);
  const LadderRung &full = result.rungs.front(), &coarse = rung_of(result, "step 0.002");
  EXPECT_EQ(coarse.verdict, Verdict::inside);
  // 2^2, in the same band of the order.
  EXPECT_GT(coarse.error / full.error, std::pow(2.0, 1.9));
  EXPECT_LT(coarse.error / full.error, std::pow(2.0, 2.1));
}

TEST(ladder, plate_without_obstacle_needs_no_occlusion) {
  const auto result = driver::run_ladder(case_file("plate_jet"), {"target.columns=60", "target.rows=60"},
                                         options_of("jet_force", 0.001, {"outlet"}));
  EXPECT_EQ(axis_names(result), (Texts{"occlusion", "mesh"}));
  const LadderRung& off = rung_of(result, "occlusion off");
  EXPECT_EQ(off.value.mean, result.rungs.front().value.mean) << "it contributes exactly 0";
  EXPECT_EQ(off.verdict, Verdict::inside);
  // The case's outlet: 2 kg/s of the model nitrogen at 406 K through 5e-3 m2; the cut-off only leaves force
  // out.
  const double exact =
      closed_form::plate_force(2.0, closed_form::sonic_outlet({{}, 406.0, false, 2.0, 5e-3}).momentum_flux);
  const auto scene = coupled::scene_of("plate_jet");
  const double loss = jet::momentum_loss(scene.jets.front().field.model());
  EXPECT_NEAR(result.reference.value, exact, result.reference.uncertainty + (loss + 1e-9) * exact);
}

// A tank that has relaxed to 17 Pa above the ambient pressure: 0.7 mPa are little of the pressure, and 4e-5
// of those.
TEST(ladder, pressures_are_judged_by_what_they_are_above_the_ambient_one) {
  constexpr double tolerance = 2e-5;
  const auto result = driver::run_ladder(case_file("tank_stiff"), {}, options_of("pressure", tolerance));
  EXPECT_EQ(result.zero, 101325.0);
  const LadderRung& constant = rung_of(result, "as it is: cp constant");
  EXPECT_LT(std::abs(constant.value.mean / result.reference.value - 1.0), tolerance);
  EXPECT_EQ(constant.verdict, Verdict::outside);
  EXPECT_EQ(rung_of(result, "gas tolerance 1e-08").verdict, Verdict::inside);
}

// A free sphere around two jets back to back: its pressure hardly knows of them.
TEST(ladder, free_bag_needs_no_jet_for_its_pressure) {
  const Texts small{"membrane.mesh.levels=2"};
  const auto options = options_of("pressure", 0.1);
  auto result = driver::run_ladder(case_file("jet_bag"), small, options);
  EXPECT_EQ(axis_names(result), (Texts{"jet", "occlusion", "outlet", "cp", "compression", "reflection",
                                       "expansion", "direction", "pieces", "mesh", "step", "gas"}));
  EXPECT_FALSE(result.chaotic);
  EXPECT_EQ(rung_of(result, "jet off").verdict, Verdict::inside);
  EXPECT_EQ(rung_of(result, "mesh levels 1").verdict, Verdict::outside);
  EXPECT_EQ(rung_of(result, "rigid tank").verdict, Verdict::outside);
  const LadderRung& best = rung_of(result, "jet off");
  EXPECT_GT(best.value.standard_error, 0.0) << "of seeds";
  result.cheapest = static_cast<std::size_t>(&best - result.rungs.data());  // costs are not repeatable

  Folder folder;
  {
    driver::ResultFolder results(folder.path / "results", "ladder");
    results.begin({});
    driver::write_ladder(results, result, case_file("jet_bag"), small, options, false);
  }
  driver::CaseDocument written(folder.path / "results/cheapest.toml", {});
  const driver::Scene scene = driver::load_scene(written);
  EXPECT_TRUE(scene.jets.empty());
  driver::State state = driver::make_state(scene);
  double pressure = 0.0;
  driver::run_scene(scene, state, [&](bool recorded, const driver::State& now) {
    if (recorded) pressure = now.gas_point.pressure;
  });
  EXPECT_EQ(pressure, best.value.mean) << "the written case is the rung, to the last bit";
}

// The first eight milliseconds of the paper's scene: without the jet the bag has not come to the impactor. At
// a tolerance of a half their scatter does not matter: single runs.
TEST(ladder, impactor_near_the_jet_needs_it) {
  const Texts hold{"mesh", "pieces", "step", "gas", "cp", "porosity", "compression", "outlet"};
  const auto result = driver::run_ladder(case_file("passenger_pendulum"), {"scene.end_time=0.008"},
                                         options_of("pendulum_angle", 0.5, hold));
  EXPECT_FALSE(result.chaotic);
  EXPECT_GT(result.spread, 0.0);
  const LadderRung& off = rung_of(result, "jet off");
  EXPECT_EQ(off.verdict, Verdict::outside);
  EXPECT_EQ(off.value.mean, 0.0);
  EXPECT_GT(result.reference.value, 0.0);
}

TEST(ladder, values_are_those_of_any_number_of_threads) {
  const auto run = [](int threads) {
    return driver::run_ladder(case_file("jet_bag"), {"membrane.mesh.levels=1", "scene.end_time=0.005"},
                              options_of("pressure", 0.02, {"mesh"}), threads);
  };
  const auto one = run(1), two = run(2);
  for (const LadderRung& rung : one.rungs)
    if (rung.axis) {
      EXPECT_EQ(rung.value.mean, rung_of(two, rung.name).value.mean) << rung.name;
    }
  EXPECT_EQ(one.reference.value, two.reference.value);
}

TEST(ladder, names_of_quantities_and_axes) {
  const auto scene = coupled::scene_of("passenger_pendulum");
  EXPECT_EQ(driver::quantity_name(scene, "pendulum_angle"), "pendulum_angle_rad");
  EXPECT_EQ(driver::quantity_name(scene, "peak_cg_acceleration_m_s2"), "peak_cg_acceleration_m_s2");
  EXPECT_NE(refusal("passenger_pendulum", "pendulum", {}).find("more than one"), std::string::npos);
  EXPECT_NE(refusal("rigid_tank", "pendulum_angle", {}).find("allowed: peak_pressure_Pa"), std::string::npos);
  EXPECT_NE(refusal("rigid_tank", "pressure", {"mesh"}).find("--hold mesh"), std::string::npos);
  EXPECT_NE(refusal("rigid_tank", "pressure", {"gas"}).find("nothing is left"), std::string::npos);
}

// What a finer mesh would change by default stays: the contact's and the plate's stiffness.
TEST(ladder, finer_mesh_is_the_same_scene) {
  const Texts plate{"membrane.plate={point=[-0.4, 0.0, 0.0], normal=[1.0, 0.0, 0.0]}"};
  const auto plan = driver::plan_ladder(case_file("contact_vent"), plate, "pendulum_angle", {});
  const auto mesh =
      std::find_if(plan.axes.begin(), plan.axes.end(), [](const auto& axis) { return axis.name == "mesh"; });
  ASSERT_NE(mesh, plan.axes.end());
  Texts finer = plate;
  for (const auto& text : mesh->choices.back().overrides) finer.push_back(text);
  const auto coarse = coupled::scene_of("contact_vent", plate),
             fine = coupled::scene_of("contact_vent", finer);
  EXPECT_EQ(fine.bag->model.element_count, 4 * coarse.bag->model.element_count);
  EXPECT_EQ(fine.contact->parameters().stiffness, coarse.contact->parameters().stiffness);
  EXPECT_EQ(fine.bag->model.description.plates.front().stiffness,
            coarse.bag->model.description.plates.front().stiffness);
}

TEST(ladder, self_contact_is_an_effect_and_keeps_its_law_in_a_finer_mesh) {
  const auto axis = [](const driver::LadderPlan& plan, const char* name) {
    const auto found = std::ranges::find(plan.axes, name, &driver::LadderAxis::name);
    return found == plan.axes.end() ? nullptr : &*found;
  };
  const auto plan_of = [](const Texts& texts) {
    return driver::plan_ladder(case_file("sphere_inflation"), texts, "pressure", {});
  };
  EXPECT_EQ(axis(plan_of({}), "self_contact"), nullptr);
  const Texts thin{"membrane.self_contact.thickness=1e-3"};
  const auto plan = plan_of(thin);
  const driver::LadderAxis* effect = axis(plan, "self_contact");
  ASSERT_NE(effect, nullptr);
  ASSERT_EQ(effect->choices.size(), 2u);
  EXPECT_EQ(effect->base, 1u);
  Texts off = thin, finer = thin;
  for (const auto& text : effect->choices[0].overrides) off.push_back(text);
  EXPECT_FALSE(coupled::scene_of("sphere_inflation", off).skin_contact);
  for (const auto& text : axis(plan, "mesh")->choices.back().overrides) finer.push_back(text);
  const auto coarse = coupled::scene_of("sphere_inflation", thin),
             fine = coupled::scene_of("sphere_inflation", finer);
  EXPECT_EQ(fine.bag->model.element_count, 4 * coarse.bag->model.element_count);
  EXPECT_EQ(fine.skin_contact->parameters().stiffness, coarse.skin_contact->parameters().stiffness);
  // A finer mesh would have elements smaller than these layers.
  const double smallest =
      mesh::element_quality(coarse.bag->mesh.nodes, coarse.bag->mesh.elements).min_altitude;
  const auto thick = plan_of({"membrane.self_contact.thickness=" + std::to_string(0.9 * smallest)});
  EXPECT_EQ(axis(thick, "mesh")->base + 1, axis(thick, "mesh")->choices.size());
  ASSERT_FALSE(thick.left_out.empty());
  EXPECT_EQ(thick.left_out.back(), "finer meshes: membrane.self_contact.thickness is above their elements");
}

}  // namespace
