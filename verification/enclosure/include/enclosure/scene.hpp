// SPDX-License-Identifier: Apache-2.0
// A tank as plain data. All numbers are taken as exact. SI units.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace enclosure {

/// An ideal gas. Coefficients of cp/R as in (G.1); a6 is that of h, (G.2). A gas of constant cp has only a1.
struct Species {
  std::string name;
  double molar_mass;                 // [kg/mol] > 0
  std::array<double, 6> low{};       // T <= 1000 K
  std::array<double, 6> high{};      // T > 1000 K
  bool constant_cp = true;           // false: two ranges, which meet at 1000 K
  double minimum_temperature = 0.0;  // [K] below it is refused
  double maximum_temperature = std::numeric_limits<double>::infinity();  // [K] above it is refused
};

/// A point of a curve.
struct Knot {
  double at;     // [s], or [Pa] of overpressure
  double value;  // in the unit of the quantity
};

/// Piecewise linear through knots whose `at` does not fall; one knot: constant. Two knots at one time make a
/// jump; curves over the overpressure have none.
using Curve = std::vector<Knot>;

/// A node that is on from time to time, or depends on the pressure.
struct Sensor {
  std::vector<double> switching{};    // [s] at which it comes on, goes off, comes on and so on, rising
  std::optional<double> threshold{};  // [Pa] in place of `switching`: overpressure from which it is on
  std::optional<double> reset{};      // [Pa] < threshold: below it goes off; none: it stays on
};

/// A node that combines earlier ones: on once its condition has held for the delay.
struct Gate {
  enum class Logic { all, any, negated } logic;
  std::vector<std::size_t> inputs;  // sensors, then earlier gates; `negated`: one
  double delay = 0.0;               // [s] >= 0
  bool latch = false;               // counts the delay from when the condition first held, then stays on
};

/// Inflow of one inflator. The mass flow is zero outside its knots unless it is constant; the temperature is
/// held.
struct Inflator {
  std::vector<double> mass_fractions;  // [-] one per species
  Curve mass_flow;                     // [kg/s] against the time since `start`
  Curve temperature;                   // [K] likewise
  double start = 0.0;                  // [s]; with a node after its first coming on
  std::optional<std::size_t> node{};   // sensor, or gate after all sensors
};

/// A hole, (G.6).
struct Hole {
  double discharge_coefficient = 1.0;           // [-]
  Curve area;                                   // [m2] against time; held outside its knots
  std::optional<Curve> area_of_overpressure{};  // [m2] in place of `area`; held outside its knots
  bool backflow = false;                        // ambient gas flows in below ambient pressure
  /// Open while this is on; `area` then counts from each opening. None: open.
  std::optional<std::size_t> node{};
};

/// Porous fabric: (G.7) with its coefficient, or (G.12) with its area and a table of velocities.
struct Fabric {
  double coefficient;               // [m2] sum of eta^2 A (printed), eta A (screen) or area (table)
  std::optional<Curve> velocity{};  // [m/s] against overpressure, 0 at 0; held outside its knots
  Curve share{{0.0, 1.0}};          // [-] of the coefficient against time; held outside its knots
};

/// Volume as a wave, mean + amplitude sin(2 pi frequency t + phase).
struct Wave {
  double mean, amplitude, frequency, phase;  // [m3], [m3], [1/s], [rad]
};

/// A tank.
struct Scene {
  std::vector<Species> species;
  std::vector<double> initial_fractions;  // [-] by mass, one per species
  double initial_pressure = 0.0;          // [Pa]; 0: evacuated
  double initial_temperature = 0.0;       // [K]; not used of an evacuated tank
  double ambient_pressure = 101325.0;     // [Pa]
  double ambient_temperature = 293.15;    // [K]
  std::vector<double> ambient_fractions;  // [-] by mass; only of holes with backflow
  Curve volume;                           // [m3] against time; held outside its knots
  std::vector<double> bulges;             // [m3] none, or of each piece its middle less the mean of its ends
  std::optional<Wave> wave{};             // in place of `volume`
  std::vector<Inflator> inflators;
  std::vector<Hole> holes;
  std::vector<Fabric> fabrics;
  std::vector<Sensor> sensors;
  std::vector<Gate> gates;
  double wall_conductance = 0.0;     // [W/K] h A of (G.11)
  double outside_temperature = 300;  // [K]
  /// [-] d/p_a of (G.22). 0: the literal laws, which have a corner at ambient pressure.
  double laminar_share = 0.0;
};

}  // namespace enclosure
