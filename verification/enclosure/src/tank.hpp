// SPDX-License-Identifier: Apache-2.0
// A scene, ready for enclosing: gas constants, functions of time, and where the law changes.
#pragma once

#include "enclosure/scene.hpp"
#include "time_function.hpp"

namespace enclosure {

inline constexpr double joint_temperature = 1000.0;  // [K]

/// Where the right-hand side changes its formula: p - p_a = offset; p r* = p_a (G.5); T = 1000 K; or u =
/// u(1000 K) of the lower range. The upper range holds above both of the last two: of two temperatures the
/// lower is taken.
struct Surface {
  enum class Kind { level, sonic, joint, joint_energy } kind;
  Ball offset{};         // [Pa] level
  bool watched = false;  // by a sensor that would switch
};

/// Side of each surface: true above.
using Regime = std::vector<bool>;

/// Mass fractions as shares of their sum: as doubles they may not add up to 1.
Balls shares_of(const std::vector<double>& fractions);

/// The gas outside.
struct AmbientGas {
  Ball gas_constant, gamma, enthalpy;  // [J/(kg K)], [-], [J/kg] at its temperature
};

/// Inflow of one inflator over time.
struct InflowFunctions {
  Piecewise flow, enthalpy;  // [kg/s], [J/kg]
};

/// Constant data of a tank.
struct Tank {
  /// Throws std::invalid_argument for a value out of range, Refusal for what has no enclosure.
  /// `events`: times at which each pressure sensor has switched so far; none: it has not.
  explicit Tank(const Scene& scene, const std::vector<Balls>& events = {});

  std::size_t species() const { return scene.species.size(); }
  /// Powers of T of the enthalpy or the internal energy [J/kg] of a mixture, (G.2) and (G.4); of T = 0 first.
  /// Of gases with two ranges the energies of each species are counted from that of the lower one at 1000 K:
  /// there the error of the mass does not count.
  Balls enthalpy(const std::vector<double>& fractions, bool high) const;
  Balls internal_energy(const std::vector<double>& fractions, bool high) const;
  /// Times at which a function of time changes its formula.
  Balls breaks() const;
  /// Overpressure [Pa] at which a sensor would switch next, and if it is on; none: of none that acts.
  std::optional<double> watched_level(std::size_t sensor) const;
  bool is_on(std::size_t sensor) const { return events[sensor].size() % 2 == 1; }

  Scene scene;
  std::vector<Balls> events;
  Balls gas_constants;  // [J/(kg K)] per species
  bool constant_cp = true, has_backflow = false;
  double minimum_temperature = 0.0, maximum_temperature = 0.0;  // [K]
  std::vector<InflowFunctions> inflows;
  std::vector<Piecewise> areas;    // [m2] per hole
  std::vector<Piecewise> shares;   // [-] per fabric
  std::vector<Piecewise> volumes;  // one; none of a wave
  std::vector<Surface> surfaces;   // levels rise
  AmbientGas ambient;
};

}  // namespace enclosure
