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
  mesh::Mesh sphere;         // mesh of the impactor, about its centre; empty without an impactor
  double inertia = 0.0;      // [kg m2] of the pendulum about its centre of gravity; above 0, as a body needs
                             // it
  double contact_gap = 0.0;  // [m] within which contact acts, outside the sphere's mesh
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
