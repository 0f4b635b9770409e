// SPDX-License-Identifier: Apache-2.0
#include "gas/orifice.hpp"

#include <gtest/gtest.h>

#include "cases.hpp"
#include "claim.hpp"
#include "closed_form/orifice.hpp"

namespace {

using namespace cases;

constexpr double kR = 296.8;  // [J/(kg K)]

double cp_of(double gamma) {
  return gamma / (gamma - 1.0) * kR;
}

double flow(double gamma, double pressure, double temperature, double ambient) {
  return gas::orifice_mass_flow(2e-3, pressure, temperature, kR, cp_of(gamma), gamma, ambient);
}

/// mdot over A sqrt(2 rho dp).
double bernoulli_ratio(double gamma, double pressure, double ambient) {
  return flow(gamma, pressure, 400.0, ambient) /
         (2e-3 * std::sqrt(2.0 * pressure / (kR * 400.0) * (pressure - ambient)));
}

struct Choking {
  double gamma, ratio, flux;
};

/// Computed with 20 digits from the formulas of A. H. Shapiro, Compressible Fluid Flow, ch. 4.
const std::vector<Choking> kChoking{{7.0 / 5.0, 0.52828178771717411, 0.68473145637727038},
                                    {5.0 / 3.0, 0.48713928962874674, 0.72618437741389067},
                                    {1.3, 0.54572773381406477, 0.66726235124086157},
                                    {9.0 / 7.0, 0.54832271640894978, 0.66466750465953704},
                                    {1.25, 0.55492895730664363, 0.65806479175174931}};

TEST(orifice, critical_ratio_and_choked_flux_eq_reference) {
  for (const auto& [gamma, ratio, flux] : kChoking) {
    claim::expect_relative(
        {"G.5", "critical pressure ratio of five gammas [-]", "four roundings and exp: 4 eps"},
        gas::critical_pressure_ratio(gamma), ratio, 1e-15);
    for (const double t : {250.0, 700.0, 2500.0}) {
      const double ambient = 0.3 * ratio * 4e5;
      claim::expect_relative({"G.6", "choked mass flux of five gammas, mdot sqrt(R T)/(A p) [-]",
                              "eight roundings of half an eps: 4 eps"},
                             flow(gamma, 4e5, t, ambient) * std::sqrt(kR * t) / (2e-3 * 4e5), flux, 1e-15);
      EXPECT_EQ(flow(gamma, 4e5, t, ambient), flow(gamma, 4e5, t, 0.0));
    }
  }
}

TEST(orifice, flux_is_smooth_across_the_sonic_switch) {
  for (const auto& [gamma, ratio, flux] : kChoking) {
    for (const double step : {1e-3, 1e-4, 1e-5}) {
      const double sonic = flow(gamma, 4e5, 500.0, 4e5 * ratio);
      const double subsonic = flow(gamma, 4e5, 500.0, 4e5 * ratio * (1.0 + step));
      // First derivative zero, second of order 1: the drop is quadratic, and not zero.
      EXPECT_LT(1.0 - subsonic / sonic, 2.0 * step * step);
      EXPECT_GT(1.0 - subsonic / sonic, 0.2 * step * step - 1e-14);
    }
  }
}

TEST(orifice, subsonic_limit_eq_bernoulli) {
  for (const auto& [epsilon, ratio] : std::vector<std::pair<double, double>>{{0.1, 0.94491953748905229},
                                                                             {0.01, 0.99462843764706682},
                                                                             {1e-4, 0.99994642713641},
                                                                             {1e-6, 0.99999946428557079}}) {
    const double ambient = 1e5 * (1.0 - epsilon);
    claim::expect_relative({"G.6", "orifice as p nears p_a: share of Bernoulli's flow [-]",
                            "rounding of p_a, eps p/(p - p_a), times the slope"},
                           bernoulli_ratio(1.4, 1e5, ambient), ratio, 2e-14);
  }
}

/// Down to dp/p = 1e-14 at one atmosphere, and to a difference of 1e-12 Pa where p_a has the digits for it.
TEST(orifice, keeps_its_digits_as_the_pressures_meet) {
  const char* why = "some ten roundings; the next term of the series is epsilon^3";
  for (const double gamma : {1.25, 1.4, 5.0 / 3.0})
    for (const auto& [ambient, least] : {std::pair{101325.0, 1e-9}, {1.0, 1e-12}, {1e-3, 1e-12}})
      for (double difference = least; difference < 1e-5 * ambient; difference *= 7.0) {
        const double pressure = ambient + difference, exact = pressure - ambient, epsilon = exact / pressure;
        const double series = 1.0 - 3.0 * epsilon / (4.0 * gamma) -
                              (40.0 * gamma - 29.0) * epsilon * epsilon / (96.0 * gamma * gamma);
        claim::expect_relative({"G.6", "orifice, p - p_a from 1e-12 Pa: share of Bernoulli's flow [-]", why},
                               bernoulli_ratio(gamma, pressure, ambient), series, 1e-13);
        // The difference of the pressures is exact, a few roundings follow.
        claim::expect_relative({"G.7", "fabric, p - p_a from 1e-12 Pa: mass flow [kg/s]", "four roundings"},
                               gas::fabric_mass_flow(2e-3, 1.2, pressure - ambient),
                               2e-3 * std::sqrt(2.4) * std::sqrt(exact), 4.0 * kEpsilon);
      }
}

/// Negative control: the difference of powers taken literally has lost all its digits here.
TEST(orifice, literal_difference_of_powers_would_fail) {
  const double pressure = 101325.0 * (1.0 + 4.0 * kEpsilon), r = 101325.0 / pressure;
  const double literal = std::pow(r, 2.0 / 1.4) - std::pow(r, 2.4 / 1.4);
  const double epsilon = (pressure - 101325.0) / pressure;
  EXPECT_GT(relative(2.0 * cp_of(1.4) / kR * literal, 2.0 * epsilon), 1e-2);
  EXPECT_LT(relative(bernoulli_ratio(1.4, pressure, 101325.0), 1.0), 1e-13);  // some ten roundings
}

TEST(orifice, both_laws_eq_closed_form) {
  for (const double gamma : {1.1, 1.3, 1.4, 1.66}) {
    for (const double pressure : {9e4, 101325.0, 101326.0, 1.3e5, 1.9e5, 2.2e5, 9e5}) {
      const closed_form::PerfectGas perfect{kR, gamma};
      const double expected = closed_form::orifice_mass_flow({perfect, 4e-3, 0.5, pressure, 450.0, 101325.0});
      claim::expect_relative({"G.6", "orifice by gamma and pressure: mass flow [kg/s]",
                              "exponents up to 1/(gamma - 1) = 10 amplify rounding"},
                             flow(gamma, pressure, 450.0, 101325.0), expected, 1e-13);
      const double porous = closed_form::porous_mass_flow(
          {perfect, 0.05, 1.5, closed_form::PorosityLaw::screen, pressure, 450.0, 101325.0});
      claim::expect_relative({"G.7", "porous fabric, screen law, by pressure: mass flow [kg/s]",
                              "some ten roundings in each route"},
                             gas::fabric_mass_flow(0.075, pressure / (kR * 450.0), pressure - 101325.0),
                             porous, 1e-14);
    }
  }
}

struct Figure3Row {
  double difference, hole, fabric;  // [Pa], [kg/s], [kg/s] over eta^2
};

/// Fig. 3 of "Gas Jet Model for Airbag Inflators": N2 at 673 K, 8.5 dm2, against the pressure difference.
TEST(orifice, figure_3_eq_table) {
  const std::vector<Figure3Row> table{
      {1e3, 2.7064475900556699, 2.7207292132678412},   {5e3, 6.0432613251210413, 6.2015056112125386},
      {1e4, 8.5313799909347156, 8.9740977350059896},   {2e4, 12.022758660056885, 13.249045481748222},
      {3e4, 14.673452951131251, 16.882189670181414},   {5e4, 18.814024071255214, 23.395632272130098},
      {7.5e4, 22.853222752441372, 30.930149637215532}, {9e4, 24.915511113589478, 35.294055058449866},
      {9.5e4, 25.566738598735878, 36.7319554434049},   {1e5, 26.217871633212788, 38.163069391616205}};
  for (const auto& [difference, hole, fabric] : table) {
    const double pressure = 101325.0 + difference, density = pressure / (kR * 673.0);
    const char* why = "some twenty roundings in each route; p - p_a loses two digits";
    claim::expect_relative({"G.6", "the paper's Figure 3, hole, ten pressures: mass flow [kg/s]", why},
                           gas::orifice_mass_flow(0.085, pressure, 673.0, kR, 1038.8, 1.4, 101325.0), hole,
                           1e-13);
    claim::expect_relative(
        {"G.7", "the paper's Figure 3, fabric, ten pressures: mass flow over eta^2 [kg/s]", why},
        gas::fabric_mass_flow(0.085, density, pressure - 101325.0), fabric, 1e-13);
    EXPECT_LT(relative(gas::fabric_mass_flow(0.0025 * 0.085, density, pressure - 101325.0), 0.0025 * fabric),
              1e-13);
  }
}

}  // namespace
