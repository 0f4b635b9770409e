// SPDX-License-Identifier: Apache-2.0
// What a case is warned of before it runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "case_folder.hpp"
#include "engine/scene.hpp"
#include "forecast/jet_peak.hpp"
#include "run_case.hpp"

namespace warned {
namespace {

// Millimetres taken for metres, and the bag as it is.
TEST(warnings, name_a_bag_of_no_airbags_size) {
  const auto warned = [](const char* unit) {
    const driver::Scene scene =
        coupled::scene_of("bag_from_files", {std::string("membrane.mesh.length_unit=") + unit});
    return std::ranges::any_of(scene.warnings, [](const std::string& text) {
      return text.find("longest extent") != std::string::npos;
    });
  };
  const double unit = 1e-3;  // of the shipped files
  EXPECT_FALSE(warned("1e-3")) << unit;
  EXPECT_TRUE(warned("1.0"));
  EXPECT_TRUE(warned("1e-6"));
}

TEST(warnings, name_numbers_in_another_unit) {
  struct Given {
    const char *scene, *key, *value;
  };
  for (const auto& [scene, key, value] : {Given{"sphere_inflation", "ambient.temperature", "20"},
                                          Given{"sphere_inflation", "ambient.pressure", "1.013"},
                                          Given{"sphere_inflation", "gas.initial.pressure", "101.3"},
                                          Given{"sphere_inflation", "inflator.0.temperature", "127"},
                                          Given{"sphere_inflation", "inflator.0.mass_flow", "500"},
                                          Given{"sphere_inflation", "fabric.young_modulus", "60"},
                                          Given{"sphere_inflation", "fabric.thickness", "0.5"},
                                          Given{"sphere_inflation", "fabric.density", "6.2e-10"},
                                          Given{"rigid_tank", "tank.volume", "60"},
                                          Given{"tank_blowdown", "gas.initial.pressure", "5"},
                                          Given{"tank_backflow", "gas.heat_loss.coefficient", "1e12"},
                                          Given{"passenger_pendulum", "vent.0.area", "1000"},
                                          Given{"driver_bag", "scene.end_time", "60"},
                                          Given{"rigid_tank", "scene.end_time", "100"},
                                          Given{"driver_bag", "scene.gravity", "[0,-9810,0]"},
                                          Given{"pendulum_swing", "scene.gravity", "[0,0,-9810]"},
                                          Given{"passenger_pendulum", "pendulum.mass", "10900"},
                                          Given{"passenger_pendulum", "pendulum.cg_distance", "1000"},
                                          Given{"passenger_pendulum", "pendulum.inertia_cg", "1e6"},
                                          Given{"pendulum_swing", "pendulum.impactor_distance", "1310"},
                                          Given{"pendulum_swing", "pendulum.impactor_radius", "4.1e-5"},
                                          Given{"passenger_pendulum", "pendulum.initial_angle", "30"},
                                          Given{"passenger_pendulum", "membrane.strap.0.free_length", "620"},
                                          Given{"passenger_pendulum", "membrane.strap.1.stiffness", "4.5"},
                                          Given{"driver_bag", "membrane.mass_damping", "1e5"},
                                          Given{"damped_sphere", "membrane.stiffness_damping", "0.5"}}) {
    EXPECT_EQ(coupled::scene_of(scene, {}).warnings, std::vector<std::string>{}) << scene;
    const auto warnings = coupled::scene_of(scene, {std::string(key) + '=' + value}).warnings;
    ASSERT_EQ(warnings.size(), 1u) << key;
    EXPECT_TRUE(warnings[0].starts_with(std::string(key) + " is ")) << warnings[0];
  }
}

TEST(warnings, name_a_bag_that_nothing_holds_against_its_jet) {
  const auto warned = [](const char* name, std::vector<std::string> overrides) {
    driver::Scene scene = coupled::scene_of(name, overrides);
    driver::add_jet_warnings(scene);
    return std::ranges::any_of(scene.warnings,
                               [](const std::string& text) { return text.starts_with("nothing holds"); });
  };
  EXPECT_FALSE(warned("passenger_pendulum", {}));
  EXPECT_TRUE(warned("passenger_pendulum", {"membrane.fixed_panels=[]"}));
  EXPECT_FALSE(warned("jet_bag", {}));  // two jets, one against the other
}

TEST(warnings, name_a_mass_flow_in_milliseconds) {
  const auto warned = [](const std::string& times) {
    const auto warnings =
        coupled::scene_of("driver_bag", {"inflator.0.mass_flow={time=" + times + ",value=[0,1,0]}"}).warnings;
    return std::ranges::any_of(warnings, [](const std::string& text) {
      return text.starts_with("inflator.0.mass_flow continues until ");
    });
  };
  EXPECT_TRUE(warned("[0,20,60]"));
  EXPECT_FALSE(warned("[0,0.02,0.06]"));
  EXPECT_FALSE(warned("[0,0.02,60]"));  // its end alone is far away
}

// A curtain that stays full while a car rolls over, a free pendulum and the gravity of a crash.
TEST(warnings, leave_scenes_that_last_or_fall_hard) {
  for (const auto& [scene, setting] : {std::pair{"driver_bag", "scene.end_time=6"},
                                       {"pendulum_swing", "scene.end_time=60"},
                                       {"driver_bag", "scene.gravity=[400,0,0]"}})
    EXPECT_EQ(coupled::scene_of(scene, {setting}).warnings, std::vector<std::string>{}) << setting;
}

// The hint of a mesh that comes from a generator, and from a file.
TEST(warnings, are_told_with_what_is_refused_for_the_same_reason) {
  const auto refusal = [](const char* scene, std::vector<std::string> overrides) {
    return coupled::message_of(coupled::case_file(scene), overrides);
  };
  const std::string generated = refusal("ball_impact", {"membrane.mesh.radius=200"});
  EXPECT_NE(generated.find("lies inside the bag: must be outside the bag at the start\nwarning: "),
            std::string::npos)
      << generated;
  EXPECT_NE(generated.find("longest extent is 400 m"), std::string::npos) << generated;
  EXPECT_NE(generated.find("a generator are in metres"), std::string::npos) << generated;
  EXPECT_EQ(generated.find("length_unit"), std::string::npos) << generated;
  const std::string coarse =
      refusal("contact_vent", {"membrane.mesh.radius=300", "pendulum.pivot=[400,0,0]"});
  EXPECT_NE(coarse.find("at most 128 times"), std::string::npos) << coarse;
  EXPECT_NE(coarse.find("\nwarning: membrane.mesh: the bag's longest extent is 600 m"), std::string::npos)
      << coarse;
  const std::string file = refusal("bag_from_files", {"membrane.mesh.length_unit=1",
                                                      "membrane.roller=[{directions=[\"x\"],low=[0,0,"
                                                      "0],high=[1e-3,1e-3,1e-3]}]"});
  EXPECT_NE(file.find("set length_unit to"), std::string::npos) << file;
}

TEST(warnings, of_slivers_need_areas_that_a_number_holds) {
  try {
    coupled::scene_of("damped_sphere", {"membrane.mesh.radius=1e-308"});
    FAIL() << "no error";
  } catch (const driver::CaseError& error) {
    EXPECT_NE(std::string(error.what()).find("membrane.mesh: element 0: its area is zero"), std::string::npos)
        << error.what();
  }
}

TEST(warnings, are_none_of_nearly_evacuated_tanks) {
  EXPECT_EQ(coupled::scene_of("rigid_tank", {"gas.initial.pressure=100"}).warnings,
            std::vector<std::string>{});
}

// The area of a sonic outlet decides with how much of the gas its pressure is above ambient: with 0.9 of it
// as shipped.
TEST(warnings, name_a_sonic_outlet_below_ambient_pressure) {
  const auto warnings = [](std::vector<std::string> overrides) {
    std::string all;
    driver::Scene scene = coupled::scene_of("passenger_pendulum", overrides);
    driver::add_jet_warnings(scene);
    for (const auto& text : scene.warnings) all += text;
    return all;
  };
  EXPECT_EQ(warnings({}), "");
  EXPECT_NE(warnings({"inflator.0.jet.long_side=0.1", "inflator.0.jet.short_side=0.05"})
                .find("below ambient at less than 1.73 kg/s, for 0.19 of the gas"),
            std::string::npos);
  EXPECT_NE(warnings({"inflator.0.jet.long_side=0.145", "inflator.0.jet.short_side=0.08"})
                .find("cannot blow into the bag"),
            std::string::npos);
  EXPECT_EQ(warnings({"inflator.0.jet.long_side=0.145", "inflator.0.jet.outlet=pressure_matched",
                      "inflator.0.jet.temperature=stagnation"}),
            "");
}

}  // namespace
}  // namespace warned
