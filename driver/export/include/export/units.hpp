// SPDX-License-Identifier: Apache-2.0
// Unit systems of a deck.
#pragma once

#include <string>
#include <string_view>

namespace driver {

/// Consistent units of mass, length and time, in SI units. Temperatures stay in K, amounts in mol.
struct Units {
  std::string name;                                 // as on the command line
  double mass, length, time;                        // [kg], [m], [s]
  const char *mass_code, *length_code, *time_code;  // names in /BEGIN

  double area() const { return length * length; }
  double volume() const { return length * length * length; }
  double density() const { return mass / volume(); }
  double velocity() const { return length / time; }
  double acceleration() const { return velocity() / time; }
  double force() const { return mass * acceleration(); }
  double pressure() const { return force() / area(); }
  double stiffness() const { return force() / length; }
  double mass_flow() const { return mass / time; }
  double specific_energy() const { return velocity() * velocity(); }
  double energy() const { return mass * specific_energy(); }
  double inertia() const { return mass * area(); }
};

/// The system called `name`: kg-m-s, t-mm-s or kg-mm-ms. Throws CaseError for another name.
Units units_named(std::string_view name);

}  // namespace driver
