// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <string>

#include "flux.hpp"
#include "gas/control_volume.hpp"

namespace gas {

/// Pressure and volume of the gas. If the volume follows p (G.18), they lie on a line of the curve V(p -
/// p_a).
struct PressureVolume {
  double pressure;  // [Pa]
  /// [Pa] p - p_a, as accurate as the knots: more accurate than p where the volume grows fast.
  double overpressure;
  double volume;        // [m3]
  double volume_slope;  // [m3/Pa] dV/dp if the volume follows p, else 0
  double work;          // [J] int p dV from the first knot (G.19) if the volume follows p, else 0
  /// True above the last knot, where the curve gives no volume. The volume is then held.
  bool beyond;

  /// Rise of p [Pa] for 1 J more of p V.
  double pressure_per_energy() const { return 1.0 / (volume + pressure * volume_slope); }
  /// Share [-] of a change of p V that is work: p V'/(V + p V').
  double work_share() const { return pressure * volume_slope * pressure_per_energy(); }
  /// The point on the same line, extended beyond its knots, where p V is `product` [J].
  PressureVolume at(double product) const;
};

/// An amount of gas at uniform pressure and temperature in its volume, (G.8), (G.18). Without gas all members
/// are zero except volume, temperature and overpressure, which is -p_a.
struct UniformGas : PressureVolume {
  double mass = 0.0;          // [kg]
  double temperature = 0.0;   // [K]
  double gas_constant = 0.0;  // [J/(kg K)]
  double cp = 0.0;            // [J/(kg K)]
  double gamma = 0.0;         // [-]
  double enthalpy = 0.0;      // [J/kg]
  /// [J/K] heat capacity: m cv, plus the work per kelvin if the volume follows p.
  double capacity = 0.0;

  /// Compliance 1 + gamma (p/V) dV/dp [-]: gas needed to raise p, relative to a rigid volume.
  double compliance() const { return 1.0 + gamma * pressure / volume * volume_slope; }
  /// The gas as the upstream side of an opening.
  Upstream<double> upstream() const { return {pressure, overpressure, temperature, gas_constant, gamma}; }
};

/// Sets `gas` to that of `mixture` with an energy [J] in `volume` [m3]. If the volume follows p, `volume` is
/// not read, and the energy is U plus the work done so far (G.19). The temperature in `gas` is a first guess;
/// it affects the speed only. Returns false and sets nothing if the temperature is out of range.
bool locate(const ControlVolumeModel& model, const Mixture& mixture, double energy, double volume,
            UniformGas& gas);
/// Work (G.19) [J] of the gas of `state`; 0 unless the volume follows p. Throws DomainError outside the
/// range.
double stored_work(const ControlVolumeModel& model, const ControlVolumeState& state);
/// The same for a mixture at a temperature [K].
double work_at(const ControlVolumeModel& model, const Mixture& mixture, double temperature);

/// Message for PressureVolume::beyond, and for a temperature out of range.
std::string beyond_text(const ControlVolumeModel& model);
std::string range_text(const ControlVolumeModel& model);

}  // namespace gas
