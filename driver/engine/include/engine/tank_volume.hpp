// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "gas/curve.hpp"
#include "gas/integrator.hpp"

namespace driver {

/// Volume of a tank that moves as prescribed: a table, or mean + amplitude sin(2 pi frequency t + phase).
struct TankVolume {
  std::optional<gas::Curve> table;                                   // [m3]
  double mean = 0.0, amplitude = 0.0, frequency = 0.0, phase = 0.0;  // [m3], [m3], [1/s], [rad]
  /// Volume [m3] at `time` [s].
  double at(double time) const;
  /// End [s] of the piece that begins at `time` [s]: the next knot of the table, or 1/512 of a period later.
  double piece_end(double time) const;
  /// Volume over the piece [begin, end] [s], with `leak_area` [m2]. A table gives a line. A sine gives the
  /// parabola through its middle, which is off the sine by at most amplitude * 1.5e-8 and exact at both ends.
  gas::VolumePath piece(double begin, double end, double leak_area) const;
};

}  // namespace driver
