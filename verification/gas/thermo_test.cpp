// SPDX-License-Identifier: Apache-2.0
#include "gas/thermo.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>

#include "cases.hpp"
#include "claim.hpp"

namespace {

using namespace cases;

const std::vector<double> kTemperatures{200.0,  250.0,  298.15, 400.0,  673.0,  999.9,
                                        1000.1, 1200.0, 2000.0, 3500.0, 5000.0, 6000.0};

gas::Thermo every_species() {
  return nasa7(gas::species_names());
}

/// Gauss-Legendre with 5 points, exact to degree 9.
template <class Function>
double integrate(Function f, double a, double b) {
  constexpr std::array<double, 3> kNodes{0.0, 0.538469310105683091, 0.906179845938663993};
  constexpr std::array<double, 3> kWeights{0.568888888888888889, 0.478628670499366468, 0.236926885056189088};
  const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
  double sum = kWeights[0] * f(middle);
  for (std::size_t i = 1; i < 3; ++i)
    sum += kWeights[i] * (f(middle - half * kNodes[i]) + f(middle + half * kNodes[i]));
  return half * sum;
}

TEST(thermo, twelve_species_are_built_in) {
  EXPECT_EQ(gas::species_names().size(), 12u);
}

TEST(thermo, cp_eq_dhdT) {
  const gas::Thermo thermo = every_species();
  for (std::size_t k = 0; k < thermo.size(); ++k) {
    for (const double t : kTemperatures) {
      const double a = t <= 1000.0 ? std::max(200.0, t - 20.0) : std::max(1000.05, t - 20.0);
      const double dh = thermo.enthalpy(k, t) - thermo.enthalpy(k, a);
      const double heat = integrate([&](double x) { return thermo.cp(k, x); }, a, t);
      const double scale = std::abs(thermo.enthalpy(k, t)) + thermo.cp(k, t) * t;
      claim::expect_near({"G.2", "integral of cp over 20 K, every species: difference of h [J/kg]",
                          "ten roundings of h, whose terms exceed it up to tenfold; Gauss' rule is exact"},
                         heat, dh, 100.0 * kEpsilon * scale);
    }
  }
}

TEST(thermo, dsdT_eq_cp_over_T) {
  const gas::Thermo thermo = every_species();
  for (std::size_t k = 0; k < thermo.size(); ++k) {
    for (const double t : {300.0, 640.0, 980.0, 1300.0, 2900.0, 5900.0}) {
      const double ds = thermo.standard_entropy(k, t) - thermo.standard_entropy(k, t - 10.0);
      const double sum = integrate([&](double x) { return thermo.cp(k, x) / x; }, t - 10.0, t);
      claim::expect_near({"G.3", "integral of cp/T over 10 K, every species: difference of s [J/(kg K)]",
                          "as for h; Gauss' rule of five points is off by (1/58)^10"},
                         sum, ds, 100.0 * kEpsilon * thermo.standard_entropy(k, t));
    }
  }
}

/// Every species alone, and air.
std::vector<std::vector<double>> compositions(const gas::Thermo& thermo) {
  std::vector<std::vector<double>> all;
  for (std::size_t k = 0; k < thermo.size(); ++k) {
    all.emplace_back(thermo.size(), 0.0);
    all.back()[k] = 1.0;
  }
  all.push_back(thermo.mass_fractions_by_mole(gas::air_by_mole()));
  return all;
}

TEST(thermo, h_minus_u_eq_RT_and_cp_minus_cv_eq_R) {
  const gas::Thermo thermo = every_species();
  for (const std::vector<double>& gas : compositions(thermo))
    for (const double t : kTemperatures) {
      const double r = thermo.gas_constant(gas), h = thermo.enthalpy(gas, t), cp = thermo.cp(gas, t);
      // Differences of two numbers of the size of h and cp: one rounding each, a few more in air's sums.
      EXPECT_NEAR(h - thermo.mixture(gas).internal_energy(t), r * t, 8.0 * kEpsilon * (std::abs(h) + cp * t));
      EXPECT_NEAR(cp - thermo.cv(gas, t), r, 8.0 * kEpsilon * cp);
      EXPECT_NEAR(thermo.gamma(gas, t), cp / (cp - r), 16.0 * kEpsilon);
      EXPECT_LT(relative(thermo.speed_of_sound(gas, t), std::sqrt(cp / (cp - r) * r * t)), 16.0 * kEpsilon);
    }
  for (std::size_t k = 0; k < thermo.size(); ++k)
    for (const double t : kTemperatures)
      EXPECT_NEAR(thermo.enthalpy(k, t) - thermo.internal_energy(k, t), thermo.gas_constant(k) * t,
                  4.0 * kEpsilon * (std::abs(thermo.enthalpy(k, t)) + thermo.gas_constant(k) * t));
}

/// J. D. Cox, D. D. Wagman, V. A. Medvedev, CODATA Key Values for Thermodynamics, 1989: enthalpy of formation
/// [J/mol] and entropy at 1 bar [J/(mol K)], both at 298.15 K.
TEST(thermo, formation_enthalpy_and_entropy_eq_codata) {
  const std::map<std::string, std::array<double, 2>> codata{
      {"N2", {0.0, 191.609}},        {"O2", {0.0, 205.152}},        {"Ar", {0.0, 154.846}},
      {"He", {0.0, 126.153}},        {"H2", {0.0, 130.680}},        {"CO", {-110530.0, 197.660}},
      {"CO2", {-393510.0, 213.785}}, {"H2O", {-241826.0, 188.835}}, {"NH3", {-45940.0, 192.77}}};
  const gas::Thermo thermo = every_species();
  for (const auto& [name, value] : codata) {
    const std::size_t k = thermo.index(name);
    const double molar_mass = thermo.species(k).molar_mass;
    const char* why = "CODATA's own uncertainty, that of NH3 being the largest";
    claim::expect_near({"G.2", "enthalpy of formation of nine species, CODATA [J/mol]", why},
                       thermo.enthalpy(k, 298.15) * molar_mass, value[0], value[0] == 0.0 ? 1.0 : 350.0);
    claim::expect_near({"G.3", "entropy at 1 bar of nine species, CODATA [J/(mol K)]", why},
                       thermo.standard_entropy(k, 298.15) * molar_mass, value[1], 0.05);
  }
}

/// B. J. McBride, M. J. Zehe, S. Gordon, NASA Glenn Coefficients for Calculating Thermodynamic Properties of
/// Individual Species, NASA/TP-2002-211556, 2002: the species that CODATA has not, enthalpies of formation as
/// stated there, entropies by its fits of nine coefficients (file thermo.inp of NASA's CEA program).
TEST(thermo, formation_enthalpy_and_entropy_eq_nasa_glenn) {
  const std::map<std::string, std::array<double, 2>> glenn{
      {"NO", {91271.310, 210.74796}}, {"N2O", {81600.0, 220.00972}}, {"CH4", {-74600.0, 186.37107}}};
  const gas::Thermo thermo = every_species();
  // Ten years older fits to the same evaluations, with R = 8.31451: 6e-6 of H and S; NO's was refined since.
  const char* why = "another fit to the same evaluation; an R 6e-6 larger";
  for (const auto& [name, value] : glenn) {
    const std::size_t k = thermo.index(name);
    const double molar_mass = thermo.species(k).molar_mass;
    claim::expect_near({"G.2", "enthalpy of formation of NO, N2O, CH4, NASA Glenn [J/mol]", why},
                       thermo.enthalpy(k, 298.15) * molar_mass, value[0], 5.0);
    claim::expect_near({"G.3", "entropy at 1 bar of NO, N2O, CH4, NASA Glenn [J/(mol K)]", why},
                       thermo.standard_entropy(k, 298.15) * molar_mass, value[1], 0.005);
  }
}

/// Both ranges of a fit are constrained to meet at 1000 K: a wrong digit in either shows there.
TEST(thermo, ranges_meet_at_1000_K) {
  const gas::Thermo thermo = every_species();
  const double below = 1000.0, above = std::nextafter(1000.0, 2000.0);
  for (std::size_t k = 0; k < thermo.size(); ++k) {
    const double cp = thermo.cp(k, below);
    // Nine digits printed: half a unit of the ninth in five terms up to a few times the sum, which is 1e-8.
    // The largest is 1.4e-8 (cp of NO).
    EXPECT_LT(relative(thermo.cp(k, above), cp), 2e-8) << thermo.species(k).name;
    EXPECT_NEAR(thermo.enthalpy(k, above), thermo.enthalpy(k, below), 2e-8 * cp * below)
        << thermo.species(k).name;
    EXPECT_LT(relative(thermo.standard_entropy(k, above), thermo.standard_entropy(k, below)), 2e-8)
        << thermo.species(k).name;
  }
}

TEST(thermo, air_by_mole_has_its_gas_constant_and_speed_of_sound) {
  const gas::Thermo thermo = nasa7({"CO2", "N2", "O2", "Ar"});
  const std::vector<double> air = thermo.mass_fractions_by_mole(gas::air_by_mole());
  const double molar_mass = (0.7808 * 28.014 + 0.2095 * 31.998 + 0.0093 * 39.95 + 0.0004 * 44.009) / 1000.0;
  // Four products and one quotient; the sum of the mole fractions is 1 to one rounding.
  EXPECT_LT(relative(thermo.gas_constant(air), gas::kMolarGasConstant / molar_mass), 16.0 * kEpsilon);
  claim::expect_relative(
      {"G.1", "speed of sound of dry air at 288.15 K, ISO 2533 [m/s]", "the spread of tables"},
      thermo.speed_of_sound(air, 288.15), 340.294, 1e-3);
}

TEST(thermo, mixture_properties_are_mass_weighted_and_extensive) {
  const gas::Thermo thermo = nasa7({"N2", "H2O", "CO2"});
  const std::vector<double> masses{0.02, 0.005, 0.011};
  for (const double t : kTemperatures) {
    double h = 0.0, cp = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      h += masses[k] * thermo.enthalpy(k, t) / 0.036;
      cp += masses[k] * thermo.cp(k, t) / 0.036;
    }
    // Sums of 3 x 6 terms in another order.
    EXPECT_NEAR(thermo.enthalpy(masses, t), h, 1e3 * kEpsilon * (std::abs(h) + cp * t));
    EXPECT_LT(relative(thermo.cp(masses, t), cp), 100.0 * kEpsilon);
    EXPECT_LT(relative(thermo.mixture(masses).cp(t), 0.036 * cp), 100.0 * kEpsilon);
  }
}

/// At constant p: ds = dh/T, over each step of T by Gauss' rule on cp/T.
TEST(thermo, mixture_entropy_ds_eq_dh_over_T) {
  const gas::Thermo real = nasa7({"N2", "H2O", "CO2"});
  const gas::Thermo constant(
      {gas::constant_cp_species("N2"), gas::constant_cp_species("H2O"), gas::constant_cp_species("CO2")});
  const std::vector<double> masses{0.02, 0.005, 0.011};
  for (const gas::Thermo& thermo : {std::cref(real), std::cref(constant)}) {
    for (const double t : {300.0, 640.0, 980.0, 1300.0, 2900.0, 5900.0}) {
      const double ds = thermo.entropy(masses, t, 2e5) - thermo.entropy(masses, t - 10.0, 2e5);
      const double sum = integrate([&](double x) { return thermo.cp(masses, x) / x; }, t - 10.0, t);
      // The rule's error as in dsdT_eq_cp_over_T; rounding of s, some ten operations on terms of its size.
      EXPECT_NEAR(sum, ds, 100.0 * kEpsilon * thermo.entropy(masses, t, 2e5)) << t;
    }
  }
}

TEST(thermo, entropy_of_mixing_and_of_pressure_eq_closed_form) {
  const gas::Thermo thermo = nasa7({"N2", "He", "CO2"});
  // Equal numbers of molecules of two gases: R ln 2 per mole; the third has none.
  const std::vector<double> equal =
      thermo.mass_fractions_by_mole(std::vector<gas::Component>{{"N2", 0.5}, {"He", 0.5}});
  const double t = 700.0, p = 3e5, r = thermo.gas_constant(equal);
  double apart = 0.0;
  for (std::size_t k = 0; k < 2; ++k) {
    std::vector<double> pure(3, 0.0);
    pure[k] = 1.0;
    apart += equal[k] * thermo.entropy(pure, t, p);
    // One species at 1 bar: (G.3) itself.
    EXPECT_EQ(thermo.entropy(pure, t, gas::kStandardPressure), thermo.standard_entropy(k, t));
  }
  const double s = thermo.entropy(equal, t, p);
  const char* why = "differences of numbers of the size of s, some ten operations each";
  claim::expect_near({"G.15", "entropy of mixing of N2 and He, R ln 2 [J/(kg K)]", why}, s - apart,
                     r * std::log(2.0), 50.0 * kEpsilon * s);
  claim::expect_near({"G.15", "entropy of seven times the pressure, -R ln 7 [J/(kg K)]", why},
                     s - thermo.entropy(equal, t, 7.0 * p), r * std::log(7.0), 50.0 * kEpsilon * s);
  // The amount does not matter.
  std::vector<double> tenfold = equal;
  for (double& m : tenfold) m *= 10.0;
  EXPECT_LT(relative(thermo.entropy(tenfold, t, p), s), 16.0 * kEpsilon);
}

TEST(thermo, entropy_of_bad_states_is_refused) {
  const gas::Thermo thermo = nasa7({"N2", "He"});
  const std::vector<double> half{0.5, 0.5};
  for (const double p : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_THROW(thermo.entropy(half, 300.0, p), std::invalid_argument) << p;
  EXPECT_THROW(thermo.entropy(half, 199.0, 1e5), gas::DomainError);
  EXPECT_THROW(thermo.entropy(std::vector{0.0, 0.0}, 300.0, 1e5), std::invalid_argument);
}

TEST(thermo, constant_cp_gives_h_eq_cpT_without_offset) {
  const gas::Thermo thermo({gas::constant_cp_species("H2O"), gas::constant_cp_species("gas", 296.8, 1038.8)});
  const double cp_water = nasa7({"H2O"}).cp(std::size_t{0}, gas::kReferenceTemperature);
  for (const double t : {1.0, 300.0, 1000.0, 1e5}) {
    // One product.
    EXPECT_LT(relative(thermo.enthalpy(0, t), cp_water * t), 8.0 * kEpsilon);
    EXPECT_LT(relative(thermo.internal_energy(1, t), 742.0 * t), 8.0 * kEpsilon);
  }
}

}  // namespace
