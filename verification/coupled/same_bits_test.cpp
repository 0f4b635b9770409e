// SPDX-License-Identifier: Apache-2.0
// Same case, same build: same bits, for any number of threads.
#include <gtest/gtest.h>

#include <atomic>
#include <bit>
#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <thread>

#include "many_runs/ensemble.hpp"
#include "run_case.hpp"

namespace {

using coupled::run_case;

std::vector<std::uint64_t> bits_of(const coupled::Row& row) {
  std::vector<std::uint64_t> all;
  for (const auto& [name, value] : row) all.push_back(std::bit_cast<std::uint64_t>(value));
  return all;
}

void expect_same_bits(const coupled::CaseRun& a, const coupled::CaseRun& b) {
  ASSERT_EQ(a.history.size(), b.history.size());
  for (std::size_t i = 0; i < a.history.size(); ++i) {
    ASSERT_EQ(bits_of(a.history[i]), bits_of(b.history[i])) << "row " << i;
    ASSERT_EQ(bits_of(a.energy[i]), bits_of(b.energy[i])) << "row " << i;
  }
}

coupled::CaseRun run_on(int threads, const char* name, const std::vector<std::string>& overrides) {
  auto run = run_case(name, overrides, driver::Executor(threads));
  EXPECT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  return run;
}

// The impactor hangs at the folded bag and the inflator starts at full flow: contact within a millisecond.
const std::string kNear = "pendulum.pivot=[0.12,0.0,1.31]", kFullFlow = "inflator.0.mass_flow=4.0";

TEST(same_bits, for_one_two_and_three_threads) {
  // 10 976 elements: enough blocks for the threads to share.
  const std::vector<std::string> overrides{"scene.end_time=0.001", "membrane.mesh.refine=1", kNear,
                                           kFullFlow};
  const auto one = run_on(1, "passenger_pendulum", overrides);
  expect_same_bits(one, run_on(2, "passenger_pendulum", overrides));
  expect_same_bits(one, run_on(3, "passenger_pendulum", overrides));
  EXPECT_GE(one.history.size(), 10u);
  EXPECT_GT(one.state.flows.contact_impulse, 0.0);
  EXPECT_GT(one.state.flows.jet_work, 0.0);
}

TEST(executor, calls_each_number_once_on_the_threads_it_has) {
  for (const int threads : {1, 3}) {
    const driver::Executor executor(threads);
    std::vector<int> calls(1000, 0);
    std::atomic<int> now = 0, most = 0;
    executor.for_each(1000, [&](int i) {
      const int inside = ++now;
      for (int seen = most; inside > seen && !most.compare_exchange_weak(seen, inside);) {
      }
      std::this_thread::sleep_for(std::chrono::microseconds(100));
      ++calls[static_cast<std::size_t>(i)];
      --now;
    });
    EXPECT_EQ(calls, std::vector<int>(1000, 1));
    EXPECT_LE(most, threads);
    EXPECT_GE(most, threads > 1 ? 2 : 1);  // a third thread may come late
  }
}

TEST(executor, throws_what_a_call_throws) {
  for (const int threads : {1, 2})
    EXPECT_THROW(driver::Executor(threads).for_each(10,
                                                    [](int i) {
                                                      if (i == 7) throw std::domain_error("7");
                                                    }),
                 std::domain_error);
  EXPECT_THROW(driver::Executor(0), std::invalid_argument);
}

TEST(same_bits, of_the_scene_with_jet_and_contact) {
  const std::vector<std::string> overrides{"scene.end_time=0.002", kNear, kFullFlow};
  const auto one = run_on(1, "passenger_pendulum", overrides);
  expect_same_bits(one, run_on(2, "passenger_pendulum", overrides));
  EXPECT_GT(one.state.flows.contact_impulse, 0.0);
  EXPECT_GT(one.state.flows.jet_work, 0.0);
}

// A run of the ensemble is the run with that perturbation, by the same bits.
TEST(same_bits, run_of_an_ensemble_eq_run_of_its_seed) {
  driver::EnsembleOptions options;
  options.runs = 2;
  options.first_seed = 3;
  options.quiet = true;
  const auto result = driver::run_ensemble(coupled::case_file("jet_bag"), {"scene.end_time=1e-3"}, options);
  const auto peaks = result.quantities.at("peak_volume_m3");
  for (int seed = 3; seed < 5; ++seed) {
    const auto run = run_case("jet_bag", {"scene.end_time=1e-3", "membrane.perturbation=1e-4",
                                          "membrane.perturbation_seed=" + std::to_string(seed)});
    EXPECT_EQ(peaks.at(static_cast<std::size_t>(seed - 3)), run.state.peaks.volume);
  }
}

TEST(same_bits, perturbation_of_1e_12_m_is_another_run) {
  const auto base = run_case("passenger_pendulum", {"scene.end_time=0.004"});
  const auto other = run_case("passenger_pendulum", {"scene.end_time=0.004", "membrane.perturbation=1e-12"});
  EXPECT_NE(base.history.back().at("volume_m3"), other.history.back().at("volume_m3"));
  EXPECT_NEAR(base.history.back().at("volume_m3") / other.history.back().at("volume_m3"), 1.0,
              1e-6);  // chaos takes longer
}

}  // namespace
