// SPDX-License-Identifier: Apache-2.0
#include "engine/tank_volume.hpp"

#include <elementary/trigonometric.hpp>
#include <numbers>

namespace driver {

double TankVolume::at(double time) const {
  return table ? table->value(time)
               : mean + amplitude * elementary::sin(2.0 * std::numbers::pi * frequency * time + phase);
}

double TankVolume::piece_end(double time) const {
  constexpr double pieces = 512.0;
  return table ? table->next_knot(time) : time + 1.0 / (pieces * frequency);
}

gas::VolumePath TankVolume::piece(double begin, double end, double leak_area) const {
  const double first = at(begin), last = at(end);
  const double bulge = table ? 0.0 : at(0.5 * (begin + end)) - 0.5 * (first + last);
  return {first, last, leak_area, leak_area, bulge};
}

}  // namespace driver
