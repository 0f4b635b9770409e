// SPDX-License-Identifier: Apache-2.0
// Bad input of the gas tables: refused where it stands.
#include <gtest/gtest.h>

#include "case_folder.hpp"
#include "fault.hpp"

namespace {

using coupled::Fault;
using coupled::message_of;

class bad_gas_input : public testing::TestWithParam<Fault> {};

TEST_P(bad_gas_input, is_refused_where_it_stands) {
  coupled::expect_refused_where_it_stands(GetParam());
}

const Fault kGasFaults[] = {
    {"two_sensors_in_one", "tank_triggers", "[[sensor]]                    # deceleration of the car, in g",
     "[[sensor]]\ntime = 1.0", "sensor.0", "exactly one is needed"},
    {"sensor_of_nothing", "tank_triggers", "[[sensor]]\nname = \"safing\"\ntime",
     "[[sensor]]\nname = \"safing\"\ntyme", "sensor.1.tyme", "unknown key", "tyme"},
    {"sensor_without_kind", "tank_triggers", "[[sensor]]\nname = \"safing\"\ntime",
     "[[sensor]]\nname = \"safing\"\nabove", "sensor.1", "has 0 of time"},
    {"trigger_without_sensors", "tank_blowdown", "[[vent]]", "[[vent]]\ntrigger = \"x\"", "vent.0.trigger",
     "is \"x\", allowed: the name of a [[sensor]], but the case has none", "trigger ="},
    {"sensor_reset", "tank_triggers", "reset = 70.0e3", "reset = 90.0e3", "sensor.4.reset",
     "less than overpressure"},
    {"sensor_reset_too_near", "tank_triggers", "reset = 70.0e3", "reset = 79999.9999999", "sensor.4.reset",
     "Pa or more below the threshold"},
    {"sensor_named_twice", "tank_triggers", "name = \"safing\"", "name = \"crash\"", "sensor.1.name",
     "second time"},
    {"contact_false", "contact_vent", "contact = true", "contact = false", "sensor.0.contact",
     "allowed: true"},
    {"unknown_node", "tank_triggers", "all = [\"crash\", \"safing\"]", "all = [\"crash\", \"safety\"]",
     "trigger.0.all", "\"safety\""},
    {"later_node", "tank_triggers", "not = \"too_high\"", "not = \"second\"", "trigger.1.not", "earlier"},
    {"no_inputs", "tank_triggers", "all = [\"crash\", \"safing\"]", "all = []", "trigger.0.all", "is empty"},
    {"negative_delay", "tank_triggers", "delay = 0.005", "delay = -0.005", "trigger.2.delay", "0 or more"},
    {"inflator_of_unknown_trigger", "tank_triggers", "trigger = \"first\"", "trigger = \"frist\"",
     "inflator.0.trigger", "frist"},
    {"vent_of_unknown_trigger", "tank_triggers", "trigger = \"disc\"", "trigger = \"disk\"", "vent.0.trigger",
     "disk"},
    {"negative_area_curve", "tank_triggers", "area = { time = [0.0, 0.002], value = [0.0, 4.0e-4] }",
     "area = { time = [0.0, 0.002], value = [0.0, -4.0e-4] }", "vent.0.area.value", "0 or more",
     "value = [0.0, -4.0e-4]"},
    {"unsorted_overpressure", "piston_leak", "area = { overpressure = [5000.0, 30000.0]",
     "area = { overpressure = [30000.0, 5000.0]", "vent.0.area", "rising order"},
    {"overpressure_that_jumps", "piston_leak", "area = { overpressure = [5000.0, 30000.0]",
     "area = { overpressure = [5000.0, 5000.0]", "vent.0.area", "strictly rising order"},
    {"volume_that_jumps", "tank_stiff", "volume = { time = [0.0, 0.005, 0.015]",
     "volume = { time = [0.0, 0.005, 0.005]", "tank.volume", "jumps at 0.005 s"},
    {"backflow_is_no_number", "tank_backflow", "backflow = true", "backflow = 1", "vent.0.backflow",
     "true or false"},
    {"ambient_composition", "tank_backflow", "composition = { air = 1.0 } ", "composition = { air = 0.9 } ",
     "ambient.composition", "sum to 0.9"},
    {"ambient_species", "tank_backflow", "composition = { air = 1.0 } ", "composition = { Xe = 1.0 } ",
     "ambient.composition", "Xe"},
    {"composition_that_no_vent_lets_in", "tank_backflow", "backflow = true", "", "ambient.composition",
     "no [[vent]] has backflow", "composition = { air = 1.0 }"},
    {"heat_coefficient", "tank_backflow", "coefficient = 200.0", "coefficient = -200.0",
     "gas.heat_loss.coefficient", "above 0"},
    {"volume_that_falls", "bag_volume", "0.16192, 0.21171]", "0.16192, 0.01171]", "tank.volume",
     "must not fall", "volume]"},
    {"start_above_the_curve", "bag_volume", "initial = { composition = { air = 1.0 } }",
     "initial = { composition = { air = 1.0 }, pressure = 5.0e5 }", "tank.volume", "at the start", "volume]"},
    {"amplitude", "piston_leak", "volume = { mean = 1.0e-3, amplitude = 0.3e-3",
     "volume = { mean = 1.0e-3, amplitude = 1.3e-3", "tank.volume.amplitude", "less than mean",
     "amplitude = 1.3e-3"},
    {"frequency", "piston_leak", "frequency = 50.0", "frequency = 50.0e30", "tank.volume.frequency",
     "allowed: at most 100000 (10000 periods", "frequency = 50.0e30"},
    {"leak_law", "piston_leak", "leak_law = \"table\"", "leak_law = \"none\"", "tank.fabric.leak_law",
     "printed"},
    {"velocity", "piston_leak",
     "velocity = { overpressure = [0.0, 500.0, 5000.0, 50000.0], value = [0.0, 0.4, 1.8, 7.0] }",
     "velocity = { overpressure = [0.0, 500.0], value = [0.0, 0.4, 1.8] }", "tank.fabric.velocity",
     "equal numbers are needed"},
    {"velocity_at_rest", "piston_leak",
     "velocity = { overpressure = [0.0, 500.0, 5000.0, 50000.0], value = [0.0,",
     "velocity = { overpressure = [0.0, 500.0, 5000.0, 50000.0], value = [0.1,", "tank.fabric.velocity",
     "is 0.1 m/s without overpressure"},
    {"bag_without_velocity", "bag_leak_table", "velocity = {", "speed = {", "fabric.velocity", "is missing",
     "[fabric]"},
    {"negative_velocity", "bag_leak_table", "value = [0.0, 0.017", "value = [0.0, -0.017",
     "fabric.velocity.value", "0 or more"},
    {"velocity_of_time", "bag_leak_table", "velocity = { overpressure =", "velocity = { time =",
     "fabric.velocity.overpressure", "is missing", "{ time = [0.0, 500.0"},
    {"velocity_without_its_law", "bag_leak_table", "leak_law = \"table\"", "leak_law = \"printed\"",
     "fabric.velocity", "unknown key", "velocity ="},
    {"bag_without_gas", "bag_leak_table",
     "[gas]\nthermodynamics = \"constant\"\n"
     "initial = { composition = { N2 = 1.0 } }\n\n[[inflator]]\ncomposition = { N2 = 1.0 }\n"
     "mass_flow = { time = [0.0, 0.02, 0.04], value = [0.0, 1.0, 0.0] }   # kg/s, 0.02 kg\n"
     "temperature = 406.0           # K\n",
     "", "gas", "is missing", ""},
    {"species_in_other_letters", "driver_bag", "composition = { N2 = 1.0 }", "composition = { Co2 = 1.0 }",
     "inflator.0.composition", "CH4 air; is 'CO2' meant?", "composition = { Co2"},
    {"air_in_capitals", "driver_bag", "composition = { air = 1.0 } }", "composition = { AIR = 1.0 } }",
     "gas.initial.composition", "CH4 air; is 'air' meant?", "composition = { AIR"},
    {"species_of_ones_own_misspelt", "tank_fixed_steps", "composition = { model_N2",
     "composition = { modl_N2", "composition", "; is 'model_N2' meant?", "composition = { modl"},
    {"species_without_name", "tank_fixed_steps", "name = \"model_N2\"", "name = \"\"", "gas.species.0.name",
     "is empty"},
    {"species_of_a_built_in_name", "tank_fixed_steps", "name = \"model_N2\"", "name = \"air\"",
     "gas.species.0.name", "allowed: any name except the built-in N2 O2"},
    {"species_with_both_masses", "tank_fixed_steps", "gas_constant = 296.8",
     "gas_constant = 296.8\nmolar_mass = 0.028", "gas.species.0.gas_constant", "is given with molar_mass",
     "gas_constant = 296.8\nmolar"},
    {"species_without_mass", "tank_fixed_steps", "gas_constant = 296.8  ", "", "gas.species.0.molar_mass",
     "is missing", "[[gas.species]]"},
    {"species_of_negative_mass", "tank_fixed_steps", "gas_constant = 296.8  ", "molar_mass = -0.028",
     "gas.species.0.molar_mass", "1e-3 to 1 [kg/mol]", "molar_mass"},
    {"species_in_grams", "tank_fixed_steps", "gas_constant = 296.8  ", "molar_mass = 28.0",
     "gas.species.0.molar_mass", "1e-3 to 1 [kg/mol]", "molar_mass"},
    {"species_below_its_gas_constant", "tank_fixed_steps", "cp = 1038.8", "cp = 296.0", "gas.species.0.cp",
     "greater than gas_constant", "cp = 296.0"},
    {"species_with_both_capacities", "tank_fixed_steps", "cp = 1038.8", "nasa7 = {}\ncp = 1038.8",
     "gas.species.0.cp", "is given with nasa7", "cp = 1038.8"},
    {"species_of_six_coefficients", "tank_fixed_steps", "cp = 1038.8  ",
     "nasa7 = { low = [3.5, 0.0, 0.0, 0.0, 0.0, 0.0], high = [], range = [200.0, 6000.0] }",
     "gas.species.0.nasa7.low", "has 6 numbers, needed: 7", "low = [3.5"},
    {"species_of_another_middle", "tank_fixed_steps", "cp = 1038.8  ",
     "nasa7 = { middle = 1200.0, low = [], high = [], range = [200.0, 6000.0] }",
     "gas.species.0.nasa7.middle", "is 1200, allowed: 1000 K", "middle = 1200.0"},
    {"species_of_one_temperature", "tank_fixed_steps", "cp = 1038.8  ", "nasa7 = { range = [200.0] }",
     "gas.species.0.nasa7.range", "has 1 numbers, needed: 2", "range = [200.0]"},
    {"species_whose_ranges_do_not_meet", "tank_fixed_steps", "cp = 1038.8  ",
     "nasa7 = { low = [3.5, 0, 0, 0, 0, 0, 0], high = [3.6, 0, 0, 0, 0, 0, 0], range = [200.0, 6000.0] }",
     "gas.species.0.nasa7", "jump of cp/R at 1000 K", "nasa7 = {"},
    {"species_colder_than_its_data", "tank_fixed_steps", "cp = 1038.8  ",
     "nasa7 = { low = [3.5, 0, 0, 0, 0, 0, 0], high = [3.5, 0, 0, 0, 0, 0, 0], range = [300.0, 6000.0] }",
     "gas.species.0.nasa7", "must be 300 to 6000", "nasa7 = {"},
    {"second_fabric_without_velocity", "tank_steps", "leak_law = \"table\"\nvelocity =",
     "leak_law = \"table\"\nspeed =", "tank.fabric.1.velocity", "is missing", "[[tank.fabric]]\narea = 0.5"},
    {"second_fabric_of_no_area", "tank_steps", "area = 0.5 ", "area = 0.0 ", "tank.fabric.1.area", "above 0"},
    {"sensor_without_name", "tank_triggers", "name = \"crash\"", "name = \"\"", "sensor.0.name", "is empty"},
    {"gas_step_of_zero", "tank_fixed_steps", "gas_step = 3.0e-3", "gas_step = 0.0", "time.gas_step",
     "above 0"},
    {"gas_step_and_tolerance", "tank_fixed_steps", "gas_step = 3.0e-3",
     "gas_tolerance = 1e-6\ngas_step = 3.0e-3", "time.gas_tolerance", "no effect"},
    {"gas_step_of_a_target", "plate_jet", "[output]", "[time]\ngas_step = 1e-3\n[output]", "time.gas_step",
     "no volume", "gas_step"},
    {"gas_method", "tank_stiff", "gas_method = \"rosenbrock\"", "gas_method = \"gear\"", "time.gas_method",
     "rosenbrock"},
    {"porosity", "tank_stiff", "porosity = 0.05", "porosity = 1.05", "tank.fabric.porosity", "at most 1"},
    {"volume_of_zero", "tank_stiff",
     "volume = { time = [0.0, 0.005, 0.015], value = [1.0e-4, 1.0e-4, 2.0e-4] }",
     "volume = { time = [0.0, 0.005, 0.015], value = [1.0e-4, 0.0, 2.0e-4] }", "tank.volume.value",
     "1e-100 to", "value = [1.0e-4, 0.0"},
};
INSTANTIATE_TEST_SUITE_P(faults, bad_gas_input, testing::ValuesIn(kGasFaults),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(bad_gas_input, sensors_need_what_they_sense) {
  const std::filesystem::path cases = GASJET_SOURCE_DIR "/cases";
  const std::string no_contact =
      message_of(cases / "tank_triggers.toml", {"sensor.1={name=\"safing\",contact=true}"});
  EXPECT_NE(no_contact.find("no [contact]"), std::string::npos) << no_contact;
}

}  // namespace
