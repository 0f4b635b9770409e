// SPDX-License-Identifier: Apache-2.0
// Stage S4: overpressure of a jet on the elements of a surface, and the elements it can reach.
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

/// What S4 writes. Made once by JetField::make_state, for this field, then reused: no allocation in a step.
struct FieldState {
  std::vector<double> overpressure;  // [Pa] M, dp of each element; zero off the candidates
  std::vector<int> candidates;       // elements inside the jet, facing it, above the cut-off; ascending
  double displacement_bound = kMotionUnknown;  // [m] as of the last call
  std::vector<std::uint8_t> inside{};  // bits of groups of four elements: inside the jet, and take load
  std::vector<double> slack{};         // [m] by group: they stay so while displacement_bound is below
  std::vector<int> selected{};         // workspace of the choice of candidates
};

/// Field of one jet over a surface of M elements. Const after construction.
class JetField {
 public:
  /// `null_elements` take no load. Throws std::invalid_argument as validated(JetModel), for an empty surface
  /// and for an element index out of range.
  JetField(const JetModel& model, int element_count, std::span<const int> null_elements = {});

  ~JetField();
  JetField(JetField&&) noexcept;
  JetField& operator=(JetField&&) noexcept;

  const JetModel& model() const { return model_; }  // with axis and long direction normalised
  FieldState make_state() const;                    // sized for the surface, all zero

  /// Overpressure dp = (1 + e) rho0 max(V . n, 0)^2 (J.6), V at the centroid, n the unit vector of the area
  /// vector. `area_vectors` [m2] and `centroids` [m], 3 x M, outward. A candidate has V . n > 0 and an
  /// area > 0, and its centroid lies strictly downstream of the outlet's plane (z > 0) and within the
  /// cut-off. Without flow (density or velocity 0) there is none. `displacement_bound` [m]: between two calls
  /// no centroid moves farther than it grows by. Elements that cannot have crossed a bound of the jet are not
  /// looked at; the results are the same. Without it, and whenever it decreases, all are looked at.
  /// `velocities` [m/s] 3 x M of the elements' centroids is read if the model says relative_to_skin: then
  /// dp = (1 + e) rho0 max(V . n - v . n, 0)^2, and candidates have V . n > v . n as well. Throws
  /// std::invalid_argument on a wrong shape, where velocities are missing; DomainError where a candidate's
  /// overpressure is not finite.
  void evaluate(const Points& area_vectors, const Points& centroids, const OutletState& outlet,
                FieldState& state, const Points* velocities = nullptr,
                double displacement_bound = kMotionUnknown) const;

 private:
  void take_no_load(int element);
  void reset(FieldState& state) const;

  JetModel model_;
  std::unique_ptr<const JetShape> shape_;
  int element_count_;
  std::vector<std::uint8_t> loaded_;  // bits of groups of four elements: take load
};

/// Stage S5's last line: dp of candidates[k] is set to zero where lit[k] is 0.
/// Throws std::invalid_argument unless lit has one entry a candidate.
void apply_mask(std::span<const std::uint8_t> lit, FieldState& state);

/// Force of the jet on the surface [N]: sum over the candidates of dp_e S_e. Throws std::invalid_argument
/// unless there is one area vector an element.
Eigen::Vector3d jet_force(const FieldState& state, const Points& area_vectors);

}  // namespace jet
