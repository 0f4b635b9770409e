// SPDX-License-Identifier: Apache-2.0
// Histories that LS-DYNA writes as text: rcforc, nodout, rbdout.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "base/case_reader.hpp"
#include "case_folder.hpp"
#include "compare/compare.hpp"

namespace {

const std::string kTextMaps = GASJET_SOURCE_DIR "/cases/maps/";

// Motion at the time t [ms] of what is written: x = 10 t^2 [mm], force 2 t [kN].
double travel(double t) {
  return 10.0 * t * t;
}

std::string rcforc(int contact) {
  std::string text =
      " legend of contacts\n{BEGIN LEGEND}\n Entity #        Title\n     1     bag\n{END LEGEND}\n\n";
  for (int i = 0; i < 4; ++i)
    for (const auto& [side, sign] : {std::pair{"slave", 1.0}, {"master", -1.0}})
      text += fmt::format(
          "  {:<6} {:>10} time {:12.5E}  x {:12.5E}  y {:12.5E}  z {:12.5E} mass {:12.5E}"
          " mx {:12.5E} my {:12.5E} mz {:12.5E}\n",
          side, contact, 1.0 * i, sign * 1.2 * i, 0.0, -sign * 1.6 * i, 0.0, 0.0, 0.0, 0.0);
  return text;
}

// Full fields of 12 characters: no blanks between numbers of three digits of exponent.
std::string nodout(std::initializer_list<int> nodes) {
  std::string text;
  const auto field = [&](double value) { text += fmt::format("{:12.4E}", value); };
  for (int i = 0; i < 4; ++i) {
    const double t = i;
    text += fmt::format(
        "\n n o d a l   p r i n t   o u t   f o r   t i m e  s t e p {:>7}{:>30}( at time {:13.7E} )\n",
        i + 1, "", t);
    text += "\n nodal point  x-disp     y-disp      z-disp      x-vel  ...\n";
    for (const int node : nodes) {
      text += fmt::format("{:>10}", node);
      for (const double value :
           {travel(t), 0.0, 0.0, 20.0 * t, 0.0, 0.0, -20.0, 0.0, 0.0, node + travel(t), 1.0, 2.0})
        field(value);
      text += '\n';
    }
    text += "\n nodal point  x-rot      y-rot       z-rot       x-rot vel ...\n";
    for (const int node : nodes) {
      text += fmt::format("{:>10}", node);
      for (const double value : {0.0, 0.1 * t, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.0}) field(value);
      text += '\n';
    }
  }
  return text;
}

std::string rbdout(std::initializer_list<int> bodies) {
  std::string text;
  for (int i = 0; i < 4; ++i) {
    const double t = i;
    text += fmt::format(
        "1\n\n\n  r i g i d   b o d y   m o t i o n   a t  cycle= {:>7}    time= {:12.5E}\n\n", i, t);
    for (const int body : bodies) {
      const auto row = [&](const char* name, std::initializer_list<double> values) {
        text += name;
        for (const double value : values) text += fmt::format(" {:11.4E}", value);
        text += '\n';
      };
      text += fmt::format(
          " rigid body   {:>8}\n                 global      x           y           z   ...\n", body);
      row("   coordinates:", {travel(t), 0.0, 0.0});
      row(" displacements:", {travel(t), 0.0, 0.0, 0.0, -0.1 * t, 0.0});
      row("    velocities:", {20.0 * t, 0.0, 0.0, 0.0, -0.1, 0.0});
      row(" accelerations:", {12.0, 0.0, 16.0, 0.0, 0.0, 0.0});
      text +=
          " principal or user defined local coordinate direction vectors\n     a           b           c\n";
      row("   row 1", {1.0, 0.0, 0.0});
      text += " output in principal or user defined local coordinate directions\n     a   b  c  a-rot\n";
      row(" displacements:", {9.0, 9.0, 9.0, 9.0, 9.0, 9.0});
      row("    velocities:", {9.0, 9.0, 9.0, 9.0, 9.0, 9.0});
      row(" accelerations:", {9.0, 9.0, 9.0, 9.0, 9.0, 9.0});
    }
  }
  return text;
}

struct TextFiles {
  coupled::Folder folder;
  std::string write(const char* name, const std::string& text) const {
    std::ofstream(folder.path / name) << text;
    return (folder.path / name).string();
  }
};

const std::vector<double>& column_of(const driver::History& history, const std::string& name) {
  const auto found = std::ranges::find(history.columns, name, [](const auto& c) { return c.first; });
  if (found == history.columns.end()) throw std::runtime_error("no column " + name);
  return found->second;
}

TEST(lsdyna_text, rcforc_in_si_units_by_the_shipped_map) {
  const TextFiles files;
  const auto history =
      driver::read_history(files.write("rcforc", rcforc(1)), kTextMaps + "lsdyna_rcforc.toml");
  ASSERT_EQ(history.time.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(history.time[i], 1e-3 * static_cast<double>(i), 1e-15);
    EXPECT_NEAR(column_of(history, "contact_force_N")[i], 2000.0 * static_cast<double>(i), 1e-9);
  }
}

TEST(lsdyna_text, rbdout_in_si_units_by_the_shipped_map) {
  const TextFiles files;
  const auto history =
      driver::read_history(files.write("rbdout", rbdout({7})), kTextMaps + "lsdyna_rbdout.toml");
  ASSERT_EQ(history.time.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(column_of(history, "pendulum_angle_rad")[i], 0.1 * static_cast<double>(i), 1e-15);
    EXPECT_NEAR(column_of(history, "pendulum_angular_velocity_rad_s")[i], 100.0, 1e-12);
    EXPECT_NEAR(column_of(history, "pendulum_cg_acceleration_m_s2")[i], 20e3, 1e-9);
  }
}

TEST(lsdyna_text, nodout_picks_a_node_with_its_rotations) {
  const TextFiles files;
  const auto map = files.write("map.toml",
                               "format = \"nodout\"\nnumber = 22\n[time]\ncolumn = \"time\"\n"
                               "[[quantity]]\nname = \"x\"\ncolumn = \"x_coor\"\n"
                               "[[quantity]]\nname = \"turn\"\ncolumn = \"y_rot\"\n"
                               "[[quantity]]\nname = \"a\"\ncolumn = \"accl\"\n");
  const auto history = driver::read_history(files.write("nodout", nodout({9, 22})), map);
  ASSERT_EQ(history.time.size(), 4U);
  EXPECT_NEAR(column_of(history, "x")[3], 22.0 + 90.0, 1e-9);
  EXPECT_NEAR(column_of(history, "turn")[3], 0.3, 1e-9);
  EXPECT_NEAR(column_of(history, "a")[3], 20.0, 1e-9);
}

std::string fault_of(const std::function<void()>& read) {
  try {
    read();
  } catch (const driver::CaseError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(lsdyna_text, faults_have_a_place) {
  const TextFiles files;
  const auto says = [&](const char* format, const std::string& text, const std::string& keys,
                        const char* part) {
    const auto map =
        files.write("map.toml", fmt::format("format = \"{}\"\n{}[time]\ncolumn = \"time\"\n", format, keys));
    const auto file = files.write("file", text);
    const std::string message = fault_of([&] { driver::read_history(file, map); });
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  says("rcforc", rcforc(3), "", "accepted");
  says("rcforc", rcforc(3), "number = 2\n", "number 2: no such contact, the file has 3");
  says("rcforc", "nothing\n", "", "no contact in the file");
  says("rbdout", rbdout({1, 2}), "", "number: is missing in the map, the file has rigid body of 1, 2");
  says("nodout", nodout({9}), "number = 0\n", "number");
  std::string torn = nodout({9});
  torn.replace(torn.find("E+00", 400), 4, "E+0*");
  says("nodout", torn, "", "is not a finite number");
  const std::string whole = nodout({9});
  says("nodout", whole.substr(0, whole.size() - 20), "", "the row ends in field 8 of 9");
  says("nodout", whole.substr(0, whole.rfind(" nodal point")), "",
       "the state has no z_racc, but others have");
  says("rbdout", rbdout({1}).substr(0, 330), "", "numbers, needed: 6");
  const std::string bodies = rbdout({1});
  const auto last = bodies.find("    velocities:", bodies.rfind(" rigid body"));
  says("rbdout", bodies.substr(0, last), "", "but others have");
  std::string short_row = rbdout({1});
  short_row.erase(short_row.find(" displacements:") + 40, 12);
  says("rbdout", short_row, "", "has 5 numbers, needed: 6");
  says("csv", "time,x\n0,1\n", "number = 1\n", "number");
}

}  // namespace
