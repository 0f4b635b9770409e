// SPDX-License-Identifier: Apache-2.0
// Contact of a triangulated skin with itself. Layers closer than the thickness h push each other apart:
//   (K.44) E = sum_n A_n/2 sum_f c_f kappa phi(h, d(n, f)) + sum_ee a kappa [phi(0.8 h, d(e, e')) - phi(0.8
//   h, d_end)],
//          phi(h, d) = [(h - d)^2 + 20 (h/2 - d)^2] / 2
// where squares of a negative number are zero: what meets hard is stopped in the second half. d is the
// distance of the closest points: of a node n and a triangle, edge or node f, and of two edges; d_end is the
// least distance of an end of one edge from the other, of ends that touch a triangle there as nodes. A_n is
// a third of the reference area around n, a half of the areas of all triangles at the two edges. The numbers
// c_f are +1 for triangles, -1 for inner edges and +1 for inner nodes, so that a node near several triangles
// of one layer counts it once, and two flat layers feel the pressure kappa (h - d) down to 0.8 h. Edges keep
// creases from crossing.
//
// Parts that have a common node, or nodes that an edge joins, are neighbours and do not touch: a crease has
// no thickness.
//
// Distances have no sign. The side of a layer is that of the start, because no distance may reach 0: between
// two levels all points move on straight lines, and what may have met is tested along its path.
//
// A node that starts closer than h to another layer has that distance as its limit in place of h, and starts
// without force. The limit follows the node's distance up to h, never down (K.45).
#pragma once
#include <Eigen/Core>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "coupling/error.hpp"
#include "coupling/skin.hpp"

namespace coupling {

namespace detail {
struct SkinParts;
struct SkinRun;
}  // namespace detail

/// Parameters of the contact of a skin with itself.
struct SkinContactParameters {
  double thickness;       // [m] h > 0, at most the smallest altitude of a reference element
  double stiffness;       // [N/m3] kappa > 0: pressure per h - d
  double friction = 0.0;  // [-] mu >= 0
};

/// Two parts of the skin: a node and an element, or two edges.
struct SkinPair {
  int first[2] = {-1, -1};                               // node, -1; or the nodes of an edge
  int second[3] = {-1, -1, -1};                          // nodes of the element; or nodes of an edge, -1
  double gap = std::numeric_limits<double>::infinity();  // [m] their distance
};
/// "node 5 and element nodes 1, 2, 3" or "edges 1-2 and 5-6".
std::string text_of(const SkinPair& pair);

/// Result of one evaluation. The forces on the nodes sum to zero; without friction their moments do, too.
struct SkinContactResult {
  double energy = 0.0;         // [J] including the stretch of sticking nodes
  double friction_loss = 0.0;  // [J] lost since the last level
  /// [1/s2] Bound of the contact's omega^2 (K.46); at the first level, of all nodes that start at their
  /// limit.
  double omega_squared = 0.0;
  int contacts = 0;  // pairs closer than their limit
  SkinPair closest;  // of those in contact
  /// [-] Largest decrease of a distance since the last level over the reach (h; of edges 0.8 h), of parts
  /// whose closest points come within the reach in one and a half such steps. The time step keeps it small
  /// (K.47).
  double approach = 0.0;
  /// [J] Sum over the nodes whose force begins, ends or changes its slope within one and a half steps like
  /// the last: the jump of the stiffness times the square of the change of the distance since the last level.
  /// The time step keeps an eighth of it small, which is the error of the energy (K.48).
  double kink_energy = 0.0;
};

/// Layers met: a gap reached 0. A stiffer contact or a shorter step prevents that.
class GapError : public ContactError {
 public:
  /// `motion` [m]: see motion().
  GapError(const std::string& message, const SkinPair& pair, double motion)
      : ContactError(message), pair_(pair), motion_(motion) {}
  const SkinPair& pair() const { return pair_; }  // the parts that met
  double motion() const { return motion_; }       // [m] relative to each other since the last level

 private:
  SkinPair pair_;
  double motion_;
};

/// A node that sticks to a layer or slides on it.
struct SkinBristle {
  int node;           // that sticks
  int side;           // of the node: 0 or 1
  int triangle;       // of the layer
  int unused = 0;     // no hole: states are compared as bytes
  double stretch[3];  // [m] tangential, of the node against the element
};

/// What the levels to come depend on beside their positions.
struct SkinContactRecord {
  long level = -1;                         // number of the last one; -1: none
  long looks = 0;                          // distances computed
  long sweeps = 0;                         // paths tested
  Eigen::Matrix3Xd nodes;                  // [m] at the last level
  std::vector<double> node_limits;         // [m]
  std::vector<double> edge_limits;         // [m]
  std::vector<SkinBristle> bristles = {};  // in the order in which their energies are summed
};

/// Workspace of one run, made by SkinContactModel::make_state. It holds what the energy depends on beside the
/// positions, the limits of nodes and edges and the stretch of friction; the rest saves work.
class SkinContactState {
 public:
  SkinContactState(const SkinContactState& other);                 // copies go on by themselves
  SkinContactState(SkinContactState&& other) noexcept;             // leaves `other` without a run
  SkinContactState& operator=(const SkinContactState& other);      // likewise a copy
  SkinContactState& operator=(SkinContactState&& other) noexcept;  // likewise a move
  ~SkinContactState();                                             // ends the run

  int limited_nodes() const;         // nodes whose limit is below h
  double smallest_limit() const;     // [m] of a node
  long looks() const;                // counter: distances computed
  long sweeps() const;               // counter: paths tested
  SkinContactRecord record() const;  // for make_state()

 private:
  friend class SkinContactModel;
  explicit SkinContactState(std::unique_ptr<detail::SkinRun> run);
  std::unique_ptr<detail::SkinRun> run_;
};

/// Penalty contact of a skin with itself. Immutable.
class SkinContactModel {
 public:
  /// `triangles` (3 x M) are the skin's elements, `reference` (3 x N) [m] its stress-free shape, `masses` (N)
  /// [kg] are lumped.
  ///
  /// Throws std::invalid_argument for values out of range, node numbers that do not exist, elements without
  /// area, and a thickness above the smallest altitude of an element.
  SkinContactModel(const Triangles& triangles, const Nodes& reference, std::span<const double> masses,
                   const SkinContactParameters& parameters);

  /// A state without a last level. `every_pair`: each level computes all distances, which costs M^2; the
  /// forces have the same bits.
  SkinContactState make_state(bool every_pair = false) const;
  /// A state that goes on with the same bits as the one that was recorded. Throws std::invalid_argument for a
  /// record of another model.
  SkinContactState make_state(const SkinContactRecord& record) const;

  /// Adds the forces at `nodes` (3 x N) [m] to `forces`, and returns the result. Calls with one state belong
  /// to successive levels; the first one sets the limits.
  ///
  /// Throws ContactError if a coordinate is not finite, GapError if parts meet on straight paths from the
  /// last level, or at the first one; std::invalid_argument for a state of another model or wrong sizes.
  /// After an exception `forces` and the state must not be used.
  SkinContactResult evaluate(SkinContactState& state, const Nodes& nodes, NodalForces forces) const;

  /// Bound [1/s2] with both sides of the whole skin in contact (K.46).
  double full_omega_squared() const;
  const SkinContactParameters& parameters() const { return parameters_; }  // the parameters as given
  int node_count() const;                                                  // N, nodes of the skin

 private:
  SkinContactParameters parameters_;
  std::shared_ptr<const detail::SkinParts> parts_;
};

/// Largest stiffness [N/m3] whose bound, both sides of the skin in contact, is that share of
/// `other_omega_squared` [1/s2] for a skin of `surface_density` [kg/m2]: share omega^2 rho h / 4 (K.46),
/// without friction. Throws std::invalid_argument for a value out of range.
double default_skin_stiffness(double share, double other_omega_squared, double surface_density);

}  // namespace coupling
