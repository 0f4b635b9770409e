// SPDX-License-Identifier: Apache-2.0
// Thermodynamics, outflow and tank through gasjet.h.
#include <gasjet_exact.h>

#include <algorithm>

#include "meshes.hpp"

using namespace border_test;

namespace {

TEST(c_gas, properties_belong_together) {
  Handle gas;
  ASSERT_OK(gasjet_gas_create("N2=0.7, H2O = 0.2, CO2=0.1", 0.0, &gas.value));
  for (const double temperature : {250.0, 293.15, 999.0, 1001.0, 2500.0}) {
    gasjet_gas_values values;
    ASSERT_OK(gasjet_gas_evaluate(gas.value, temperature, &values));
    EXPECT_NEAR(values.cp - values.cv, values.gas_constant, 1e-12 * values.cp);
    EXPECT_DOUBLE_EQ(values.gamma, values.cp / values.cv);
    EXPECT_NEAR(values.enthalpy - values.internal_energy, values.gas_constant * temperature,
                1e-15 * std::abs(values.enthalpy) + 1e-9);
    EXPECT_NEAR(values.speed_of_sound, std::sqrt(values.gamma * values.gas_constant * temperature),
                1e-12 * values.speed_of_sound);
    double back = 0.0;
    ASSERT_OK(gasjet_gas_temperature(gas.value, values.internal_energy, &back));
    EXPECT_NEAR(back, temperature, 1e-9);
  }
  gasjet_gas_values values;
  EXPECT_EQ(gasjet_gas_evaluate(gas.value, 1e4, &values), GASJET_DOMAIN);
  EXPECT_NE(std::string(gasjet_last_error()).find("10000"), std::string::npos) << gasjet_last_error();
}

TEST(c_gas, entropy_of_constant_cp_eq_its_logarithms) {
  Handle gas;
  ASSERT_OK(gasjet_gas_create_ideal(296.8, 1038.8, &gas.value));
  double cold = 0.0, hot = 0.0;
  ASSERT_OK(gasjet_gas_entropy(gas.value, 300.0, 1e5, &cold));
  ASSERT_OK(gasjet_gas_entropy(gas.value, 600.0, 4e5, &hot));
  EXPECT_NEAR(hot - cold, 1038.8 * std::log(2.0) - 296.8 * std::log(4.0), 1e-9);
}

TEST(c_gas, orifice_chokes_at_the_critical_ratio) {
  double ratio = 0.0, at = 0.0, below = 0.0, above = 0.0;
  ASSERT_OK(gasjet_critical_pressure_ratio(1.4, &ratio));
  EXPECT_NEAR(ratio, std::pow(2.0 / 2.4, 3.5), 1e-14);
  ASSERT_OK(gasjet_orifice(1e-3, 5e5, 600.0, 296.8, 1038.8, ratio * 5e5, &at));
  ASSERT_OK(gasjet_orifice(1e-3, 5e5, 600.0, 296.8, 1038.8, 0.5 * ratio * 5e5, &below));
  ASSERT_OK(gasjet_orifice(1e-3, 5e5, 600.0, 296.8, 1038.8, 0.9 * 5e5, &above));
  EXPECT_NEAR(at, below, 1e-14 * at);
  EXPECT_LT(above, at);
  double leak = 0.0;
  ASSERT_OK(gasjet_fabric(0.01, 1.2, 2e4, &leak));
  EXPECT_DOUBLE_EQ(leak, 0.01 * std::sqrt(2.0 * 1.2 * 2e4));
}

/// Pressures [Pa] of the closed form blowdown at the times.
std::vector<double> blowdown(const std::vector<double>& times) {
  gasjet_handle table = 0;
  EXPECT_EQ(
      gasjet_exact_create("blowdown", nullptr, times.data(), static_cast<int64_t>(times.size()), &table),
      GASJET_OK)
      << gasjet_exact_last_error();
  int64_t columns = 0, rows = 0;
  EXPECT_EQ(gasjet_exact_size(table, &columns, &rows), GASJET_OK);
  std::vector<double> pressures;
  for (int64_t c = 0; c < columns; ++c) {
    char name[80];
    const double* values = nullptr;
    EXPECT_EQ(gasjet_exact_name(table, c, name, sizeof name), GASJET_OK);
    EXPECT_EQ(gasjet_exact_column(table, c, &values), GASJET_OK);
    if (std::string(name) == "pressure_Pa") pressures.assign(values, values + rows);
  }
  EXPECT_EQ(gasjet_exact_free(table), GASJET_OK);
  return pressures;
}

TEST(c_tank, blowdown_eq_closed_form_and_balances) {
  Handle gas, tank;
  ASSERT_OK(gasjet_gas_create_ideal(296.8, 1038.8, &gas.value));
  ASSERT_OK(gasjet_tank_create(gas.value, 5e5, 600.0, 0.06, 101325.0, 1e-10, &tank.value));
  ASSERT_OK(gasjet_tank_add_vent(tank.value, 1.0, 1e-3, 0.0));
  const std::vector<double> times{0.05, 0.1, 0.2, 0.3};
  const auto exact = blowdown(times);
  ASSERT_EQ(exact.size(), times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    gasjet_tank_state state;
    ASSERT_OK(gasjet_tank_advance(tank.value, times[i], 0.06));
    ASSERT_OK(gasjet_tank_read(tank.value, &state));
    EXPECT_NEAR(state.pressure, exact[i], 1e-9 * exact[i]);  // ten times the integrator's tolerance
    EXPECT_EQ(state.time, times[i]);
  }
  gasjet_tank_balance balance;
  ASSERT_OK(gasjet_tank_read_balance(tank.value, &balance));
  EXPECT_GT(balance.vent_mass_out, 0.1);
  EXPECT_NEAR(balance.mass_residual, 0.0, 1e-15);
  EXPECT_NEAR(balance.energy_residual, 0.0, 1e-9);  // [J] of 75 kJ
}

TEST(c_tank, inflow_of_another_gas_while_the_volume_grows_balances) {
  Handle air, hot, tank;
  ASSERT_OK(gasjet_gas_create("N2=0.79, O2=0.21", 0.0, &air.value));
  ASSERT_OK(gasjet_gas_create("N2=0.5, CO2=0.5", 0.0, &hot.value));
  ASSERT_OK(gasjet_tank_create(air.value, 101325.0, 293.15, 0.01, 101325.0, 1e-10, &tank.value));
  const double time[] = {0.0, 0.02, 0.05}, flow[] = {0.0, 1.0, 0.0}, temperature[] = {800.0, 800.0, 700.0};
  ASSERT_OK(gasjet_tank_add_inflow(tank.value, hot.value, 3, time, flow, temperature, 0.01));
  ASSERT_OK(gasjet_tank_add_fabric(tank.value, 1e-4));
  ASSERT_OK(gasjet_tank_add_vent(tank.value, 0.7, 1e-3, 3e4));
  double largest = 0.0;
  for (int i = 1; i <= 50; ++i) {
    gasjet_tank_state state;
    ASSERT_OK(gasjet_tank_advance(tank.value, 2e-3 * i, 0.01 + 2e-4 * i));
    ASSERT_OK(gasjet_tank_read(tank.value, &state));
    if (largest < 101325.0 + 3e4) {
      EXPECT_EQ(state.vent_outflow > 0.0, state.pressure >= 101325.0 + 3e4);
    }
    largest = std::max(largest, state.pressure);
  }
  gasjet_tank_balance balance;
  ASSERT_OK(gasjet_tank_read_balance(tank.value, &balance));
  EXPECT_NEAR(balance.mass_in, 0.025, 1e-15);  // the triangle's area
  EXPECT_GT(balance.vent_mass_out, 0.0);
  EXPECT_GT(balance.fabric_mass_out, 0.0);
  EXPECT_NEAR(balance.mass_residual, 0.0, 1e-16);
  EXPECT_NEAR(balance.energy_residual, 0.0, 1e-10);
}

}  // namespace
