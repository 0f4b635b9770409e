// SPDX-License-Identifier: Apache-2.0
// Folded start shapes: a thin pack of fabric is folded over lines, one after the other (M.60).
#pragma once

#include <array>
#include <vector>

#include "mesh/mesh.hpp"

namespace mesh {

/// Direction through the thickness of a pack: along an axis (0 x, 1 y, 2 z), upwards (+1) or downwards (-1).
/// Flaps are laid on the pack's side in this direction.
struct PackSide {
  int axis = 0;       // 0 x, 1 y, 2 z
  double sign = 1.0;  // +1 or -1
};

/// The axis along which the nodes have the least extent, away from the fixed nodes (upwards without any).
PackSide thin_side(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes, const std::vector<int>& fixed);

/// How the panels between fold lines come to lie.
enum class FoldType {
  letter,     // one flap of each side, laid over the pack in the order of `at`
  accordion,  // panels of equal or falling width, to and fro
  roll        // the outermost panel is laid over the next one, both over the next one, and so on
};

/// One fold, over one or more parallel lines.
struct FoldOptions {
  FoldType type = FoldType::letter;  // order of the panels
  int axis = 2;                      // across the fold lines: 0 x, 1 y, 2 z
  std::vector<double> at;            // [m] coordinates of the fold lines along `axis`, each once
  double gap = 0.0;                  // [m] least distance between layers that a fold brings together, > 0
  /// Transition from gathered to free fabric, in element lengths, 0 to 10. A transition of 0 stretches
  /// elements by a tenth or more if they have no sides along the fold line. It is used where it stretches
  /// none.
  double easing = 2.0;
};

/// What a fold over one line took.
struct FoldLine {
  double at = 0.0;       // [m] coordinate of the line
  double height = 0.0;   // [m] height of the folded pack's bend, outermost layer
  double reach = 0.0;    // [m] fabric within this distance of the line is gathered in the bend
  double element = 0.0;  // [m] longest extent across the line of the elements that cross it
  bool eased = false;    // with `easing`
};

/// A bag that is folded step by step. Nodes and elements keep their numbers.
///
/// The fabric beyond a line is mirrored at the line and at a plane, so that it comes to lie above everything
/// there with the gap between them. The bend is square: it has one upright strip for each layer, and the
/// strips are as far apart as the layers. Elements that are longer than a bend cannot follow it. So the
/// fabric near the line is gathered until no element side runs past a corner of the bend. The map of each
/// layer shortens distances or keeps them, and layers in parallel planes cannot meet.
class Folding {
 public:
  /// `mesh.nodes` is the stress-free shape, `start` (3 x nodes) the shape to be folded. Nodes of `fixed` must
  /// not move. Throws std::invalid_argument for a shape of another size or a number out of range.
  Folding(const Mesh& mesh, const Eigen::Matrix3Xd& start, const std::vector<int>& fixed,
          const PackSide& side);

  /// Lays two sheets that are sewn at their rim on each other, `gap` [m] apart, with the seam half-way. The
  /// sheet that holds the fixed nodes stays in their plane. Throws std::invalid_argument for a gap that is
  /// not above 0 or above a tenth of the sheets' extent, a bag that is not made of two sheets, and fixed
  /// nodes that would move.
  void press(double gap);

  /// Folds. Throws std::invalid_argument, with key, value, limit and remedy, for
  /// - values out of range, lines beyond the bag or through the fixed nodes,
  /// - lines that do not suit the type,
  /// - layers of the pack that are nearer to each other than the gap,
  /// - a bend that reaches the fixed nodes or takes the whole flap,
  /// - an accordion that would reach below the pack.
  void fold(const FoldOptions& options);

  /// Positions of the folded bag, 3 x nodes [m].
  const Eigen::Matrix3Xd& nodes() const { return nodes_; }
  /// [nodes] true for a node in a bend or its transition.
  const std::vector<bool>& gathered() const { return gathered_; }
  /// Lines folded so far, in that order.
  const std::vector<FoldLine>& lines() const { return lines_; }

 private:
  struct Crease;
  Crease crease(const FoldOptions& options, double at, double direction, double up) const;
  double layer_distance() const;
  bool on_edge(const Eigen::Vector3i& element) const;
  void gather(Crease& crease, double gap) const;
  Eigen::ArrayXd across(const Crease& crease) const;
  Eigen::ArrayXd heights(const Crease& crease) const;
  void lay(const FoldOptions& options, double at, double direction, double up);
  void require_free(const Crease& crease) const;
  Eigen::Matrix3Xd laid(const Crease& crease) const;

  const Mesh* mesh_;
  Eigen::Matrix3Xd nodes_;
  std::vector<int> fixed_;
  PackSide side_;
  std::vector<bool> gathered_;
  std::vector<FoldLine> lines_;
};

/// Least distance [m] between the layers of a pack, seen along its thin axis: of a node from an element that
/// shares no node with those about it. Elements with `left_out` (one flag each), those on edge, and the nodes
/// of the latter do not count. Infinite for a single layer.
double least_layer_distance(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes,
                            const Eigen::Ref<const Eigen::Matrix3Xi>& elements, int thin_axis,
                            const std::vector<bool>& left_out);

/// Principal stretches (smaller, larger) of each element: its length in `shape` over that in `design`.
std::vector<std::array<double, 2>> principal_stretches(const Eigen::Ref<const Eigen::Matrix3Xd>& design,
                                                       const Eigen::Ref<const Eigen::Matrix3Xd>& shape,
                                                       const Eigen::Ref<const Eigen::Matrix3Xi>& elements);

}  // namespace mesh
