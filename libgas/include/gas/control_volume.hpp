// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "gas/curve.hpp"
#include "gas/thermo.hpp"
#include "gas/trigger.hpp"

/// One volume of gas at uniform pressure and temperature, with inflows and outflows:
///   p V = sum(m_k R_k) T,  U = sum m_k u_k(T)                                                        (G.8)
///   dm_k/dt = sum_i Y_ik mdot_i + Y_ak mdot_back - Y_k (mdot_vent + mdot_fabric)                     (G.9)
///   dU/dt = sum_i mdot_i h_i(T_i) + mdot_back h_a(T_a) - (mdot_vent + mdot_fabric) h(T) - p dV/dt - Q (G.10)
///   Q = h A (T - T_ext)                                                                             (G.11)
namespace gas {

/// Air around: what vents and fabric blow into.
struct Ambient {
  double pressure;                       // [Pa] >= 0
  double temperature;                    // [K] > 0
  std::vector<double> mass_fractions{};  // [-] of the gas outside; needed by vents with backflow only
};

/// Gas that flows in, as an inflator's curves. Flow is zero before firing and outside the curve's knots.
struct Inflow {
  std::vector<double> mass_fractions;    // [-] one per species of the Thermo, sum 1
  Curve mass_flow;                       // [kg/s] >= 0, against time since firing [s]; may jump
  Curve temperature;                     // [K], against time since firing [s]; may jump
  double start_time = 0.0;               // [s] firing time, or delay after the trigger; infinity: never
  std::optional<std::size_t> trigger{};  // node whose first coming on fires; none: fires at start_time
};

/// A hole. Its area is a number or, where given, a curve (held outside its knots).
struct Vent {
  double discharge_coefficient;                 // [-] 0 to 1
  double area;                                  // [m2] >= 0; not read where a curve is given
  std::optional<Curve> area_of_time{};          // [m2] against time since opening [s]; may jump
  std::optional<Curve> area_of_overpressure{};  // [m2] against p - p_a [Pa], without a jump
  bool backflow = false;                 // ambient gas flows in at p < p_a, (G.6) with the roles changed
  std::optional<std::size_t> trigger{};  // node while which it is open; none: always open
};

/// Porous fabric, which leaks besides the vents. Its area is a share of the leak area that calls give.
struct Fabric {
  double share;  // [-] 0 to 1
  /// [m/s] >= 0, 0 at 0, against p - p_a [Pa], without a jump: where given, it leaks area rho v(p - p_a)
  /// (G.12) instead of (G.7).
  std::optional<Curve> velocity{};
};

/// Heat through the walls, (G.11); none by default.
struct HeatLoss {
  double conductance = 0.0;            // [W/K] >= 0, h A
  double outside_temperature = 300.0;  // [K] > 0
};

/// Everything constant about a control volume. validate() checks it; GasIntegrator's constructor does so too.
struct ControlVolumeModel {
  Thermo thermo;                // species of the gas; all mass fractions are in their order
  Ambient ambient;              // constant over a run
  std::vector<Inflow> inflows;  // of any number
  std::vector<Vent> vents;      // of any number; fabrics leak besides
  HeatLoss heat_loss{};         // adiabatic by default
  /// Shares of sum 1; they leak where the leak area of calls is above 0. None given: one, by (G.7).
  std::vector<Fabric> fabrics{};
  /// [m3] > 0, not falling, without a jump, against p - p_a [Pa]: where given, the volume follows the
  /// pressure, (G.18), and those of calls are not read. Held below the first knot (at -p_a or above); above
  /// the last: DomainError.
  std::optional<Curve> volume_of_overpressure{};
  TriggerModel triggers{};  // whose nodes inflows and vents name
  /// [-] 0 to 1e-3, share of p_a: at overpressures below it holes and fabric leak less than by (G.6), (G.7),
  /// by the factor (G.22), as real ones are laminar there. 0: the laws as they are, whose slope has no bound
  /// at p_a.
  double laminar_share = 1e-8;
  /// Fabrics, that of none given included.
  std::size_t fabric_count() const { return fabrics.empty() ? 1 : fabrics.size(); }
};

/// What the integrator advances; make one by make_state.
struct ControlVolumeState {
  std::vector<double> masses;  // [kg] one per species
  double internal_energy;      // [J]
  double temperature;          // [K] of (masses, internal_energy); only a first guess for the root find
  TriggerState triggers{};     // one per node of the model's triggers
};

/// The gas at one moment. Without gas (evacuated) all is zero but `temperature`, which is the state's, and
/// `inflow`.
struct GasPoint {
  double pressure;          // [Pa]
  double temperature;       // [K]
  double volume;            // [m3]
  double density;           // [kg/m3]
  double gamma;             // [-] cp/cv
  double cp;                // [J/(kg K)]
  double gas_constant;      // [J/(kg K)]
  double mass;              // [kg]
  double vent_mass_flow;    // [kg/s] out through all vents, (G.6)
  double fabric_mass_flow;  // [kg/s] out through all fabrics, (G.7) or (G.12)
  double inflow;            // [kg/s] in through all inflows
  double backflow;          // [kg/s] in through all vents
  double heat_loss;         // [W] (G.11)
};

/// The gas that an inflator delivers at one moment; what a jet needs to know.
struct InflatorPoint {
  double mass_flow;     // [kg/s]
  double temperature;   // [K]
  double cp;            // [J/(kg K)] at `temperature`
  double gamma;         // [-]
  double gas_constant;  // [J/(kg K)]
};

/// Throws std::invalid_argument, naming field, value and what is allowed, unless every field is in its range,
/// every inflow (and the ambient, if a vent lets it in) has one mass fraction per species with sum 1, the
/// fabrics' shares have that sum (both to 1e-9), temperatures are in the range of the Thermo, and triggers
/// are nodes that exist.
void validate(const ControlVolumeModel& model);

/// State of gas at p [Pa] >= 0, T [K], V [m3] > 0; p = 0 is evacuated. Throws std::invalid_argument.
ControlVolumeState make_state(const Thermo& thermo, std::span<const double> mass_fractions, double pressure,
                              double temperature, double volume);

/// The same, with the triggers of `model` at rest. Throws std::invalid_argument.
ControlVolumeState make_state(const ControlVolumeModel& model, std::span<const double> mass_fractions,
                              double pressure, double temperature, double volume);

/// Firing time [s] of inflow `i`; infinity if it has not been triggered.
double firing_time(const Inflow& inflow, const TriggerState& triggers);

/// Stage S2: the gas of `state` in `volume` [m3] at time `time` [s], with the fabrics' leak area [m2] (see
/// fabric_mass_flow). Flows are those of the integrator's equations, (G.22) included. Does not allocate.
/// Throws DomainError if the volume is not positive or p and temperature leave their ranges.
GasPoint evaluate(const ControlVolumeModel& model, const ControlVolumeState& state, double volume,
                  double leak_area, double time);

/// Stage S3: inflow `i` at time `time` [s].
InflatorPoint inflator_point(const ControlVolumeModel& model, const ControlVolumeState& state, std::size_t i,
                             double time);
/// The same without a state: of an inflator whose trigger comes on at 0. Where its curves jump, on that side.
InflatorPoint inflator_point(const ControlVolumeModel& model, std::size_t i, double time,
                             Side side = Side::after);

}  // namespace gas
