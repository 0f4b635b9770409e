// SPDX-License-Identifier: Apache-2.0
// Saved states of the 2744-element passenger bag, each made once and the same in every run.
#pragma once
#include <vector>

#include "membrane/bag_model.hpp"
#include "membrane/bag_state.hpp"
#include "mesh/passenger_bag.hpp"

namespace benchmarks {

inline constexpr double kAmbientPressure = 101325.0;  // [Pa]
inline constexpr double kGamma = 1.4;                 // [-] of the gas inside
inline constexpr int kShapes = 3;

// flat: a tenth of the design depth. inflated: the design shape, settled at 5 kPa. crumpled: the design shape
// sucked in at -1 kPa for 7 ms, so that fabric faces away from the outlet and hides other fabric.
enum class Shape { flat, crumpled, inflated };
const char* name_of(Shape shape);

struct PassengerState {
  mesh::PassengerBag bag;
  membrane::BagModel model;
  membrane::BagState state;        // surface and forces belong to its positions
  double gauge_pressure;           // [Pa]
  std::vector<int> null_elements;  // the vent
  std::vector<int> attachment_elements;
};

// The fabric of "Gas Jet Model for Airbag Inflators": 60 MPa, 0.3, 620 kg/m3, 0.5 mm, porosity 0.05;
// attachment fixed, two straps of 620 mm and 4500 N/m.
const PassengerState& passenger_state(Shape shape);

}  // namespace benchmarks
