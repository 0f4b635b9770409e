// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

/// Tanks as plain numbers, for two routes that share no code: libgas, and the equations of docs/theory/gas.md
/// written and integrated anew (plain_route.hpp).
namespace random_tanks {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Piecewise linear through (x, y), held outside; empty: not given.
struct Table {
  std::vector<double> x;  // strictly rising
  std::vector<double> y;  // one each
  bool empty() const { return x.empty(); }
  double at(double position) const;
};

struct Gas {
  std::string name;           // of a row of nasa7.csv, or of the tank's own
  double gas_constant = 0.0;  // [J/(kg K)] of a gas of constant cp
  double cp = 0.0;            // [J/(kg K)]; 0: the row of nasa7.csv
};

using Node = std::optional<std::size_t>;  // number of a sensor, or of a gate after all sensors

/// An inflow: nothing outside the knots of mass_flow.
struct Pulse {
  std::vector<double> fractions;  // [-]
  Table mass_flow;                // [kg/s] of the time since firing [s]
  Table temperature;              // [K] of the time since firing [s]
  double start = 0.0;             // [s] firing time, or delay after the node's first coming on
  Node node{};
};

struct Hole {
  double discharge_coefficient = 1.0;
  double area = 0.0;             // [m2], unless a table gives it
  Table area_of_time{};          // [m2] of the time since opening [s]
  Table area_of_overpressure{};  // [m2] of p - p_a [Pa]
  bool backflow = false;
  Node node{};  // open while it is on
};

enum class Watch { time, signal, pressure };

struct SensorPlan {
  Watch kind = Watch::time;
  double threshold = 0.0;
  std::optional<double> reset{};  // [Pa] of pressure
  Table signal{};                 // of signal, against time
};

enum class Join { all, any, negated };

struct GatePlan {
  Join logic = Join::all;
  std::vector<std::size_t> inputs;
  double delay = 0.0;  // [s]
  bool latch = false;
};

/// One tank and its run: calls from times[i] to times[i + 1].
struct Tank {
  std::uint64_t seed = 0;
  double tolerance = 1e-10;
  std::vector<Gas> gases;
  std::vector<double> start;                 // [-] mass fractions at the start
  double pressure = 0.0, temperature = 0.0;  // [Pa], [K] at the start
  double ambient_pressure = 0.0, ambient_temperature = 0.0;
  std::vector<double> ambient;  // [-] mass fractions outside
  std::vector<Pulse> pulses;
  std::vector<Hole> holes;
  double conductance = 0.0, outside_temperature = 300.0;  // [W/K], [K]
  Table fabric_velocity{};                                // [m/s] of p - p_a
  Table volume_of_overpressure{};                         // [m3] of p - p_a
  std::vector<SensorPlan> sensors;
  std::vector<GatePlan> gates;
  std::vector<double> times, volumes, leak_areas;  // [s], [m3], [m2] at the ends of the calls
  std::vector<double> bulges;                      // [m3] one per call, see gas::VolumePath
};

/// The tank of a seed, the same on every platform.
Tank random_tank(std::uint64_t seed);
/// All of its numbers, with 17 digits.
std::ostream& operator<<(std::ostream& out, const Tank& tank);

}  // namespace random_tanks
