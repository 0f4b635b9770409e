// SPDX-License-Identifier: Apache-2.0
// Everything that changes during a run. Each member has one writer: the stage on its line.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "coupling/skin_contact.hpp"
#include "coupling/sphere_contact.hpp"
#include "engine/peaks.hpp"
#include "engine/scene.hpp"
#include "gas/kick_work.hpp"
#include "membrane/stages.hpp"
#include "membrane/time_step.hpp"

namespace driver {

/// Stages of a step: what each reads -> writes. docs/stages.md has the whole table.
enum class Stage {
  surface,     // S1 x^n -> area vectors, centroids, V^n (from S9 of the last step)
  gas_point,   // S2 m_k, U, V -> p, T, rho, gamma
  forces,      // S3 fabric, straps, plates, pressure; the jets' after S7
  contact,     // S4 sphere against skin, skin against itself; then the size of the step
  outlet,      // S5 inflators over the kick -> V0, rho0
  jet_field,   // S6 centroids -> overpressure, candidates
  visibility,  // S7 candidates -> exact mask
  advance,     // S8 central difference
  volume,      // S9 surface at n+1
  gas,         // S10 gas ODE over the step
  ledger,      // S11 balances
  count
};
inline constexpr std::size_t kStages = static_cast<std::size_t>(Stage::count);
std::string_view stage_name(Stage stage);

/// Sums from the start to a time level. S10 writes those of the gas, S8 and S11 the rest.
struct Flows {
  double mass_in = 0.0;            // [kg]
  double vent_mass_out = 0.0;      // [kg]
  double fabric_mass_out = 0.0;    // [kg]
  double enthalpy_in = 0.0;        // [J]
  double enthalpy_out = 0.0;       // [J]
  double backflow_mass = 0.0;      // [kg] of ambient gas, in through vents
  double backflow_enthalpy = 0.0;  // [J]
  double heat_loss = 0.0;          // [J]
  double gas_work = 0.0;           // [J] int p dV
  long gas_substeps = 0;
  long gas_evaluations = 0;
  double damping_loss = 0.0;      // [J]
  double friction_loss = 0.0;     // [J]
  double jet_work = 0.0;          // [J] by external jets
  double pressure_work = 0.0;     // [J] by a prescribed overpressure
  double driving_work = 0.0;      // [J] by what drives impactor or skin from outside
  double impactor_damping = 0.0;  // [J] lost in the dampers of its rail
  double kick_work = 0.0;         // [J] of all forces, kick form
  double contact_impulse = 0.0;   // [N s] integral of the magnitude of the contact force
  /// [N s] Integral of the contact force's part along the impactor's path (K.26).
  double path_impulse = 0.0;
};

/// Skin on which a jet acts: its elements, or their pieces.
struct JetSkin {
  Eigen::Matrix3Xd nodes;         // [m] pieces only; S6
  Eigen::Matrix3Xd area_vectors;  // [m2] pieces only; S6
  Eigen::Matrix3Xd centroids;     // [m] pieces only; S6
  Eigen::Matrix3Xd velocity;      // [m/s] of the elements, relative jets only; S6
  /// [m/s] Velocity of each piece, that of its element; relative jets with pieces only; S6.
  Eigen::Matrix3Xd piece_velocity;
};

/// Internal energies that gas has at ambient temperature [J]: of what is held, and of what the streams
/// carried since the start. Less these, energies are sensible: no zero of enthalpy is in them.
struct AmbientEnergies {
  double held = 0.0, inflow = 0.0, outflow = 0.0, backflow = 0.0;
};

/// Mass and enthalpy of each stream since the start; S10.
struct Streams {
  std::vector<gas::StreamFlux> inflows, outflows, backflows;  // outflows: vents, then fabrics
  AmbientEnergies ambient;
  std::vector<double> outflow_ambient;  // [J] ambient.outflow by outflow
};

/// When the flow of the gas changed its regime; NaN: not yet.
struct GasEvents {
  gas::StepMoments last;       // S10, last time of each
  std::vector<double> opened;  // S2 [s] first time, of each vent
};

/// State of one jet.
struct JetRun {
  /// Overpressure on the elements, after the mask.
  const jet::FieldState& load() const { return elements.overpressure.empty() ? field : elements; }

  jet::OutletState outlet;  // S5, mean over the kick
  JetSkin skin;             // S6
  /// S6, its restitution S5; S7 applies the mask. Of the pieces if there are any, else of the elements.
  jet::FieldState field;
  jet::FieldState elements;                         // S7, averages over the pieces; empty without pieces
  std::vector<std::uint8_t> lit;                    // S7, one per candidate
  jet::VisibilityQuery query;                       // S7 workspace
  jet::VisibilityCounters counters;                 // S7, of this step
  jet::VisibilityCounters total;                    // S7, of the run
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // S7 [N]
  double load_change = 0.0;  // S5, load on a plate over that of the call before; 0 if there was none
  /// S5 [s] Firing of its inflator, as far as it was known when the kick began.
  double firing = std::numeric_limits<double>::infinity();
  /// Outlet of the caller that was last known to be inside the bag: centre [m] and axis; NaN: none.
  Eigen::Matrix<double, 3, 2> known_inside = Eigen::Matrix<double, 3, 2>::Constant(NAN);
};

/// Values of the current level n that later stages overwrite, kept for the balances of n.
struct Level {
  double internal_energy = 0.0;                     // S2 [J]
  double volume = 0.0;                              // S2 [m3]
  double skin_area = 0.0;                           // S2 [m2]
  double skin_strain = 0.0;                         // S3 [J]
  double displacement = 0.0;                        // S8 [m] largest of a node since the start, if wanted
  double pendulum_angle = 0.0;                      // S4 [rad]
  coupling::Pose impactor;                          // S4
  Eigen::Vector3d field = Eigen::Vector3d::Zero();  // S8 [m/s2] mean of Scene::field over the kick
  Flows flows;                                      // S2, sums up to n
  AmbientEnergies ambient;                          // S2
  /// S2 [kg] of each species; like `streams`, only if the history has them.
  std::vector<double> masses;
  Streams streams;         // S2
  double jet_force = 0.0;  // S11 [N] magnitude of the resultant of all jets
  /// S8 [J]; this and the next members only if the balance of n is wanted.
  double skin_gravity = 0.0;
  double jet_power = 0.0;        // S8 [W] of all jets on the skin, at the velocity of n-1/2
  double pressure_power = 0.0;   // S8 [W] of a prescribed pressure, likewise
  double own_power = 0.0;        // S8 [W] of BagState::own_force, likewise
  double skin_kinetic = 0.0;     // S11 [J]
  double energy_residual = 0.0;  // S11 [J] physical drift (K.21)
  double kick_residual = 0.0;    // S11 [J] (K.20): change of kinetic energy less the work of every force
};

/// Step sizes and what limits them.
struct StepSizes {
  double before = 0.0;                                    // [s] step that led to n; 0 at the start
  double after = 0.0;                                     // [s] step that leaves n
  double kick_begin = 0.0;                                // [s] where the kick at n-1 ended
  double kick_end = 0.0;                                  // [s] half a step after n
  double stop = std::numeric_limits<double>::infinity();  // [s] that the caller wants to meet
  double meet_every = 0.0;                                // [s] whose multiples the caller wants to meet
  double critical = 0.0;                                  // [s] bound at n
  double drift_limit = std::numeric_limits<double>::infinity();  // [s] limit of (M.22) at n
  double force_mobility = 0.0;                                   // [J/s2] of the last kick (M.22); S8
  /// Number of steps that (M.22) or (M.24) made shorter.
  long drift_limited = 0;
  /// [m] No node of the skin has moved farther since the start; S8.
  double displacement_bound = 0.0;
  /// [s] Share of the bound that is taken, which grows slowly (M.33).
  double steady = std::numeric_limits<double>::infinity();
  /// Number of steps that the change of the deformation gradient made shorter (M.32).
  long deformation_limited = 0;
  double deformation = 0.0;   // [-] largest change of an element's dF in a given step (M.32)
  int deformed_element = -1;  // that element, or the last one that made a step shorter
  /// [s] Limit by layers of the skin that touch, which grows slowly (K.47).
  double touching = std::numeric_limits<double>::infinity();
  long approach_limited = 0;             // number of steps that layers of the skin made shorter (K.47, K.48)
  double approach = 0.0;                 // [-] largest share of the thickness closed in a given step (K.47)
  double self_contact = 0.0;             // [1/s2] part of shares.contact: the skin with itself
  double self_contact_sum = 0.0;         // [-] part of share_sums.contact
  double jet_damping = 0.0;              // [1/s] damping rate at n of jets relative to the skin (J.9)
  double minimum = 0.0;                  // [s] of the run
  double maximum = 0.0;                  // [s]
  membrane::StiffnessShares shares;      // [1/s2] of omega^2 at n
  membrane::StiffnessShares share_sums;  // [-] sums over the steps, each over its total
};

/// State of the pendulum.
struct PendulumRun {
  coupling::PendulumState motion;         // S8
  double moment = 0.0;                    // S4 [N m] at n, of gravity and contact
  double contact_moment = 0.0;            // S4 [N m] at n, of the contact force
  double driving_moment = 0.0;            // S8 [N m] that the case prescribes, its mean over the kick
  double driving_work = 0.0;              // S8 [J] of that moment in this kick
  double driving_work_before = 0.0;       // S8 [J] its part before n (K.42)
  double angular_velocity = 0.0;          // S8 [rad/s] at n
  coupling::CgAcceleration acceleration;  // S8 at n
  double kinetic_before = 0.0;            // S8 [J] at n-1/2
  double kinetic_after = 0.0;             // S8 [J] at n+1/2
  double kinetic = 0.0;                   // S8 [J] at n
};

/// State of an impactor on a rail, or free.
struct BodyRun {
  /// Its motion is the caller's, who sets it before S4; S8 lets it go on at the speeds given.
  bool driven = false;
  coupling::Pose last_pose{};                               // S8 at n-1, driven only; so are the next two
  coupling::RigidBodyLoad last_contact{};                   // S8 at n-1
  Eigen::Vector3d last_velocity = Eigen::Vector3d::Zero();  // [m/s] S8 at n-1
  coupling::RigidBodyState motion;                          // S8
  coupling::RigidBodyLoad contact;                          // S4 at n
  double displacement = 0.0;                                // S4 [m] at n
  double gravity_energy = 0.0;                              // S4 [J] at n
  double spring_energy = 0.0;                               // S4 [J] at n
  double driving_work = 0.0;         // S8 [J] of the force that the case prescribes, in this kick
  double driving_work_before = 0.0;  // S8 [J] its part before n
  coupling::RigidBodyKick kick;      // S8
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          // S8 [m/s] at n
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();      // S8 [m/s2] at n
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  // S8 [rad/s] at n
  double kinetic = 0.0;                                        // S8 [J] at n
};

/// What the balances count from.
struct AtStart {
  double gas_mass = 0.0;               // [kg]
  double volume = 0.0;                 // [m3] at the start, or when the ambient pressure was last set
  double ambient_work = 0.0;           // [J] on the ambient gas until then
  double energy = 0.0;                 // [J] sum of all energies
  double kinetic = 0.0;                // [J] of skin and impactor
  double smallest_energy = 0.0;        // [J] below which a skin's is not judged
  std::vector<double> masses;          // [kg] of each species
  std::vector<double> ambient_energy;  // [J/kg] u of each species at ambient temperature
};

/// Surface of the rigid target.
struct TargetSurface {
  membrane::Vectors area_vectors, centroids;  // [m2], [m]
};

/// State of a run.
struct State {
  double time = 0.0;  // [s] of level n
  long steps = 0;
  Stage stage = Stage::surface;  // that is running, for messages
  StepSizes step;
  Flows flows;
  Level level;
  Peaks peaks;

  gas::ControlVolumeState gas;                       // S10
  std::optional<gas::GasIntegrator> gas_integrator;  // S10 workspace
  Streams streams;                                   // S10
  GasEvents gas_events;                              // S2, S10
  gas::GasPoint gas_point{};                         // S2
  gas::KickWork jet_work;                            // S10, with JetWork::from_gas
  AtStart start;

  std::optional<membrane::BagState> bag;  // S1, S3, S8, S9
  std::optional<PendulumRun> pendulum;
  std::optional<BodyRun> body;
  std::optional<coupling::ContactState> contact_cache;           // S4 workspace
  coupling::ContactResult contact;                               // S4
  std::optional<coupling::SkinContactState> skin_contact_cache;  // S4 workspace
  coupling::SkinContactResult skin_contact;                      // S4
  std::vector<JetRun> jets;
  /// S3: views of what S6 and S7 wrote for each jet.
  std::vector<membrane::JetLoad> jet_loads;
  TargetSurface target;  // S1

  /// Time of each stage, in ticks (stage_clock.hpp).
  std::array<std::uint64_t, kStages> stage_ticks{};
};

/// State at t = 0. Throws CaseError for a scene that starts outside the models' domain.
State make_state(const Scene& scene);

}  // namespace driver
