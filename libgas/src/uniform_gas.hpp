// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <span>

#include "flux.hpp"
#include "gas/control_volume.hpp"
#include "pressure_volume.hpp"

namespace gas {

/// An amount of gas at uniform pressure and temperature in its volume, (G.8), (G.18). Without gas all is zero
/// but the volume, the temperature and the overpressure, -p_a.
struct UniformGas {
  double mass;          // [kg]
  double temperature;   // [K]
  double pressure;      // [Pa]
  double overpressure;  // [Pa] p - p_a; where the volume follows p, with more digits than the difference
  double volume;        // [m3]
  double volume_slope;  // [m3/Pa] dV/dp where the volume follows p, else 0
  double gas_constant;  // [J/(kg K)]
  double cp;            // [J/(kg K)]
  double gamma;         // [-]
  double enthalpy;      // [J/kg]
  double capacity;      // [J/K] heat capacity: m cv, and the work share of a volume that follows p
  double work;          // [J] (G.19) where the volume follows p
  bool beyond;          // p is above the curve of such a volume

  /// 1 + gamma (p/V) dV/dp: so many times more gas than in a rigid volume raises p as much.
  double compliance() const {
    return 1.0 + (pressure > 0.0 ? gamma * pressure / volume * volume_slope : 0.0);
  }
  /// dp [Pa] of 1 J more of p V.
  double pressure_per_energy() const { return 1.0 / (volume + pressure * volume_slope); }
  /// As what flows out of it.
  Upstream upstream() const { return {pressure, overpressure, temperature, gas_constant, gamma}; }
};

/// Finds the temperature, and with it all else, of a mixture.
class GasLocator {
 public:
  /// `model` must outlive this.
  explicit GasLocator(const ControlVolumeModel& model);

  /// The gas of `mixture` with internal energy `energy` [J] in `volume` [m3]; where the volume follows p,
  /// which is then not read, `energy` is U and the work done so far, (G.19). `guess` [K] sets the speed
  /// alone. Empty if the temperature is out of its range.
  std::optional<UniformGas> locate(const Mixture& mixture, double energy, double volume, double guess) const;
  /// (G.19) [J] of the gas of `state`; 0 unless the volume follows p. Throws DomainError outside the range.
  double stored_work(const ControlVolumeState& state) const;
  /// The same of a mixture at a temperature.
  double work_at(const Mixture& mixture, double temperature) const;
  /// Share [-] of a change of p V that is work of a volume that follows p.
  static double work_share(const UniformGas& gas) {
    return gas.pressure * gas.volume_slope * gas.pressure_per_energy();
  }

 private:
  const ControlVolumeModel& model_;
  std::optional<PressureVolume> volume_by_pressure_;
};

}  // namespace gas
