// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace gas {

inline constexpr double kMolarGasConstant = 8.31446261815324;  // [J/(mol K)] CODATA 2018, exact
inline constexpr double kStandardPressure = 1e5;               // [Pa] of the entropies (G.3)
inline constexpr double kReferenceTemperature = 298.15;        // [K] default temperature at which a constant
                                                               // cp is taken
inline constexpr double kJointTemperature = 1000.0;            // [K] where the two NASA-7 ranges meet

/// NASA-7 coefficients a1..a7 of one temperature range:
///   cp/R = a1 + a2 T + a3 T^2 + a4 T^3 + a5 T^4                                      (G.1)
///   h/(R T) = a1 + a2 T/2 + a3 T^2/3 + a4 T^3/4 + a5 T^4/5 + a6/T                    (G.2)
///   s/R = a1 ln T + a2 T + a3 T^2/2 + a4 T^3/3 + a5 T^4/4 + a7   (298.15 K, 1 bar)   (G.3)
using Nasa7 = std::array<double, 7>;

/// An ideal gas. A gas of constant cp has a1 = cp/R and all other coefficients zero, so h = cp T and u = cv T
/// without offset. Its range is every positive temperature.
struct Species {
  std::string name;            // used in compositions
  double molar_mass;           // [kg/mol]
  double minimum_temperature;  // [K]
  double maximum_temperature;  // [K]
  Nasa7 low;                   // T <= 1000 K
  Nasa7 high;                  // T > 1000 K
  bool constant_cp;            // cp does not depend on T
};

/// Names of the built-in species (NASA TM-4513, 1993): N2 O2 Ar He H2 CO CO2 H2O NO N2O NH3 CH4.
std::vector<std::string> species_names();

/// Built-in species with cp(T), 200 to 6000 K. Throws std::invalid_argument for an unknown name.
Species nasa7_species(std::string_view name);

/// User-defined gas with cp(T). Throws std::invalid_argument, naming the value and what is allowed, unless
/// - all numbers are finite and molar_mass [kg/mol] > 0,
/// - 0 < minimum_temperature < 1000 K < maximum_temperature,
/// - cp > R in the whole range,
/// - cp and h of both ranges agree at 1000 K within 1e-5 of cp and cp T, the rounding of seven digits.
Species nasa7_species(std::string_view name, double molar_mass, double minimum_temperature,
                      double maximum_temperature, const Nasa7& low, const Nasa7& high);

/// Built-in species with constant cp, taken from NASA-7 at `temperature` [K], 200 to 6000. Throws
/// std::invalid_argument for another temperature or an unknown name.
Species constant_cp_species(std::string_view name, double temperature = kReferenceTemperature);

/// The same for any species, at a `temperature` [K] in its range.
Species constant_cp_species(const Species& species, double temperature);

/// User-defined gas of constant cp. `gas_constant` [J/(kg K)] > 0 and `cp` [J/(kg K)] > gas_constant, both
/// finite; else throws std::invalid_argument.
Species constant_cp_species(std::string_view name, double gas_constant, double cp);

/// One part of a composition. Whether the fraction is by mole or by mass depends on the function that takes
/// it.
struct Component {
  std::string species;  // name of the species
  double fraction;      // [-]
};

/// Dry air, fractions by mole: 0.7808 N2, 0.2095 O2, 0.0093 Ar, the rest CO2.
std::vector<Component> air_by_mole();

}  // namespace gas
