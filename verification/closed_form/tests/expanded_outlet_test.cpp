// SPDX-License-Identifier: Apache-2.0
// The notional nozzle of an underexpanded outlet. Reference numbers: 40-digit arithmetic (mpmath) of the
// balances, rounded to 17 digits.
#include <cmath>
#include <limits>

#include "check.hpp"
#include "closed_form/jet.hpp"

namespace {

using namespace closed_form;
using test::expect_refused;
using test::expect_relative;
using test::kAlgebra;

TEST(ClosedFormExpandedOutlet, state_eq_reference) {
  struct Row {
    ExpandedOutlet outlet;
    NotionalNozzle exact;
  };
  for (const Row& r : {Row{{{}, 700.0, 5e-3, 101325.0, 3.0},
                           {4.3219679700842257, 726.76961554131724, 0.76585157605957113, 445.76719576719577,
                            1.5529953917050691, 3141.075}},
                       Row{{{2077.0, 5.0 / 3.0}, 900.0, 1e-3, 1.5e5, 1.25},
                           {0.20443512314221387, 1712.034579090037, 0.11690550929838364, 617.76,
                            1.0214285714285714, 350.0}}}) {
    const NotionalNozzle s = expanded_outlet(r.outlet);
    for (const auto member :
         {&NotionalNozzle::mass_flow, &NotionalNozzle::velocity, &NotionalNozzle::density,
          &NotionalNozzle::temperature, &NotionalNozzle::area_ratio, &NotionalNozzle::thrust})
      expect_relative(s.*member, r.exact.*member, kAlgebra);
    EXPECT_EQ(plate_load(r.outlet, 0.0), s.thrust);
  }
}

const PerfectGas kGases[] = {{296.8, 1.4}, {2077.0, 5.0 / 3.0}, {188.9, 1.3}, {300.0, 1.02}};

// A control volume from the outlet to the nozzle, with the bag's pressure on its sides.
TEST(ClosedFormExpandedOutlet, expansion_keeps_mass_momentum_and_enthalpy) {
  for (const PerfectGas& gas : kGases)
    for (const double n : {1.0, 1.1, 2.0, 5.0, 200.0}) {
      const double area = 4e-3, p = 1.2e5, rest = 900.0, cp = specific_heat_cp(gas);
      const NotionalNozzle s = expanded_outlet({gas, rest, area, p, n});
      const OutletState in = sonic_outlet({gas, rest, true, s.mass_flow, area});
      expect_relative(in.static_pressure, n * p, kAlgebra);
      const double out = area * s.area_ratio;
      expect_relative(s.density * s.velocity * out, s.mass_flow, kAlgebra);
      expect_relative(s.density * s.velocity * s.velocity * out,
                      in.density * in.velocity * in.velocity * area + (in.static_pressure - p) * area,
                      kAlgebra);
      expect_relative(s.thrust, s.mass_flow * s.velocity, kAlgebra);
      expect_relative(cp * s.temperature + 0.5 * s.velocity * s.velocity, cp * rest, kAlgebra);
      expect_relative(s.density * gas.gas_constant * s.temperature, p, kAlgebra);
      for (const double e : {-0.5, 0.3, 1.0, 4.0})
        expect_relative(plate_load({gas, rest, area, p, n}, e), s.thrust + e * s.mass_flow * in.velocity,
                        kAlgebra);
    }
}

// The gas mixes with none and exchanges no heat, so its entropy cannot fall: V stays below that of the
// isentrope to the same pressure. Both begin at the throat, where the flow per area has its maximum, so they
// part with the third power of 1 - 1/n.
TEST(ClosedFormExpandedOutlet, expansion_raises_the_entropy) {
  for (const PerfectGas& gas : kGases) {
    const double gamma = gas.heat_capacity_ratio;
    const auto loss = [&](double n) {
      const NotionalNozzle s = expanded_outlet({gas, 900.0, 4e-3, 1.2e5, n});
      const double isentrope = 2.0 / (gamma + 1.0) * std::pow(n, (1.0 - gamma) / gamma);  // T/T_s
      const double velocity = std::sqrt(2.0 * specific_heat_cp(gas) * 900.0 * (1.0 - isentrope));
      return 1.0 - s.velocity / velocity;
    };
    EXPECT_NEAR(loss(1.0), 0.0, 10 * kAlgebra);  // 1 - T/T_s is as small as 0.01
    double before = 0.0;
    for (const double n : {1.1, 1.5, 3.0, 10.0, 1000.0}) {
      EXPECT_GT(loss(n), before);
      before = loss(n);
    }
    // Rounding of 1e-15 is 1e-6 of the smaller loss; the next term of the series is of the order of 1 - 1/n.
    EXPECT_NEAR(loss(1.0 / 0.99) / loss(1.0 / 0.995), 8.0, 0.2);
    // Area follows: it grows with the square of 1 - 1/n, by (gamma + 1)/(2 gamma^2).
    const double growth = expanded_outlet({gas, 900.0, 4e-3, 1.2e5, 1.0 / 0.999}).area_ratio - 1.0;
    EXPECT_NEAR(growth / 1e-6, 0.5 * (gamma + 1.0) / (gamma * gamma), 5e-3);
  }
}

TEST(ClosedFormExpandedOutlet, far_expansion_tends_to_its_limits) {
  for (const PerfectGas& gas : kGases) {
    const double n = 1e9, gamma = gas.heat_capacity_ratio;
    const NotionalNozzle s = expanded_outlet({gas, 900.0, 4e-3, 1.0, n});
    const double sonic = sonic_outlet({gas, 900.0, true, s.mass_flow, 4e-3}).velocity;
    expect_relative(s.velocity, sonic * (1.0 + 1.0 / gamma), 2.0 / n);  // slopes in 1/n of up to 1
    expect_relative(s.temperature, 900.0 / (gamma * gamma), 2.0 / n);
    EXPECT_GT(s.temperature, 900.0 / (gamma * gamma));
  }
}

TEST(ClosedFormExpandedOutlet, bad_parameters_are_refused_by_name) {
  const ExpandedOutlet good{{}, 700.0, 5e-3, 1e5, 1.0};
  expanded_outlet(good);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double n : {std::nextafter(1.0, 0.0), 0.0, -3.0, infinity, kRequired})
    expect_refused([&] { expanded_outlet({{}, 700.0, 5e-3, 1e5, n}); }, "pressure_ratio");
  expect_refused([] { expanded_outlet({{}, -700.0, 5e-3, 1e5, 2.0}); }, "stagnation_temperature");
  expect_refused([] { expanded_outlet({{}, 700.0, 0.0, 1e5, 2.0}); }, "area");
  expect_refused([] { expanded_outlet({{}, 700.0, 5e-3, kRequired, 2.0}); }, "bag_pressure");
  for (const double e : {-1.01, infinity, kRequired})
    expect_refused([&] { plate_load(good, e); }, "restitution");
}

}  // namespace
