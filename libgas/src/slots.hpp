// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <vector>

namespace gas {

using Vector = std::vector<double>;

/// Place of each unknown of a sub-step in the ODE vector y. All unknowns are zero at the begin of the
/// sub-step:
///   out(k)              [kg] species k that left through all openings
/// work()              [J]  int p dV (0 if the volume follows the pressure)
///   heat()              [J]  lost through the walls
///   mass(j), enthalpy(j) [kg], [J] that left in stream j: the vents, then the fabrics
///   back(j)             [kg] ambient gas that came in through vent j; only if a vent has backflow
struct Slots {
  std::size_t species, vents, fabrics, backflows;

  std::size_t out(std::size_t k) const { return k; }
  std::size_t work() const { return species; }
  std::size_t heat() const { return species + 1; }
  std::size_t mass(std::size_t j) const { return species + 2 + 2 * j; }
  std::size_t enthalpy(std::size_t j) const { return mass(j) + 1; }
  std::size_t streams() const { return vents + fabrics; }
  std::size_t back(std::size_t j) const { return mass(streams()) + j; }
  std::size_t size() const { return back(backflows); }
};

}  // namespace gas
