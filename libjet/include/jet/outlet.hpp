// SPDX-License-Identifier: Apache-2.0
// State of the gas in an inflator's outlet (stage S3): one uniform velocity and density.
#pragma once

#include <stdexcept>

namespace jet {

/// A quantity left its domain while a run was under way; what() names it, its value and what is allowed.
class DomainError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// `sonic`: always sonic, so the outlet pressure follows the mass flow (the paper's form).
/// `pressure_matched`: sonic while the outlet pressure that results is at least the bag's, else subsonic at
/// bag pressure.
enum class OutletLaw { sonic, pressure_matched };

/// Meaning of the inflator's temperature: that of the moving gas in the outlet (the paper's form), or of the
/// chamber.
enum class OutletTemperature { static_value, stagnation };

/// Constant part of an outlet.
struct OutletModel {
  OutletLaw law = OutletLaw::sonic;                                 // sets the outlet pressure
  OutletTemperature temperature = OutletTemperature::static_value;  // what OutletInput::temperature means
  double area = 0.0;                                                // [m2] > 0, see outlet_area(JetModel)
};

/// What the outlet is fed with at one instant.
struct OutletInput {
  double mass_flow = 0.0;     // [kg/s] >= 0
  double temperature = 0.0;   // [K] > 0, static or stagnation according to OutletModel
  double cp = 0.0;            // [J/(kg K)] of the inflator's gas, > gas_constant
  double gas_constant = 0.0;  // [J/(kg K)] specific, > 0
  double bag_pressure = 0.0;  // [Pa] absolute, > 0; read by `pressure_matched` alone
};

/// Uniform gas state in the outlet.
struct OutletState {
  double velocity = 0.0;     // [m/s] V0
  double density = 0.0;      // [kg/m3] rho0; 0 without flow (`sonic`)
  double pressure = 0.0;     // [Pa] static, implied by rho0 R T
  double temperature = 0.0;  // [K] static
};

/// Throws std::invalid_argument unless the area is finite and > 0 and `pressure_matched` comes with a
/// stagnation temperature (with a static one the energy that sets the subsonic velocity is not known).
void validate(const OutletModel& model);

/// Outlet velocity and density, (J.1) and (J.2):
///   static temperature T_s:  V0 = sqrt((gamma - 1) cp T_s), the paper's; T = T_s
///   stagnation temperature:  V0 = sqrt(2 gamma R T_s / (gamma + 1)), T = 2 T_s / (gamma + 1)
///   rho0 = mass_flow / (area V0), p = rho0 R T
/// `pressure_matched`, where that p would be below the bag's: p = bag pressure and V0 the positive root of
///   mass_flow V^2 / (2 cp) + (area p / R) V - mass_flow T_s = 0   (continuity with T = T_s - V^2 / (2 cp)).
/// Precondition: validate(model) passed. Throws DomainError for input outside the ranges of OutletInput.
/// Source: Lupker and Bruijs, Gas Jet Model for Airbag Inflators; one-dimensional adiabatic flow of an ideal
/// gas.
OutletState outlet_state(const OutletModel& model, const OutletInput& input);

/// Axial momentum flux rho0 V0^2 A [N] that leaves the outlet, equal to mass_flow V0.
double momentum_flux(const OutletState& state, double area);

}  // namespace jet
