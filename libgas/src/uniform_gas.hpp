// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <span>

#include "flux.hpp"
#include "gas/control_volume.hpp"
#include "pressure_volume.hpp"

namespace gas {

/// An amount of gas at uniform pressure and temperature in its volume, (G.8), (G.18). Without gas all members
/// are zero except volume, temperature and overpressure, which is -p_a.
struct UniformGas {
  double mass;         // [kg]
  double temperature;  // [K]
  double pressure;     // [Pa]
  /// [Pa] p - p_a. If the volume follows p, it has more digits than the difference.
  double overpressure;
  double volume;        // [m3]
  double volume_slope;  // [m3/Pa] dV/dp if the volume follows p, else 0
  double gas_constant;  // [J/(kg K)]
  double cp;            // [J/(kg K)]
  double gamma;         // [-]
  double enthalpy;      // [J/kg]
  /// [J/K] Heat capacity: m cv, plus the share of work of a volume that follows p.
  double capacity;
  double work;  // [J] (G.19) if the volume follows p
  bool beyond;  // p is above the curve of such a volume

  /// Compliance 1 + gamma (p/V) dV/dp [-]: the gas needed to raise p, over that needed in a rigid volume.
  double compliance() const {
    return 1.0 + (pressure > 0.0 ? gamma * pressure / volume * volume_slope : 0.0);
  }
  /// Rise of p [Pa] for 1 J more of p V.
  double pressure_per_energy() const { return 1.0 / (volume + pressure * volume_slope); }
  /// The gas as the upstream side of an opening.
  Upstream upstream() const { return {pressure, overpressure, temperature, gas_constant, gamma}; }
};

/// Finds the temperature of a mixture, and all other properties with it.
class GasLocator {
 public:
  /// `model` must outlive this object.
  explicit GasLocator(const ControlVolumeModel& model);

  /// The gas of `mixture` with internal energy `energy` [J] in `volume` [m3]. If the volume follows p,
  /// `volume` is not read and `energy` is U plus the work done so far (G.19). `guess` [K] affects the speed
  /// only. Empty if the temperature is out of range.
  std::optional<UniformGas> locate(const Mixture& mixture, double energy, double volume, double guess) const;
  /// Work (G.19) [J] of the gas of `state`; 0 unless the volume follows p. Throws DomainError outside the
  /// range.
  double stored_work(const ControlVolumeState& state) const;
  /// The same for a mixture at a temperature [K].
  double work_at(const Mixture& mixture, double temperature) const;
  /// Share [-] of a change of p V that is work, for a volume that follows p.
  static double work_share(const UniformGas& gas) {
    return gas.pressure * gas.volume_slope * gas.pressure_per_energy();
  }

 private:
  const ControlVolumeModel& model_;
  std::optional<PressureVolume> volume_by_pressure_;
};

}  // namespace gas
