// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "gas/integrator.hpp"

// The gas by another route: (G.9), (G.10) in (m_k, U), with rates from the pointwise functions of libgas,
// stepped by GSL's msbdf. Nothing of GasIntegrator is used: no events, and inflow is stepped with the rest
// unless asked for in closed form.
namespace second_route {

inline constexpr double kVolume = 0.06, kFilled = 0.05, kEnd = 0.1;  // [m3], [s], [s]

/// A rigid tank.
struct Tank {
  gas::ControlVolumeModel model;
  gas::ControlVolumeState start;
  double volume = kVolume;                   // [m3]
  double leak_area = 0.0;                    // [m2] of fabric, (G.7)
  std::vector<double> stops{kFilled, kEnd};  // [s] rising: inflows jump at no other time; the last is the end
};

/// 60 litres of air of cp(T), filled with N2, CO2, H2O at 1200 K for 50 ms, vented through 1e-3 m2.
Tank benchmark_tank(double vent_area = 1e-3);

/// How what flows in is added.
enum class Inflow {
  stepped,      // as a rate like all others
  closed_form,  // y is what the tank holds less what has come in: only outflow is stepped
};

/// What passes between two stops: at its ends the inflows are those inside.
struct Stretch {
  const Tank& tank;
  double begin, end;  // [s]
  Inflow inflow = Inflow::stepped;
};

/// Adds to y = (m_k, U) what has flowed in from the begin of the stretch to t. Precondition: inflow
/// temperatures are constant.
void add_inflow(const Stretch& stretch, double t, std::span<double> y);

/// Rates of y = (m_k, U) at time t of the stretch. Throws gas::DomainError outside the range.
void rates(const Stretch& stretch, double t, std::span<const double> y, std::span<double> dydt);

/// What the absolute part of a tolerance multiplies, of y: the mass and the thermal energy at the start.
std::vector<double> scales(const Tank& tank);

/// (m_k, U), and the state that they are.
std::vector<double> unknowns(const gas::ControlVolumeState& state);
gas::ControlVolumeState state_of(const Tank& tank, std::span<const double> y);

/// States at all stops, stepped with the relative tolerance given. Throws std::runtime_error if GSL gives up.
std::vector<gas::ControlVolumeState> msbdf(const Tank& tank, double tolerance,
                                           Inflow inflow = Inflow::stepped);

}  // namespace second_route
