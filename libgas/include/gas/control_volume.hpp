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

/// The gas outside the volume. Vents and fabric discharge into it.
struct Ambient {
  double pressure;                       // [Pa] >= 0
  double temperature;                    // [K] > 0
  std::vector<double> mass_fractions{};  // [-] of the gas outside; used only by vents with backflow
};

/// Inflow of one inflator, given as curves. The mass flow is zero before firing; outside its knots it follows
/// the curve's Outside.
struct Inflow {
  std::vector<double> mass_fractions;  // [-] one per species of the Thermo, sum 1
  Curve mass_flow;                     // [kg/s] >= 0, against the time since firing [s]; may jump
  Curve temperature;        // [K], against the time since firing [s]; may jump; held outside its knots
  double start_time = 0.0;  // [s] firing time, or delay after the trigger; infinity: it never fires
  /// Trigger node. The inflow fires start_time after this node first comes on. None: it fires at start_time.
  std::optional<std::size_t> trigger{};
};

/// A hole. Its area is constant or follows one of two curves. A curve is held outside its knots.
struct Vent {
  double discharge_coefficient;                 // [-] 0 to 1
  double area;                                  // [m2] >= 0; not used if a curve is given
  std::optional<Curve> area_of_time{};          // [m2] against time since opening [s]; may jump
  std::optional<Curve> area_of_overpressure{};  // [m2] against p - p_a [Pa], without a jump
  /// True: ambient gas flows in at p < p_a, by (G.6) with inside and outside exchanged.
  bool backflow = false;
  /// Trigger node. The vent is open while this node is on. None: it is always open.
  std::optional<std::size_t> trigger{};
};

/// Porous fabric. It leaks in parallel to the vents. Its area is a share of the leak area passed to a call.
struct Fabric {
  double share;  // [-] 0 to 1
  /// [m/s] >= 0, against p - p_a [Pa]; 0 at 0, without a jump. If given, the fabric leaks area rho v(p - p_a)
  /// (G.12) instead of (G.7).
  std::optional<Curve> velocity{};
};

/// Heat flow through the walls (G.11). The default is none.
struct HeatLoss {
  double conductance = 0.0;            // [W/K] >= 0, h A
  double outside_temperature = 300.0;  // [K] > 0
};

/// Constant data of a control volume. validate() checks it; so does the constructor of GasIntegrator.
struct ControlVolumeModel {
  Thermo thermo;                  // species of the gas; all mass fractions are in their order
  Ambient ambient;                // constant over a run
  std::vector<Inflow> inflows{};  // any number
  std::vector<Vent> vents{};      // any number
  HeatLoss heat_loss{};           // adiabatic by default
  /// Fabrics, whose shares sum to 1. They leak if the leak area passed to a call is above 0. None given: one
  /// fabric that leaks by (G.7).
  std::vector<Fabric> fabrics{};
  /// [m3] > 0 against p - p_a [Pa], not falling, without a jump. If given, the volume follows the pressure
  /// (G.18) and the volumes passed to calls are not read. It needs two knots; the first is at -p_a or above.
  /// Below the first knot the volume is held; above the last one it ends the computation with DomainError.
  std::optional<Curve> volume_of_overpressure{};
  TriggerModel triggers{};  // inflows and vents name its nodes
  /// [-] 0 to 1e-3, share of p_a. At overpressures below this share, holes and fabric leak less than by (G.6)
  /// and (G.7), by the factor (G.22), because real openings are laminar there. 0 switches the factor off; the
  /// slope of the laws is then unbounded at p_a.
  double laminar_share = 1e-8;
  /// Number of fabrics; 1 if none is given.
  std::size_t fabric_count() const { return fabrics.empty() ? 1 : fabrics.size(); }
};

/// State that the integrator advances. Make one by make_state.
struct ControlVolumeState {
  std::vector<double> masses;  // [kg] one per species
  double internal_energy;      // [J]
  double temperature;          // [K] of (masses, internal_energy); only the first guess of the root find
  TriggerState triggers{};     // one per node of the model's triggers
};

/// The gas at one moment. Without gas (an evacuated volume) density, mass and gas properties are zero, and so
/// are pressure and outflow. `temperature` is then the state's.
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

/// The gas that an inflator delivers at one moment. A jet is computed from it.
struct InflatorPoint {
  double mass_flow;     // [kg/s]
  double temperature;   // [K]
  double cp;            // [J/(kg K)] at `temperature`
  double gamma;         // [-]
  double gas_constant;  // [J/(kg K)]
};

/// Checks a model. Throws std::invalid_argument, naming field, value and what is allowed, unless
/// - every field is in its range,
/// - every inflow has one mass fraction per species, with sum 1; so has the ambient, if a vent has backflow,
/// - the shares of the fabrics sum to 1 (both sums to 1e-9),
/// - inflows, and ambient gas that can flow in, have temperatures in the range of the Thermo,
/// - every trigger named is a node.
void validate(const ControlVolumeModel& model);

/// State of gas at p [Pa] >= 0, T [K] and V [m3] > 0, with one mass fraction [-] per species. p = 0 means
/// evacuated. Throws std::invalid_argument for a value out of range.
ControlVolumeState make_state(const Thermo& thermo, std::span<const double> mass_fractions, double pressure,
                              double temperature, double volume);

/// The same for a model with triggers, all of them off. Throws std::invalid_argument for a value out of
/// range.
ControlVolumeState make_state(const ControlVolumeModel& model, std::span<const double> mass_fractions,
                              double pressure, double temperature, double volume);

/// Firing time [s] of an inflow; infinity while its trigger has not come on.
double firing_time(const Inflow& inflow, const TriggerState& triggers);

/// Stage S2: the gas of `state` in `volume` [m3] at time `time` [s]. `leak_area` [m2] >= 0 is the total of
/// all fabrics (see fabric_mass_flow). The flows are those that the integrator uses, (G.22) included. Does
/// not allocate. Throws std::invalid_argument for a state without the triggers of the model. Throws
/// DomainError
/// - if the volume is not positive, or the leak area is negative or not finite,
/// - if the temperature leaves its range, or p exceeds the last knot of volume_of_overpressure.
GasPoint evaluate(const ControlVolumeModel& model, const ControlVolumeState& state, double volume,
                  double leak_area, double time);

/// Stage S5: the gas of inflow `i` at time `time` [s]. Throws std::out_of_range if there is no inflow `i`,
/// and std::invalid_argument for a state without the triggers of the model.
InflatorPoint inflator_point(const ControlVolumeModel& model, const ControlVolumeState& state, std::size_t i,
                             double time);
/// The same without a state: a trigger, if any, comes on at time 0. Where a curve jumps, `side` selects the
/// value.
InflatorPoint inflator_point(const ControlVolumeModel& model, std::size_t i, double time,
                             Side side = Side::after);
/// The same at a time `since` its firing [s]; before it, nothing flows.
InflatorPoint inflator_point_since_firing(const ControlVolumeModel& model, std::size_t i, double since,
                                          Side side = Side::after);

}  // namespace gas
