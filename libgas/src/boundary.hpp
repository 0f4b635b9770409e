// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "gas/integrator.hpp"
#include "inflows.hpp"
#include "openings.hpp"
#include "slots.hpp"
#include "uniform_gas.hpp"

namespace gas {

/// A VolumePath over its step (G.17).
struct StepPath {
  double begin = 0.0, end = 0.0;                         // [s]
  double first = 0.0, mean_rate = 0.0, curvature = 0.0;  // [m3], [m3/s], [m3/s2]
  double leak_first = 0.0, leak_rate = 0.0;              // [m2], [m2/s]
  double volume(double t) const { return first + (mean_rate + curvature * (end - t)) * (t - begin); }
  double rate(double t) const { return mean_rate + curvature * (begin + end - 2.0 * t); }
  double acceleration() const { return -2.0 * curvature; }
  template <class S>
  S leak_area(const S& t) const {
    return leak_first + leak_rate * (t - begin);
  }
  bool moves() const { return mean_rate != 0.0 || curvature != 0.0; }
  bool leaks() const { return leak_first > 0.0 || leak_rate != 0.0; }
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
/// Fabric i of the model, the default one included.
const Fabric& fabric_of(const ControlVolumeModel& model, std::size_t i);

/// Mass flow [kg/s] out through fabric i, (G.7) or (G.12); `leak_area` [m2] is that of all fabrics.
template <class S>
S fabric_flow(const ControlVolumeModel& model, std::size_t i, const S& leak_area, const Upstream<S>& gas) {
  const auto& [share, velocity] = fabric_of(model, i);
  const S area = share * leak_area;
  if (!velocity) return area * fabric_flux(gas, laminar_overpressure(model));
  return area * gas.density() * value_of(*velocity, gas.overpressure);
}

/// Heat flow [W] through the walls (G.11) at a temperature [K] of the gas.
double heat_flow(const ControlVolumeModel& model, double temperature);

/// All flows through the boundary of a volume, over a segment of time in which nothing switches.
class Boundary {
 public:
  /// `model` must outlive this object.
  explicit Boundary(const ControlVolumeModel& model);

  void begin_step(double t0, double t1, const VolumePath& path);
  void begin_segment(const TriggerState& triggers, double a, double b);
  double next_break(const TriggerState& triggers, double t) const;

  const ControlVolumeModel& model() const { return model_; }
  const Slots& slots() const { return slots_; }
  const AmbientGas& ambient() const { return ambient_; }
  const Inflows& inflows() const { return inflows_; }
  const StepPath& path() const { return path_; }
  bool is_open() const { return openings_.is_open() || path_.leaks(); }  // gas can leave
  bool has_open_vent() const { return openings_.is_open(); }
  bool has_backflow() const { return openings_.has_backflow(); }  // gas can come in

  /// Mass flows [kg/s] at time t, as numbers or with derivatives. Out in stream j of Slots: through a vent
  /// (G.6), or through a fabric, (G.7) or (G.12). In through vent j.
  template <class S>
  S out(std::size_t j, const Upstream<S>& gas, const S& t) const;
  template <class S>
  S back(std::size_t j, const Upstream<S>& gas, const S& t) const;
  /// All that flow out; below zero those that flow in.
  template <class S>
  S flow(const Upstream<S>& gas, const S& t) const;

 private:
  const ControlVolumeModel& model_;
  const AmbientGas ambient_;
  const Slots slots_;
  const double laminar_;  // [Pa] d of (G.22)
  Inflows inflows_;
  Openings openings_;
  StepPath path_;
};

template <class S>
S Boundary::out(std::size_t j, const Upstream<S>& gas, const S& t) const {
  if (j >= slots_.vents)
    return path_.leaks() ? fabric_flow(model_, j - slots_.vents, path_.leak_area(t), gas) : S(0.0);
  if (!openings_.is_open(j)) return S(0.0);
  return openings_.area(j, t, gas.overpressure) * hole_flux(gas, laminar_);
}

template <class S>
S Boundary::back(std::size_t j, const Upstream<S>& gas, const S& t) const {
  if (!model_.vents[j].backflow || !openings_.is_open(j)) return S(0.0);
  return openings_.area(j, t, gas.overpressure) * hole_flux(ambient_.upstream(gas.overpressure), laminar_);
}

template <class S>
S Boundary::flow(const Upstream<S>& gas, const S& t) const {
  const bool leaves = gas.overpressure > 0.0;
  S sum(0.0);
  for (std::size_t j = 0; j < (leaves ? slots_.streams() : slots_.backflows); ++j)
    sum = sum + (leaves ? out(j, gas, t) : -back(j, gas, t));
  return sum;
}

/// V dp/dt [W] with the openings shut, from inflow, volume and walls.
double closed_growth(const Boundary& boundary, const UniformGas& gas, double t);
/// V dp/dt [W] from a flow [kg/s] out through the openings; below zero it is ambient gas that comes in.
double open_growth(const Boundary& boundary, const UniformGas& gas, double flow);

}  // namespace gas
