// SPDX-License-Identifier: Apache-2.0
// An outlet that pokes out of the skin: the message says where along its axis it is inside, and it is.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <regex>
#include <string>

#include "results/load_scene.hpp"

namespace {

struct Outlet {
  const char* name;
  std::string centre, axis, shape;
  std::string membrane = "mesh = { generator = \"icosphere\", radius = 0.3, levels = 3 }";
};

std::string case_of(const Outlet& outlet) {
  return fmt::format(R"(
[scene]
name = "outlet"
end_time = 0.001
[gas]
thermodynamics = "constant"
initial = {{ composition = {{ N2 = 1.0 }} }}
[[inflator]]
composition = {{ N2 = 1.0 }}
mass_flow = 1.0
temperature = 600.0
[inflator.jet]
{}
centre = {}
axis = {}
decay_coefficient = 0.08
[fabric]
young_modulus = 60e6
poisson_ratio = 0.3
density = 620.0
thickness = 0.5e-3
leak_law = "none"
[membrane]
{}
)",
                     outlet.shape, outlet.centre, outlet.axis, outlet.membrane);
}

/// What reading a case says; empty if it is read, and its warnings go to `warnings`.
std::string message(const Outlet& outlet, std::string* warnings = nullptr) {
  try {
    auto document = driver::CaseDocument::of_text(case_of(outlet), "case.toml", {});
    const driver::Scene scene = driver::load_scene(document);
    if (warnings)
      for (const auto& text : scene.warnings) *warnings += text + '\n';
    return {};
  } catch (const driver::CaseError& error) {
    return error.what();
  }
}

const std::string round = "shape = \"round\"\nradius = 0.03";
const std::string slot =
    "shape = \"rectangular\"\nlong_side = 0.2\nshort_side = 0.02\nlong_direction = [0.0, 0.0, 1.0]";

TEST(outlet_place, where_the_message_says_the_outlet_is_inside) {
  const std::array outlets{
      Outlet{"tilted", "[-0.29, 0.0, 0.0]", "[1.0, 0.5, 0.0]", round},
      Outlet{"tilted_more", "[-0.295, 0.0, 0.0]", "[1.0, 1.5, 0.0]", round},
      Outlet{"tilted_upwards", "[0.0, -0.29, 0.0]", "[0.3, 1.0, -0.4]", round},
      Outlet{"far_outside", "[-2.0, 0.0, 0.0]", "[1.0, 0.0, 0.0]", round},
      Outlet{"a_little_outside", "[-0.3, 0.0, 0.0]", "[1.0, 0.0, 0.0]", round},
      Outlet{"a_long_axis", "[-0.3, 0.0, 0.0]", "[700.0, 350.0, 0.0]", round},
      Outlet{"slot", "[-0.295, 0.0, 0.0]", "[1.0, 0.0, 0.0]", slot},
      Outlet{"slot_tilted", "[-0.28, 0.0, 0.0]", "[1.0, 0.7, 0.0]", slot},
  };
  for (const Outlet& outlet : outlets) {
    const std::string said = message(outlet);
    std::smatch found;
    ASSERT_TRUE(std::regex_search(
        said, found,
        std::regex("; moved ([0-9.e-]+) m along its axis it is inside: centre = (\\[[^\\]]*\\])")))
        << outlet.name << ": " << said;
    EXPECT_EQ(said.rfind("case.toml:", 0), 0u) << said;
    Outlet moved = outlet;
    moved.centre = found[2];
    EXPECT_EQ(message(moved), "") << outlet.name << " at " << moved.centre;
  }
}

TEST(outlet_place, a_shorter_way_is_not_inside) {
  Outlet outlet{"tilted", "[-0.29, 0.0, 0.0]", "[1.0, 0.0, 0.0]", round};
  const std::string said = message({"", "[-0.32, 0.0, 0.0]", outlet.axis, round});
  std::smatch found;
  ASSERT_TRUE(std::regex_search(said, found, std::regex("; moved ([0-9.e-]+) m along")));
  const double way = std::stod(found[1]);  // to three digits, upwards
  outlet.centre = fmt::format("[{}, 0.0, 0.0]", -0.32 + 0.98 * way);
  EXPECT_NE(message(outlet), "");
}

TEST(outlet_place, an_outlet_that_never_meets_the_bag_has_no_advice) {
  for (const char* axis : {"[-1.0, 0.0, 0.0]", "[0.0, 1.0, 0.0]"}) {
    const std::string said = message({"", "[-2.0, 0.0, 0.0]", axis, round});
    EXPECT_NE(said.find("is outside the bag"), std::string::npos) << said;
    EXPECT_EQ(said.find("along its axis"), std::string::npos) << said;
  }
}

// Two discs of 0.35 m in x = 0, with 4 mm between their middles; sheets of 1 mm; and discs that hold the
// outlet.
const std::string lens = "mesh = { generator = \"driver\", opening = 0.004 }",
                  pressed =
                      "mesh = { generator = \"driver\" }\nfixed_panels = [\"attachment\"]\n"
                      "[[membrane.fold]]\ntype = \"press\"\ngap = 1e-3",
                  thick = "mesh = { generator = \"driver\", opening = 0.2 }";

// The rim of 60 mm is beyond both sheets; what blows along them is a jet in the plane of the bag.
TEST(outlet_place, a_jet_along_the_plane_of_a_flat_bag_is_accepted) {
  const std::string across = "shape = \"rectangular\"\nlong_side = 0.1\nshort_side = 0.02\n";
  for (const Outlet& outlet : {
           Outlet{"lens", "[0.002, -0.1, 0.0]", "[0.0, 1.0, 0.0]", round, lens},
           Outlet{"oblique_in_the_plane", "[0.002, -0.1, 0.05]", "[0.0, 1.0, 0.7]", round, lens},
           Outlet{"a_little_tilted", "[0.002, -0.1, 0.0]", "[0.4, 1.0, 0.0]", round, lens},
           Outlet{"slot_in_the_plane", "[0.002, -0.1, 0.0]", "[0.0, 1.0, 0.0]",
                  across + "long_direction = [0.0, 0.0, 1.0]", lens},
           Outlet{"pressed", "[0.0005, -0.1, 0.0]", "[0.0, 1.0, 0.0]", round, pressed},
           Outlet{"at_the_seam", "[0.0005, -0.345, 0.0]", "[0.0, 1.0, 0.0]", round, pressed},
       }) {
    std::string warnings;
    EXPECT_EQ(message(outlet, &warnings), "") << outlet.name;
    EXPECT_NE(warnings.find("its outlet is wider than the bag at the start, "), std::string::npos)
        << outlet.name << ": " << warnings;
  }
}

TEST(outlet_place, a_rim_outside_is_refused_where_the_outlet_would_fit_or_blows_through_the_skin) {
  const std::string across = "shape = \"rectangular\"\nlong_side = 0.1\nshort_side = 0.02\n";
  for (const Outlet& outlet : {
           Outlet{"would_fit", "[0.02, -0.1, 0.0]", "[0.0, 1.0, 0.0]", round, thick},
           Outlet{"too_tilted", "[0.002, -0.1, 0.0]", "[0.7, 1.0, 0.0]", round, lens},
           Outlet{"in_a_sheet", "[0.0, -0.1, 0.0]", "[0.0, 1.0, 0.0]", round, pressed},
           Outlet{"source_beside_the_bag", "[0.006, -0.1, 0.0]", "[0.0, 1.0, 0.0]", round, lens},
           Outlet{"before_the_seam", "[0.0005, -0.36, 0.0]", "[0.0, 1.0, 0.0]", round, pressed},
           Outlet{"slot_across_the_sheets", "[0.002, -0.1, 0.0]", "[0.0, 1.0, 0.0]",
                  across + "long_direction = [1.0, 0.0, 0.0]", lens},
       })
    EXPECT_NE(message(outlet).find("is outside the bag"), std::string::npos)
        << outlet.name << message(outlet);
  EXPECT_EQ(message({"fits", "[0.06, -0.1, 0.0]", "[0.0, 1.0, 0.0]", round, thick}), "");
}

}  // namespace
