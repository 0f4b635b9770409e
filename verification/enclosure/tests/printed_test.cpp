// SPDX-License-Identifier: Apache-2.0
// `gasjet exact` prints no digit that is not the exact value's.
#include <gtest/gtest.h>

#include "random_rows.hpp"

namespace {

using closed_form::ParameterMap;

// Where terms cancel, of each kind one: differences of pressures, integrals near an end, roots near their
// start, elliptic functions near the top, long times, short times, gamma next to 1.
TEST(printed, digits_are_right_where_terms_cancel) {
  const struct {
    const char* name;
    ParameterMap given;
    std::vector<double> abscissae;
  } rows[] = {
      {"orifice_flow", {}, {1e-30, 1e-9, 1e-3}},
      {"porous_flow", {}, {1e-30, 1e-9}},
      {"blowdown", {{"gamma", 1.0000001}}, {0.01, 0.2}},
      {"blowdown", {{"p0", 101325.00001}}, {1e-9, 1e-6}},
      {"blowdown_times", {{"p0", 101325.00001}}, {}},
      {"isothermal_blowdown_times", {{"p0", 101325.00001}}, {}},
      {"ambient_inrush", {{"p0", 101324.99999}}, {0.0, 1e-8, 1e-6}},
      {"linear_fabric_tank", {{"p0", 101325.00001}}, {1e-6, 0.1}},
      {"vented_fill_steady", {{"gamma", 1.0000001}}, {}},
      {"volume_work_drift", {}, {-1e-3, 1e-12, 1e-4, 0.14, 0.16}},
      {"volume_work_drift", {{"gamma", 1.0000001}}, {1e-4}},
      {"tank_fill_pulse", {{"p0", 1e-9}}, {1e-9, 1e-5}},
      {"heat_loss_fill", {{"T0", 0.05}}, {1e-12}},
      {"adiabatic_piston", {{"V", 0.06}}, {0.06 * (1 + 1e-9)}},
      {"sphere_inflation_hencky", {}, {1e-9, 1.0}},
      {"cylinder_fixed_length_hencky", {}, {1e-9, 1.0}},
      {"cylinder_closed_ends_hencky", {}, {1e-9, 1.0}},
      {"cylinder_closed_ends", {}, {1e-9, 1.0}},
      {"pendulum_swing", {{"theta0", 3.141592}}, {0.0, 1e-9, 1.0, 3.0, 1e6}},
      {"pendulum_swing", {{"theta0", 1e-9}}, {0.3, 0.6, 1.0}},
      {"pendulum_half_sine", {}, {1e-12, 1e-6, 0.02, 0.021}},
      {"pendulum_constants", {{"L_i", 1.2549}}, {}},
      {"sphere_shadow", {}, {0.5 * (1 + 1e-12)}},
      {"sphere_shadow", {{"r", 1e-9}}, {0.6}},
      {"twisted_ring", {{"outer_radius", 0.1 * (1 + 1e-9)}, {"inner_radius", 0.1}}, {1e-3}},
      {"gas_spring", {}, {1e-9, 1e5}},
      {"sphere_fill", {}, {0.0, 1e-12, 1e-6}},
      {"pressed_cylinder", {{"E", 1e-3}}, {0.06}},
      {"half_plane_target", {}, {-10.0}},
      {"mesh_time_step", {{"E", 1e-180}}, {0.01}},
  };
  for (const auto& row : rows)
    test::expect_printed(closed_form::find_entry(row.name), row.given, row.abscissae);
}

TEST(printed, digits_are_right_at_random_parameters) {
  const auto count = test::expect_printed_at_random(3, 1);
  EXPECT_GT(count.values, 600);
  // The digits that a form states are left nearly everywhere.
  EXPECT_LT(count.shortened, count.values / 50);
}

// A form of which the true digits are known: (1 + x) - 1 for a large and a small x.
TEST(printed, values_end_where_rounding_begins) {
  closed_form::Entry entry{"difference",
                           "",
                           "",
                           "",
                           "",
                           15,
                           {},
                           {"x", "difference", "product"},
                           {1.0},
                           [](const ParameterMap&, double x) {
                             return std::vector<double>{(x + 1e9) - 1e9, 3.0 * x}; }};
  const auto table = closed_form::evaluate_rounded(entry, {}, std::vector<double>{1.0 / 3.0, 1e-12, 0.0});
  EXPECT_EQ(table.rows[0][0], 1.0 / 3.0);  // the abscissa is as given
  EXPECT_NEAR(table.rows[0][1], 1.0 / 3.0, table.within[0][1]);
  EXPECT_EQ(table.within[0][1], 1e-6);  // a double near 1e9 is known to 1.2e-7
  EXPECT_EQ(table.rows[0][2], 1.0);
  EXPECT_EQ(table.rows[1][1], 0.0);
  EXPECT_EQ(table.within[1][1], 1e-6);
  EXPECT_EQ(table.rows[2][1], 0.0);
  EXPECT_EQ(table.within[2], std::vector<double>(3, 0.0));  // exact
}

}  // namespace
