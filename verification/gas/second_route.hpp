// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "gas/integrator.hpp"

// The gas by another route: (G.9), (G.10) in (m_k, U), with rates from the pointwise functions of libgas,
// stepped by GSL's msbdf. Nothing of GasIntegrator is used: no closed-form inflow, no events.
namespace second_route {

struct VentedTank {
  gas::ControlVolumeModel model;
  gas::ControlVolumeState start;
};

inline constexpr double kVolume = 0.06, kFilled = 0.05, kEnd = 0.1;  // [m3], [s], [s]

/// 60 litres of air of cp(T), filled with N2, CO2, H2O at 1200 K for 50 ms, vented through 1e-3 m2.
VentedTank benchmark_tank(double vent_area = 1e-3);

/// Rates of y = (m_k, U) at time t. Throws gas::DomainError outside the range.
void rates(const VentedTank& tank, double t, std::span<const double> y, std::span<double> dydt);

/// State at kEnd, stepped with the relative tolerance given.
gas::ControlVolumeState msbdf(const VentedTank& tank, double tolerance);

}  // namespace second_route
