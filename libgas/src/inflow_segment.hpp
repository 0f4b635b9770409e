// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "gas/control_volume.hpp"

namespace gas {

/// Time since firing [s] at time t. The subtraction rounds, so a result within round-off of a knot is that
/// knot: a pulse keeps its exact length however late it fires.
double local_time(const Inflow& inflow, double t);

/// First time after t at which the inflow is not smooth: firing, a knot, an inflow temperature of 1000 K.
double next_break(const Inflow& inflow, bool constant_cp, double t);

/// One inflow on an interval [a, b] without a break inside, where mass flow and temperature are linear.
class InflowSegment {
 public:
  struct Flow {
    double mass_flow;    // [kg/s]
    double temperature;  // [K]
  };
  struct Delivered {
    double mass;      // [kg]
    double enthalpy;  // [J]
  };

  InflowSegment() = default;
  /// `gas` is 1 kg of the inflow's mixture.
  InflowSegment(const Inflow& inflow, const Mixture& gas, double a, double b);

  Flow flow(double elapsed) const;
  /// Mass and enthalpy from a to a + elapsed: closed form, or (cp(T) and a changing temperature) a Gauss rule
  /// that is exact for the integrand, a polynomial of degree 6 in time.
  Delivered delivered(double elapsed) const;
  /// The same from a to b; the length of the interval is taken between the knots themselves.
  Delivered total() const { return delivered(duration_); }
  const Mixture& gas() const { return *gas_; }

 private:
  double enthalpy_by_quadrature(double elapsed) const;

  const Mixture* gas_ = nullptr;
  double duration_ = 0.0;
  double mass_flow_ = 0.0, mass_flow_slope_ = 0.0;
  double temperature_ = 0.0, temperature_slope_ = 0.0;
  double enthalpy_ = 0.0;  // [J/kg] at temperature_
};

}  // namespace gas
