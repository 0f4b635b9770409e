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
  double leak_area(double t) const { return leak_first + leak_rate * (t - begin); }
  bool moves() const { return mean_rate != 0.0 || curvature != 0.0; }
  bool leaks() const { return leak_first > 0.0 || leak_rate != 0.0; }
};

/// The gas outside, which flows in through vents with backflow.
struct AmbientGas {
  explicit AmbientGas(const ControlVolumeModel& model);
  /// The gas upstream of a vent while the gas inside is at `overpressure` [Pa] < 0.
  Upstream upstream(double overpressure) const {
    return {pressure, -overpressure, temperature, gas_constant, gamma};
  }

  Mixture mixture{};  // 1 kg; empty if no vent has backflow
  double pressure, temperature;
  double gas_constant = 287.0, gamma = 1.4, enthalpy = 0.0;  // [J/(kg K)], [-], [J/kg]
};

/// A mass flow and its partial derivatives.
struct Flow {
  double value;         // [kg/s]
  double pressure;      // by p of the gas inside
  double temperature;   // by its T
  double gas_constant;  // by its R
  double gamma;         // by its gamma
  double time;          // by time, through an area
};

double laminar_overpressure(const ControlVolumeModel& model);  // [Pa] d of (G.22)
/// Fabric i of the model, the default one included.
const Fabric& fabric_of(const ControlVolumeModel& model, std::size_t i);
/// Mass flow [kg/s] out through fabric i, (G.7) or (G.12); `leak_area` [m2] is that of all fabrics.
double fabric_flow(const ControlVolumeModel& model, std::size_t i, double leak_area, const UniformGas& gas);
/// Heat flow [W] through the walls (G.11).
double heat_flow(const ControlVolumeModel& model, const UniformGas& gas);

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

  /// Mass flows [kg/s] at time t. Out in stream j of Slots: through a vent (G.6), or through a fabric, (G.7)
  /// or (G.12). In through vent j.
  double out(std::size_t j, const UniformGas& gas, double t) const;
  double back(std::size_t j, const UniformGas& gas, double t) const;
  /// The same with their derivatives.
  Flow vent_slopes(std::size_t j, const UniformGas& gas, double t) const;
  Flow fabric_slopes(std::size_t i, const UniformGas& gas, double t) const;
  Flow out_slopes(std::size_t j, const UniformGas& gas, double t) const;
  Flow back_slopes(std::size_t j, const UniformGas& gas, double t) const;

 private:
  const ControlVolumeModel& model_;
  const AmbientGas ambient_;
  const Slots slots_;
  const double laminar_;  // [Pa] d of (G.22)
  Inflows inflows_;
  Openings openings_;
  StepPath path_;
};

/// V dp/dt [W] with the openings shut, from inflow, volume and walls.
double closed_growth(const Boundary& boundary, const UniformGas& gas, double t);
/// V dp/dt [W] for 1 kg/s of `mixture` that enters `gas` at `temperature` [K].
double growth_per_flow(const Mixture& mixture, double temperature, const UniformGas& gas);

}  // namespace gas
