// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "membrane/element_group.hpp"
#include "membrane/isa.hpp"
#include "membrane/mass_shares.hpp"
#include "membrane/material.hpp"
#include "membrane/vectors.hpp"

namespace membrane {

/// Default of members that must be given: make_model throws and names the member.
inline constexpr double kMustBeGiven = std::numeric_limits<double>::quiet_NaN();

/// Makes the fabric of an element orthotropic. `young_modulus` and `poisson` of the element then belong to
/// the warp: in tension along the warp the fabric contracts across by poisson. Needs poisson^2 < 0.998
/// young_modulus / young_modulus_weft.
struct WeaveProperties {
  double young_modulus_weft = kMustBeGiven;  // > 0 [Pa]
  /// G > 0 [Pa], 1e-4 to 100 times sqrt(young_modulus young_modulus_weft).
  double shear = kMustBeGiven;
  /// Direction of the warp, of any length > 0. The part in the plane of the reference element is used; it
  /// must be more than 1e-6 of the length.
  Eigen::Vector3d warp = Eigen::Vector3d::Constant(kMustBeGiven);
};

/// Measured curve of a strip along the warp or the weft: nominal stress [Pa] (force per width and thickness
/// as sewn) over strain [-] (stretch minus 1). 2 to 64 points, the first (0, 0), both rising.
struct StressCurve {
  std::vector<double> strain;  // [-] strain of each point
  std::vector<double> stress;  // [Pa] stress of each point
};

/// Fabric of one element. A null element closes a hole: it bounds the volume and carries the gas pressure,
/// but has no mass and no stress. Its thickness, density, young_modulus and poisson are not used, and its
/// porosity must be 0.
struct ElementProperties {
  double thickness = kMustBeGiven;            // h > 0 [m]
  double density = kMustBeGiven;              // rho > 0 [kg/m3]
  double young_modulus = kMustBeGiven;        // E > 0 [Pa]
  double poisson = kMustBeGiven;              // -1 < nu < 1 [-]
  double porosity = 0.0;                      // eta, 0 to 1 [-]
  bool null_panel = false;                    // true: null element
  std::optional<WeaveProperties> weave = {};  // empty: isotropic
  std::vector<double> law_constants = {};     // one for each of LawTraits::own of the bag's law
};

/// Massless spring with tension only: it pulls when it is longer than its free length (M.7).
struct Strap {
  int node_a = -1;                    // one end
  int node_b = -1;                    // the other end, not node_a
  double stiffness = kMustBeGiven;    // k > 0 [N/m]
  double free_length = kMustBeGiven;  // > 0 [m]
};

/// Rigid one-sided plate (M.8). A node at depth d behind the plane has the energy
///   stiffness * (its reference area) * d^2 / 2.
struct Plate {
  Eigen::Vector3d point = Eigen::Vector3d::Constant(kMustBeGiven);   // on the plane [m]
  Eigen::Vector3d normal = Eigen::Vector3d::Constant(kMustBeGiven);  // [-] towards the bag, any length > 0
  /// kappa > 0, per area [N/m3]. Empty: the stiffness whose omega^2 is kDefaultPlateShare of the fabric's.
  std::optional<double> stiffness = {};
};

/// Default share [-] of the fabric's omega^2 that a plate adds. Such a plate is stiff, yet shortens the step
/// by only a tenth.
inline constexpr double kDefaultPlateShare = 0.25;

/// Input of make_model: everything that defines a bag.
struct BagDescription {
  Eigen::Matrix3Xd reference{};                 // stress-free positions, 3 x nodes [m]
  Eigen::Matrix3Xi elements{};                  // corner nodes, 3 x elements, oriented outward
  std::vector<ElementProperties> properties{};  // one per element
  Compression compression = Compression::none;  // compression law of all fabric
  /// Law of all fabric, a name of law_names(). "hencky" needs Compression::none and has no weave. "curve"
  /// needs Compression::none and a weave of each fabric; it uses the weave's shear and warp, but no moduli.
  std::string law = "saint_venant_kirchhoff";
  std::array<StressCurve, 2> curves{};  // curves of warp and weft, for laws by curves
  std::vector<int> fixed_nodes{};       // nodes that never move; any order, repeats allowed
  /// Nodes that never move along x, along y and along z: rollers, and planes of symmetry. Order and repeats
  /// as above.
  std::array<std::vector<int>, 3> held_nodes{};
  std::vector<Strap> straps{};                        // may be empty
  std::vector<Plate> plates{};                        // may be empty
  double mass_damping = 0.0;                          // alpha >= 0: force -alpha m v [1/s]
  double stiffness_damping = 0.0;                     // beta >= 0: stress beta dS/dt (M.28) [s]
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // [m/s2]
  Isa isa = best_isa();                               // kernels to use; all give the same bits
};

/// The elements in the order of the kernels: compact patches of neighbours, for any numbering of the mesh.
/// Elements without effect fill up each patch to whole groups. All other arrays keep the mesh's numbers.
struct BlockTable {
  AlignedVector<ElementGroup> group;  // kLanes elements each
  AlignedVector<FabricGroup> fabric;  // each fabric once; ElementGroup::fabric points here
  std::vector<std::int32_t> element;  // element of each lane of each group; -1 for padding
  std::vector<std::int32_t> place;    // place of each element: kLanes * group + lane
  std::vector<ElementBlock> block;    // blocks in the order in which their sums are added
  std::vector<std::int32_t> node;     // nodes of each block: own ones, then shared ones, both ascending

  /// Fabric of group g.
  const FabricGroup& fabric_of(std::size_t g) const {
    return fabric[static_cast<std::size_t>(group[g].fabric)];
  }
};

/// Nodes that several blocks share, ascending, with the slots of their partial sums in the order of the
/// blocks (compressed rows).
struct SharedNodes {
  std::vector<std::int32_t> node;       // their numbers in the mesh
  std::vector<std::int32_t> row_begin;  // [shared nodes + 1]
  std::vector<std::int32_t> slot;       // places in BagState::shared_sums, by rows
};

/// Elements around each node, ascending (compressed rows).
struct CornerTable {
  std::vector<std::int32_t> row_begin;  // [nodes + 1]
  std::vector<std::int32_t> element;    // element numbers, by rows
};

/// Model of a bag, constant during a run. Only make_model makes one.
struct BagModel {
  int node_count = 0;     // N
  int element_count = 0;  // M, null elements included
  /// Place in FabricLaws: the law for woven fabric if any element has a weave, otherwise the law for
  /// isotropic fabric.
  int law = 0;
  BagDescription description;     // as given and checked; plates with unit normal and stiffness
  BlockTable elements;            // in the order of the kernels
  YarnCurves yarns{};             // curves, for laws by curves
  SharedNodes shared;             // nodes that blocks share
  CornerTable corners;            // elements around each node
  std::vector<double> node_mass;  // [kg] sum of rho h A / 3
  Vectors inverse_mass;           // [1/kg] 1 / mass, nodes, 0 along directions that are held
  /// [m2] reference area of the fabric around each node, sum of A / 3.
  std::vector<double> node_area;
  std::vector<double> reference_area;       // [m2] reference area of each element
  std::vector<ElementStiffness> stiffness;  // stiffness of each element
  MassShares shares;                        // tuned to the reference shape
  /// [1/s2] largest bound of omega^2 of an element in the reference shape.
  double fabric_frequency = 0.0;
  /// [1/s2] bound of omega^2 that the straps add, taut or not.
  double strap_frequency = 0.0;
  /// [1/s2] bound of omega^2 that the plates add, touched or not.
  double plate_frequency = 0.0;
  double fabric_mass = 0.0;              // [kg]
  std::vector<double> gradient_squared;  // [1/m2] sum of |grad N_a|^2 of each element, 0 of null ones
  /// [1/m2] for each node: three times the largest gradient_squared of the elements around it.
  std::vector<double> node_gradient_squared;
};

/// False if the area of the triangle with sides `ab` and `ac` [m] is only round-off of its corners: at most
/// 1e-14 of the longer side squared. Also false if the area overflows a double.
bool has_area(const Eigen::Vector3d& ab, const Eigen::Vector3d& ac);

/// Builds the model. Throws std::invalid_argument, naming the element, node, strap or plate, the field, its
/// value and what is allowed, for
/// - sizes that differ, numbers that are not finite, and values outside the ranges above,
/// - node numbers that are out of range, or repeated in an element or strap,
/// - an element without area, or a node without an element,
/// - a null panel with a node that no fabric holds.
///
/// Open surfaces are legal membranes; mesh/surface_check.hpp checks whether a surface is closed.
BagModel make_model(const BagDescription& description);

}  // namespace membrane
