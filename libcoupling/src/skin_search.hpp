// SPDX-License-Identifier: Apache-2.0
// Which parts of a skin are closer than the thickness, level by level, and proof that none passed another.
//
// The skin's elements are in groups of 16 neighbours, each with the nodes and edges that it owns. At a mark
// the groups whose boxes are near are paired; others cannot touch before a node has moved by a margin. A pair
// is looked at when the motion of its groups relative to each other may have used up the least distance of
// its parts: since the mark, as positions; or since the last look, as a path, which is shorter for a while. A
// look takes all parts of which the boxes, of their paths in the last step, are near. So what met between two
// levels is seen, and forces have an order that depends on the mesh alone.
#pragma once
#include <memory>
#include <vector>

#include "skin_lists.hpp"
#include "skin_motion.hpp"

namespace coupling::detail {

/// Two parts closer than the reach of their kind.
struct Touch {
  PartPair pair;
  Closest closest;
  double ahead;  // [m] distance after another step and a half like the last one
};

/// Two groups that may touch. Lengths [m].
struct GroupPair {
  int first, second;
  double slack = -1.0;  // motion since the mark before parts can touch
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

  const std::vector<Touch>& touches() const { return touches_; }  // of the last level
  double approach() const { return approach_; }                   // [-] as in SkinContactResult
  const SkinPaths& paths() const { return paths_; }               // to the last level from the one before
  const std::shared_ptr<const SkinParts>& parts() const { return parts_; }
  bool first_level() const { return level_ == 1; }  // the last level was the first one
  long looks() const { return looks_; }             // distances computed
  long sweeps() const { return sweeps_; }           // paths tested

 private:
  void mark();
  bool must_look(GroupPair& pair);
  double look(const GroupPair& pair, double range);
  double look(const PartPair& pair);

  std::shared_ptr<const SkinParts> parts_;
  bool every_pair_;
  double margin_;         // [m] motion of a node before the next mark
  long level_ = 0;        // levels so far
  bool marking_ = false;  // this level is a mark
  SkinPaths paths_;
  SkinMotion motion_;
  std::vector<GroupPair> pairs_;  // by first and second group, ascending
  // Looks at pairs since the mark, and at near ones at the mark: a new one is worth that many.
  std::size_t spent_ = 0, price_ = 0;
  std::vector<Touch> touches_;
  double approach_ = 0.0;
  long looks_ = 0, sweeps_ = 0;
};

}  // namespace coupling::detail
