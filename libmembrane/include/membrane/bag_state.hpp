// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "membrane/bag_model.hpp"
#include "membrane/vectors.hpp"

namespace membrane {

/// Nodes of one block in S8 and in the loads. Sums are taken per block and then over the blocks in order, so
/// their bits do not depend on threads.
inline constexpr int kNodeBlock = 512;

/// S1/S9: sums over the surface.
struct SurfaceSums {
  double volume = 0.0;                 // V enclosed (M.5) [m3]
  double area = 0.0;                   // of all elements, null ones included [m2]
  double porosity_area = 0.0;          // sum of eta A [m2]
  double porosity_squared_area = 0.0;  // sum of eta^2 A [m2]
  double gradient_mobility = 0.0;      // g^T M^-1 g, g = dV/dx at the free nodes [m4/kg]
};

/// S3: sums over the elements and supports.
struct ForceSums {
  double strain_energy = 0.0;                             // [J]
  double strap_energy = 0.0;                              // [J]
  double plate_energy = 0.0;                              // [J]
  Eigen::Vector3d plate_force = Eigen::Vector3d::Zero();  // force of the plates on the nodes, summed [N]
  double element_frequency = 0.0;                         // largest element bound of omega^2 (M.10) [1/s2]
};

/// S8: work of each force over one kick, tau f . (v- + v+) / 2 [J] (K.20). Their total is kinetic_after -
/// kinetic_before to round-off, for any forces and steps.
struct KickWork {
  double membrane = 0.0;  // work of the fabric's stress
  double pressure = 0.0;  // work of the gas pressure
  double jet = 0.0;       // work of the jets' overpressure
  double support = 0.0;   // work of straps and plates
  double contact = 0.0;   // work of contact_force
  double own = 0.0;       // work of own_force
  double gravity = 0.0;   // work of the weight
  double damping = 0.0;   // work of both dampings
  /// Sum of all [J].
  double total() const { return membrane + pressure + jet + support + contact + own + gravity + damping; }
};

/// S8: results of one step.
struct AdvanceSums {
  KickWork work;                // work of each force
  double kinetic_before = 0.0;  // kinetic energy at n-1/2 [J]
  double kinetic_after = 0.0;   // kinetic energy at n+1/2 [J]
  /// Sum of m v- . v+ / 2 [J]. A linear system conserves this plus the strain energy.
  double kinetic_product = 0.0;
  Eigen::Vector3d momentum_before = Eigen::Vector3d::Zero();  // [kg m/s]
  Eigen::Vector3d momentum_after = Eigen::Vector3d::Zero();   // [kg m/s]
  /// tau * force on the free nodes, without damping [N s].
  Eigen::Vector3d impulse = Eigen::Vector3d::Zero();
  double max_speed_squared = 0.0;  // largest |v|^2 at n+1/2 [m2/s2]
};

/// Partial sums of one block; workspace of the stages.
struct BlockSums {
  /// Sums of a block of elements. `volume` is still three times the volume.
  SurfaceSums surface;
  ForceSums forces;  // fabric: sums of a block of elements; plates: of a block of nodes
  /// Part of gradient_mobility from a block of shared nodes [m4/kg].
  double shared_mobility = 0.0;
  AdvanceSums advance;  // sums of a block of nodes
};

/// Stiffness-proportional damping; empty without it.
struct ViscousState {
  Vectors force;           // [N], nodes
  Vectors elastic_stress;  // (S11, S22, S12) at the last evaluation [Pa], elements
  Vectors corner_force;    // workspace: at corners b and c [N], 2 x elements
};

/// State of a bag: everything that changes during a run. Each array has one writer, named on its line.
/// make_state allocates everything. Arrays of Vectors are padded to 4 doubles a column.
struct BagState {
  Vectors position;  // x at n [m], nodes; S8
  Vectors velocity;  // v at n-1/2 [m/s], nodes, 0 at fixed ones; S8
  /// For each 16 nodes, the largest |v|^2 times BagModel::node_gradient_squared [1/s2]; 0 at the start; S8.
  std::vector<double> rate_bound_squared;
  /// Of elements; empty without jet; S6 update_geometry, of the elements that it is asked for.
  Vectors area_vector;      // S_e, outward, length = area [m2]
  Vectors centroid;         // ((a + b) + c) / 3 [m]
  Vectors volume_gradient;  // dV/dx = sum of S_e / 3 [m2], nodes; S1/S9
  /// p - p_a [Pa]; S8 takes gauge_pressure * volume_gradient as the nodal force; S3 pressure_forces.
  double gauge_pressure = 0.0;
  /// [m/s2] That of the description, or what the caller sets for the next kick; S8 takes it.
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  Vectors membrane_force;             // [N], nodes; S3 membrane_forces
  Vectors jet_force;                  // [N], nodes; empty without jet; S3 jet_forces
  std::vector<int> jet_nodes;         // nodes with a jet_force that is not zero; S3 jet_forces
  std::vector<char> has_jet_force;    // for each node, whether it is one of jet_nodes; S3 jet_forces
  Vectors support_force;              // force of straps and plates [N], nodes; empty without them; S3
                                      // support_forces
  std::vector<double> strap_tension;  // [N], straps; S3 support_forces
  ViscousState viscous;               // S3 viscous_forces
  Vectors contact_force;              // [N], nodes; empty without contact; S4, the caller
  Vectors own_force;  // [N], nodes; empty unless the caller gives it a vector for each node; the caller
  /// Workspace of S3 and S9: partial sums of each block at its shared nodes.
  AlignedVector<NodeSums> shared_sums;
  /// Shares of the nodes' mass, at first those of the model; update_mass_shares.
  MassShares shares;
  std::vector<double> share_demand;  // elements; workspace of update_mass_shares
  std::vector<BlockSums> block;      // workspace of the block sums
  SurfaceSums surface;               // S1/S9
  ForceSums forces;                  // S3
  AdvanceSums advance;               // S8
};

/// Loads besides pressure and supports. A load that is absent costs nothing.
struct LoadKinds {
  bool jet = false;      // keep area vectors, centroids and jet forces
  bool contact = false;  // keep contact_force, for the caller to write
};

/// State at rest at the given positions, 3 x nodes [m]. Surface and membrane forces are not yet computed.
/// Throws std::invalid_argument, naming the node, for a wrong size or a coordinate that is not finite.
BagState make_state(const BagModel& model, ConstVectorsRef position, LoadKinds loads = {});

/// Throws std::invalid_argument unless the arrays have the sizes that make_state gives them for this model.
/// The stages call it. It does not distinguish models of equal sizes.
void check_state(const BagModel& model, const BagState& state);

}  // namespace membrane
