// SPDX-License-Identifier: Apache-2.0
// Simulations through gasjet.h: bits, views, and calls with one wrong argument each.
#include <chrono>
#include <functional>

#include "bad_calls.hpp"

using namespace border_test;

namespace {

const std::string kCase = std::string(GASJET_SOURCE_DIR) + "/cases/passenger_sharp.toml";
const char* const kShort = "scene.end_time=0.002\n";

struct CSimulation : BadCalls {
  void SetUp() override {
    BadCalls::SetUp();
    ASSERT_OK(gasjet_sim_create(kCase.c_str(), nullptr, kShort, nullptr, 1, &sim.value));
  }
  Handle sim;
};

TEST_F(CSimulation, steps_have_the_bits_of_a_run) {
  Handle run, mine;
  ASSERT_OK(gasjet_run(kCase.c_str(), nullptr, kShort, nullptr, 1, nullptr, nullptr, &run.value));
  ASSERT_OK(gasjet_sim_advance(sim.value, 1.0, 0, nullptr, nullptr));
  ASSERT_OK(gasjet_sim_results(sim.value, &mine.value));
  int64_t columns = 0, rows = 0, my_rows = 0;
  ASSERT_OK(gasjet_run_size(run.value, GASJET_HISTORY, &columns, &rows));
  ASSERT_OK(gasjet_run_size(mine.value, GASJET_HISTORY, &columns, &my_rows));
  ASSERT_EQ(rows, my_rows);
  for (int64_t c = 0; c < columns; ++c) {
    const double *theirs = nullptr, *own = nullptr;
    ASSERT_OK(gasjet_run_column(run.value, GASJET_HISTORY, c, &theirs));
    ASSERT_OK(gasjet_run_column(mine.value, GASJET_HISTORY, c, &own));
    for (int64_t r = 0; r < rows; ++r) ASSERT_EQ(theirs[r], own[r]) << c << " " << r;
  }
  double time = 0.0, drift = 1.0, value = 0.0;
  int64_t steps = 0;
  int ended = 0;
  ASSERT_OK(gasjet_sim_time(sim.value, &time, &steps, &ended));
  EXPECT_EQ(time, 0.002);
  EXPECT_EQ(ended, 1);
  ASSERT_OK(gasjet_sim_drift(sim.value, &drift));
  EXPECT_LT(drift, 0.01);
  ASSERT_OK(gasjet_sim_value(sim.value, GASJET_ENERGY, "driving_work_J", &value));
  EXPECT_EQ(value, 0.0);
}

TEST_F(CSimulation, views_follow_the_steps) {
  const double* x = nullptr;
  int64_t rows = 0, columns = 0, stride = 0;
  for (int array = GASJET_SIM_POSITION; array <= GASJET_SIM_BACKFLOWS; ++array)
    ASSERT_OK(gasjet_sim_view(sim.value, array, &x, &rows, &columns, &stride));
  ASSERT_OK(gasjet_sim_view(sim.value, GASJET_SIM_POSITION, &x, &rows, &columns, &stride));
  EXPECT_EQ(columns, 3);
  EXPECT_EQ(stride, 4);
  const double before = x[4 * 700];
  Handle clone;
  ASSERT_OK(gasjet_sim_clone(sim.value, &clone.value));
  ASSERT_OK(gasjet_sim_step(sim.value, 20));
  EXPECT_NE(x[4 * 700], before);
  ASSERT_OK(gasjet_sim_assign(sim.value, clone.value));
  EXPECT_EQ(x[4 * 700], before);
  ASSERT_OK(gasjet_sim_step(sim.value, 1));
  ASSERT_OK(gasjet_sim_reset(sim.value));
  EXPECT_EQ(x[4 * 700], before);
}

// What the memory below the caller's frame holds.
[[gnu::noinline]] void fill_stack(unsigned char value) {
  volatile unsigned char below[200000];
  for (volatile unsigned char& byte : below) byte = value;
}

TEST_F(CSimulation, saved_bytes_hold_the_state_and_nothing_else) {
  for (const char* name : {"passenger_sharp", "free_headform", "passenger_letter", "tank_blowdown"}) {
    const std::string file = std::string(GASJET_SOURCE_DIR) + "/cases/" + name + ".toml";
    Handle made;
    ASSERT_OK(gasjet_sim_create(file.c_str(), nullptr, nullptr, nullptr, 1, &made.value));
    ASSERT_OK(gasjet_sim_step(made.value, 3));
    int64_t size = 0;
    ASSERT_OK(gasjet_sim_save(made.value, nullptr, 0, &size));
    std::vector<uint8_t> bytes[2] = {std::vector<uint8_t>(static_cast<std::size_t>(size)),
                                     std::vector<uint8_t>(static_cast<std::size_t>(size))};
    for (int i = 0; i < 2; ++i) {
      fill_stack(i == 0 ? 0x55 : 0xaa);
      ASSERT_OK(gasjet_sim_save(made.value, bytes[i].data(), size, &size));
    }
    EXPECT_EQ(bytes[0], bytes[1]) << name;
  }
}

TEST_F(CSimulation, null_and_other_handles_are_refused) {
  double d = 0.0;
  double v[9] = {};
  int64_t i = 0;
  int n = 0;
  const double* numbers_of = nullptr;
  const int32_t* numbers = nullptr;
  const uint8_t* lit_ones = nullptr;
  double* force = nullptr;
  gasjet_tank_state gas_now;
  gasjet_sim_impact impact;
  gasjet_handle other = 0;
  uint8_t bytes[8] = {};
  const std::vector<std::function<int(gasjet_handle)>> all{
      [&](gasjet_handle s) { return gasjet_sim_clone(s, &other); },
      [&](gasjet_handle s) { return gasjet_sim_assign(s, sim.value); },
      [&](gasjet_handle s) { return gasjet_sim_save(s, nullptr, 0, &i); },
      [&](gasjet_handle s) { return gasjet_sim_restore(s, bytes, 8); },
      [&](gasjet_handle s) { return gasjet_sim_reset(s); },
      [&](gasjet_handle s) { return gasjet_sim_time(s, &d, &i, &n); },
      [&](gasjet_handle s) { return gasjet_sim_evaluate(s, &d, &d); },
      [&](gasjet_handle s) { return gasjet_sim_step(s, 1); },
      [&](gasjet_handle s) { return gasjet_sim_advance(s, 1.0, 0, nullptr, nullptr); },
      [&](gasjet_handle s) { return gasjet_sim_finish(s); },
      [&](gasjet_handle s) { return gasjet_sim_results(s, &other); },
      [&](gasjet_handle s) { return gasjet_sim_record(s, 1); },
      [&](gasjet_handle s) { return gasjet_sim_view(s, 0, &numbers_of, &i, &i, &i); },
      [&](gasjet_handle s) { return gasjet_sim_own_force(s, &force, &i, &i); },
      [&](gasjet_handle s) { return gasjet_sim_triangles(s, &numbers, &i); },
      [&](gasjet_handle s) { return gasjet_sim_jet(s, 0, &numbers_of, &i, &numbers, &lit_ones, &i); },
      [&](gasjet_handle s) { return gasjet_sim_gas(s, &gas_now); },
      [&](gasjet_handle s) { return gasjet_sim_read_impact(s, &impact); },
      [&](gasjet_handle s) { return gasjet_sim_value(s, 0, "time_s", &d); },
      [&](gasjet_handle s) { return gasjet_sim_drift(s, &d); },
      [&](gasjet_handle s) { return gasjet_sim_set_vent(s, 0, 1e-3); },
      [&](gasjet_handle s) { return gasjet_sim_set_sensor(s, "x", 1); },
      [&](gasjet_handle s) { return gasjet_sim_set_ambient(s, 1e5, 300.0); },
      [&](gasjet_handle s) { return gasjet_sim_set_inflow(s, 0, 1.0, 300.0); },
      [&](gasjet_handle s) { return gasjet_sim_set_outlet(s, 0, v, v); },
      [&](gasjet_handle s) { return gasjet_sim_set_gravity(s, v); },
      [&](gasjet_handle s) { return gasjet_sim_set_impactor(s, v, nullptr, v, nullptr); }};
  for (const auto& one : all) each_bad_handle("sim", tank.value, one);

  const gasjet_handle s = sim.value;
  refused(gasjet_sim_clone(s, nullptr), "clone");
  refused(gasjet_sim_save(s, nullptr, 0, nullptr), "needed");
  refused(gasjet_sim_save(s, bytes, 8, &i), "size");
  refused(gasjet_sim_save(s, nullptr, 8, &i), "bytes");
  refused(gasjet_sim_restore(s, nullptr, 8), "bytes");
  refused(gasjet_sim_restore(s, bytes, 0), "size");
  refused(gasjet_sim_restore(s, bytes, 8), "state");
  refused(gasjet_sim_time(s, nullptr, &i, &n), "time");
  refused(gasjet_sim_time(s, &d, nullptr, &n), "steps");
  refused(gasjet_sim_time(s, &d, &i, nullptr), "ended");
  refused(gasjet_sim_evaluate(s, nullptr, &d), "step");
  refused(gasjet_sim_evaluate(s, &d, nullptr), "limit");
  refused(gasjet_sim_results(s, nullptr), "run");
  for (const int array : {-1, 11, 1000}) refused(gasjet_sim_view(s, array, &numbers_of, &i, &i, &i), "array");
  refused(gasjet_sim_view(s, 0, nullptr, &i, &i, &i), "values");
  refused(gasjet_sim_view(s, 0, &numbers_of, nullptr, &i, &i), "rows");
  refused(gasjet_sim_view(s, 0, &numbers_of, &i, nullptr, &i), "columns");
  refused(gasjet_sim_view(s, 0, &numbers_of, &i, &i, nullptr), "stride");
  refused(gasjet_sim_own_force(s, nullptr, &i, &i), "force");
  refused(gasjet_sim_triangles(s, nullptr, &i), "triangles");
  for (const int64_t which : {int64_t{-1}, int64_t{1}, INT64_MAX})
    refused(gasjet_sim_jet(s, which, &numbers_of, &i, &numbers, &lit_ones, &i), "jet");
  refused(gasjet_sim_jet(s, 0, nullptr, &i, &numbers, &lit_ones, &i), "overpressure");
  refused(gasjet_sim_gas(s, nullptr), "gas");
  refused(gasjet_sim_read_impact(s, nullptr), "impact");
  refused(gasjet_sim_value(s, 2, "time_s", &d), "table");
  refused(gasjet_sim_value(s, 0, nullptr, &d), "name");
  refused(gasjet_sim_value(s, 0, "no_such", &d), "name");
  refused(gasjet_sim_value(s, 0, "time_s", nullptr), "value");
  refused(gasjet_sim_set_sensor(s, nullptr, 1), "name");
  refused(gasjet_sim_set_outlet(s, 0, nullptr, v), "centre");
  refused(gasjet_sim_set_outlet(s, 0, v, nullptr), "axis");
  refused(gasjet_sim_set_outlet(s, 0, v, v), "axis");
  refused(gasjet_sim_set_gravity(s, nullptr), "gravity");
  refused(gasjet_sim_set_impactor(s, nullptr, nullptr, v, nullptr), "centre");
  refused(gasjet_sim_set_impactor(s, v, nullptr, nullptr, nullptr), "velocity");
  refused(gasjet_sim_step(s, INT64_MIN), "count");
  refused(gasjet_sim_set_vent(s, INT64_MIN, 1.0), "vent");
  each(kNotCounted, "area", [&](double value) { return gasjet_sim_set_vent(s, 0, value); });
  each(kNotCounted, "mass_flow", [&](double value) { return gasjet_sim_set_inflow(s, 0, value, 300.0); });
  each(kNotPositive, "temperature", [&](double value) { return gasjet_sim_set_inflow(s, 0, 1.0, value); });
  each(kNotCounted, "pressure", [&](double value) { return gasjet_sim_set_ambient(s, value, 300.0); });
  each(kNotPositive, "temperature", [&](double value) { return gasjet_sim_set_ambient(s, 1e5, value); });
  refused(gasjet_sim_create(nullptr, nullptr, nullptr, nullptr, 1, &other), "case_file");
  refused(gasjet_sim_create(kCase.c_str(), nullptr, nullptr, nullptr, 0, &other), "threads");
  refused(gasjet_sim_create(kCase.c_str(), nullptr, nullptr, nullptr, 1, nullptr), "sim");
  EXPECT_GT(calls, 200);
}

// What the border adds to a step: a pendulum alone costs next to nothing.
TEST_F(CSimulation, a_step_costs_less_than_a_microsecond_more) {
  const std::string pendulum = std::string(GASJET_SOURCE_DIR) + "/cases/pendulum_pulse.toml";
  double least = 1.0;
  for (int round = 0; round < 5; ++round) {
    Handle one, many;
    ASSERT_OK(gasjet_sim_create(pendulum.c_str(), nullptr, nullptr, nullptr, 1, &one.value));
    ASSERT_OK(gasjet_sim_clone(one.value, &many.value));
    const auto start = std::chrono::steady_clock::now();
    for (int step = 0; step < 400; ++step) gasjet_sim_step(one.value, 1);
    const auto middle = std::chrono::steady_clock::now();
    ASSERT_OK(gasjet_sim_step(many.value, 400));
    const std::chrono::duration<double> single = middle - start,
                                        together = std::chrono::steady_clock::now() - middle;
    least = std::min(least, (single - together).count() / 400.0);
  }
  std::printf("%.0f ns a call\n", 1e9 * least);
  EXPECT_LT(least, 1e-6 * 20);  // twenty times the goal, for sanitizers and busy machines
}

}  // namespace
