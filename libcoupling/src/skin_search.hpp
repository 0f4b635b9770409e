// SPDX-License-Identifier: Apache-2.0
// Which parts of a skin are closer than the thickness, level by level, and proof that none passed another.
//
// The skin's elements are in groups of 16 neighbours, each with the nodes and edges that it owns. At a mark
// the groups whose boxes are near are paired; others cannot touch before a node has moved by a margin. A pair
// rests while the motion of its groups relative to each other is below its slack, the least distance of their
// parts: since the mark, as positions; or since the last look, as a path, which is shorter for a while. A
// mark is cheap, as slack is carried over, and worked out anew only for pairs that have used it up.
//
// A look takes all parts of which the boxes, of their paths in the last step, are near. A pair rests if its
// motion was below its slack at both ends of the step, so that what met between two levels is seen. Forces
// have an order that depends on the mesh alone.
#pragma once
#include <memory>
#include <vector>

#include "skin_looks.hpp"
#include "skin_motion.hpp"

namespace coupling::detail {

/// Two groups that may touch. Lengths [m].
struct GroupPair {
  int first, second;
  double slack = -1.0;  // motion since the mark before parts can touch
  bool fresh = false;   // slack was worked out at the last mark
  bool rests = false;   // motion was below it at the last level
  double path = 0.0;    // motion since the last look
  double room = -1.0;   // motion since the last look before parts can touch
  long level = -1;      // of the path
};

/// The search of one run.
class SkinSearch {
 public:
  SkinSearch(std::shared_ptr<const SkinParts> parts, bool every_pair);

  /// Goes on to the next level. Throws ContactError.
  void follow(const Nodes& nodes);

  const std::vector<Touch>& touches() const { return looks_.touches; }      // of the last level
  double approach() const { return looks_.approach; }                       // [-] as in SkinContactResult
  const Eigen::Matrix3Xd& now() const { return looks_.paths.now(); }        // positions at the last level
  const Eigen::Matrix3Xd& before() const { return looks_.paths.before(); }  // and at the one before
  const std::shared_ptr<const SkinParts>& parts() const { return parts_; }
  bool first_level() const { return looks_.level == 0; }  // the last level was the first one
  long looks() const { return looks_.looks; }             // distances computed
  long sweeps() const { return looks_.sweeps; }           // paths tested

 private:
  void mark();
  bool must_look(GroupPair& pair);

  std::shared_ptr<const SkinParts> parts_;
  bool every_pair_;
  double margin_;  // [m] motion of a node before the next mark
  SkinLooks looks_;
  SkinBoxes boxes_at_mark_;
  SkinMotion motion_;
  std::vector<GroupPair> pairs_;  // by first and second group, ascending
  // Pairs looked at since the mark, and worked out for it: a new one is worth that many.
  std::size_t spent_ = 0, price_ = 0;
};

}  // namespace coupling::detail
