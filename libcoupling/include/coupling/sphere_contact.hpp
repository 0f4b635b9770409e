// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "coupling/element_groups.hpp"
#include "coupling/error.hpp"
#include "coupling/skin.hpp"

namespace coupling {

namespace detail {
struct Grip;
}

// Contact of a rigid sphere with a triangulated skin, by an energy that is an integral over the skin's
// reference area, so that force against penetration converges with the mesh:
//   (K.10) E = sum_q w_q kappa (r - d_q)^2 / 2 over quadrature points with d_q = |x_q - c| < r.
// Points sit at the centroids of n x n sub-triangles; n is chosen per element at build so that the longest
// reference edge / n <= r/4. E depends on positions only: the forces (K.11) f_a = -dE/dx_a are conservative.
// Friction (K.16) is Coulomb's, regularised by sticking points that stretch elastically, as stiff across the
// normal as along it, until mu times the pressure is reached.
// The skin has no thickness and the sphere stays on the side of the skin where it is: see side.hpp.

struct ContactParameters {
  double sphere_radius;   // [m] r > 0
  double stiffness;       // [N/m3] kappa > 0: pressure per penetration; peaks follow its root (K.23)
  double friction = 0.0;  // [-] mu >= 0
};

// One evaluation. The moment of the forces on the sphere about any point P is (c - P) x force + couple.
struct ContactResult {
  Eigen::Vector3d force =
      Eigen::Vector3d::Zero();  // [N] on the sphere; the nodes' forces sum to its negative
  Eigen::Vector3d couple = Eigen::Vector3d::Zero();  // [N m] about the centre, of the friction alone
  double energy = 0.0;                               // [J] stretch of sticking points included
  double friction_loss = 0.0;                        // [J] (K.17) since the last level
  double area = 0.0;                                 // [m2] reference area of the points that touch
  double penetration = 0.0;                          // [m] largest r - d_q, 0 when nothing touches
  int deepest_element = -1;                          // -1 when nothing touches
  double omega_squared_skin = 0.0;                   // [1/s2] (K.12) max_a sum_q w_q kappa N_a(q) / m_a
  double omega_squared_sphere = 0.0;                 // [1/s2] (K.12) sum_q w_q kappa / m_eff
  // (K.12) Upper bound of the contact's omega^2: add it to the other stiffness terms of the step.
  double omega_squared() const { return omega_squared_skin + omega_squared_sphere; }
};

// A quadrature point that sticks or slides.
struct Bristle {
  int element;              // its number
  int point;                // of the element's quadrature
  Eigen::Vector3d stretch;  // [m] of the skin against the sphere, tangential
  double weight;            // [m2]
};

// Work arrays of one run; make one by ContactModel::make_state. Everything in it is a cache: results depend
// on nodes and centre alone, bit for bit; what it carries from call to call only makes them cheap, and lets
// the centre's path be tested. With friction, `bristles` are a history that the results do depend on.
struct ContactState {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // [m] at the last call
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();   // [m] of the centre up to the last call
  Eigen::Matrix3Xd nodes;                            // (3 x N) [m] at the last call, if kept
  bool kept = false;                                 // a step may come that needs them
  bool started = false;                              // false: no last call
  double displacement_bound = 0.0;                   // [m] bound of the relative motion since the first call
  double told = kNotTold;                            // [m] motion since the last level, by stays_clear
  double ahead = 0.0;                                // [m] motion that has to fit into the gap
  double expected = 0.0;  // [m] that of the last level, without which nodes are kept
  double gap = 0.0;       // [m] nothing touches while displacement_bound is below: least slack
  std::vector<double>
      slack;  // (M) [m] by place in the groups: cannot touch while displacement_bound is below
  std::vector<double> group_slack;      // (groups) [m] least of each, or less
  std::vector<int> near;                // elements that overlap the sphere, ascending
  int nearest = 0;                      // an element within `ahead` at the last level that had one
  std::vector<double> nodal_stiffness;  // (N) [N/m] zero between calls
  std::vector<Bristle> bristles;        // by element and point; of the last call
  std::vector<Bristle> old_bristles;    // and of the one before it
  int looks = 0;                        // counter: elements whose gap was computed
  int skips = 0;                        // counter: levels that were certain to be idle
  int sweeps = 0;                       // counter: swept tests of the whole skin

  // Of `told`.
  static constexpr double kNotTold = std::numeric_limits<double>::quiet_NaN();
};

// Penalty contact of a sphere with the skin, (K.11), and the bound of its stiffness, (K.12). Immutable.
class ContactModel {
 public:
  // triangles: (3 x M) of the skin; reference: (3 x N) [m] stress-free shape, or the
  // current one; masses: (N) [kg] lumped; effective_mass: [kg] of the sphere along its path (K.3).
  // open_elements close a hole: they push nothing, but the sphere's centre must not cross them either.
  // Throws std::invalid_argument (values, node and element numbers, elements without area, more than
  // kMaxSubdivision).
  ContactModel(const Triangles& triangles, const Nodes& reference, std::span<const double> masses,
               double effective_mass, const ContactParameters& parameters,
               std::span<const int> open_elements = {});

  ContactState make_state() const;  // with all that evaluate() needs

  // S7: adds the contact forces (K.11) to `forces` for touched nodes only and returns the sphere's side.
  // Calls of one state belong to successive levels: between the last call and this one the centre and every
  // skin point are taken to move on straight lines at constant speed, and the centre must not meet the skin
  // (K.15). Set state.started = false to begin anew. No allocation. Throws ContactError, naming the element,
  // when the penetration exceeds r/2 (K.24), when the centre crosses the skin and when a coordinate is not
  // finite (all are looked at unless stays_clear was told the motion); `forces` are then not to be used.
  // `turn` [rad] is the sphere's rotation since the last call; only friction feels it. Not finite:
  // std::invalid_argument, and the state stays as it is.
  ContactResult evaluate(ContactState& state, const Nodes& nodes, const Eigen::Vector3d& centre,
                         NodalForces forces, const Eigen::Vector3d& turn = Eigen::Vector3d::Zero()) const;

  // Is it certain that nothing touches at this level, which needs no call of `evaluate` then? `motion` [m]
  // bounds how far skin points and centre have moved relative to each other since the last level; if the
  // answer is `false`, the call of `evaluate` takes it from here, else it measures the motion of every node.
  // The answer costs a comparison; it is `false` at the first level and whenever the gap last seen may be
  // used up. `ahead` [m] > 0 bounds the next level's motion, 0 says nothing of it: positions are kept from
  // level to level only where a path may need testing over such a motion. Without them `evaluate` refuses a
  // level that was not asked about here (std::invalid_argument), and a longer motion that may have crossed
  // the skin.
  bool stays_clear(ContactState& state, double motion, double ahead = 0.0) const;

  // Lower bound of the relative motion before anything touches [m]; 0 in touch.
  static double free_gap(const ContactState& state) {
    return std::max(0.0, state.gap - state.displacement_bound);
  }

  // (K.12) with the whole skin in touch: the bound of every level's omega_squared_skin [1/s2]. A step that
  // the points now in touch allow is too long for those that it brings into touch.
  double full_omega_squared() const { return full_omega_squared_; }

  const ContactParameters& parameters() const { return parameters_; }        // as given
  int element_count() const { return static_cast<int>(triangles_.cols()); }  // M of the skin
  int node_count() const { return static_cast<int>(masses_.size()); }        // N of the skin
  // n: the element is loaded at n^2 points. Precondition: 0 <= element < M.
  int subdivision(int element) const { return subdivision_[static_cast<std::size_t>(element)]; }

  static constexpr int kMaxSubdivision = 512;  // of an element, else the constructor throws

 private:
  void follow(ContactState& state, const Nodes& nodes, const Eigen::Vector3d& centre) const;
  void keep(ContactState& state, const Nodes& nodes) const;
  void aim(int element, const ContactState& state, const Nodes& nodes, detail::Grip& grip) const;
  void add_element(int element, detail::Grip* grip, ContactState& state, const Nodes& nodes,
                   NodalForces& forces, ContactResult& result) const;
  void bound_stiffness(ContactState& state, ContactResult& result) const;
  double full_omega_squared_of_skin() const;

  Eigen::Matrix3Xi triangles_;
  ElementGroups groups_;
  std::vector<double> weights_;   // (M) [m2] reference area of one sub-triangle
  std::vector<int> subdivision_;  // (M) n
  std::vector<double> masses_;    // (N) [kg]
  double effective_mass_;         // [kg]
  double full_omega_squared_ = 0.0;
  ContactParameters parameters_;
};

// What the default stiffness follows from; all > 0 and finite but friction, which may be 0.
struct StiffnessBudget {
  double share;                // [-] of other_omega_squared that contact may add to the step's bound
  double other_omega_squared;  // [1/s2] of the other terms, a lower bound of it over the run
  double surface_density;      // [kg/m2] rho h, the least of the skin
  double sphere_radius;        // [m]
  double effective_mass;       // [kg] of the sphere (K.3)
  double friction = 0.0;       // [-]
};

// (K.13) The largest contact stiffness [N/m3] whose omega^2, (K.12) with the turning of its force (K.8),
// stays within that share wherever one layer of skin lies on the sphere, down to the depth r/2: lumped masses
// give sum_q w_q N_a / m_a <= 1/(rho h), and the patch is at most 3/4 pi r^2. Throws std::invalid_argument.
double default_contact_stiffness(const StiffnessBudget& budget);

}  // namespace coupling
