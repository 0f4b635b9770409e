// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "gas/control_volume.hpp"

namespace gas {

/// Areas of the vents and the velocity through the fabric, as smooth functions on one sub-step: the interval
/// of time fixes the pieces of the curves of time, a band of overpressure those of the curves of
/// overpressure.
class Openings {
 public:
  /// `model` must outlive this.
  explicit Openings(const ControlVolumeModel& model);

  /// Overpressures [Pa] where a curve has a knot, rising.
  std::vector<double> knots() const;
  /// First time after t at which an area is not smooth.
  double next_break(const TriggerState& triggers, double t) const;
  /// Fixes which vents are open and their pieces on [a, b].
  void begin_segment(const TriggerState& triggers, double a, double b);
  /// Fixes the pieces that hold around `overpressure`, which is no knot.
  void enter_band(double overpressure);

  std::size_t vents() const { return vents_.size(); }
  bool is_open() const;  // any vent
  bool any_backflow() const { return any_backflow_; }
  bool has_backflow(std::size_t j) const { return model_.vents[j].backflow; }
  /// Cd A [m2], not negative.
  double effective_area(std::size_t j, double t, double overpressure) const;
  /// Velocity [m/s] through the fabric, not negative, if the model has a table.
  double fabric_velocity(double overpressure) const;

 private:
  struct Opening {
    Curve::Piece piece;  // of Cd A, against time or overpressure
    bool of_overpressure;
    bool open;
  };

  const ControlVolumeModel& model_;
  std::vector<Opening> vents_;
  Curve::Piece fabric_{};
  bool any_backflow_ = false;
};

}  // namespace gas
