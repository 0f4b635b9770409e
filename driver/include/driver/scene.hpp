// SPDX-License-Identifier: Apache-2.0
// A scene: the constant models of a case file, composed. What the case does not name does not exist here.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coupling/pendulum.hpp"
#include "coupling/sphere_contact.hpp"
#include "driver/case_reader.hpp"
#include "gas/control_volume.hpp"
#include "gas/integrator.hpp"
#include "jet/field.hpp"
#include "jet/outlet.hpp"
#include "jet/subdivision.hpp"
#include "jet/visibility.hpp"
#include "membrane/bag_model.hpp"
#include "membrane/mesh.hpp"

namespace driver {

/// Which sum over the skin the fabric's leak takes: eta^2 A as printed in the paper, or eta A (screen
/// resistance, or a table of the velocity through the share eta of the area).
enum class LeakLaw { none, printed, screen, table };

/// Does the work of the jet on the skin come from outside (the paper), or out of the bag's gas?
/// `from_gas` takes the work of a kick out after the kick, and what the next one will have done by then at
/// the same rate: energy balances, and the pressure is second order.
enum class JetWork { external, from_gas };

/// Volume of a tank along a prescribed path: a table, or mean + amplitude sin(2 pi frequency t + phase).
struct TankVolume {
  std::optional<gas::Curve> table;                                   // [m3]
  double mean = 0.0, amplitude = 0.0, frequency = 0.0, phase = 0.0;  // [m3], [m3], [1/s], [rad]
  double at(double time) const;
  /// End of a piece that begins at `time`: the next knot of the table, or 1/512 of a period.
  double piece_end(double time) const;
  /// The volume over the piece [begin, end]: linear for a table, else the parabola through its middle, off
  /// the sine by at most amplitude * 1.5e-8 and on it at both ends.
  gas::VolumePath piece(double begin, double end, double leak_area) const;
};

/// Gas: species, inflators, vents. A scene with a jet on a rigid target has inflators, but no volume of gas.
struct GasPart {
  gas::ControlVolumeModel model;
  gas::IntegratorOptions integrator;
  std::vector<double> initial_fractions;  // mass fractions per species
  double initial_pressure = 0.0;          // [Pa]
  double initial_temperature = 0.0;       // [K]
  std::optional<double> rigid_volume;     // [m3], set for a tank; at the start if it varies
  std::optional<TankVolume> tank_volume;  // of a tank that moves
  double tank_leak_area = 0.0;            // [m2] of a tank with fabrics, all together
};

struct BagPart {
  membrane::Mesh mesh;  // stress-free design shape
  membrane::BagModel model;
  Eigen::Matrix3Xd initial_position;  // 3 x nodes [m]
  LeakLaw leak_law = LeakLaw::none;
  std::vector<int> null_elements;
};

/// Rigid surface that a jet blows at; its force is reported, nothing moves.
struct TargetPart {
  Eigen::Matrix3Xd nodes;      // 3 x N [m]
  Eigen::Matrix3Xi triangles;  // 3 x M
};

struct JetPart {
  std::size_t inflator = 0;
  std::optional<jet::Subdivision> pieces;  // of the elements; the field and the roles are theirs then
  jet::JetField field;
  jet::OutletModel outlet;
  jet::SurfaceRoles roles;
  bool occlusion = true;
  jet::VisibilityRoute route = jet::VisibilityRoute::fast;
  JetWork work = JetWork::external;
};

struct PendulumPart {
  coupling::PendulumModel model;
  coupling::PendulumState initial;
};

struct TimePart {
  double end = 0.0;            // [s]
  double safety = 0.8;         // share of the critical step
  std::optional<double> step;  // [s] fixed step, instead of safety * critical
  bool unsafe_step = false;    // run a fixed step above its bound
};

struct OutputPart {
  double history_every =
      0.0;  // [s] a row at the first step at or past each multiple; gas-only scenes step by it
  bool history_exact = false;  // steps are shortened to end on the multiples
  double fields_every = 0.0;   // [s] 0: no field files
  bool streams = false;        // columns of the history for each species and stream
};

struct Scene {
  std::string name;
  std::filesystem::path case_file;
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // [m/s2]
  gas::Ambient ambient{};
  TimePart time;
  OutputPart output;
  std::optional<GasPart> gas;
  std::optional<BagPart> bag;
  std::optional<TargetPart> target;
  std::vector<JetPart> jets;
  std::optional<PendulumPart> pendulum;
  std::optional<coupling::ContactModel> contact;
  std::vector<std::string> warnings;  // plausible slips that are no errors; `check` and `run` print them

  bool has_volume() const { return bag.has_value() || (gas && gas->rigid_volume); }
  bool moves() const { return bag.has_value() || pendulum.has_value(); }
};

/// Reads and checks a whole case. Throws CaseError (message with file, line, column, key).
Scene read_scene(CaseDocument& document);

}  // namespace driver
