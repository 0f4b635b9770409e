// SPDX-License-Identifier: Apache-2.0
// A jet of a C caller: its model, the caller's surface, and the elements that a call asks for.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "jet/field.hpp"
#include "jet/subdivision.hpp"
#include "jet/visibility.hpp"
#include "skin_object.hpp"

namespace border {

/// Input of one call.
struct JetCall {
  const Points::View* nodes = nullptr;       // [m]
  const Points::View* velocities = nullptr;  // [m/s] of the nodes, or null
  jet::OutletState outlet;
  bool occlusion = true;
  double displacement_bound = jet::kMotionUnknown;  // [m]
  /// Elements asked for, or nothing: all. In range; a number that occurs twice is refused.
  std::optional<std::span<const int>> elements;
};

/// Result of one call.
struct JetLoad {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // [N] on the elements asked for
  double power = 0.0;                               // [W] done on them; 0 without velocities
  jet::VisibilityCounters counters;
};

/// The elements of a call that can take load, in the caller's order, with all that is computed on them.
class AskedElements {
 public:
  /// `asked` as in JetCall; `loaded` has a byte for each element of the surface, 0 if it takes no load. `cut`
  /// is the whole surface in pieces, or null.
  AskedElements(const JetCall& call, const Skin& skin, std::span<const std::uint8_t> loaded,
                const jet::Subdivision* cut, const jet::JetModel& model);

  /// True if a call asks for the same elements.
  bool serves(const JetCall& call) const;
  /// The outlet moved to where `model` has it.
  void place(const jet::JetModel& model);
  /// Field without shadows. `points` are those that `cut` has in place of the nodes.
  void evaluate(const JetCall& call, const jet::Points& points, const jet::Subdivision* cut,
                double restitution);
  /// Sets the load of what the source does not see to 0.
  jet::VisibilityCounters hide(const JetCall& call, const jet::Points& points, const jet::RaySource& source,
                               jet::VisibilityQuery& query);
  /// Writes the overpressure of each element asked for, and sums it up.
  JetLoad write(const JetCall& call, const jet::Subdivision* cut, std::span<double> overpressure);

 private:
  void measure(const JetCall& call, const jet::Points& points, const jet::Subdivision* cut);
  double reach() const;

  std::optional<std::vector<int>> list_;  // as it was asked
  std::vector<int> places_;               // in the list, of those that can take load
  Eigen::Matrix3Xi corners_;              // their nodes
  std::vector<int> pieces_;               // what the query calls their pieces; the elements if there are none
  Eigen::Matrix3Xi piece_corners_;
  std::optional<jet::JetField> field_;  // nothing if no element can take load
  jet::FieldState state_, whole_;       // of pieces, of elements if they have pieces
  Eigen::Matrix3Xd area_vectors_, velocities_, piece_area_vectors_, piece_velocities_, centroids_;
  /// Largest distance [m] of a centroid from the outlet when it was last measured, with the nodes' bound and
  /// the outlet's centre then.
  struct Extent {
    double farthest = 0.0, bound = 0.0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  } extent_;
  std::vector<int> candidates_;  // of the query
  std::vector<std::uint8_t> lit_;
};

/// Outlet, surface and switches.
class Jet : public Object {
 public:
  Jet(const jet::JetModel& model, Skin given);

  static constexpr const char* name = "a jet";
  static constexpr bool shared = false;

  /// Moves the outlet. Throws as jet::validated.
  void place(const Eigen::Vector3d& centre, const Eigen::Vector3d& axis,
             const Eigen::Vector3d& long_direction);
  /// One byte for each element: 0 takes it out of the surface.
  void set_elements(std::span<const std::uint8_t> on);
  /// Cuts each element into n^2 pieces. Throws as jet::Subdivision.
  void subdivide(int n);
  /// Whether the velocity of the skin counts in the overpressure.
  void set_relative(bool relative);
  /// Writes the overpressure of each element asked for. Throws jet::DomainError as jet::JetField does.
  JetLoad load(const JetCall& call, std::span<double> overpressure);

  const jet::JetModel& model() const { return model_; }  // where the outlet is now
  Skin skin;
  double area_ratio = 1.0, reflected = 1.0;      // [-] of the notional nozzle
  double restitution;                            // [-]
  std::vector<double> node_copy, velocity_copy;  // of a caller with single precision

 private:
  void leave_out(jet::VisibilityQuery& query, const jet::Subdivision* cut) const;
  std::span<const std::uint8_t> loaded();

  jet::JetModel model_;
  std::vector<std::uint8_t> on_, loaded_;
  std::optional<jet::Subdivision> cut_;  // on the numbers of skin.named
  jet::VisibilityQuery query_;
  Eigen::Matrix3Xd own_nodes_, points_;  // workspace with pieces: skin.named, nodes of the pieces
  std::optional<AskedElements> asked_;
};

}  // namespace border
