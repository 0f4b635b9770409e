// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "tank.hpp"

/// The second route: a tank integrated without any code of libgas, from the formulas of docs/theory/gas.md
/// and the numbers of libgas/data/nasa7.csv.
namespace random_tanks {

struct Options {
  double tolerance = 1e-12;   // of each step
  double perturbation = 0.0;  // of the start, see PlainRates::start
  double until = kInfinity;   // [s] ends there, if before the end of the calls
};

/// The gas at one moment.
struct Sample {
  double time = 0.0;                                     // [s]
  double pressure = 0.0, temperature = 0.0, mass = 0.0;  // [Pa], [K], [kg]
  double overpressure = 0.0;                             // [Pa]
  std::vector<double> masses;                            // [kg]
};

struct Outcome {
  std::vector<Sample> samples;                // at the start, at the end of each call, and at `until`
  double coldest = kInfinity, hottest = 0.0;  // [K] of all steps' ends
  int steps = 0;
  int switchings = 0;   // of pressure sensors
  std::string failure;  // empty: it came to its end
};

/// Ranges of temperature [K] of the gases of a tank.
struct Range {
  double minimum = 0.0, maximum = 0.0;
};
Range range_of(const Tank& tank, const std::string& csv);

Outcome plain_route(const Tank& tank, const std::string& csv, const Options& options);

}  // namespace random_tanks
