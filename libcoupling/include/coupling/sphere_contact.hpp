// SPDX-License-Identifier: Apache-2.0
// Contact of a rigid impactor (impactor.hpp) with a triangulated skin. Its energy is an integral over the
// skin's reference area, so the force for a penetration converges with the mesh:
//   (K.10) E = sum_q w_q kappa (r - d_q)^2 / 2 over quadrature points with d_q = |x_q - c| < r.
// For another shape, r - d_q is the depth below its surface (K.49), and r its size.
// The points are the centroids of n x n sub-triangles. The constructor chooses n for each element so that the
// longest reference edge / n <= r/4. E depends on positions only, so the forces f_a = -dE/dx_a (K.11) are
// conservative.
//
// Friction (K.16) is Coulomb's, regularised: a sticking point stretches elastically until mu times the
// pressure is reached. Its tangential stiffness equals the normal one.
//
// The skin has no thickness. The body stays on its side of the skin: see side.hpp.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "coupling/element_groups.hpp"
#include "coupling/error.hpp"
#include "coupling/impactor.hpp"
#include "coupling/skin.hpp"

namespace coupling {

namespace detail {
struct Grip;
}

/// Parameters of the contact.
struct ContactParameters {
  Impactor impactor;  // shape
  /// [N/m3] kappa > 0: pressure per penetration. The peak force grows with its square root (K.23).
  double stiffness;
  double friction = 0.0;  // [-] mu >= 0
};

/// Result of one evaluation. The moment of the forces on the sphere about a point P is (c - P) x
/// force + couple.
struct ContactResult {
  /// [N] on the sphere; the forces on the nodes sum to its negative.
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  /// [N m] about the centre: of friction only on a sphere, of all forces on another shape (K.51).
  Eigen::Vector3d couple = Eigen::Vector3d::Zero();
  double energy = 0.0;                // [J] including the stretch of sticking points
  double friction_loss = 0.0;         // [J] lost since the last level (K.17)
  double area = 0.0;                  // [m2] reference area of the points in contact
  double penetration = 0.0;           // [m] largest r - d_q; 0 if nothing touches
  int deepest_element = -1;           // element of the penetration; -1 if nothing touches
  double omega_squared_skin = 0.0;    // [1/s2] (K.12) max_a sum_q w_q kappa N_a(q) / m_a
  double omega_squared_sphere = 0.0;  // [1/s2] (K.12) sum_q w_q kappa / m_eff
  /// Upper bound of the contact's omega^2 [1/s2] (K.12). Add it to the other stiffness terms of the step.
  double omega_squared() const { return omega_squared_skin + omega_squared_sphere; }
};

/// A quadrature point in contact that sticks or slides.
struct Bristle {
  int element;              // element number
  int point;                // number in the element's quadrature
  Eigen::Vector3d stretch;  // [m] tangential stretch of the skin against the sphere
  double weight;            // [m2]
};

/// Workspace of one run, made by ContactModel::make_state for this model and its copies only. Without
/// friction all of it is a cache, which saves work and allows tests of the centre's path: results depend on
/// nodes and centre only, bit for bit. With friction they also depend on the history in `bristles`.
struct ContactState {
  std::shared_ptr<const ElementGroups> owner;        // groups of the model that made the state; evaluate()
                                                     // throws if there are none
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // [m] at the last call
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();    // of the body at the last call
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();   // [m] motion of the centre in the last call
  Eigen::Matrix3Xd nodes;                            // (3 x N) [m] at the last call, if `kept`
  /// True if the next level may need `nodes`.
  bool kept = false;
  bool started = false;  // false: there is no last call
  /// [m] Bound of the relative motion since the first call.
  double displacement_bound = 0.0;
  /// [m] motion since the last level, as passed to stays_clear.
  double told = kNotTold;
  double ahead = 0.0;  // [m] bound of the next level's motion
  /// [m] `ahead` of the last level; nodes are not kept if it is short enough.
  double expected = 0.0;
  /// [m] least slack: nothing touches while displacement_bound is below this.
  double gap = 0.0;
  std::vector<double>
      /// (M) [m] by place in the groups: the element cannot touch while displacement_bound is below this.
      slack;
  /// (groups) [m] lower bound of each group's least slack.
  std::vector<double> group_slack;
  std::vector<int> near;  // elements that overlap the sphere, ascending
  /// An element within `ahead` at the last level with such an element.
  int nearest = 0;
  std::vector<double> nodal_stiffness;  // (N) [N/m] 0 between calls
  std::vector<Bristle> bristles;        // bristles of the last call, by element and point
  std::vector<Bristle> old_bristles;    // bristles of the call before
  int looks = 0;                        // counter: elements whose gap was computed
  int skips = 0;                        // counter: levels certain to have no contact
  int sweeps = 0;                       // counter: swept tests of the whole skin

  /// Value of `told` if no motion was passed.
  static constexpr double kNotTold = std::numeric_limits<double>::quiet_NaN();
};

/// Penalty contact of a rigid body with the skin (K.11), and the bound of its stiffness (K.12). Immutable.
class ContactModel {
 public:
  /// `triangles` (3 x M) are the skin's elements; `reference` (3 x N) [m] is its stress-free or current
  /// shape; `masses` (N) [kg] are lumped; `effective_mass` [kg] is that of the sphere's centre along its path
  /// (K.3), or the least of any point of another body.
  /// `open_elements` close a hole: they exert no force, but the sphere's centre must not cross them.
  ///
  /// Throws std::invalid_argument for values out of range, node or element numbers that do not exist,
  /// elements without area, and a subdivision above kMaxSubdivision.
  ContactModel(const Triangles& triangles, const Nodes& reference, std::span<const double> masses,
               double effective_mass, const ContactParameters& parameters,
               std::span<const int> open_elements = {});

  ContactState make_state() const;  // a state with all that evaluate() needs

  /// S4: adds the contact forces (K.11) to `forces` at touched nodes only, and returns the result for the
  /// body at `pose`. Does not allocate. `turn` [rad] is the body's rotation since the last call; only
  /// friction uses it.
  ///
  /// Calls with one state belong to successive levels. Between two calls the centre and all skin points are
  /// assumed to move on straight lines at constant speed. The centre must not meet the skin (K.15). Set
  /// state.started to false to start again.
  ///
  /// Throws ContactError, naming the element, if
  /// - the penetration exceeds half the body's size, r/2 for a sphere (K.24),
  /// - a sphere's centre crosses the skin, or another body may have crossed it: the relative motion,
  /// including
  ///   the body's rotation, exceeds the gap before it plus the size,
  /// - a coordinate is not finite (all are read, unless stays_clear got the motion).
  ///
  /// Throws std::invalid_argument for a state of another model, for wrong sizes, for axes that are not
  /// orthonormal, and for a turn that is not finite; the state is then unchanged. After an exception `forces`
  /// must not be used.
  ContactResult evaluate(ContactState& state, const Nodes& nodes, const Pose& pose, NodalForces forces,
                         const Eigen::Vector3d& turn = Eigen::Vector3d::Zero()) const;

  /// True if certainly nothing touches at this level, so that `evaluate` need not be called. The answer costs
  /// one comparison. It is `false` at the first level, and when the motion since may exceed the last gap.
  ///
  /// `motion` [m] bounds how far skin points and body have moved relative to each other since the last level:
  /// speeds of the skin plus those of any point of the body. A sphere's rotation does not count. After the
  /// answer `false`, `evaluate` uses it; without this call `evaluate` measures the motion of every node.
  ///
  /// `ahead` [m] > 0 bounds the next level's motion; 0: not known. Positions are kept from level to level
  /// only if a path over such a motion may need a test. Without them `evaluate` throws std::invalid_argument
  /// for a level that was not passed to this function, and ContactError for a longer motion that may have
  /// crossed the skin.
  ///
  /// Throws std::invalid_argument for a state of another model.
  bool stays_clear(ContactState& state, double motion, double ahead = 0.0) const;

  /// Lower bound [m] of the relative motion before anything touches; 0 in touch.
  static double free_gap(const ContactState& state) {
    return std::max(0.0, state.gap - state.displacement_bound);
  }

  /// Bound (K.12) [1/s2] with the whole skin in contact: omega_squared_skin never exceeds it. (A step that
  /// suits the points now in contact may be too long for the points that it brings into contact.)
  double full_omega_squared() const { return full_omega_squared_; }

  const ContactParameters& parameters() const { return parameters_; }        // the parameters as given
  int element_count() const { return static_cast<int>(triangles_.cols()); }  // M, elements of the skin
  int node_count() const { return static_cast<int>(masses_.size()); }        // N, nodes of the skin
  /// Subdivision n of the element, which is loaded at n^2 points. Precondition: 0 <= element < M.
  int subdivision(int element) const { return quadrature_[static_cast<std::size_t>(element)].subdivision; }

  static constexpr int kMaxSubdivision = 512;  // largest n; the constructor throws for more

 private:
  template <class Body>
  ContactResult evaluate_body(const Body& body, ContactState& state, const Nodes& nodes, const Pose& pose,
                              NodalForces& forces, const Eigen::Vector3d& turn) const;
  template <class Body>
  void follow(const Body& body, ContactState& state, const Nodes& nodes, const Pose& pose) const;
  void keep(double size, ContactState& state, const Nodes& nodes) const;
  void aim(int element, const ContactState& state, const Nodes& nodes, detail::Grip& grip) const;
  template <class Body>
  void add_element(const Body& body, int element, detail::Grip* grip, ContactState& state, const Nodes& nodes,
                   NodalForces& forces, ContactResult& result) const;
  void bound_stiffness(ContactState& state, ContactResult& result) const;
  double full_omega_squared_of_skin() const;

  // Quadrature of an element.
  struct Quadrature {
    double weight;    // [m2] reference area of one sub-triangle
    int subdivision;  // n
  };
  Eigen::Matrix3Xi triangles_;
  std::shared_ptr<const ElementGroups> groups_;  // shared by copies, so that their states are, too
  std::vector<Quadrature> quadrature_;           // (M)
  std::vector<double> masses_;                   // (N) [kg]
  double effective_mass_;                        // [kg]
  double full_omega_squared_ = 0.0;
  ContactParameters parameters_;
};

/// Input of default_contact_stiffness. All members are finite and > 0; friction may be 0.
struct StiffnessBudget {
  /// [-] Share of other_omega_squared that contact may add to the step's bound.
  double share;
  double other_omega_squared;  // [1/s2] smallest bound of the other terms over the run
  double surface_density;      // [kg/m2] least rho h of the skin
  Impactor impactor;           // shape
  double effective_mass;       // [kg] of the sphere (K.3)
  double friction = 0.0;       // [-]
};

/// Largest contact stiffness [N/m3] whose omega^2, (K.12) plus the force's rotation (K.8), stays within that
/// share (K.13). The bound holds for one layer of skin on the sphere, down to the depth r/2: lumped masses
/// give sum_q w_q N_a / m_a <= 1/(rho h), and the contact area is at most 3/4 of the
/// impactor's largest section. Throws
/// std::invalid_argument for a value out of range.
double default_contact_stiffness(const StiffnessBudget& budget);

}  // namespace coupling
