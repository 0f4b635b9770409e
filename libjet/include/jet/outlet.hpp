// SPDX-License-Identifier: Apache-2.0
// State of the gas in the outlet of an inflator (stage S5): one uniform velocity and density.
#pragma once

#include <stdexcept>

namespace jet {

/// A quantity left its domain during a run. what() gives its name, its value and its range.
class DomainError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Law of the outlet pressure. `sonic` (the paper's form): the flow is always sonic, and the mass flow sets
/// the outlet pressure. `pressure_matched`: the flow is sonic while that outlet pressure is at least the
/// bag's, else subsonic at bag pressure.
enum class OutletLaw { sonic, pressure_matched };

/// Meaning of the inflator's temperature: of the moving gas in the outlet (the paper's form), or in the
/// chamber.
enum class OutletTemperature { static_value, stagnation };

/// Constant data of an outlet.
struct OutletModel {
  OutletLaw law = OutletLaw::sonic;                                 // sets the outlet pressure
  OutletTemperature temperature = OutletTemperature::static_value;  // meaning of OutletInput::temperature
  double area = 0.0;                                                // [m2] > 0, see outlet_area(JetModel)
};

/// Inflow to the outlet at one instant.
struct OutletInput {
  double mass_flow = 0.0;     // [kg/s] >= 0
  double temperature = 0.0;   // [K] > 0, static or stagnation by OutletModel
  double cp = 0.0;            // [J/(kg K)] of the inflator's gas, > gas_constant
  double gas_constant = 0.0;  // [J/(kg K)] specific, > 0
  double bag_pressure = 0.0;  // [Pa] absolute, > 0; used by `pressure_matched` only
};

/// Uniform gas state in the outlet.
struct OutletState {
  double velocity = 0.0;     // [m/s] V0 >= 0
  double density = 0.0;      // [kg/m3] rho0 >= 0; 0 if there is no flow and the law is `sonic`
  double pressure = 0.0;     // [Pa] static, rho0 R T
  double temperature = 0.0;  // [K] static
};

/// Throws std::invalid_argument unless the area is finite and > 0, and `pressure_matched` has a stagnation
/// temperature. (The subsonic velocity follows from the total energy, which a static temperature does not
/// give.)
void validate(const OutletModel& model);

/// Outlet velocity and density, (J.1) and (J.2):
///   static temperature T_s:  V0 = sqrt((gamma - 1) cp T_s), the paper's; T = T_s
///   stagnation temperature:  V0 = sqrt(2 gamma R T_s / (gamma + 1)), T = 2 T_s / (gamma + 1)
///   rho0 = mass_flow / (area V0), p = rho0 R T
/// If `pressure_matched` and that p is below the bag's, p is the bag pressure and V0 is the positive root of
///   mass_flow V^2 / (2 cp) + (area p / R) V - mass_flow T_s = 0   (continuity with T = T_s - V^2 / (2 cp)).
/// Precondition: validate(model) passed. Throws DomainError for input outside the ranges of OutletInput.
/// Source: Lupker and Bruijs, Gas Jet Model for Airbag Inflators; one-dimensional adiabatic flow of an ideal
/// gas.
OutletState outlet_state(const OutletModel& model, const OutletInput& input);

/// Axial momentum flux through the outlet [N], rho0 V0^2 A = mass_flow V0. `area` [m2].
double momentum_flux(const OutletState& state, double area);

}  // namespace jet
