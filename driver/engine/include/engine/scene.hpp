// SPDX-License-Identifier: Apache-2.0
// A scene: the constant models of a case file, put together. Parts that the case does not name do not exist.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/case_reader.hpp"
#include "coupling/impactor.hpp"
#include "coupling/pendulum.hpp"
#include "coupling/rigid_body.hpp"
#include "coupling/skin_contact.hpp"
#include "coupling/sphere_contact.hpp"
#include "engine/tank_volume.hpp"
#include "gas/control_volume.hpp"
#include "gas/integrator.hpp"
#include "jet/field.hpp"
#include "jet/outlet.hpp"
#include "jet/subdivision.hpp"
#include "jet/visibility.hpp"
#include "membrane/bag_model.hpp"
#include "mesh/fold.hpp"
#include "mesh/mesh.hpp"

namespace driver {

/// Leak area of the fabric, as a sum over the skin: none; eta^2 A, as printed in the paper; eta A, by screen
/// resistance; or eta A with a table of the velocity.
enum class LeakLaw { none, printed, screen, table };

/// Source of the jet's work on the skin: external (the paper), or the bag's gas. `from_gas` takes the work of
/// a kick out of the gas after the kick. It also takes out the work that the next kick will have done by then
/// at the same rate. So energy balances, and the pressure is second order.
enum class JetWork { external, from_gas };

/// Gas: species, inflators, vents. In a scene with a jet on a rigid target there are inflators but no volume
/// of gas.
struct GasPart {
  gas::ControlVolumeModel model;
  gas::IntegratorOptions integrator;
  std::vector<double> initial_fractions;       // mass fractions per species
  std::vector<std::size_t> contact_sensors{};  // nodes that follow the contact; other inputs are the caller's
  std::vector<std::string> sensor_names{};     // of the first nodes
  double initial_pressure = 0.0;               // [Pa]
  double initial_temperature = 0.0;            // [K]
  std::optional<double> rigid_volume{};        // [m3] of a tank, at the start if it varies
  std::optional<TankVolume> tank_volume{};     // of a tank that moves
  double tank_leak_area = 0.0;                 // [m2] of all fabrics of a tank
  /// [W/(m2 K)] of the walls, if they take heat; the model has it times their area.
  std::optional<double> heat_loss_coefficient{};
};

/// The bag: fabric around the gas, or a sheet under prescribed overpressure.
struct BagPart {
  mesh::Mesh mesh;  // stress-free design shape
  membrane::BagModel model;
  Eigen::Matrix3Xd initial_position;  // 3 x nodes [m]
  LeakLaw leak_law = LeakLaw::none;
  std::vector<int> null_elements;
  /// [Pa] Prescribed over time, held outside of its knots; in a scene without gas. The sheet may be open.
  std::optional<gas::Curve> overpressure;
  std::vector<double> element_mass;        // [kg] of each element's fabric
  std::vector<mesh::FoldLine> fold_lines;  // of a folded start
  std::vector<bool> gathered;              // [nodes] true in the bends of a folded start; else empty
};

/// Rigid surface that a jet acts on. Its force is reported; nothing moves.
struct TargetPart {
  int columns = 0, rows = 0;   // cells
  Eigen::Matrix3Xd nodes;      // 3 x N [m], row by row
  Eigen::Matrix3Xi triangles;  // 3 x M, two for each cell
};

/// One jet, of an outlet of an inflator.
struct JetPart {
  std::size_t inflator = 0;  // number of its inflator
  std::string name;          // for messages: "0", or "0.2" of the third outlet of one with several
  std::string path;          // of its table in the case
  double share = 1.0;        // [-] of the inflator's flow
  /// Pieces of the elements; if given, field, roles and query are those of the pieces.
  std::optional<jet::Subdivision> pieces;
  jet::JetField field;
  jet::OutletModel outlet;
  std::optional<gas::Curve> restitution;  // [-] over injected by contained mass; else the field's
  jet::SurfaceRoles roles;
  std::shared_ptr<const jet::VisibilityQuery> query;  // each run has another one of it
  bool occlusion = true;
  jet::VisibilityRoute route = jet::VisibilityRoute::fast;
};

/// The pendulum.
struct PendulumPart {
  coupling::PendulumModel model;
  coupling::PendulumState initial;
  std::optional<gas::Curve> driving_moment;  // [N m] about the axis, over time; zero outside of its knots
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // columns: the impactor's axes at angle 0
  std::string path = "pendulum";                       // where its keys stand in the case
};

/// An impactor on a rail, or free.
struct BodyPart {
  coupling::RigidBodyModel model;
  std::optional<gas::Curve> force;  // [N] along the rail, over time; zero outside of its knots
};

/// Time and step.
struct TimePart {
  double end = 0.0;            // [s]
  double safety = 0.95;        // [-] step over the critical step
  std::optional<double> step;  // [s] fixed step, in place of safety * critical
  bool unsafe_step = false;    // true: allow a fixed step above its bound
};

/// Output.
struct OutputPart {
  /// [s] A row at the first step at or after each multiple; scenes of gas alone step by it.
  double history_every = 0.0;
  bool history_exact = false;            // true: steps are shortened to end on the multiples
  double fields_every = 0.0;             // [s] 0: no field files
  int frames = 100;                      // intervals of frames.bin, scenes with a bag or target; 0: none
  double self_intersection_every = 0.0;  // [s] looks at the skin beside the usual ones; 0: none
  bool streams = false;                  // history columns for each species and stream
  std::vector<int> channel_classes;      // [Hz] rising; by which the pendulum's acceleration is filtered
};

/// A whole scene.
struct Scene {
  std::string name;
  std::filesystem::path case_file;
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // [m/s2]
  /// [m/s2] In place of it, components over time, zero outside of their knots: of the frame of a sled.
  std::optional<std::array<gas::Curve, 3>> field;
  gas::Ambient ambient{};
  TimePart time;
  OutputPart output;
  std::uint64_t digest = 0;  // checksum of the settings, if a program that saves states gives it
  bool driven = false;       // a program sets forces, an impactor or gravity (controls.hpp)
  std::optional<GasPart> gas;
  std::optional<BagPart> bag;
  std::optional<TargetPart> target;
  std::vector<JetPart> jets;
  JetWork jet_work = JetWork::external;  // of all jets
  std::optional<PendulumPart> pendulum;
  std::optional<BodyPart> body;  // in place of the pendulum
  coupling::Impactor impactor;   // shape of either
  std::optional<coupling::ContactModel> contact;
  std::optional<double> contact_share;  // [-] stiffness_share, if the stiffness comes of it
  std::optional<coupling::SkinContactModel> skin_contact;  // of the bag's fabric with itself
  std::optional<double> skin_contact_share;                // [-] its stiffness_share, likewise
  /// Likely mistakes that are no errors; `check` and `run` print them.
  std::vector<std::string> warnings;

  /// True if there is a volume of gas.
  bool has_volume() const { return gas && (bag || gas->rigid_volume); }
  /// True if anything moves.
  bool moves() const { return bag || has_impactor(); }
  bool has_impactor() const { return pendulum || body; }
};

/// Reads the mesh file of a case. Throws mesh::MeshFileError.
using MeshReader = std::function<mesh::Mesh(const std::filesystem::path&)>;

/// Reads and checks a whole case; `read_mesh` reads the mesh files that it names. Throws CaseError; the
/// message has file, line, column and key.
Scene read_scene(CaseDocument& document, const MeshReader& read_mesh);

/// Displaces each free node of the bag's initial shape by up to `amplitude` [m] along each axis, as
/// `membrane.perturbation` and `perturbation_seed` do. Throws std::invalid_argument without a bag.
void displace_nodes(Scene& scene, double amplitude, int seed);

}  // namespace driver
