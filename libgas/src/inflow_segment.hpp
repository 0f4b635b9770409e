// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <initializer_list>

#include "gas/control_volume.hpp"

namespace gas {

/// Time since `start` [s] at time t; -infinity if the start never comes. A result within round-off of zero,
/// or of a knot of `curves`, is set to it: then a pulse keeps its exact length however late it fires.
double local_time(std::initializer_list<const Curve*> curves, double start, double t);
/// The same for an inflow: time since it fired.
double local_time(const Inflow& inflow, double start, double t);

/// First time after t at which the inflow is not smooth: firing, a knot, an inflow temperature of 1000 K.
double next_break(const Inflow& inflow, double start, bool constant_cp, double t);

/// One inflow on an interval [a, b] without a break inside, where mass flow and temperature are linear. Times
/// count from a, so that they keep their digits even where a is late; the first gas of an evacuated volume
/// needs that.
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
  /// `gas` is 1 kg of the inflow's mixture; it must outlive this object.
  InflowSegment(const Inflow& inflow, double start, const Mixture& gas, double a, double b);

  bool is_idle() const { return mass_flow_ == 0.0 && mass_flow_slope_ == 0.0; }
  Flow flow(double t) const {
    return {mass_flow_ + mass_flow_slope_ * t, temperature_ + temperature_slope_ * t};
  }
  /// Mass flow [kg/s] and enthalpy flow [W] at t; then their derivatives by t.
  Delivered rate(double t) const;
  Delivered rate_slope(double t) const;
  /// Mass and enthalpy delivered from t0 to t1, in closed form. For cp(T) and a changing temperature it uses
  /// a Gauss rule, which is exact for the integrand, a polynomial of degree 6 in time.
  Delivered delivered(double t0, double t1) const;
  const Mixture& gas() const { return *gas_; }

 private:
  double enthalpy_by_quadrature(double from, double to) const;

  const Mixture* gas_ = nullptr;
  double mass_flow_ = 0.0, mass_flow_slope_ = 0.0;
  double temperature_ = 0.0, temperature_slope_ = 0.0;
  double enthalpy_ = 0.0;  // [J/kg] at temperature_
};

}  // namespace gas
