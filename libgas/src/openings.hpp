// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "flux.hpp"
#include "gas/control_volume.hpp"

namespace gas {

/// Value of a curve, or with its derivatives.
inline double value_of(const Curve& curve, double x) {
  return curve.value(x);
}
template <std::size_t N>
Dual<N> value_of(const Curve& curve, const Dual<N>& x) {
  return curve.piece(x.value).at(x);
}

/// Cd A of a vent [m2] at `time` [s] and `overpressure` [Pa]; zero while it is shut.
double effective_area(const Vent& vent, const TriggerState& triggers, double time, double overpressure);

/// Areas of the vents over a segment of time in which none opens, shuts or passes a knot.
class Openings {
 public:
  /// `model` must outlive this object.
  explicit Openings(const ControlVolumeModel& model);

  /// First time after t at which an area is not smooth.
  double next_break(const TriggerState& triggers, double t) const;
  /// Sets which vents are open, and their pieces on [a, b].
  void begin_segment(const TriggerState& triggers, double a, double b);

  bool is_open(std::size_t j) const { return open_[j]; }
  bool is_open() const { return is_open_; }            // any vent
  bool has_backflow() const { return has_backflow_; }  // any open vent with backflow
  /// Cd A [m2] of vent j, which is open.
  template <class S>
  S area(std::size_t j, const S& t, const S& overpressure) const {
    if (const auto& curve = model_.vents[j].area_of_overpressure)
      return pieces_[j].value * value_of(*curve, overpressure);
    const S area = pieces_[j].at(t);
    return area < 0.0 ? S(0.0) : area;
  }

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
