// SPDX-License-Identifier: Apache-2.0
// Random coupled scenes: each ends with its energy balanced, or names the stage, the time and the limit that
// it left.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <regex>
#include <sstream>

#include "base/case_reader.hpp"
#include "run_case.hpp"

namespace {

class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  /// A number from `low` to `high`, any power of ten as likely as another.
  double over(double low, double high) { return low * std::exp(share() * std::log(high / low)); }
  /// The share of 1 is in [0, 1); the sequence is the same on every machine.
  double share() { return static_cast<double>(engine_()) / 4294967296.0; }
  template <class T>
  T one_of(std::initializer_list<T> choices) {
    return choices.begin()[static_cast<std::size_t>(share() * static_cast<double>(choices.size()))];
  }

 private:
  std::mt19937 engine_;
};

std::string set(const char* key, double value) {
  std::ostringstream text;
  text.precision(17);
  text << key << '=' << std::scientific << value;
  return text.str();
}

/// From soft to stiff, from a whiff to a burst: also what no bag bears.
std::vector<std::string> random_overrides(const std::string& name, Dice& dice) {
  std::vector<std::string> list{
      set("fabric.young_modulus", dice.over(1e6, 1e9)),
      set("fabric.thickness", dice.over(1e-4, 2e-3)),
      set("inflator.0.mass_flow", dice.over(1e-3, 30.0)),
      set("inflator.0.temperature", dice.over(250.0, 1500.0)),
      dice.one_of({"gas.thermodynamics=\"constant\"", "gas.thermodynamics=\"nasa7\""}),
      dice.one_of({"fabric.compression=\"none\"", "fabric.compression=\"linear\""}),
      set("membrane.perturbation", dice.over(1e-9, 1e-4)),
      "scene.end_time=0.01",
  };
  if (name == "passenger_pendulum") {
    list.emplace_back("pendulum.pivot=[0.12, 0.0, 1.31]");  // contact soon
    list.push_back(set("inflator.0.jet.short_side", dice.over(5e-3, 8e-2)));
    list.push_back(set("pendulum.mass", dice.over(1.0, 100.0)));
    return list;
  }
  list.emplace_back("membrane.mesh.levels=2");
  if (name == "contact_vent") {
    list.push_back(set("vent.0.area", dice.over(1e-5, 2e-2)));
    list.push_back(set("contact.friction", dice.over(1e-3, 1.0)));
    list.push_back(set("pendulum.mass", dice.over(1.0, 100.0)));
  } else {
    list.push_back(set("inflator.0.jet.radius", dice.over(5e-3, 5e-2)));
    list.push_back(set("inflator.1.mass_flow", dice.over(1e-3, 10.0)));
  }
  return list;
}

/// What the driver says of a failure or a drift; a bare `nan` or an exception of the standard library is none
/// of it.
bool names_a_limit(const driver::RunOutcome& outcome) {
  static const std::regex failure(
      "^stage S[0-9]+.* at [0-9.e-]+ s, step [0-9]+: "
      ".*(above|below|beyond|limit|range|must|radius|allowed|cross).*");
  static const std::regex drift(".*energy.*_J.*");
  return std::regex_match(outcome.message, outcome.status == driver::RunStatus::failed ? failure : drift);
}

TEST(random_scenes, balance_their_energy_or_name_a_limit) {
  int ended = 0;
  for (unsigned seed = 1; seed <= 500; ++seed) {
    Dice dice(seed);
    const std::string name = dice.one_of({"contact_vent", "jet_bag", "passenger_pendulum"});
    const auto overrides = random_overrides(name, dice);
    std::string options;
    for (const auto& text : overrides) options += " --set " + text;
    SCOPED_TRACE("seed " + std::to_string(seed) + ": " + name + options);
    try {
      const auto run = coupled::run_case(name, overrides);
      for (const auto& row : run.history)
        for (const auto& [column, value] : row) ASSERT_TRUE(std::isfinite(value)) << column;
      if (run.outcome.status != driver::RunStatus::done) {
        EXPECT_TRUE(names_a_limit(run.outcome)) << run.outcome.message;
        continue;
      }
      ++ended;
      double scale =
          0.0;  // energies are of a gas with constant heat capacities or of formation: all of them count
      for (const auto& [column, value] : run.energy.back())
        if (column != "time_s") scale = std::max(scale, std::abs(value));
      EXPECT_LE(std::abs(run.energy.back().at("residual_J")), 0.01 * scale);
    } catch (const driver::CaseError& error) {
      ADD_FAILURE() << "refused: " << error.what();
    }
  }
  EXPECT_GT(ended, 250) << "most of them are scenes that a bag bears";
}

}  // namespace
