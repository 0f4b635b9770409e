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
/// bag's, else subsonic at bag pressure. `expanded`: the same, but a sonic flow then expands to bag pressure,
/// and the jet begins behind that expansion, at the notional nozzle (J.12).
enum class OutletLaw { sonic, pressure_matched, expanded };

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
  double bag_pressure = 0.0;  // [Pa] absolute, > 0; used by all laws but `sonic`
};

/// Uniform gas state in the outlet, or at the notional nozzle of an expanded jet.
struct OutletState {
  double velocity = 0.0;     // [m/s] V >= 0
  double density = 0.0;      // [kg/m3] rho >= 0; 0 if there is no flow and the law is `sonic`
  double pressure = 0.0;     // [Pa] static, rho R T
  double temperature = 0.0;  // [K] static
  double area_ratio = 1.0;   // [-] > 0, area of the notional nozzle over the outlet's
  double reflected = 1.0;    // [-] V0 / V: what a plate turns back (J.6) has the outlet's velocity
};

/// Throws std::invalid_argument unless the area is finite and > 0, and laws other than `sonic` have a
/// stagnation temperature. (Their velocities follow from the total energy, which a static temperature does
/// not give.)
void validate(const OutletModel& model);

/// Outlet velocity and density, (J.1) and (J.2):
///   static temperature T_s:  V0 = sqrt((gamma - 1) cp T_s), the paper's; T = T_s
///   stagnation temperature:  V0 = sqrt(2 gamma R T_s / (gamma + 1)), T = 2 T_s / (gamma + 1)
///   rho0 = mass_flow / (area V0), p = rho0 R T
/// If `pressure_matched` and that p is below the bag's, p is the bag pressure and V0 is the positive root of
///   mass_flow V^2 / (2 cp) + (area p / R) V - mass_flow T_s = 0   (continuity with T = T_s - V^2 / (2 cp)).
/// `expanded` is the same there. Above bag pressure p_b, mass, momentum and stagnation enthalpy are kept:
///   V = V0 + (p - p_b) area / mass_flow, T = T_s - V^2 / (2 cp), rho = p_b / (R T),
///   area ratio = mass_flow / (rho V area)                                                        (J.12)
/// Precondition: validate(model) passed. Throws DomainError for input outside the ranges of OutletInput.
/// Source: Lupker and Bruijs, Gas Jet Model for Airbag Inflators; one-dimensional adiabatic flow of an ideal
/// gas.
OutletState outlet_state(const OutletModel& model, const OutletInput& input);

/// Thrust [N]: axial momentum flux rho V^2 A of the outlet or of the notional nozzle. That is mass_flow V0,
/// and for an expanded jet mass_flow V0 + (p - p_b) A. `area` [m2] of the outlet.
double momentum_flux(const OutletState& state, double area);

}  // namespace jet
