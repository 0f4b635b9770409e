// SPDX-License-Identifier: Apache-2.0
// A caller's floating-point environment: the library computes in the default one and leaves the caller's
// alone.
#include <cfenv>

#include "meshes.hpp"

using namespace border_test;

namespace {

constexpr int kTraps = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;  // those of gfortran -ffpe-trap

/// Traps, and rounding, of a caller during a test.
struct Caller {
  explicit Caller(int traps, int rounding = FE_TONEAREST) {
    std::fegetenv(&before);
    std::feclearexcept(FE_ALL_EXCEPT);
    std::fesetround(rounding);
    feenableexcept(traps);
  }
  ~Caller() { std::fesetenv(&before); }
  std::fenv_t before{};
};

const gasjet_source kInside{{0.01, 0.02, 0.03}, {1.0, 0.5, 0.2}, {0.0, 0.0, 0.0}, 0.0};

struct Parts {
  Parts() {
    EXPECT_OK(gasjet_surface_create(mesh.triangles.data(), mesh.triangle_count(), nullptr, mesh.node_count(),
                                    nullptr, 0, nullptr, 0, &surface.value));
    EXPECT_OK(gasjet_jet_create(&model, mesh.triangles.data(), mesh.triangle_count(), nullptr,
                                mesh.node_count(), nullptr, 0, nullptr, 0, &jet.value));
    EXPECT_OK(gasjet_gas_create("N2=0.7, CO2=0.3", 0.0, &gas.value));
  }
  /// Overpressures, and a property of the gas, by calls that compute with NaN and 1/0 inside.
  std::vector<double> numbers() {
    std::vector<double> all(static_cast<std::size_t>(mesh.triangle_count()));
    std::vector<uint8_t> lit(all.size());
    double force[3];
    EXPECT_OK(gasjet_jet_pressure(jet.value, mesh.nodes.data(), mesh.node_count(), nullptr, 400.0, 0.7, 1,
                                  kNan, all.data(), mesh.triangle_count(), force, nullptr));
    EXPECT_OK(gasjet_surface_visible(surface.value, mesh.nodes.data(), mesh.node_count(), nullptr, &kInside,
                                     nullptr, 0, kNan, lit.data(), mesh.triangle_count(), nullptr));
    gasjet_gas_values values;
    EXPECT_OK(gasjet_gas_evaluate(gas.value, 777.0, &values));
    EXPECT_EQ(gasjet_gas_evaluate(gas.value, kNan, &values), GASJET_BAD_INPUT);
    all.insert(all.end(), {values.enthalpy, values.cp, force[0], static_cast<double>(lit.front())});
    return all;
  }
  Mesh mesh = box(6, 2.0, -1.0);
  gasjet_jet_model model = round_jet();
  Handle surface, jet, gas;
};

std::vector<double> pressures(const char* name, const char* overrides, int threads, gasjet_progress progress,
                              Parts* parts = nullptr) {
  Handle run;
  const std::string file = std::string(GASJET_SOURCE_DIR) + "/cases/" + name;
  EXPECT_OK(gasjet_run(file.c_str(), nullptr, overrides, nullptr, threads, progress, parts, &run.value));
  int64_t columns = 0, rows = 0;
  const double* values = nullptr;
  EXPECT_OK(gasjet_run_size(run.value, GASJET_HISTORY, &columns, &rows));
  EXPECT_OK(gasjet_run_find(run.value, GASJET_HISTORY, "pressure_Pa", &values));
  return {values, values + rows};
}

TEST(c_environment, traps_do_not_stop_a_call_and_are_there_afterwards) {
  Parts parts;
  const Caller caller(kTraps);
  parts.numbers();
  EXPECT_EQ(fegetexcept(), kTraps);
  EXPECT_EQ(std::fetestexcept(FE_ALL_EXCEPT), 0);
}

TEST(c_environment, traps_do_not_stop_a_run_on_threads) {
  const Caller caller(kTraps);
  for (const int threads : {1, 2}) {
    EXPECT_FALSE(pressures("sphere_inflation.toml", "scene.end_time=5e-4", threads, nullptr).empty());
    EXPECT_FALSE(pressures("passenger_pendulum.toml", "scene.end_time=5e-4", threads, nullptr).empty());
  }
  EXPECT_EQ(fegetexcept(), kTraps);
  EXPECT_EQ(std::fetestexcept(FE_ALL_EXCEPT), 0);
}

TEST(c_environment, bits_do_not_depend_on_the_callers_rounding) {
  Parts parts;
  const auto nearest = parts.numbers();
  const auto run = pressures("tank_blowdown.toml", "scene.end_time=0.01", 1, nullptr);
  const Caller caller(0, FE_UPWARD);
  EXPECT_EQ(parts.numbers(), nearest);
  EXPECT_EQ(pressures("tank_blowdown.toml", "scene.end_time=0.01", 1, nullptr), run);
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
  EXPECT_EQ(std::fetestexcept(FE_ALL_EXCEPT), 0);
}

TEST(c_environment, flags_of_the_caller_are_kept) {
  Parts parts;
  const Caller caller(0);
  std::feraiseexcept(FE_UNDERFLOW);
  parts.numbers();
  EXPECT_EQ(std::fetestexcept(FE_ALL_EXCEPT), FE_UNDERFLOW);
}

/// Sees the caller's traps, and may call the library; the flag that it raises is the caller's.
int in_the_callers_environment(double, double, void* parts) {
  EXPECT_EQ(fegetexcept(), kTraps);
  EXPECT_EQ(std::fetestexcept(FE_ALL_EXCEPT & ~FE_UNDERFLOW), 0);
  static_cast<Parts*>(parts)->numbers();
  EXPECT_EQ(fegetexcept(), kTraps);
  std::feraiseexcept(FE_UNDERFLOW);
  return 0;
}

TEST(c_environment, a_callback_runs_in_that_of_the_caller) {
  Parts parts;
  const auto before = pressures("jet_bag.toml", "scene.end_time=1e-3", 1, nullptr);
  const Caller caller(kTraps);
  EXPECT_EQ(pressures("jet_bag.toml", "scene.end_time=1e-3", 1, in_the_callers_environment, &parts), before);
  EXPECT_EQ(std::fetestexcept(FE_ALL_EXCEPT), FE_UNDERFLOW);
}

}  // namespace
