// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "tank_test/identify.hpp"

namespace gas {

/// The tank's own gas with a mass m [kg] of the inflator's gas; the terms of (G.33).
class TankGas {
 public:
  /// Tank filled with its own gas at `initial_pressure` [Pa], whose walls stay at the initial temperature and
  /// take `conductance` [W/K] times the gas's excess.
  TankGas(const TankTest& test, double initial_pressure, double conductance = 0.0);

  /// The gas at pressure p [Pa] that rises at dp [Pa/s], with m [kg] of the inflator's gas in it.
  struct Rate {
    double power;   // [W] V p' cv/R and the heat lost: left side of (G.33)
    double offset;  // [J/kg] cv T R_i/R - u_i(T)
  };
  /// Throws DomainError, naming `time`, if the gas temperature leaves its range.
  Rate rate(double time, double p, double dp, double m) const;

  /// Heat [W] lost to the walls at p [Pa] with m [kg] of the inflator's gas.
  double heat(double p, double m) const { return conductance_ * (temperature(p, m) - initial_temperature_); }
  /// Rate [Pa/s] at which p would rise without the loss.
  double adiabatic_rate(double p, double dp, double m) const;
  /// Specific enthalpy [J/kg] of the mass m [kg] that raised the tank from its start to p [Pa] while the heat
  /// `lost` [J] left it.
  double mean_enthalpy(double p, double m, double lost) const;
  /// Mass [kg] of that enthalpy [J/kg], at most `most`, that raised the tank to p while the heat `lost` [J]
  /// left it. `guess` is near it.
  double delivered(double p, double enthalpy, double lost, double most, double guess) const;
  /// Temperature [K] of the inflator's gas with that enthalpy [J/kg]. Throws DomainError outside its range.
  double inflow_temperature(double enthalpy) const;

  /// Mass flow [kg/s] of gas at T_s [K] that gives this rate (G.33).
  double mass_flow(const Rate& rate, double temperature) const {
    return rate.power / (inflator_.enthalpy(temperature) + rate.offset);
  }
  /// Mass flow [kg/s] through an outlet of effective area [m2] from a chamber at p_c, T_s into a tank at p_t.
  double outlet_flow(double area, double temperature, double chamber, double tank) const;
  /// T_s [K] at which outlet_flow gives this rate (G.36); a bound of temperatures() if there is none in
  /// between.
  double stagnation_temperature(const Rate& rate, double area, double chamber, double tank,
                                double guess) const;

  /// gamma R [J/(kg K)] of the inflator's gas.
  double gamma_r(double temperature) const;
  struct Range {
    double low, high;  // [K]
  };
  Range temperatures() const { return range_; }

 private:
  double temperature(double p, double m) const {
    return p * volume_ / (own_.gas_constant_sum + m * inflator_.gas_constant_sum);
  }
  double energy(double p, double m) const;

  double volume_, initial_temperature_, conductance_;
  Mixture own_;       // all of it
  Mixture inflator_;  // 1 kg
  Range range_;
  double initial_energy_;  // [J] of the own gas
};

}  // namespace gas
