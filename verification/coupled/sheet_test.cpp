// SPDX-License-Identifier: Apache-2.0
// Sheets under prescribed pressure, open or closed, without gas.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "case_folder.hpp"
#include "claim.hpp"
#include "closed_form/disc.hpp"
#include "closed_form/membrane.hpp"
#include "run_case.hpp"

namespace {

using coupled::message_of;

constexpr double kDiscRadius = 0.3;  // [m]

// Quarter of a disc as in cases/clamped_disc.obj, of n rings and one more that is held.
std::string quarter_disc(int n) {
  std::string text;
  std::vector<int> first;  // node of each circle
  int count = 0;
  for (int k = 0; k <= n + 1; ++k) {
    first.push_back(count + 1);
    for (int i = 0; i <= 2 * k; ++i, ++count) {
      const double angle = k > 0 ? M_PI / 2 * i / (2 * k) : 0.0, r = kDiscRadius * k / n;
      text += fmt::format("v {} {} 0\n", i == 2 * k ? 0.0 : r * std::cos(angle), r * std::sin(angle));
    }
  }
  const auto ring = [&](int k) {
    const auto node = [&](int circle, int i) { return first[static_cast<std::size_t>(circle)] + i; };
    for (int s = 0; s < 2; ++s)
      for (int j = 0; j < k; ++j) {
        const int inner = node(k - 1, s * (k - 1) + j), outer = node(k, s * k + j);
        text += fmt::format("f {} {} {}\n", inner, outer, outer + 1);
        if (j < k - 1) text += fmt::format("f {} {} {}\n", inner, outer + 1, inner + 1);
      }
  };
  text += "g membrane\n";
  for (int k = 1; k <= n; ++k) ring(k);
  text += "g rim\n";
  ring(n + 1);
  return text;
}

double drift_of(const coupled::CaseRun& run) {
  return run.state.peaks.energy_residual / run.state.peaks.energy_scale;
}

TEST(sheet, quarter_of_a_clamped_disc_comes_to_rest_at_the_closed_form_with_order_2) {
  const double pressure = 1000.0;
  const auto exact = closed_form::clamped_disc({closed_form::paper_fabric(), kDiscRadius, pressure});
  std::vector<double> errors;
  for (const int n : {4, 8, 16}) {
    const coupled::Folder folder;
    std::ofstream(folder.path / "clamped_disc.obj") << quarter_disc(n);
    coupled::fs::copy_file(coupled::case_file("clamped_disc"), folder.path / "clamped_disc.toml");
    driver::CaseDocument document(folder.path / "clamped_disc.toml", {});
    const auto run = coupled::run_of(driver::load_scene(document));
    ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
    const auto& row = run.history.back();
    EXPECT_EQ(row.at("overpressure_Pa"), pressure);
    EXPECT_NEAR(run.history[5].at("overpressure_Pa"), 500.0, 1e-9);  // half way up the ramp
    errors.push_back(row.at("skin_displacement_m") / exact.centre_deflection - 1.0);
    // Second order in the step, which is a hundredth of the slowest mode's.
    EXPECT_LT(drift_of(run), 1e-3);
    EXPECT_GT(run.energy.back().at("pressure_work_J"), run.energy.back().at("skin_strain_J"));
  }
  claim::expect_order(
      {"M.6", "quarter of a clamped disc under prescribed pressure: height at rest", "at a point: h^2 log h"},
      errors, 1.7, 2.1);
}

// Logarithm of the swing about the radius at rest, by neighbouring extremes of the displacement.
double decay_rate(const coupled::CaseRun& run) {
  std::vector<double> times, sizes;
  const auto& h = run.history;
  for (std::size_t i = 1; i + 1 < h.size(); ++i) {
    const auto at = [&](std::size_t k) { return h[k].at("skin_area_m2"); };
    const double left = at(i - 1), middle = at(i), right = at(i + 1);
    if ((middle - left) * (middle - right) <= 0.0) continue;
    const double shift = 0.5 * (left - right) / (left - 2.0 * middle + right);  // of the parabola's top
    times.push_back(h[i].at("time_s") + shift * (h[i + 1].at("time_s") - h[i].at("time_s")));
    sizes.push_back(middle - 0.25 * (left - right) * shift);
  }
  // Differences of neighbouring extremes decay as the swing does.
  const auto range = [&](std::size_t i) { return std::abs(sizes[i + 1] - sizes[i]); };
  constexpr std::size_t from = 3, to = 13;
  return std::log(range(from) / range(to)) / (times[to] - times[from]);
}

TEST(sheet, sphere_with_stiffness_damping_decays_at_the_rate_of_the_closed_form) {
  const auto run = coupled::run_case("damped_sphere");
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  const auto sheet = closed_form::paper_fabric();
  claim::expect_relative({"M.28", "breathing sphere with stiffness damping: rate of decay [1/s]",
                          "320 elements: 2 % of omega^2; lag of the damping: c dt / 2 = 0.1 %"},
                         decay_rate(run),
                         closed_form::sphere_breathing_decay({sheet, kDiscRadius}, 2000.0, 1e-4), 0.03);
  EXPECT_LT(drift_of(run), 1e-3);
  EXPECT_GT(run.energy.back().at("damping_J"), 0.0);
}

TEST(sheet, step_above_the_bound_with_damping_is_refused) {
  const auto run = coupled::run_case("damped_sphere", {"membrane.stiffness_damping=1e-2"});
  EXPECT_EQ(run.outcome.status, driver::RunStatus::failed);
  EXPECT_NE(run.outcome.message.find("stiffness damping"), std::string::npos) << run.outcome.message;
}

TEST(sheet, faults_are_named) {
  const auto says = [](const char* name, const std::vector<std::string>& overrides, const char* text) {
    const std::string message = message_of(coupled::case_file(name), overrides);
    EXPECT_NE(message.find(text), std::string::npos) << message;
  };
  says("half_cylinder", {"membrane.overpressure=1000"}, "overpressure: is for sheets without gas");
  says("clamped_disc", {"fabric.porosity=0.05"}, "porosity");
  says("clamped_disc", {"membrane.stiffness_damping=-1"}, "stiffness_damping");
  says("clamped_disc", {"membrane.overpressure={time=[0,1],value=[0,nan]}"}, "overpressure");
}

TEST(sheet, without_gas_or_pressure_is_refused_and_open_bags_of_gas_too) {
  const coupled::Folder folder;
  std::ofstream(folder.path / "clamped_disc.obj") << quarter_disc(2);
  std::string text = coupled::read(coupled::case_file("clamped_disc"));
  const auto at = text.find("overpressure = {");
  text.erase(at, text.find('\n', at) - at);
  std::ofstream(folder.path / "case.toml") << text;
  EXPECT_NE(message_of(folder.path / "case.toml").find("gas: is missing"), std::string::npos);
  std::ofstream(folder.path / "case.toml") << text << "[gas]\ninitial = { composition = { N2 = 1.0 } }\n";
  EXPECT_NE(message_of(folder.path / "case.toml").find("not a closed control volume"), std::string::npos);
}

}  // namespace
