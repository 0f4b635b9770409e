// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "gas/integrator.hpp"
#include "inflows.hpp"
#include "slots.hpp"
#include "uniform_gas.hpp"

namespace gas {

/// The time between two break points.
struct Segment {
  double begin = 0.0, length = 0.0;  // [s]
};

/// A VolumePath (G.17) as a function of the share x of the step. Times count from the begin of a segment.
struct StepPath {
  double t0 = 0.0;                       // [s] begin of the step
  double begin = 0.0, per_second = 0.0;  // x where the segment begins; dx/dt [1/s]
  VolumePath path{};
  template <class S>
  S share(const S& t) const {
    return begin + t * per_second;
  }
  double growth() const { return path.volume_end - path.volume_begin; }
  double volume(double t) const {
    const double x = share(t);
    return path.volume_begin + x * (growth() + 4.0 * path.volume_bulge * (1.0 - x));
  }
  double rate(double t) const {
    return (growth() + 4.0 * path.volume_bulge * (1.0 - 2.0 * share(t))) * per_second;
  }
  double acceleration() const { return -8.0 * path.volume_bulge * per_second * per_second; }
  template <class S>
  S leak_area(const S& t) const {
    return path.leak_area_begin + share(t) * (path.leak_area_end - path.leak_area_begin);
  }
  bool moves() const { return growth() != 0.0 || path.volume_bulge != 0.0; }
  bool leaks() const { return path.leak_area_begin > 0.0 || path.leak_area_end > 0.0; }
};

/// The gas outside, which flows in through vents with backflow.
struct AmbientGas {
  explicit AmbientGas(const ControlVolumeModel& model);
  /// The gas upstream of a vent while the gas inside is at `overpressure` [Pa] < 0.
  template <class S>
  Upstream<S> upstream(const S& overpressure) const {
    return {pressure, -overpressure, temperature, gas_constant, gamma};
  }

  Mixture mixture{};  // 1 kg; empty if no vent has backflow
  double pressure, temperature;
  double gas_constant = 287.0, gamma = 1.4, enthalpy = 0.0;  // [J/(kg K)], [-], [J/kg]
};

double laminar_overpressure(const ControlVolumeModel& model);  // [Pa] d of (G.22)
/// Time [s] at which a vent opened. Its area_of_time counts from there.
double opened_at(const Vent& vent, const TriggerState& triggers);
/// Fabric i of the model, the default one included.
const Fabric& fabric_of(const ControlVolumeModel& model, std::size_t i);

/// Value of a curve, as a number or with derivatives.
inline double value_of(const Curve& curve, double x) {
  return curve.value(x);
}
template <std::size_t N>
Dual<N> value_of(const Curve& curve, const Dual<N>& x) {
  return curve.piece(x.value).at(x);
}

/// Mass flow [kg/s] out through fabric i, (G.7) or (G.12); `leak_area` [m2] is the total of all fabrics.
template <class S>
S fabric_flow(const ControlVolumeModel& model, std::size_t i, const S& leak_area, const Upstream<S>& gas) {
  const auto& [share, velocity] = fabric_of(model, i);
  const S area = share * leak_area;
  if (!velocity) return area * fabric_flux(gas, laminar_overpressure(model));
  return area * gas.density() * value_of(*velocity, gas.overpressure);
}

/// Heat flow [W] through the walls (G.11) at a temperature [K] of the gas.
double heat_flow(const ControlVolumeModel& model, double temperature);

/// All flows through the boundary of a volume, over a segment of time without a switch and without a knot of
/// a curve over time. Times within the segment count from its begin.
class Boundary {
 public:
  /// `model` must outlive this object.
  explicit Boundary(const ControlVolumeModel& model);

  void begin_step(double t0, double t1, const VolumePath& path);
  void begin_segment(const TriggerState& triggers, double a, double b);
  /// First time after t at which a segment has to end.
  double next_break(const TriggerState& triggers, double t) const;

  const ControlVolumeModel& model() const { return model_; }
  const Slots& slots() const { return slots_; }
  const AmbientGas& ambient() const { return ambient_; }
  const Inflows& inflows() const { return inflows_; }
  const StepPath& path() const { return path_; }
  const Segment& segment() const { return segment_; }
  bool has_open_vent() const;
  bool is_open() const { return has_open_vent() || path_.leaks(); }  // gas can leave
  bool has_backflow() const;                                         // gas can come in

  /// Mass flows [kg/s] at time t of the segment, as numbers or with derivatives. out(): stream j of Slots,
  /// through a vent (G.6) or a fabric, (G.7) or (G.12). in(): through vent j.
  template <class S>
  S out(std::size_t j, const Upstream<S>& gas, const S& t) const {
    if (j < slots_.vents) return through_vent(j, gas, gas.overpressure, t);
    return path_.leaks() ? fabric_flow(model_, j - slots_.vents, path_.leak_area(t), gas) : S(0.0);
  }
  template <class S>
  S back(std::size_t j, const Upstream<S>& gas, const S& t) const {
    if (!model_.vents[j].backflow) return S(0.0);
    return through_vent(j, ambient_.upstream(gas.overpressure), gas.overpressure, t);
  }
  /// Total flow out; below zero: in.
  template <class S>
  S flow(const Upstream<S>& gas, const S& t) const {
    const bool leaves = gas.overpressure > 0.0;
    S sum(0.0);
    for (std::size_t j = 0; j < (leaves ? slots_.streams() : slots_.backflows); ++j)
      sum = sum + (leaves ? out(j, gas, t) : -back(j, gas, t));
    return sum;
  }

 private:
  bool is_open(std::size_t j) const { return areas_[j].value > 0.0 || areas_[j].slope != 0.0; }
  template <class S>
  S through_vent(std::size_t j, const Upstream<S>& upstream, const S& overpressure, const S& t) const {
    if (!is_open(j)) return S(0.0);
    S area = areas_[j].at(t);
    if (area < 0.0) return S(0.0);
    if (const auto& curve = model_.vents[j].area_of_overpressure)
      area = area * value_of(*curve, overpressure);
    return area * hole_flux(upstream, laminar_overpressure(model_));
  }

  const ControlVolumeModel& model_;
  const AmbientGas ambient_;
  const Slots slots_;
  Inflows inflows_;
  /// [vent] Cd A over time, zero while shut. If the area is a curve over the overpressure: Cd alone.
  std::vector<Curve::Piece> areas_;
  StepPath path_;
  Segment segment_;
};

}  // namespace gas
