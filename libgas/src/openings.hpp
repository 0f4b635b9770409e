// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "gas/control_volume.hpp"

namespace gas {

/// Cd A of a vent [m2] at `time` [s] and `overpressure` [Pa]; zero while it is shut.
double effective_area(const Vent& vent, const TriggerState& triggers, double time, double overpressure);

/// Areas of the vents over a segment of time in which none opens, shuts or passes a knot.
class Openings {
 public:
  /// An area and its derivatives.
  struct Area {
    double value;            // [m2] Cd A, not negative
    double by_overpressure;  // [m2/Pa]
    double by_time;          // [m2/s]
  };

  /// `model` must outlive this object.
  explicit Openings(const ControlVolumeModel& model);

  /// First time after t at which an area is not smooth.
  double next_break(const TriggerState& triggers, double t) const;
  /// Sets which vents are open, and their pieces on [a, b].
  void begin_segment(const TriggerState& triggers, double a, double b);

  bool is_open() const { return is_open_; }            // any vent
  bool has_backflow() const { return has_backflow_; }  // any open vent with backflow
  /// Of vent j.
  Area area(std::size_t j, double t, double overpressure) const;
  /// Its value alone.
  double effective_area(std::size_t j, double t, double overpressure) const;

 private:
  const ControlVolumeModel& model_;
  /// Of Cd A over time; for a vent with a curve over the overpressure, Cd only.
  std::vector<Curve::Piece> pieces_;
  std::vector<bool> open_;
  bool is_open_ = false, has_backflow_ = false;
};

/// Overpressures [Pa] at which an area, a fabric's velocity or the volume has a knot, rising.
std::vector<double> overpressure_knots(const ControlVolumeModel& model);

}  // namespace gas
