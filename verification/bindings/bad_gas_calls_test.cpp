// SPDX-License-Identifier: Apache-2.0
// Calls with something wrong: a status that is not GASJET_OK, a text that begins with the argument's name,
// outputs as they were. Each test prints how many it makes: more than 300 all together.
#include "bad_calls.hpp"

using namespace border_test;
using bad_calls = BadCalls;

namespace {

TEST_F(bad_calls, gas) {
  gasjet_handle out = 0;
  double y = 7.0;
  gasjet_gas_values v;
  for (const char* text : {"", "N2", "N2=", "N2=x", "=1", "N2=0.5", "N2=1,", "N2=2", "N2=-1", "N2=nan",
                           "N2=1 O2=0", "N2=0.5;O2=0.5"})
    refused(gasjet_gas_create(text, 0.0, &out), "composition");
  for (const char* text : {"Xx=1", "n2=1", "N2=0.5, N2=0.5"}) {
    EXPECT_EQ(gasjet_gas_create(text, 0.0, &out), GASJET_BAD_INPUT);
    EXPECT_NE(std::string(gasjet_last_error())
                  .find(text[0] == 'N'                ? "N2"
                        : text == std::string("n2=1") ? "n2"
                                                      : "Xx"),
              std::string::npos);
    ++calls;
  }
  refused(gasjet_gas_create(nullptr, 0.0, &out), "composition");
  refused(gasjet_gas_create("N2=1", 0.0, nullptr), "gas");
  each(kNotCounted, "constant_cp_at", [&](double t) { return gasjet_gas_create("N2=1", t, &out); });
  each(kNotPositive, "gas_constant", [&](double r) { return gasjet_gas_create_ideal(r, 1000.0, &out); });
  each(kNotFinite, "cp", [&](double cp) { return gasjet_gas_create_ideal(300.0, cp, &out); });
  EXPECT_EQ(out, 0);
  each_bad_handle("gas", tank.value, [&](gasjet_handle h) { return gasjet_gas_evaluate(h, 300.0, &v); });
  each_bad_handle("gas", jet.value, [&](gasjet_handle h) { return gasjet_gas_temperature(h, 3e5, &y); });
  each(kNotFinite, "temperature", [&](double t) { return gasjet_gas_evaluate(gas.value, t, &v); });
  each(kNotFinite, "internal_energy", [&](double u) { return gasjet_gas_temperature(gas.value, u, &y); });
  each(kNotFinite, "temperature", [&](double t) { return gasjet_gas_entropy(gas.value, t, 1e5, &y); });
  each(kNotPositive, "pressure", [&](double p) { return gasjet_gas_entropy(gas.value, 300.0, p, &y); });
  refused(gasjet_gas_evaluate(gas.value, 300.0, nullptr), "values");
  EXPECT_EQ(y, 7.0);
}

TEST_F(bad_calls, outflow) {
  double y = 7.0;
  gasjet_outlet_state s;
  each(kNotPositive, "gamma", [&](double g) { return gasjet_critical_pressure_ratio(g, &y); });
  refused(gasjet_critical_pressure_ratio(1.0, &y), "gamma");
  each(kNotCounted, "effective_area",
       [&](double a) { return gasjet_orifice(a, 2e5, 300, 297, 1039, 1e5, &y); });
  each(kNotCounted, "pressure", [&](double p) { return gasjet_orifice(1, p, 300, 297, 1039, 1e5, &y); });
  each(kNotPositive, "temperature", [&](double t) { return gasjet_orifice(1, 2e5, t, 297, 1039, 1e5, &y); });
  each(kNotPositive, "gas_constant", [&](double r) { return gasjet_orifice(1, 2e5, 300, r, 1039, 1e5, &y); });
  each(kNotPositive, "cp", [&](double cp) { return gasjet_orifice(1, 2e5, 300, 297, cp, 1e5, &y); });
  each(kNotCounted, "ambient_pressure",
       [&](double p) { return gasjet_orifice(1, 2e5, 300, 297, 1039, p, &y); });
  each(kNotCounted, "leak_area", [&](double a) { return gasjet_fabric(a, 1.0, 1.0, &y); });
  each(kNotCounted, "density", [&](double d) { return gasjet_fabric(1.0, d, 1.0, &y); });
  each(kNotFinite, "overpressure", [&](double p) { return gasjet_fabric(1.0, 1.0, p, &y); });
  refused(gasjet_fabric(1.0, 1.0, 1.0, nullptr), "mass_flow");
  each(std::vector<int>{-1, 4, 99}, "law",
       [&](int law) { return gasjet_outlet(law, 1, 1, 300, 1039, 297, 1e5, &s); });
  each(kNotPositive, "area", [&](double a) { return gasjet_outlet(0, a, 1, 300, 1039, 297, 1e5, &s); });
  each(kNotCounted, "mass_flow", [&](double f) { return gasjet_outlet(0, 1, f, 300, 1039, 297, 1e5, &s); });
  each(kNotPositive, "temperature", [&](double t) { return gasjet_outlet(0, 1, 1, t, 1039, 297, 1e5, &s); });
  each(kNotPositive, "cp", [&](double cp) { return gasjet_outlet(0, 1, 1, 300, cp, 297, 1e5, &s); });
  for (const int law : {2, 3})
    each(kNotPositive, "bag_pressure",
         [&](double p) { return gasjet_outlet(law, 1, 1, 300, 1039, 297, p, &s); });
  EXPECT_EQ(y, 7.0);
}

TEST_F(bad_calls, tank) {
  gasjet_handle out = 0;
  each_bad_handle("gas", tank.value,
                  [&](gasjet_handle h) { return gasjet_tank_create(h, 1e5, 300, 1, 1e5, 1e-8, &out); });
  each(kNotCounted, "pressure",
       [&](double p) { return gasjet_tank_create(gas.value, p, 300, 1, 1e5, 1e-8, &out); });
  each(kNotPositive, "temperature",
       [&](double t) { return gasjet_tank_create(gas.value, 1e5, t, 1, 1e5, 1e-8, &out); });
  each(kNotPositive, "volume",
       [&](double v) { return gasjet_tank_create(gas.value, 1e5, 300, v, 1e5, 1e-8, &out); });
  each(kNotCounted, "ambient_pressure",
       [&](double p) { return gasjet_tank_create(gas.value, 1e5, 300, 1, p, 1e-8, &out); });
  each(kNotPositive, "tolerance",
       [&](double e) { return gasjet_tank_create(gas.value, 1e5, 300, 1, 1e5, e, &out); });
  refused(gasjet_tank_create(gas.value, 1e5, 1e5, 1, 1e5, 1e-8, &out), "temperature");
  EXPECT_EQ(out, 0);
  const double time[] = {0.0, 1.0}, flow[] = {1.0, 1.0}, hot[] = {700.0, 700.0}, falling[] = {1.0, 0.0},
               nan[] = {0.0, kNan}, below[] = {1.0, -1.0};
  const auto add = [&](int64_t count, const double* t, const double* f, const double* T, double start = 0.0) {
    return gasjet_tank_add_inflow(tank.value, gas.value, count, t, f, T, start);
  };
  each(std::vector<int64_t>{-1, 0, 1, INT64_MAX}, "count",
       [&](int64_t c) { return add(c, time, flow, hot); });
  refused(add(2, nullptr, flow, hot), "time");
  refused(add(2, time, nullptr, hot), "mass_flow");
  refused(add(2, time, flow, nullptr), "temperature");
  refused(add(2, reinterpret_cast<const double*>(reinterpret_cast<const char*>(time) + 4), flow, hot),
          "time: is not aligned");
  refused(add(2, nan, flow, hot), "time");
  refused(add(2, time, nan, hot), "mass_flow");
  refused(add(2, time, below, hot), "mass_flow");
  refused(add(2, time, flow, nan), "temperature");
  each(kNotFinite, "start_time", [&](double s) { return add(2, time, flow, hot, s); });
  EXPECT_EQ(add(2, falling, flow, hot), GASJET_BAD_INPUT);  // times that fall: the curve says so
  each_bad_handle("tank", gas.value, [&](gasjet_handle h) { return gasjet_tank_add_vent(h, 1.0, 1.0, 0.0); });
  each(kNotCounted, "discharge_coefficient",
       [&](double c) { return gasjet_tank_add_vent(tank.value, c, 1.0, 0.0); });
  each(kNotCounted, "area", [&](double a) { return gasjet_tank_add_vent(tank.value, 1.0, a, 0.0); });
  each(kNotCounted, "opens_at", [&](double p) { return gasjet_tank_add_vent(tank.value, 1.0, 1.0, p); });
  each(kNotCounted, "leak_area", [&](double a) { return gasjet_tank_add_fabric(tank.value, a); });
  const auto back = [&](int64_t vent, gasjet_handle h, double t) {
    return gasjet_tank_add_backflow(tank.value, vent, h, t);
  };
  refused(gasjet_tank_set_vent(tank.value, 0, 1.0), "vent: is 0, but the tank has none");
  ASSERT_OK(gasjet_tank_add_vent(tank.value, 1.0, 0.0, 1e6));
  each(std::vector<int64_t>{-1, 1, INT64_MAX}, "vent", [&](int64_t v) { return back(v, gas.value, 300.0); });
  each_bad_handle("gas", tank.value, [&](gasjet_handle h) { return back(0, h, 300.0); });
  each(kNotPositive, "temperature", [&](double t) { return back(0, gas.value, t); });
  each(kNotCounted, "area", [&](double a) { return gasjet_tank_set_vent(tank.value, 0, a); });
  each(kNotCounted, "conductance", [&](double c) { return gasjet_tank_set_heat_loss(tank.value, c, 300.0); });
  each(kNotPositive, "outside_temperature",
       [&](double t) { return gasjet_tank_set_heat_loss(tank.value, 1.0, t); });
  int64_t size = 0;
  char name[2];
  double masses[2] = {7.0, 7.0};
  refused(gasjet_tank_species(tank.value, name, 2, nullptr), "needed");
  refused(gasjet_tank_species(tank.value, name, 1, &size), "size");
  refused(gasjet_tank_masses(tank.value, masses, masses, 99), "species_count");
  refused(gasjet_tank_masses(tank.value, nullptr, masses, 2), "mass");
  EXPECT_EQ(masses[0], 7.0);
  each(kNotPositive, "time", [&](double t) { return gasjet_tank_advance(tank.value, t, 0.1); });
  each(kNotPositive, "volume", [&](double v) { return gasjet_tank_advance(tank.value, 1.0, v); });
  refused(gasjet_tank_read(tank.value, nullptr), "state");
  refused(gasjet_tank_read_balance(tank.value, nullptr), "balance");
  gasjet_tank_state state;
  ASSERT_OK(gasjet_tank_read(tank.value, &state));
  EXPECT_DOUBLE_EQ(state.pressure, 2e5);  // none of these has changed the tank
  ASSERT_OK(gasjet_tank_advance(tank.value, 1.0, 0.1));
  refused(gasjet_tank_add_vent(tank.value, 1.0, 1.0, 0.0), "tank");
  refused(back(0, gas.value, 300.0), "tank");
  refused(gasjet_tank_advance(tank.value, 1.0, 0.1), "time");
}

TEST_F(bad_calls, pendulum) {
  const gasjet_pendulum_model good = pendulum();
  gasjet_pendulum_point point;
  double moment = 7.0, angle = 0.1, velocity = 0.2;
  const double force[] = {1.0, 0.0, 0.0}, wrong[] = {kNan, 0.0, 0.0};
  refused(gasjet_pendulum_evaluate(nullptr, 0.0, 0.0, &point), "model");
  refused(gasjet_pendulum_evaluate(&good, 0.0, 0.0, nullptr), "point");
  each(kNotFinite, "angle", [&](double a) { return gasjet_pendulum_evaluate(&good, a, 0.0, &point); });
  each(kNotFinite, "angular_velocity",
       [&](double w) { return gasjet_pendulum_evaluate(&good, 0.0, w, &point); });
  refused(gasjet_pendulum_moment(&good, nullptr, force, &moment), "force");
  refused(gasjet_pendulum_moment(&good, force, wrong, &moment), "point");
  refused(gasjet_pendulum_moment(&good, force, force, nullptr), "moment");
  each(kNotFinite, "moment",
       [&](double x) { return gasjet_pendulum_advance(&good, x, 0.0, 1e-3, &angle, &velocity); });
  each(kNotCounted, "dt_before",
       [&](double dt) { return gasjet_pendulum_advance(&good, 0.0, dt, 1e-3, &angle, &velocity); });
  each(kNotPositive, "dt_after",
       [&](double dt) { return gasjet_pendulum_advance(&good, 0.0, 0.0, dt, &angle, &velocity); });
  refused(gasjet_pendulum_advance(&good, 0.0, 0.0, 1e-3, nullptr, &velocity), "angle");
  for (const double bad : kNotPositive) {
    gasjet_pendulum_model changed = good;
    changed.mass = bad;
    ++calls;
    EXPECT_EQ(gasjet_pendulum_evaluate(&changed, 0.0, 0.0, &point), GASJET_BAD_INPUT);
    EXPECT_NE(std::string(gasjet_last_error()).find("mass"), std::string::npos);
  }
  EXPECT_EQ(moment, 7.0);
  EXPECT_EQ(angle, 0.1);
}

TEST_F(bad_calls, results_that_no_double_holds_are_no_results) {
  double y = 7.0;
  Handle ideal, dense;
  gasjet_gas_values of_gas;
  gasjet_outlet_state outlet;
  gasjet_pendulum_point point;
  gasjet_tank_state state;
  const gasjet_pendulum_model swing = pendulum();
  const auto left = [&](int status, const std::string& result) {
    ++calls;
    EXPECT_EQ(status, GASJET_DOMAIN) << result;
    EXPECT_EQ(std::string(gasjet_last_error()).rfind(result, 0), 0u) << gasjet_last_error();
  };
  left(gasjet_orifice(1e308, 1e308, 300, 297, 1039, 1e5, &y), "mass_flow");
  left(gasjet_fabric(1e200, 1.0, 1e300, &y), "mass_flow");
  left(gasjet_outlet(0, 1e-300, 1e300, 300, 1039, 297, 1e5, &outlet), "state");
  ASSERT_OK(gasjet_gas_create_ideal(297, 1039, &ideal.value));
  left(gasjet_gas_evaluate(ideal.value, 1e307, &of_gas), "values");
  left(gasjet_gas_entropy(ideal.value, 300, 5e-324, &y), "entropy");
  left(gasjet_pendulum_evaluate(&swing, 0.0, 1e200, &point), "point");
  const double far[] = {1e308, 1e308, 1e308};
  double along[] = {7.0, 7.0, 7.0};
  left(gasjet_pendulum_moment(&swing, far, far, &y), "moment");
  ASSERT_OK(gasjet_tank_create(ideal.value, 1e300, 1e-3, 1e-200, 1e300, 1e-8, &dense.value));
  left(gasjet_tank_read(dense.value, &state), "state");
  left(gasjet_jet_velocity(&model, far, 1, nullptr, along, 3), "velocity");
  EXPECT_EQ(y, 7.0);
  EXPECT_EQ(along[0], 7.0);
}

}  // namespace
