// SPDX-License-Identifier: Apache-2.0
// Which parts of a skin are closer than the thickness, level by level, and proof that none passed another.
//
// The skin's elements are in groups of 16 neighbours, each with the nodes and edges that it owns. A pair of
// groups is in one of three states:
// - not watched: their boxes are farther apart than all nodes have moved since the watch began;
// - watched: looked at when the motion may have closed the gap of their boxes;
// - listed: their parts closer than `pad` are listed. From here on motion is that of the two groups relative
// to
//   each other, their translation taken out, as a path length. A listed part is looked at again when that
//   path may have closed its own gap.
// Parts are visited in an order that depends on the mesh alone, so that sums do not depend on the history.
#pragma once
#include <memory>
#include <vector>

#include "skin_pair.hpp"
#include "skin_parts.hpp"

namespace coupling::detail {

/// Two parts that touch, closer than the reach of their kind.
struct Touch {
  PartPair pair;
  Closest closest;
};

/// Two parts of two groups. They cannot touch before the path of the groups reaches `free` [m].
struct Listed {
  PartPair pair;
  double free;
};

/// Two groups of which parts may touch.
struct GroupPair {
  int first, second;
  double due;           // [m] of the whole motion, to look at the boxes; of pairs that are not listed
  bool listed = false;  // what follows is of listed pairs
  double step = 0.0;    // [m] relative motion in the last step, at most
  double path = 0.0;    // [m] sum of the steps since the list was made
  double wake = 0.0;    // [m] of the path: least `free`
  std::vector<Listed> list;
};

/// Box of a group at a level.
struct GroupBox {
  long level = -1;
  Eigen::Array3d low, high;
};

/// The search of one run.
class SkinSearch {
 public:
  SkinSearch(std::shared_ptr<const SkinParts> parts, bool every_pair);

  /// Goes on to the next level. Throws ContactError.
  void follow(const Nodes& nodes);

  const std::vector<Touch>& touches() const { return touches_; }  // of the last level
  double approach() const { return approach_; }                   // [m] as in SkinContactResult
  /// (3 x N) [m] Motion of the nodes since the level before.
  const Eigen::Matrix3Xd& motion() const { return step_; }
  const std::shared_ptr<const SkinParts>& parts() const { return parts_; }
  bool first_level() const { return level_ == 1; }  // the last level was the first one
  long looks() const { return looks_; }             // distances computed
  long sweeps() const { return sweeps_; }           // paths tested

 private:
  void measure(const Nodes& nodes);
  void watch(const Nodes& nodes);
  void replace_pairs(std::vector<GroupPair> found, const Nodes& nodes);
  void look(GroupPair& pair, const Nodes& nodes);
  void move(GroupPair& pair, const Nodes& nodes);
  void list(GroupPair& pair, const Nodes& nodes);
  void list_nodes(GroupPair& pair, int from, int to, const Nodes& nodes);
  void list_edges(GroupPair& pair, const Nodes& nodes);
  void visit(GroupPair& pair, const Nodes& nodes);
  void visit(const GroupPair& pair, Listed& entry, const Nodes& nodes);
  void certify(const PartPair& pair, const Nodes& nodes, double known);
  void sweep(const GroupPair& pair, const Nodes& nodes);
  const GroupBox& box(int group, const Nodes& nodes);
  double relative_step(const GroupPair& pair) const;

  std::shared_ptr<const SkinParts> parts_;
  bool every_pair_;
  double pad_, reach_;            // [m] gaps of parts that are listed, of boxes that are watched, at most
  long level_ = 0;                // levels so far
  double motion_ = 0.0;           // [m] no two points moved farther relative to each other in the last step
  double travelled_ = 0.0;        // [m] sum of that
  double watch_end_ = 0.0;        // [m] of travelled_: parts not watched may come near
  std::vector<GroupPair> pairs_;  // by first and second group, ascending
  std::vector<GroupBox> boxes_;
  Eigen::Matrix3Xd previous_, step_;  // (3 x N) [m] nodes of the last level, motion since
  Eigen::Matrix3Xd shift_;            // (3 x groups) [m] mean motion of each group's nodes in the last step
  std::vector<double> spread_;        // [m] largest difference from it
  std::vector<Touch> touches_;
  double approach_ = 0.0;
  long looks_ = 0, sweeps_ = 0;
};

}  // namespace coupling::detail
