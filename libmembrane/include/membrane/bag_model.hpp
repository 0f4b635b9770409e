// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "membrane/element_group.hpp"
#include "membrane/isa.hpp"
#include "membrane/mass_shares.hpp"
#include "membrane/material.hpp"
#include "membrane/vectors.hpp"

namespace membrane {

// Default of what has none: make_model refuses it by name.
inline constexpr double kMustBeGiven = std::numeric_limits<double>::quiet_NaN();

// Makes the fabric of an element orthotropic: `young_modulus` and `poisson` are then those of the warp
// (pulled along the warp the fabric contracts by poisson across), with poisson^2 < young_modulus /
// young_modulus_weft.
struct WeaveProperties {
  double young_modulus_weft = kMustBeGiven;  // > 0 [Pa]
  double shear = kMustBeGiven;  // G > 0, 1e-4 to 100 of sqrt(young_modulus young_modulus_weft) [Pa]
  // Along the warp, any length > 0; its part in the plane of the reference element counts.
  Eigen::Vector3d warp = Eigen::Vector3d::Constant(kMustBeGiven);
};

// Fabric of one element. A null element closes a hole: it bounds the volume and carries the gas pressure, but
// has no mass and no stress; its thickness, density, young_modulus and poisson are not read and its porosity
// is zero.
struct ElementProperties {
  double thickness = kMustBeGiven;            // h > 0 [m]
  double density = kMustBeGiven;              // rho > 0 [kg/m3]
  double young_modulus = kMustBeGiven;        // E > 0 [Pa]
  double poisson = kMustBeGiven;              // -1 < nu < 1 [-]
  double porosity = 0.0;                      // eta, 0 to 1 [-]
  bool null_panel = false;                    // closes a hole
  std::optional<WeaveProperties> weave = {};  // absent: isotropic
};

// Massless spring that pulls when longer than its free length and never pushes (M.7).
struct Strap {
  int node_a = -1;                    // one end
  int node_b = -1;                    // the other, not node_a
  double stiffness = kMustBeGiven;    // k > 0 [N/m]
  double free_length = kMustBeGiven;  // > 0 [m]
};

// Rigid one-sided support (M.8): a node at depth d behind the plane has the energy
// stiffness * (its reference area) * d^2 / 2.
struct Plate {
  Eigen::Vector3d point = Eigen::Vector3d::Constant(kMustBeGiven);   // on the plane [m]
  Eigen::Vector3d normal = Eigen::Vector3d::Constant(kMustBeGiven);  // towards the bag, any length > 0
  std::optional<double> stiffness = {};  // kappa > 0, per area [N/m3]; absent: kDefaultPlateShare decides
};

// Share of the fabric's own omega^2 that a plate adds by default: stiff, yet a tenth off the step.
inline constexpr double kDefaultPlateShare = 0.25;

// Everything that defines a bag, as a case gives it.
struct BagDescription {
  Eigen::Matrix3Xd reference;                         // stress-free positions, 3 x nodes [m]
  Eigen::Matrix3Xi elements;                          // corner nodes, 3 x elements, oriented outward
  std::vector<ElementProperties> properties;          // one per element
  Compression compression = Compression::none;        // of all fabric
  std::vector<int> fixed_nodes;                       // they never move; in any order, repeats allowed
  std::vector<Strap> straps;                          // may be empty
  std::vector<Plate> plates;                          // may be empty
  double mass_damping = 0.0;                          // alpha >= 0: force -alpha m v [1/s]
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // [m/s2]
  Isa isa = best_isa();                               // kernels to use; every choice gives the same bits
};

// The elements in the order of the kernels: compact patches of neighbours, whatever the numbering of the
// mesh, each padded to whole groups by elements without effect. The mesh's numbers stay in all other arrays.
struct BlockTable {
  AlignedVector<ElementGroup> group;  // kLanes elements each
  AlignedVector<FabricGroup> fabric;  // each once, see ElementGroup::fabric
  AlignedVector<WeaveGroup> weave;    // of each group; empty unless woven
  std::vector<std::int32_t> element;  // of each lane of each group, -1 where it is padding
  std::vector<std::int32_t> place;    // of each element: kLanes * group + lane
  std::vector<ElementBlock> block;    // in the order of their sums
  std::vector<std::int32_t> node;     // of each block: its own, then the shared ones, both ascending

  // The fabric of group g.
  const FabricGroup& fabric_of(std::size_t g) const {
    return fabric[static_cast<std::size_t>(group[g].fabric)];
  }
};

// Nodes that several blocks share, ascending, and the slots of their sums in block order (compressed rows).
struct SharedNodes {
  std::vector<std::int32_t> node;       // their numbers in the mesh
  std::vector<std::int32_t> row_begin;  // shared nodes + 1
  std::vector<std::int32_t> slot;       // in BagState::shared_sums, by rows
};

// For each node the elements around it, ascending (compressed rows).
struct CornerTable {
  std::vector<std::int32_t> row_begin;  // nodes + 1
  std::vector<std::int32_t> element;    // by rows
};

// Constant during a run. Made by make_model only.
struct BagModel {
  int node_count = 0;                       // N
  int element_count = 0;                    // M, null ones too
  bool woven = false;                       // some element has a weave: all take the orthotropic law
  BagDescription description;               // as given and checked
  BlockTable elements;                      // for the kernels
  SharedNodes shared;                       // of the blocks
  CornerTable corners;                      // elements around each node
  std::vector<double> node_mass;            // sum of rho h A / 3 [kg]
  std::vector<double> inverse_mass;         // 1 / mass, 0 at fixed nodes [1/kg]
  std::vector<double> node_area;            // reference area of the fabric around the node, sum of A / 3 [m2]
  std::vector<double> reference_area;       // of each element [m2]
  std::vector<ElementStiffness> stiffness;  // of each element
  MassShares shares;                        // as sewn
  double fabric_frequency = 0.0;            // largest bound of omega^2 of an element, as sewn [1/s2]
  double strap_frequency = 0.0;             // bound of omega^2 added by the straps, taut or not [1/s2]
  double plate_frequency = 0.0;             // bound of omega^2 added by the plates, touched or not [1/s2]
  double fabric_mass = 0.0;                 // [kg]
};

// Builds the model. Throws std::invalid_argument, naming the element, node, strap or plate, the field, its
// value and what is allowed: sizes that differ, non-finite numbers, values outside the ranges above, node
// numbers out of range or repeated in an element or strap, an element without area, a node without element,
// and a null panel with a node that no fabric holds. Whether the surface is closed is not asked here (open
// strips are legal membranes): see membrane/surface_check.hpp.
BagModel make_model(const BagDescription& description);

}  // namespace membrane
