// SPDX-License-Identifier: Apache-2.0
// Bad input: each fault is refused where it stands, as `file:line:column: key: what is wrong, what is
// allowed`.
#include <gtest/gtest.h>

#include <fstream>

#include "case_folder.hpp"
#include "fault.hpp"
#include "run_case.hpp"

namespace {

namespace fs = std::filesystem;
using coupled::Fault;
using coupled::Folder;
using coupled::message_of;
using coupled::read;

class bad_input : public testing::TestWithParam<Fault> {};

TEST_P(bad_input, is_refused_where_it_stands) {
  coupled::expect_refused_where_it_stands(GetParam());
}

const Fault kFaults[] = {
    {"unknown_key", "rigid_tank", "volume = 0.06", "volume = 0.06\nvolum = 1", "tank.volum", "unknown key",
     "volum = 1"},
    {"unknown_table", "rigid_tank", "[tank]", "[tanks]\n[tank]", "tanks", "unknown key", "tanks]"},
    {"missing_key", "rigid_tank", "volume = 0.06", "", "tank.volume", "is missing", "[tank]"},
    {"missing_table", "rigid_tank", "[scene]", "[target]", "scene", "is missing", ""},
    {"misspelt_table", "sphere_inflation", "[membrane]", "[membran]", "membran", "is 'membrane' meant?",
     "membran]"},
    {"wrong_type", "rigid_tank", "volume = 0.06", "volume = \"big\"", "tank.volume", "is a string",
     "volume = \"big\""},
    {"not_a_table", "rigid_tank", "[scene]", "ambient = 3\n[scene]", "ambient",
     "is a number, allowed: a table", "ambient = 3"},
    {"nan", "rigid_tank", "volume = 0.06", "volume = nan", "tank.volume", "is nan", "volume = nan"},
    {"inf", "rigid_tank", "end_time = 0.1 ", "end_time = inf ", "scene.end_time", "is inf", "end_time = inf"},
    {"negative_volume", "rigid_tank", "volume = 0.06", "volume = -0.06", "tank.volume",
     "1e-100 to 1e100 [m³]", "volume = -0.06"},
    {"zero_area", "tank_blowdown", "area = 1.0e-3", "area = 0.0", "vent.0.area", "above 0", "area = 0.0"},
    {"negative_coefficient", "tank_blowdown", "discharge_coefficient = 1.0", "discharge_coefficient = -1.0",
     "vent.0.discharge_coefficient", "at most 1", "discharge_coefficient"},
    {"zero_thickness", "sphere_inflation", "thickness = 0.5e-3", "thickness = 0.0", "fabric.thickness",
     "above 0", "thickness = 0.0"},
    {"negative_thickness", "sphere_inflation", "thickness = 0.5e-3", "thickness = -0.5e-3",
     "fabric.thickness", "above 0", "thickness = -0.5e-3"},
    {"negative_temperature", "rigid_tank", "temperature = 700.0", "temperature = -700.0",
     "inflator.0.temperature", "1 to 1e5 [K]", "temperature = -700.0"},
    {"unsorted_knots", "sphere_inflation", "time = [0.0, 0.02, 0.04]", "time = [0.0, 0.04, 0.02]",
     "inflator.0.mass_flow", "rising order", "mass_flow = {"},
    {"repeated_knots", "sphere_inflation", "time = [0.0, 0.02, 0.04]", "time = [0.02, 0.02, 0.02]",
     "inflator.0.mass_flow", "third there", "mass_flow = {"},
    {"knots_too_close", "sphere_inflation", "time = [0.0, 0.02, 0.04]", "time = [0.0, 5e-324, 0.04]",
     "inflator.0.mass_flow", "slope", "mass_flow = {"},
    {"knots_without_values", "sphere_inflation", "value = [0.0, 1.0, 0.0]", "value = [0.0, 1.0]",
     "inflator.0.mass_flow", "equal numbers are needed", "mass_flow = {"},
    {"negative_mass_flow", "sphere_inflation", "value = [0.0, 1.0, 0.0]", "value = [0.0, -1.0, 0.0]",
     "inflator.0.mass_flow", "0 or more", "value = [0.0, -1.0"},
    {"unknown_species", "sphere_inflation", "composition = { N2 = 1.0 }\nmass_flow",
     "composition = { Xe = 1.0 }\nmass_flow", "inflator.0.composition", "Xe", "composition = { Xe"},
    {"fractions", "sphere_inflation", "composition = { N2 = 1.0 }\nmass_flow",
     "composition = { N2 = 0.5 }\nmass_flow", "inflator.0.composition", "sum to 0.5",
     "composition = { N2 = 0.5"},
    {"temperature_range", "sphere_inflation",
     "thermodynamics = \"constant\"\ninitial = { composition = { N2 = 1.0 } }",
     "thermodynamics = \"nasa7\"\ninitial = { composition = { N2 = 1.0 }, temperature = 100.0 }",
     "gas.initial", "200", "initial = {"},
    {"hencky_with_compression", "sphere_inflation", "leak_law = \"none\"",
     "leak_law = \"none\"\nlaw = \"hencky\"\ncompression = \"linear\"", "fabric.compression",
     "carries no compression", "compression = \"linear\""},
    {"hencky_with_weave", "sphere_inflation", "leak_law = \"none\"",
     "leak_law = \"none\"\nlaw = \"hencky\"\n"
     "weave = { young_modulus_weft = 5e7, shear_modulus = 2e6, warp = [1, 2, 3] }",
     "fabric.law", "isotropic fabric, without weave", "law = \"hencky\""},
    {"wrong_choice", "sphere_inflation", "leak_law = \"none\"", "leak_law = \"leaky\"", "fabric.leak_law",
     "printed", "leak_law = \"leaky\""},
    {"poisson", "sphere_inflation", "poisson_ratio = 0.3", "poisson_ratio = 1.5", "fabric.poisson_ratio",
     "0.999", "poisson_ratio"},
    {"outlet_outside", "passenger_pendulum", "centre = [0.0, 0.0, 0.0] ", "centre = [0.0, 0.9, 0.0] ",
     "inflator.0.jet.centre", "outside the bag", "centre = [0.0, 0.9"},
    {"tiny_coordinate", "passenger_pendulum", "centre = [0.0, 0.0, 0.0] ", "centre = [0.0, 5e-324, 0.0] ",
     "inflator.0.jet.centre", "1e-100", "centre = [0.0, 5e-324"},
    {"zero_axis", "passenger_pendulum", "axis = [1.0, 0.0, 0.0] ", "axis = [0.0, 0.0, 0.0] ",
     "inflator.0.jet", "axis", "[inflator.jet]"},
    {"short_vector", "passenger_pendulum", "axis = [1.0, 0.0, 0.0] ", "axis = [1.0, 0.0] ",
     "inflator.0.jet.axis", "needed: 3", "axis = [1.0, 0.0] "},
    {"pendulum_inside", "passenger_pendulum", "pivot = [0.35, 0.0, 1.31]", "pivot = [0.03, 0.0, 1.31]",
     "pendulum", "into the skin", "[pendulum]"},
    {"unknown_panel", "passenger_pendulum", "null_panels = [\"vent\"]", "null_panels = [\"hole\"]",
     "membrane.null_panels", "hole", "null_panels"},
    {"null_with_interior_nodes", "passenger_pendulum", "null_panels = [\"vent\"]",
     "null_panels = [\"side_right\"]", "membrane", "node", "[membrane]"},
    {"jet_work_of_static_gas", "passenger_pendulum", "outlet = \"sonic\"",
     "outlet = \"sonic\"\njet_work = \"from_gas\"", "inflator.0.jet.jet_work", "stagnation", "jet_work = "},
    {"two_decay_coefficients", "plate_jet", "outlet_type =", "decay_coefficient = 0.08\noutlet_type =",
     "inflator.0.jet.outlet_type", "one of the two", "outlet_type ="},
    {"no_decay_of_a_round_jet", "plate_jet", "outlet_type = \"cylindrical_tube\"", "",
     "inflator.0.jet.decay_coefficient",
     "0.06 to 0.12 are usual), or outlet_type = \"contracting_nozzle\", \"cylindrical_tube\" or",
     "[inflator.jet]"},
    {"no_decay_of_a_slot", "jet_slot_plate", "outlet_type = \"sharp_slot\"", "",
     "inflator.0.jet.decay_coefficient", "0.09 to 0.16 are usual), or outlet_type = \"plane_nozzle\"",
     "[inflator.jet]"},
    {"outlet_of_another_shape", "plate_jet", "outlet_type = \"cylindrical_tube\"",
     "outlet_type = \"sharp_slot\"", "inflator.0.jet.outlet_type", "contracting_nozzle", "outlet_type ="},
    {"no_pieces", "jet_slot_plate", "subdivisions = 4", "subdivisions = 0", "inflator.0.jet.subdivisions",
     "1", "subdivisions = 0"},
    {"cone_of_a_right_angle", "jet_slot_plate", "cone_half_angle = 0.28", "cone_half_angle = 1.6",
     "inflator.0.jet.cone_half_angle", "below pi/2", "cone_half_angle ="},
    {"everything_cut_off", "jet_slot_plate",
     "restitution =", "cut_off = 1.0\nrestitution =", "inflator.0.jet.cut_off", "below 1", "cut_off ="},
    {"tank_and_bag", "sphere_inflation", "[membrane]", "[tank]\nvolume = 1.0\n[membrane]", "tank", "not both",
     "tank]\nvolume = 1.0"},
    {"bag_without_fabric", "sphere_inflation", "[fabric]", "[target]", "fabric", "is missing", ""},
    {"unsafe_without_step", "sphere_inflation", "[output]", "[time]\nunsafe_step = true\n[output]",
     "time.unsafe_step", "`step`", "unsafe_step"},
    {"negative_area", "tank_blowdown", "area = 1.0e-3", "area = -1.0e-3", "vent.0.area", "above 0",
     "area = -1"},
    {"panel_twice", "passenger_pendulum", "null_panels = [\"vent\"]", "null_panels = [\"vent\", \"vent\"]",
     "membrane.null_panels", "twice", "null_panels"},
    {"strap_off_the_bag", "passenger_pendulum", "stiffness = 4500.0                   #",
     "from = [0.0, 0.0, 0.0]\nto = [9.0, 0.0, 0.0]\nstiffness = 4500.0 #", "membrane.strap.0.to",
     "nearest node", "to = [9.0"},
    {"knot_before_firing", "sphere_inflation", "time = [0.0, 0.02, 0.04]", "time = [-0.01, 0.02, 0.04]",
     "inflator.0.mass_flow", "first knot", "mass_flow = {"},
    {"streams_of_no_gas", "pendulum_swing", "[output]", "[output]\nstreams = true", "output.streams",
     "no volume of gas", "streams = true"},
    {"species_that_names_no_column", "rigid_tank", "[output]",
     "[[gas.species]]\nname = \"a,b\"\ngas_constant = 300.0\ncp = 1000.0\n[[inflator]]\ncomposition = { "
     "\"a,b\" = 1.0 }\nmass_flow = 1.0\ntemperature = 300.0\n[output]\nstreams = true",
     "output.streams", "letters, digits", "streams = true"},
    {"endless_history", "rigid_tank", "history_every = 0.001", "history_every = 1e-12",
     "output.history_every", "end_time / 1e7", "history_every"},
    {"inflow_out_of_range", "reference/two_gas_fill", "temperature = 1100.0", "temperature = 6100.0",
     "inflator.0.temperature", "6000", "temperature = 6100.0"},
    {"species_twice", "rigid_tank", "[tank]",
     "[[gas.species]]\nname = \"model_N2\"\ngas_constant = 1.0\ncp = 2.0\n[tank]", "gas.species.1.name",
     "second time", "name = \"model_N2\"\ngas_constant = 1.0"},
    {"empty_array", "sphere_inflation", "time = [0.0, 0.02, 0.04]", "time = []", "inflator.0.mass_flow",
     "equal numbers are needed", "mass_flow = {"},
    {"wide_outlet", "passenger_pendulum", "centre = [0.0, 0.0, 0.0] ", "centre = [0.0, 0.1, 0.0] ",
     "inflator.0.jet.centre", "0.14, 0] m is outside the bag", "centre = [0.0, 0.1, 0.0"},
    {"plate_behind", "passenger_pendulum", "normal = [1.0, 0.0, 0.0] }", "normal = [-1.0, 0.0, 0.0] }",
     "membrane.plate", "has the bag behind it", "plate = {"},
    {"short_side_longer", "passenger_pendulum", "short_side = 0.045 ", "short_side = 0.2 ",
     "inflator.0.jet.short_side", "longer", "short_side"},
    {"step_of_a_tank", "rigid_tank", "[output]", "[time]\nstep = 1e-3\n[output]", "time.step",
     "nothing moves", "step = 1e-3"},
    {"safety_of_a_tank", "rigid_tank", "[output]", "[time]\nsafety = 0.5\n[output]", "time.safety",
     "nothing moves", "safety = 0.5"},
    {"safety_beside_step", "strapped_sphere", "[output]", "[time]\nstep = 1e-5\nsafety = 0.5\n[output]",
     "time.safety", "no effect with step, which replaces it", "safety = 0.5"},
    {"unsafe_step_of_a_tank", "rigid_tank", "[output]", "[time]\nunsafe_step = false\n[output]",
     "time.unsafe_step", "nothing moves", "unsafe_step = false"},
    {"gravity_of_a_tank", "rigid_tank", "end_time = 0.1 ", "gravity = [0.0, 0.0, -9.8]\nend_time = 0.1 ",
     "scene.gravity", "nothing moves", "gravity = ["},
    {"initial_gas_of_a_target", "plate_jet", "[gas]", "[gas]\ninitial = { composition = { N2 = 1.0 } }",
     "gas.initial", "no volume", "initial = {"},
    {"gas_tolerance_of_a_target", "plate_jet", "[output]", "[time]\ngas_tolerance = 1e-6\n[output]",
     "time.gas_tolerance", "no volume", "gas_tolerance"},
    {"warp_across_the_fabric", "driver_bag", "warp = [0.0, 0.0, 1.0]", "warp = [1.0, 0.0, 0.0]", "membrane",
     "element's plane", "[membrane]"},
    {"weave_too_soft", "driver_bag", "shear_modulus = 2.0e6", "shear_modulus = 1.0", "membrane", "shear",
     "[membrane]"},
    {"fabric_of_no_panel", "driver_bag", "panels = [\"attachment\"]", "panels = [\"hub\"]",
     "fabric.panel.0.panels", "\"hub\" does not exist", "panels = [\"hub\"]"},
    {"fabric_panel_twice", "driver_bag", "panels = [\"attachment\"]",
     "panels = [\"attachment\", \"attachment\"]", "fabric.panel.0.panels", "again", "panels = [\"att"},
    {"fabric_of_a_null_panel", "driver_bag", "panels = [\"attachment\"]", "panels = [\"vent_left\"]",
     "fabric.panel.0.panels", "no fabric", "panels = [\"vent"},
    {"flattened_twice", "driver_bag", "mass_damping = 20.0", "flatten = 0.5\nmass_damping = 20.0",
     "membrane.flatten", "its own initial shape", "flatten = 0.5"},
    {"seed_of_nothing", "driver_bag", "mass_damping = 20.0", "perturbation_seed = 3\nmass_damping = 20.0",
     "membrane.perturbation_seed", "needs perturbation", "perturbation_seed = 3"},
    {"sphere_of_no_size", "sphere_inflation", "radius = 0.3", "radius = 1e-200", "membrane.mesh",
     "not a closed control volume", "{ generator"},
    {"refined_beyond_memory", "sphere_inflation", "levels = 3", "levels = 8, refine = 6",
     "membrane.mesh.refine", "makes up to 5368709120 elements of 1310720, allowed: at most 10000000",
     "refine = 6"},
    {"jets_of_different_work", "passenger_pendulum", "[[vent]]",
     "[[inflator]]\ncomposition = { N2 = 1.0 }\ntemperature = 406.0\nmass_flow = 1.0\n[inflator.jet]\nshape "
     "= "
     "\"round\"\ncentre = [0.0, 0.0, 0.0]\naxis = [1.0, 0.0, 0.0]\nradius = 0.02\ndecay_coefficient = 0.08\n"
     "attachment_panels = [\"attachment\"]\ntemperature = \"stagnation\"\njet_work = \"from_gas\"\n[[vent]]",
     "inflator.1.jet.jet_work", "all jets need the same", "jet_work = "},
    {"rings", "driver_bag", "generator = \"driver\"", "generator = \"driver\", rings = 3", "membrane.mesh",
     "rings = 3", "{ generator"},
};
INSTANTIATE_TEST_SUITE_P(faults, bad_input, testing::ValuesIn(kFaults),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(good_input, every_shipped_case_is_accepted) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(GASJET_SOURCE_DIR "/cases")) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_EQ(message_of(entry.path()), "accepted") << entry.path();
    ++count;
  }
  EXPECT_GE(count, 6);
}

TEST(case_overrides, reach_their_key_and_name_themselves_in_errors) {
  const fs::path tank = GASJET_SOURCE_DIR "/cases/rigid_tank.toml";
  for (const char* text : {"tank.volume=0.12", " tank.volume = 0.12 "})
    EXPECT_EQ(coupled::scene_of("rigid_tank", {text}).gas->rigid_volume, 0.12);
  EXPECT_EQ(coupled::scene_of("rigid_tank", {"time.gas_tolerance=1e-6"}).gas->integrator.relative_tolerance,
            1e-6);
  for (const char* text : {"tank.volume=-1", "tank.volume = -1", "tank.volum=1", "inflator.0.mass_flow=nan",
                           "inflator.7.mass_flow=1"}) {
    const std::string message = message_of(tank, {text});
    EXPECT_NE(message.find(std::string("--set ") + text), std::string::npos) << message;
  }
}

TEST(curve_file, is_read_and_refused_by_line) {
  const Folder folder;
  std::string text = read(GASJET_SOURCE_DIR "/cases/rigid_tank.toml");
  const std::string flow = "mass_flow = 1.0 ";
  text.replace(text.find(flow), flow.size(), "mass_flow = { file = \"flow.csv\", column = \"flow_kg_s\" } ");
  std::ofstream(folder.path / "case.toml") << text;
  const auto with = [&](const char* csv) {
    std::ofstream(folder.path / "flow.csv") << csv;
    return message_of(folder.path / "case.toml");
  };
  EXPECT_EQ(with("# a comment\ntime_s,flow_kg_s\n0,1\n0.1,2\n"), "accepted");
  EXPECT_NE(with("time_s,flow_kg_s\n0,1\n0.1,abc\n").find("flow.csv:3:5: 'abc'"), std::string::npos);
  EXPECT_NE(with("time_s,flow_kg_s\n0,1\n0.1\n").find("flow.csv:3:1"), std::string::npos);
  EXPECT_NE(with("time_s,flow\n0,1\n0.1,2\n").find("no such column"), std::string::npos);
  EXPECT_EQ(with("time_s,flow_kg_s\n0,1\n0.1,2\n0.1,1\n0.2,0\n"), "accepted");
  EXPECT_NE(with("time_s,flow_kg_s\n0,1\n0,2\n-1,2\n").find("flow.csv:4:1: flow_kg_s: knot 3"),
            std::string::npos);
  EXPECT_NE(with("time_s,flow_kg_s\n0,1\n0,2\n0,3\n1,0\n")
                .find("flow.csv:4:1: flow_kg_s: knot 3 at 0 is the third"),
            std::string::npos);
  EXPECT_NE(with("time_s,flow_kg_s\n0,1\n1,-2\n").find("0 or more"), std::string::npos);
  EXPECT_NE(with("").find("flow.csv"), std::string::npos);
  fs::remove(folder.path / "flow.csv");  // then the place is that of the key
  const std::string gone = message_of(folder.path / "case.toml");
  const auto key = text.find("file = \"flow.csv\"");
  EXPECT_EQ(gone.substr(0, gone.find(": ")), coupled::place_of(folder.path / "case.toml", text, key)) << gone;
  EXPECT_NE(gone.find("no such file"), std::string::npos) << gone;
}

}  // namespace
