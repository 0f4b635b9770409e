// SPDX-License-Identifier: Apache-2.0
// A bag as a deck has it, in SI units, without a trace of the program that the deck is for.
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "import/deck_text.hpp"

namespace driver::imported {

/// Knots of a piecewise linear curve, not falling; two at one place are a jump.
using Knots = std::vector<std::array<double, 2>>;

/// A shell or a segment: three or four nodes by their numbers in the deck.
struct Facet {
  std::vector<long> nodes;
  std::string panel;
  Place at;
};

/// An ideal gas.
struct BagGas {
  std::string name;
  double molar_mass = 0.0;     // [kg/mol]
  std::array<double, 5> cp{};  // [J/(kg K^(j+1))] factors of T^j
  std::string built_in;        // name of a gas of the program, instead of all above
  bool constant() const {
    return built_in.empty() && cp[1] == 0.0 && cp[2] == 0.0 && cp[3] == 0.0 && cp[4] == 0.0;
  }
};

/// Shares by mass or by mole of the gases, by their numbers in Bag::gases.
struct Mixture {
  std::vector<std::pair<std::size_t, double>> shares;
  bool by_mole = false;
};

/// A round jet.
struct BagJet {
  Eigen::Vector3d centre, axis;
  double radius = 0.0, half_angle = 0.0;  // [m], [rad]
};

struct BagInflator {
  Mixture gas;
  Knots mass_flow;    // [kg/s] of time [s]
  Knots temperature;  // [K]
  double start = 0.0;
  std::optional<BagJet> jet;
  std::string source;
  double at_once = 0.0;  // [kg] of the flow that stand for gas of the start
};

struct BagVent {
  double area = 0.0;                            // [m2] with the coefficient; of the curve if there is one
  Knots of_time, of_overpressure;               // [m2]
  double opens_at = 0.0;                        // [s]
  std::optional<double> opens_at_overpressure;  // [Pa]
  std::string source;
  bool is_open() const { return area > 0.0 || !of_time.empty() || !of_overpressure.empty(); }
};

/// Fabric of a panel.
struct BagFabric {
  double thickness = 0.0, density = 0.0;
  double warp_modulus = 0.0, weft_modulus = 0.0, poisson = 0.0,
         shear = 0.0;                   // poisson: of stress along the warp
  std::optional<Eigen::Vector3d> warp;  // direction; none: isotropic
  double open_share = 0.0;              // [-] of the area, to which the leak law applies
  std::string source;
  bool is_isotropic(double digits) const;  // but for this relative error
};

struct BagSupport {
  std::array<bool, 3> along{};
  std::vector<long> nodes;
};

struct BagStrap {
  long from = 0, to = 0;
  double stiffness = 0.0, free_length = 0.0;
  std::string source;
};

struct BagWall {
  Eigen::Vector3d point, normal;
  std::string source;
};

enum class BagLeak { none, screen, table };

/// What holds, damps and stops a bag.
struct BagHolds {
  std::vector<BagSupport> supports;
  std::vector<BagStrap> straps;
  std::optional<BagWall> wall;
  double mass_damping = 0.0, stiffness_damping = 0.0;  // [1/s], [s]
  double layer_thickness = 0.0, layer_friction = 0.0;  // of self-contact; 0: none
};

/// Acceleration of everything that moves.
struct BagGravity {
  Knots factor;           // [-] over time [s], held outside of its knots; empty: 1
  Eigen::Vector3d along;  // [m/s2]
};

struct BagDeck {
  std::string name;
  double end_time = 0.0;
  std::optional<double> history_every;
  std::vector<BagGravity> gravity;  // their sum

  double ambient_pressure = 0.0, initial_temperature = 0.0;
  std::optional<double> initial_pressure;  // [Pa] if not the ambient pressure
  std::vector<BagGas> gases;
  Mixture initial_gas;
  double heat_transfer = 0.0;  // [W/(m2 K)]
  std::vector<BagInflator> inflators;
  std::vector<BagVent> vents;

  std::map<long, Eigen::Vector3d> nodes, reference;  // [m] at the start; stress-free, if others
  std::vector<Facet> facets;                         // of the control volume
  std::map<std::string, BagFabric> fabrics;          // by panel
  std::vector<std::string> null_panels;
  std::string law = "saint_venant_kirchhoff";
  bool carries_compression = false;
  std::array<Knots, 2> threads;  // nominal stress [Pa] over strain [-] of warp and weft, for the law "curve"
  BagLeak leak = BagLeak::none;
  Knots leak_velocity;  // [m/s] of overpressure [Pa]

  BagHolds held;
};

}  // namespace driver::imported
