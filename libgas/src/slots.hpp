// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <vector>

namespace gas {

using Vector = std::vector<double>;

/// Where each unknown of a sub-step stands in the ODE vector y. All count from its begin, where they are zero:
///   out(k)              [kg] species k that left through all openings
///   work()              [J]  int p dV (0 where the volume follows the pressure: its work is no unknown)
///   heat()              [J]  lost through the walls
///   mass(j), enthalpy(j) [kg], [J] that left through vent j, the last of them the fabric
///   back(j)             [kg] ambient gas that came in through vent j; only if a vent has backflow
struct Slots {
  std::size_t species, vents, backflows;

  std::size_t out(std::size_t k) const { return k; }
  std::size_t work() const { return species; }
  std::size_t heat() const { return species + 1; }
  std::size_t mass(std::size_t j) const { return species + 2 + 2 * j; }
  std::size_t enthalpy(std::size_t j) const { return mass(j) + 1; }
  std::size_t streams() const { return vents + 1; }
  std::size_t fabric() const { return vents; }
  std::size_t back(std::size_t j) const { return mass(streams()) + j; }
  std::size_t size() const { return back(backflows); }
};

}  // namespace gas
