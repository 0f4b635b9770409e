// SPDX-License-Identifier: Apache-2.0
// Stage S6: overpressure of a jet on the elements of a surface, and the elements it can reach.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "jet/jet.hpp"
#include "jet/outlet.hpp"
#include "jet/views.hpp"

namespace jet {

struct JetShape;

/// Result and workspace of S6. JetField::make_state makes it once for this field. It is then reused, and no
/// step allocates.
struct FieldState {
  std::vector<double> overpressure;  // [Pa] M, dp of each element; 0 off the candidates
  /// Elements inside the jet that face it, within the cut-off; ascending.
  std::vector<int> candidates;
  double restitution = 1.0;  // [-] e, at first the model's; the caller may change it, in [-0.5, 4]
  double displacement_bound = kMotionUnknown;  // [m] of the last call
  double size_ratio = 1.0;                     // [-] R or b of the last outlet's jet over R0 or b0
  double outline_motion = 0.0;                 // [m] sum of how far the cut-off has moved by that
  /// One byte for each group of four elements. A bit is set if the element is inside the jet and can take
  /// load.
  std::vector<std::uint8_t> inside{};
  /// [m] one for each group: `inside` is valid while displacement_bound is below it.
  std::vector<double> slack{};
  std::vector<int> selected{};  // workspace: choice of candidates, elements needed
};

/// Field of one jet over a surface of M elements. Const after construction.
class JetField {
 public:
  /// `null_elements` take no load. Throws std::invalid_argument for a model that fails validated(), an empty
  /// surface, and an element index out of range.
  JetField(const JetModel& model, int element_count, std::span<const int> null_elements = {});

  /// The field of the same jet at another place; `long_direction` as in JetModel. States of this field serve
  /// it if their displacement_bound is set to kMotionUnknown. Throws as the constructor.
  JetField placed(const Eigen::Vector3d& centre, const Eigen::Vector3d& axis,
                  const Eigen::Vector3d& long_direction) const;

  const JetModel& model() const { return model_; }  // the model, with axis and long direction normalised
  FieldState make_state() const;                    // sized for the surface, all zero

  /// Elements whose columns the next evaluate() with the same outlet and bound will read, in no order. Other
  /// columns may hold any numbers. Valid until that call. Throws std::invalid_argument for another field's
  /// state, and DomainError for an outlet or a restitution that evaluate() refuses.
  std::span<const int> needed(const OutletState& outlet, double displacement_bound, FieldState& state) const;

  /// Computes the overpressure dp = (1 + e V0/V) rho max(V . n, 0)^2 (J.6), with V at the centroid, n the
  /// unit vector of the area vector, and V0/V = outlet.reflected. The jet is as wide as widened() has it.
  /// `area_vectors` [m2] and `centroids` [m] are 3 x M and outward.
  ///
  /// A candidate has V . n > 0 and an area > 0. Its centroid lies strictly downstream of the outlet's plane
  /// (z > 0) and within the cut-off. Without flow (density or velocity 0) there is no candidate.
  ///
  /// `velocities` [m/s], 3 x M, are the centroids' velocities; they are used if the model has
  /// relative_to_skin. Then dp = (1 + e V0/V) rho max(V . n - v . n, 0)^2, and candidates have V . n > v . n
  /// as well.
  ///
  /// `displacement_bound` [m] grows between two calls by at least the motion of every centroid. Elements that
  /// cannot have crossed a bound of the jet are then skipped; the results are the same. Without it, and
  /// whenever it decreases, all elements are examined.
  ///
  /// Throws std::invalid_argument for a wrong shape or missing velocities, and DomainError if the outlet's
  /// velocity or density is negative or not finite, its ratios are not above 0, the restitution is outside
  /// [-0.5, 4], or the overpressure of a candidate is not finite.
  void evaluate(const Points& area_vectors, const Points& centroids, const OutletState& outlet,
                FieldState& state, const Points* velocities = nullptr,
                double displacement_bound = kMotionUnknown) const;

 private:
  void set_model(const JetModel& model);
  void take_no_load(int element);
  void require_own(const FieldState& state) const;
  void widen(const OutletState& outlet, FieldState& state) const;

  JetModel model_;
  std::shared_ptr<const JetShape> shape_;  // copies share it
  int element_count_;
  std::vector<std::uint8_t> loaded_;  // bits of groups of four elements: take load
};

/// Last part of S7: sets dp of candidates[k] to zero where lit[k] is 0. Throws std::invalid_argument unless
/// lit has one entry per candidate.
void apply_mask(std::span<const std::uint8_t> lit, FieldState& state);

/// Force of the jet on the surface [N]: the sum of dp_e S_e over the candidates. Throws std::invalid_argument
/// unless there is one area vector per element.
Eigen::Vector3d jet_force(const FieldState& state, const Points& area_vectors);

/// Rate at which a jet relative to the skin damps it, at most (J.9) [1/s]: the largest
/// 2 sqrt((1 + e V0/V) rho dp_e) |S_e| / m_e of a candidate; 0 without relative_to_skin. `masses` [kg] are
/// those of the elements. Throws std::invalid_argument unless there is one area vector and one mass per
/// element.
double damping_rate(const JetModel& model, const OutletState& outlet, const FieldState& state,
                    const Points& area_vectors, std::span<const double> masses);

}  // namespace jet
