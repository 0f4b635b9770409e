// SPDX-License-Identifier: Apache-2.0
// Field files, read by a small XML reader of the test's own: tags that match, counts that are those said, and
// the volume, jet force, pressure and pendulum angle that the history has at the same level.
#include "results/fields.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <regex>

#include "case_folder.hpp"
#include "results/load_scene.hpp"
#include "run_case.hpp"

namespace {

struct Element {
  std::string name, text;
  std::map<std::string, std::string> attributes;
};

// Every element in the order of its start tag, with its own text; throws where tags do not match.
std::vector<Element> read_xml(const std::string& xml) {
  static const std::regex attribute(R"re(([A-Za-z_]+)="([^"<]*)")re");
  std::vector<Element> elements;
  std::vector<std::size_t> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at)) {
    const std::size_t end = xml.find('>', at), next = std::min(xml.find('<', end), xml.size());
    if (end == std::string::npos) throw std::runtime_error("tag without end");
    const std::string tag = xml.substr(at + 1, end - at - 1);
    at = end;
    if (tag.starts_with("?") || tag.starts_with("!--")) continue;
    if (tag.starts_with("/")) {
      if (open.empty() || elements[open.back()].name != tag.substr(1))
        throw std::runtime_error("</" + tag.substr(1) + "> without start");
      open.pop_back();
      continue;
    }
    Element element{tag.substr(0, tag.find_first_of(" /")), xml.substr(end + 1, next - end - 1), {}};
    for (std::sregex_iterator a(tag.begin(), tag.end(), attribute), none; a != none; ++a)
      element.attributes[(*a)[1]] = (*a)[2];
    elements.push_back(element);
    if (!tag.ends_with("/")) open.push_back(elements.size() - 1);
  }
  if (!open.empty()) throw std::runtime_error("<" + elements[open.back()].name + "> without end");
  return elements;
}

struct PolyData {
  std::map<std::string, std::vector<double>> arrays;
  std::size_t points = 0, polygons = 0;

  explicit PolyData(const std::filesystem::path& file) {
    for (const Element& e : read_xml(coupled::read(file))) {
      if (e.name == "Piece") {
        points = std::stoul(e.attributes.at("NumberOfPoints"));
        if (e.attributes.contains("NumberOfPolys")) polygons = std::stoul(e.attributes.at("NumberOfPolys"));
      }
      if (e.name != "DataArray") continue;
      std::istringstream text(e.text);
      auto& values = arrays[e.attributes.at("Name")];
      for (std::string word; text >> word;) values.push_back(std::stod(word));
    }
  }
  Eigen::Vector3d point(std::size_t n) const { return Eigen::Vector3d(arrays.at("Points").data() + 3 * n); }
  Eigen::Vector3d corner(std::size_t e, std::size_t c) const {
    return point(static_cast<std::size_t>(arrays.at("connectivity").at(3 * e + c)));
  }
  Eigen::Vector3d area(std::size_t e) const {
    return 0.5 * (corner(e, 1) - corner(e, 0)).cross(corner(e, 2) - corner(e, 0));
  }
};

void expect_counts(const PolyData& bag) {
  EXPECT_EQ(bag.arrays.at("Points").size(), 3 * bag.points);
  EXPECT_EQ(bag.arrays.at("velocity_m_s").size(), 3 * bag.points);
  ASSERT_EQ(bag.arrays.at("connectivity").size(), 3 * bag.polygons);
  for (const double node : bag.arrays.at("connectivity")) ASSERT_LT(node, static_cast<double>(bag.points));
  for (const char* name : {"offsets", "panel", "principal_stress_Pa", "principal_strain", "overpressure_Pa",
                           "jet_overpressure_Pa", "jet_mask"})
    ASSERT_EQ(bag.arrays.at(name).size(), bag.polygons) << name;
  for (std::size_t e = 0; e < bag.polygons; ++e)
    ASSERT_EQ(bag.arrays.at("offsets")[e], static_cast<double>(3 * e + 3));
}

// Sums over 2744 elements in another order than the program's: off by some 2744 eps, 6e-13, of terms that
// come to some ten times their sum.
constexpr double kSums = 1e-11;

void expect_record(const PolyData& bag, const coupled::Row& row, double ambient, double facing_away) {
  double volume = 0.0;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  std::map<double, int> mask;
  for (std::size_t e = 0; e < bag.polygons; ++e) {
    volume += bag.corner(e, 0).dot(bag.corner(e, 1).cross(bag.corner(e, 2))) / 6.0;
    force += bag.arrays.at("jet_overpressure_Pa")[e] * bag.area(e);
    mask[bag.arrays.at("jet_mask")[e]] += 1;
    const double gas = bag.arrays.at("overpressure_Pa")[e] - bag.arrays.at("jet_overpressure_Pa")[e];
    ASSERT_NEAR(gas, row.at("pressure_Pa") - ambient,
                1e-9);  // differences of numbers up to 3e5: 10 eps of them
  }
  EXPECT_NEAR(volume, row.at("volume_m3"), kSums * row.at("volume_m3"));
  EXPECT_NEAR(force.norm(), row.at("jet_force_N"), kSums * row.at("jet_force_N"));
  EXPECT_EQ(mask[2.0], row.at("jet_lit_elements"));
  EXPECT_EQ(mask[1.0], row.at("jet_hidden_elements") + facing_away);
}

TEST(fields, files_say_what_the_history_says) {
  const coupled::Folder folder;
  driver::CaseDocument document(GASJET_SOURCE_DIR "/cases/passenger_pendulum.toml",
                                {"scene.end_time=0.011", "output.fields_every=0.005"});
  const driver::Scene scene = driver::load_scene(document);
  driver::State state = driver::make_state(scene);
  driver::ResultFolder results(folder.path / "results", "run");
  results.begin({});
  driver::FieldWriter writer(results, scene);
  const auto columns = driver::history_columns(scene);
  std::vector<double> times, facing_away;
  std::map<double, coupled::Row> rows;
  driver::run_scene(scene, state,
                    [&](bool recorded, const driver::State& now) {
                      if (recorded) rows[now.time] = coupled::row_of(columns, scene, now);
                    },
                    {driver::at_multiples(scene.output.fields_every, [&](const driver::State& now) {
                      writer.write(now);
                      times.push_back(now.time);
                      facing_away.push_back(static_cast<double>(now.jets.front().counters.facing_away));
                    })});
  std::vector<Element> parts;
  for (const Element& e : read_xml(coupled::read(results.path() / "fields.pvd")))
    if (e.name == "DataSet") parts.push_back(e);
  ASSERT_EQ(times.size(), 3u);  // 0, 5 and 10 ms
  ASSERT_EQ(parts.size(), 6u);  // bag and pendulum
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(std::stod(parts[2 * i].attributes.at("timestep")), times[i]);
    ASSERT_TRUE(rows.contains(times[i]));  // both intervals fall on the same steps
    const coupled::Row& row = rows.at(times[i]);
    const PolyData bag(results.path() / parts[2 * i].attributes.at("file"));
    expect_counts(bag);
    expect_record(bag, row, scene.ambient.pressure, facing_away[i]);
    const PolyData pendulum(results.path() / parts[2 * i + 1].attributes.at("file"));
    const Eigen::Vector3d rod = pendulum.point(1) - pendulum.point(0);
    EXPECT_NEAR(rod.norm(), 1.31, 1e-14);  // m, in the case; eps of the 1.3 m that are subtracted
    EXPECT_NEAR(std::atan2(rod.x(), -rod.z()), row.at("pendulum_angle_rad"), 1e-14);
  }
  EXPECT_GT(rows.at(times[2]).at("jet_force_N"), 1000.0);  // the jet is there to be compared
}

}  // namespace
