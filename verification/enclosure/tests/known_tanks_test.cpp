// SPDX-License-Identifier: Apache-2.0
// Random tanks whose solutions are elementary. Exact values are balls of 128 bits; bounds have 25 digits, so
// that an error of 1e-18 in a step is seen.
#include "bounds.hpp"
#include "known.hpp"

namespace {

using namespace test;
using enclosure::Scene;
using enclosure::Tube;

// p = p0 z^(-2 g/(g-1)), T = T0 z^-2, z = 1 + (g-1)/2 (2/(g+1))^((g+1)/(2(g-1))) Cd A sqrt(g R T0)/V t.
TEST(enclosure, contains_choked_blowdown) {
  for (unsigned seed = 1; seed <= draws; ++seed) {
    Draw draw(seed);
    const double width = width_of(seed);
    Scene s = tank(draw);
    s.ambient_pressure = 0.0;
    const double area = draw(1e-5, 1e-3), cd = draw(0.5, 1.0), time = draw(0.001, 0.05);
    s.holes = {{.discharge_coefficient = cd, .area = {{0.0, area}}}};
    Ball open(time);
    if (seed % 2 == 0) {  // opens, closes and opens again
      const double first = 0.25 * time, second = 0.5 * time, third = 0.875 * time;
      s.sensors = {{.switching = {first, second, third}}};
      s.holes[0].node = 0;
      open = Ball(second) - Ball(first) + Ball(time) - Ball(third);
    }
    const OneGas g(s);
    const Ball one(1.0), two(2.0), e = (g.gamma + one) / (g.gamma - one) / two;
    const Ball rate = pow(two / (g.gamma + one), e) * Ball(cd) * Ball(area) * sqrt(g.gamma * g.r * g.t) / g.v;
    const Ball z = one + (g.gamma - one) / two * rate * open;
    const Ball mass = g.mass * pow(z, Ball(-2.0) / (g.gamma - one));
    const Tube tube = tube_at(s, time, width);
    expect_contains(tube, "pressure_Pa", g.p * pow(z, Ball(-2.0) * g.gamma / (g.gamma - one)), width);
    expect_contains(tube, "temperature_K", g.t / (z * z), width);
    expect_contains(tube, "gas_mass_kg", mass, width);
    expect_contains(tube, "vent_0_out_kg", g.mass - mass, width * (g.mass / (g.mass - mass)).middle());
  }
}

// Masses and internal energy are integrals of the inflow; the curve has a knot in between.
TEST(enclosure, contains_two_gas_fill) {
  for (unsigned seed = 1; seed <= draws; ++seed) {
    Draw draw(seed);
    const double width = width_of(seed);
    Scene s = tank(draw);
    const OneGas g(s);
    const double cp = draw(2.6, 5.0), molar = draw(0.004, 0.05), flow = draw(0.1, 3.0),
                 t_in = draw(300.0, 1500.0);
    s.species.push_back(gas(molar, cp, "other"));
    s.initial_fractions = {1.0, 0.0};
    s.inflators = {{.mass_fractions = {0.0, 1.0},
                    .mass_flow = {{0.0, 0.0}, {0.01, flow}, {0.03, flow}},
                    .temperature = {{0.0, t_in}},
                    .start = 0.002}};
    const double time = draw(0.015, 0.03);
    const Ball since = Ball(time) - Ball(0.002), rise(0.01);
    const Ball in = Ball(flow) * (since - rise + rise * Ball(0.5)), r = gas_constant(molar);
    const Ball u = g.mass * g.cv * g.t + in * r * Ball(cp) * Ball(t_in);
    const Ball t = u / (g.mass * g.cv + in * r * Ball(cp - 1.0));
    const Tube tube = tube_at(s, time, width);
    expect_contains(tube, "inflator_0_in_kg", in, width);
    expect_contains(tube, "mass_other_kg", in, 10.0 * width * (1.0 + (g.mass / in).middle()));
    expect_contains(tube, "mass_gas_kg", g.mass, 10.0 * width * (1.0 + (in / g.mass).middle()));
    expect_contains(tube, "temperature_K", t, width);
    expect_contains(tube, "pressure_Pa", (g.mass * g.r + in * r) * t / g.v, 10.0 * width);
  }
}

// p V^g is constant, for a volume of lines, its knot too, of parabolas, and for a wave.
TEST(enclosure, contains_piston) {
  for (unsigned seed = 1; seed <= draws; ++seed) {
    Draw draw(seed);
    const double width = width_of(seed);
    Scene s = tank(draw);
    OneGas g(s);
    const double time = seed % 4 == 1 ? 0.06 : draw(0.01, 0.05), v0 = s.volume[0].value,
                 v1 = v0 * draw(0.5, 2.0);
    Ball v;
    if (seed % 2) {
      s.volume = {{0.0, v0}, {0.06, v1}};
      const Ball share = Ball(time) / Ball(0.06), bulge(seed % 4 == 3 ? 0.2 * v0 : 0.0);
      s.bulges = {bulge.middle()};
      v = Ball(v0) + (Ball(v1) - Ball(v0) + Ball(4.0) * bulge * (Ball(1.0) - share)) * share;
    } else {
      const double amplitude = 0.3 * v0, frequency = draw(10.0, 60.0), phase = draw(0.0, 6.0);
      s.wave = {v0, amplitude, frequency, phase};
      const auto at = [&](double t) {
        Ball pi, sine;
        arb_const_pi(pi.get(), enclosure::bits);
        arb_sin(sine.get(), (Ball(2.0) * pi * Ball(frequency) * Ball(t) + Ball(phase)).get(),
                enclosure::bits);
        return Ball(v0) + Ball(amplitude) * sine;
      };
      g.v = at(0.0);
      v = at(time);
    }
    const Ball p = g.p * pow(g.v / v, g.gamma);
    const Tube tube = tube_at(s, time, width);
    expect_contains(tube, "volume_m3", v, 1e-20);
    expect_contains(tube, "pressure_Pa", p, width);
    expect_contains(tube, "temperature_K", g.t * p * v / (g.p * g.v), width);
  }
}

// T - T_ext decays at h A/(m cv).
TEST(enclosure, contains_heat_loss) {
  for (unsigned seed = 1; seed <= draws; ++seed) {
    Draw draw(seed);
    const double width = width_of(seed);
    Scene s = tank(draw);
    s.wall_conductance = draw(1.0, 500.0);
    const OneGas g(s);
    const double time = draw(0.01, 0.2);
    const Ball decay = exp(Ball(0.0) - Ball(s.wall_conductance) / (g.mass * g.cv) * Ball(time));
    const Ball outside(s.outside_temperature);
    const Tube tube = tube_at(s, time, width);
    expect_contains(tube, "temperature_K", outside + (g.t - outside) * decay, width);
  }
}

// Fabric of velocity k (p - p_a): 1 - p_a/p decays at g k C p_a/V (isentrope, see docs/theory/enclosure.md).
// A share of it acts, falling to a half within a sixteenth of a second.
TEST(enclosure, contains_table_of_velocities) {
  for (unsigned seed = 1; seed <= draws; ++seed) {
    Draw draw(seed);
    const double width = width_of(seed);
    Scene s = tank(draw);
    s.initial_pressure = draw(1.1e5, 3e5);
    const double slope = draw(1e-5, 1e-4), area = draw(0.01, 0.3), time = draw(0.001, 0.05);
    s.fabrics = {{.coefficient = area,
                  .velocity = enclosure::Curve{{0.0, 0.0}, {1e6, 1e6 * slope}},
                  .share = {{0.0, 1.0}, {0.0625, 0.5}}}};
    const Ball acts = Ball(time) * (Ball(1.0) - Ball(4.0) * Ball(time));
    const OneGas g(s);
    const Ball pa(s.ambient_pressure), k = (Ball(1e6 * slope) / Ball(1e6)) * Ball(area);
    const Ball decay = exp(Ball(0.0) - g.gamma * k * pa / g.v * acts);
    const Ball p = pa / (Ball(1.0) - (Ball(1.0) - pa / g.p) * decay);
    const Ball out = g.mass * (Ball(1.0) - pow(p / g.p, Ball(1.0) / g.gamma));
    const Tube tube = tube_at(s, time, width);
    expect_contains(tube, "pressure_Pa", p, width);
    expect_contains(tube, "fabric_out_kg", out, width * (1.0 + (g.mass / out).middle()));
  }
}

// Ambient gas, choked on its way in: mass and enthalpy rise at a constant rate.
TEST(enclosure, contains_choked_backflow) {
  for (unsigned seed = 1; seed <= draws; ++seed) {
    Draw draw(seed);
    const double width = width_of(seed);
    Scene s = tank(draw);
    s.initial_pressure = draw(1e3, 2e4);
    const double area = draw(1e-5, 1e-3);
    s.holes = {{.area = {{0.0, area}}, .backflow = true}};
    s.ambient_fractions = {1.0};
    const OneGas g(s);
    const Ball one(1.0), two(2.0), ta(s.ambient_temperature);
    // Until the pressure has risen by about 0.2 p_a, far from the sonic switch.
    const double time = 0.2 * s.volume[0].value / area / (Ball(0.7) * g.gamma * sqrt(g.r * ta)).middle();
    const Ball psi = pow(two / (g.gamma + one), (g.gamma + one) / (g.gamma - one) / two);
    const Ball in = Ball(area) * Ball(s.ambient_pressure) * sqrt(g.gamma / (g.r * ta)) * psi * Ball(time);
    const Ball t = (g.mass * g.t + in * g.gamma * ta) / (g.mass + in);
    const Tube tube = tube_at(s, time, width);
    expect_contains(tube, "vent_0_backflow_kg", in, width);
    expect_contains(tube, "temperature_K", t, width);
    expect_contains(tube, "gas_mass_kg", g.mass + in, width);
  }
}

// gamma = 7/5: with x^2 = T over that at p_a, V 5 x^4 x' = - Cd A sqrt(2 cp T_e) sqrt(x^2 - 1), so that the
// time from x to x = 1 is 5 V/(Cd A c) (3 s/8 + sinh(2 s)/4 + sinh(4 s)/32), x = cosh s. Choked above x^2 =
// 6/5.
struct Emptying {
  Ball t_end_temperature, speed, factor;
  Ball left(const Ball& x) const {  // [s] to rest
    Ball s;
    arb_acosh(s.get(), x.get(), enclosure::bits);
    const auto sinh = [](const Ball& a) {
      Ball c;
      arb_sinh(c.get(), a.get(), enclosure::bits);
      return c;
    };
    return factor *
           (Ball(3.0) * s / Ball(8.0) + sinh(Ball(2.0) * s) / Ball(4.0) + sinh(Ball(4.0) * s) / Ball(32.0));
  }
};

TEST(enclosure, contains_emptying_across_the_sonic_switch_to_rest) {
  for (unsigned seed = 1; seed <= few; ++seed) {
    Draw draw(seed);
    const double width = width_of(seed);
    Scene s = tank(draw);
    s.species = {gas(draw(0.004, 0.05), 3.5)};
    s.initial_pressure = draw(2.5e5, 6e5);
    const double area = draw(1e-4, 1e-3);
    s.holes = {{.area = {{0.0, area}}}};
    const OneGas g(s);
    const Ball pa(s.ambient_pressure), te = g.t * pow(pa / g.p, Ball(2.0) / Ball(7.0));
    const Ball c = sqrt(Ball(7.0) * g.r * te);
    const Emptying law{te, c, Ball(5.0) * g.v / (Ball(area) * c)};
    const Ball x0 = pow(g.p / pa, Ball(1.0) / Ball(7.0)), xs = sqrt(Ball(6.0) / Ball(5.0));
    // Choked: T = T0 z^-2, so x = x0/z, until x = xs.
    const Ball psi = pow(Ball(5.0) / Ball(6.0), Ball(3.0));
    const Ball rate = psi * Ball(area) * sqrt(Ball(7.0) * g.r * g.t / Ball(5.0)) / g.v / Ball(5.0);
    const Ball end = (x0 / xs - Ball(1.0)) / rate + law.left(xs);
    const double before = (end - law.left(Ball(1.02))).middle(), after = 1.2 * end.middle();
    const Tube tube = enclosure::enclose(s, {.times = {before, after}, .width = width});
    // The solution falls: the bounds of p hold if their times lie on both sides of the time asked for.
    const Known p = bounds_of(tube, 0, "pressure_Pa");
    const auto time_of = [&](const Ball& pressure) {
      return end - law.left(pow(pressure / pa, Ball(1.0) / Ball(7.0)));
    };
    EXPECT_FALSE((Ball(before) - time_of(p.lower)).is_positive());
    EXPECT_FALSE((time_of(p.upper) - Ball(before)).is_positive());
    EXPECT_LE((p.upper - p.lower).middle(), width * p.upper.middle());
    expect_contains(tube, "pressure_Pa", pa, width);
    expect_contains(tube, "temperature_K", te, width);
  }
}

// Two ranges that differ at 1000 K, in both directions, passed by hot inflow and by cold one: U is exact.
TEST(enclosure, contains_the_joint_of_two_ranges) {
  constexpr double width = 1e-10;
  for (const double jump : {-2e-3, 0.0, 2e-3})
    for (const bool heats : {true, false}) {
      Scene s;
      enclosure::Species gas{.name = "N2",
                             .molar_mass = 0.028,
                             .low = {3.2, 6e-4, 0, 0, 0, 5.0},
                             .high = {3.5, 3e-4, 0, 0, 0, 5.0},
                             .constant_cp = false,
                             .minimum_temperature = 200.0,
                             .maximum_temperature = 6000.0};
      gas.high[5] += (3.2 + 0.3 - 3.5 - 0.15) * 1000.0 + jump;  // h/R at 1000 K differs by `jump`
      s.species = {gas};
      s.initial_fractions = {1.0};
      s.initial_pressure = 2e5;
      s.initial_temperature = heats ? 950.0 : 1080.0;
      s.volume = {{0.0, 0.01}};
      s.inflators = {{.mass_fractions = {1.0},
                      .mass_flow = {{0.0, 1.0}},
                      .temperature = {{0.0, heats ? 900.0 : 300.0}}}};
      const auto h = [&](const std::array<double, 6>& a, const Ball& t) {
        return Ball(a[0]) * t + Ball(a[1]) / Ball(2.0) * t * t + Ball(a[5]);  // over R
      };
      const auto u = [&](const std::array<double, 6>& a, const Ball& t) { return h(a, t) - t; };
      const Ball r = gas_constant(0.028), start(s.initial_temperature), in_temperature(heats ? 900.0 : 300.0);
      const Ball mass = Ball(2e5) * Ball(0.01) / (r * start), time(0.004);
      const Ball total =
          (mass * u(heats ? gas.low : gas.high, start) + time * h(gas.low, in_temperature)) / (mass + time);
      const Tube tube = enclosure::enclose(s, {.times = {0.004}, .width = width});
      const Known t = bounds_of(tube, 0, "temperature_K");
      const auto& range = heats ? gas.high : gas.low;
      EXPECT_TRUE(heats ? t.lower.middle() > 1000.0 : t.upper.middle() < 1000.0) << t.lower.middle();
      EXPECT_FALSE((u(range, t.lower) - total).is_positive()) << jump << heats;
      EXPECT_FALSE((total - u(range, t.upper)).is_positive()) << jump << heats;
      EXPECT_LE((t.upper - t.lower).middle(), width * 1000.0);
    }
}

// Thirds and sevenths have no last digit: the text of each end differs from them, outward.
TEST(enclosure, decimals_are_rounded_outward) {
  for (const double numerator : {1.0, -1.0, 1e-200, -3e200})
    for (const double denominator : {3.0, 7.0}) {
      const Ball exact = Ball(numerator) / Ball(denominator);
      const enclosure::Bounds b = enclosure::bounds(exact);
      const Ball below = exact - decimal(b.lower_text), above = decimal(b.upper_text) - exact;
      EXPECT_TRUE(below.is_positive() && above.is_positive()) << b.lower_text << " " << b.upper_text;
      EXPECT_LE((below + above).middle(), 1e-23 * std::abs(exact.middle()));
      EXPECT_FALSE((Ball(b.lower) - exact).is_positive() || (exact - Ball(b.upper)).is_positive());
    }
}

}  // namespace
