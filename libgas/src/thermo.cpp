// SPDX-License-Identifier: Apache-2.0
#include "gas/thermo.hpp"

#include <algorithm>
#include <cmath>
#include <elementary/exponential.hpp>
#include <limits>
#include <stdexcept>
#include <string>

#include "require.hpp"

namespace gas {
namespace {

Mixture::Sums scaled(const Nasa7& a, double gas_constant) {
  Mixture::Sums sums;
  for (std::size_t j = 0; j < sums.size(); ++j) sums[j] = gas_constant * a[j];
  return sums;
}

void add(double factor, const Mixture::Sums& from, Mixture::Sums& to) {
  for (std::size_t j = 0; j < to.size(); ++j) to[j] += factor * from[j];
}

void require_in_range(double temperature, double minimum, double maximum) {
  if (temperature > 0.0 && temperature >= minimum && temperature <= maximum && std::isfinite(temperature))
    return;
  const double nearest = temperature < minimum ? minimum : maximum;
  throw DomainError("temperature = " + to_text_beside(temperature, nearest) + " K: outside " +
                    to_text(minimum) + " to " + to_text(maximum) + " K");
}

}  // namespace

Thermo::Thermo(std::vector<Species> species) : SpeciesSet(std::move(species)) {
  none_.maximum_temperature = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < size(); ++k) {
    const Species& s = SpeciesSet::species(k);
    gas_constants_.push_back(kMolarGasConstant / s.molar_mass);
    low_.push_back(scaled(s.low, gas_constants_.back()));
    high_.push_back(scaled(s.high, gas_constants_.back()));
    none_.minimum_temperature = std::max(none_.minimum_temperature, s.minimum_temperature);
    none_.maximum_temperature = std::min(none_.maximum_temperature, s.maximum_temperature);
    none_.constant_cp = none_.constant_cp && s.constant_cp;
  }
}

double Thermo::cp(std::size_t k, double temperature) const {
  const Species& s = species(k);
  require_in_range(temperature, s.minimum_temperature, s.maximum_temperature);
  return Mixture{1.0, gas_constants_[k], low_[k], high_[k]}.cp(temperature);
}

double Thermo::enthalpy(std::size_t k, double temperature) const {
  const Species& s = species(k);
  require_in_range(temperature, s.minimum_temperature, s.maximum_temperature);
  return Mixture{1.0, gas_constants_[k], low_[k], high_[k]}.enthalpy(temperature);
}

double Thermo::internal_energy(std::size_t k, double temperature) const {
  return enthalpy(k, temperature) - gas_constants_[k] * temperature;
}

double Thermo::standard_entropy(std::size_t k, double temperature) const {
  const Species& s = species(k);
  require_in_range(temperature, s.minimum_temperature, s.maximum_temperature);
  const Nasa7& a = temperature <= kJointTemperature ? s.low : s.high;
  const double t = temperature;
  return gas_constants_[k] *
         (a[6] + a[0] * elementary::log(t) + t * (a[1] + t * (a[2] / 2 + t * (a[3] / 3 + t * (a[4] / 4)))));
}

void Thermo::mixture(std::span<const double> masses, Mixture& out) const {
  out = none_;
  for (std::size_t k = 0; k < masses.size(); ++k) {
    out.mass += masses[k];
    out.gas_constant_sum += masses[k] * gas_constants_[k];
    add(masses[k], low_[k], out.low);
    if (!none_.constant_cp) add(masses[k], high_[k], out.high);
  }
  if (none_.constant_cp) out.high = out.low;
}

Mixture Thermo::mixture(std::span<const double> masses) const {
  require(masses.size() == size(), "number of masses", static_cast<double>(masses.size()),
          "must be one per species");
  for (const double m : masses)
    require(std::isfinite(m) && m >= 0.0, "mass [kg]", m, "must be finite and not negative");
  Mixture sums;
  mixture(masses, sums);
  return sums;
}

Mixture Thermo::checked(std::span<const double> masses, double temperature) const {
  const Mixture sums = mixture(masses);
  require(sums.mass > 0.0, "mass of the mixture [kg]", sums.mass, "must be positive");
  require_in_range(temperature, sums.minimum_temperature, sums.maximum_temperature);
  return sums;
}

double Thermo::gas_constant(std::span<const double> masses) const {
  const Mixture sums = mixture(masses);
  require(sums.mass > 0.0, "mass of the mixture [kg]", sums.mass, "must be positive");
  return sums.gas_constant_sum / sums.mass;
}

double Thermo::cp(std::span<const double> masses, double temperature) const {
  const Mixture sums = checked(masses, temperature);
  return sums.cp(temperature) / sums.mass;
}

double Thermo::cv(std::span<const double> masses, double temperature) const {
  const Mixture sums = checked(masses, temperature);
  return sums.cv(temperature) / sums.mass;
}

double Thermo::gamma(std::span<const double> masses, double temperature) const {
  const Mixture sums = checked(masses, temperature);
  return sums.cp(temperature) / sums.cv(temperature);
}

double Thermo::enthalpy(std::span<const double> masses, double temperature) const {
  const Mixture sums = checked(masses, temperature);
  return sums.enthalpy(temperature) / sums.mass;
}

double Thermo::internal_energy(std::span<const double> masses, double temperature) const {
  const Mixture sums = checked(masses, temperature);
  return sums.internal_energy(temperature) / sums.mass;
}

double Thermo::speed_of_sound(std::span<const double> masses, double temperature) const {
  const Mixture sums = checked(masses, temperature);
  return std::sqrt(sums.cp(temperature) / sums.cv(temperature) * sums.gas_constant_sum / sums.mass *
                   temperature);
}

double Thermo::entropy(std::span<const double> masses, double temperature, double pressure) const {
  const Mixture sums = checked(masses, temperature);
  require(pressure > 0.0 && std::isfinite(pressure), "pressure [Pa]", pressure,
          "must be positive and finite");
  double sum = 0.0;
  for (std::size_t k = 0; k < size(); ++k) {
    if (masses[k] == 0.0) continue;                       // X ln X -> 0
    const double amount = masses[k] * gas_constants_[k];  // [J/K]
    const double partial_pressure = amount / sums.gas_constant_sum * pressure;
    sum += masses[k] * standard_entropy(k, temperature) -
           amount * elementary::log(partial_pressure / kStandardPressure);
  }
  return sum / sums.mass;
}

double Thermo::temperature_from_internal_energy(std::span<const double> masses, double internal_energy,
                                                double guess) const {
  const Mixture sums = mixture(masses);
  require(sums.mass > 0.0, "mass of the mixture [kg]", sums.mass, "must be positive");
  require(std::isfinite(guess), "guess [K]", guess, "must be finite");
  return sums.temperature(internal_energy, guess);
}

}  // namespace gas
