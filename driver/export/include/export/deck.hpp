// SPDX-License-Identifier: Apache-2.0
// A scene with a bag as plain data for the decks of other programs. All values are in SI units; the writers
// convert them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene.hpp"
#include "mesh/mesh.hpp"

namespace driver {

/// Names and texts of the files of a deck.
using DeckFiles = std::vector<std::pair<std::string, std::string>>;

enum class DeckFormat { radioss, lsdyna };

/// Elements of one panel, with one fabric.
struct DeckPart {
  int id;            // from 1
  std::string name;  // name of the panel
  bool null_panel;
  membrane::ElementProperties fabric;
  std::vector<int> elements;  // numbers in the mesh, from 0
  double area;                // [m2] in the design shape
};

/// A mixture as one gas, with the heat capacity of the mixture, exact below 1000 K.
struct DeckGas {
  std::string name;
  double molar_mass;           // [kg/mol]
  std::array<double, 5> cp{};  // [J/(kg K^(j+1))] factors of T^j
  double misfit = 0.0;         // [-] largest relative error of cp up to the highest temperature in the case
  std::array<double, 3>
      parabola{};                // [J/(kg K^(j+1))] least squares of the mixture's cp over these temperatures
  double parabola_misfit = 0.0;  // [-] largest relative error of cp over them
};

/// Knots of a curve; times rise. Further knots give the values outside the case's own knots.
using DeckCurve = std::vector<std::array<double, 2>>;

/// Title of the curve of an inflator that stands for an initial overpressure. Import knows it.
inline constexpr const char* initial_overpressure_title = "initial overpressure";

struct DeckInflator {
  DeckGas gas;
  DeckCurve mass_flow;    // [kg/s] of time [s]
  DeckCurve temperature;  // [K] of time [s]
  bool of_mass = false;   // true: `mass_flow` is the total mass [kg] so far
  std::string title{};    // of its flow, in LS-DYNA decks
};

struct DeckVent {
  std::size_t number = 0;                       // number in the case
  double area = 0.0;                            // [m2] with the discharge coefficient; factor of the curves
  std::optional<DeckCurve> of_time;             // [-] of time [s]
  std::optional<DeckCurve> of_overpressure;     // [-] of overpressure [Pa]
  double opens_at = 0.0;                        // [s]
  std::optional<double> opens_at_overpressure;  // [Pa]
};

/// Fabric of a part that leaks.
struct DeckLeak {
  int part;                           // id
  double share;                       // [-] open share of the part's area
  std::optional<DeckCurve> velocity;  // [m/s] of overpressure [Pa]
};

/// A difference between the scene and the deck, or something that the deck lacks, with its size.
struct DeckNote {
  std::string key;  // key of the case
  std::string text;
};

/// An inflator or a vent that the deck lacks.
struct DeckOmission {
  std::string part;  // path in the case: "vent.0"
  std::string why;
};

/// Threads of fabric by measured curves.
struct DeckThread {
  DeckCurve curve;        // stress [Pa] over strain [-] in the measures of the format
  double steepest = 0.0;  // [Pa] slope of the steepest piece of the case's curve
};

/// A spring of a rail between a node that does not move and the impactor, one behind the other along the
/// rail, so that it gets longer by the displacement.
struct DeckSpring {
  DeckCurve force;         // [N] over displacement [m]
  double stiffness = 0.0;  // [N/m]
  double damping = 0.0;    // [N s/m]; 0 for a stop, whose damper decks lack
};

/// A rigid impactor at the start, in space.
struct DeckImpactor {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();            // [m] of the shape
  mesh::Mesh surface;                                          // inside the shape by `gap`
  double gap = 0.0;                                            // [m] within which contact acts
  double mass = 0.0;                                           // [kg]
  Eigen::Vector3d cg = Eigen::Vector3d::Zero();                // [m] centre of gravity
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();           // [kg m2] about it; positive definite
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          // [m/s] of it
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  // [rad/s]
  bool on_rail = false;
  /// Columns: right-handed axes, x along the rail or the pendulum's axis; of a free body those of space.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  DeckCurve load;                   // [N] along that x, or [N m] about it, over time; may be empty
  std::vector<DeckSpring> springs;  // of a rail
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();  // [m] their node that does not move
};

struct Deck {
  const Scene* scene = nullptr;
  DeckFormat format = DeckFormat::radioss;
  std::vector<DeckPart> parts;
  std::array<DeckThread, 2> threads;      // warp and weft of fabric by measured curves, else empty
  std::optional<DeckCurve> overpressure;  // [Pa] of time [s], for a sheet; members of gas are then empty
  DeckGas initial_gas;
  std::vector<DeckInflator> inflators;
  std::vector<DeckVent> vents;
  std::vector<DeckLeak> leaks;
  std::optional<DeckImpactor> impactor;
  std::array<DeckCurve, 3>
      field;  // [m/s2] components of gravity over time [s], in place of the scene's constant
  std::vector<DeckNote> notes;
  std::vector<DeckOmission> omissions;
};

/// End of the deck's run [s]: later than the scene's, so that other programs write a row at or after the
/// scene's end.
double run_end(const Scene& scene);

/// Throws CaseError for a scene without a bag.
Deck make_deck(const Scene& scene, DeckFormat format);

/// Misfit of a load proportional to the cosine of incidence to that of a reflected jet, cos^2: root mean
/// square over the half space [-], and ratio at 30, 45 and 60 degrees.
struct CosineMisfit {
  double rms;
  std::array<double, 3> ratio;
};
CosineMisfit cosine_misfit();

}  // namespace driver
