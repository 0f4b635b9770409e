// SPDX-License-Identifier: Apache-2.0
// Which parts of a skin are closer than the thickness, level by level, and proof that none passed another.
//
// The skin's elements are in groups of 16 neighbours, each with the nodes and edges that it owns. Groups
// whose boxes are near are paired; others cannot touch before a node has moved by a margin. A look at a pair
// says how far its parts are apart at least: it rests until the paths of its nodes are as long. A look takes
// all parts of which the boxes are near. Boxes hold the paths of the last step, so that what met between two
// levels is seen, and of kAhead steps like that. Forces have an order that depends on the mesh alone.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "skin_boxes.hpp"
#include "skin_gaps.hpp"
#include "skin_looks.hpp"
#include "skin_motion.hpp"

namespace coupling::detail {

/// Two groups that may touch.
struct GroupPair {
  int first, second;
  const std::uint64_t* mask;  // as of PartMasks
  double wakes;               // [m] distance of parts, and the paths of both groups until then
};

/// The search of one run.
class SkinSearch {
 public:
  SkinSearch(std::shared_ptr<const SkinParts> parts, bool every_pair);

  /// Goes on to the next level. Throws ContactError.
  void follow(const Nodes& nodes, const SkinLimits& limits);
  /// Goes on from a level that another search has followed.
  void go_on_from(const SkinContactRecord& record);

  const std::vector<Touch>& touches() const { return looks_.touches; }  // of the last level
  double approach() const { return looks_.approach; }                   // [-] as in SkinContactResult
  const Eigen::Matrix3Xd& now() const { return motion_.now(); }         // positions at the last level
  const Eigen::Matrix3Xd& before() const { return motion_.before(); }   // and at the one before
  const std::shared_ptr<const SkinParts>& parts() const { return parts_; }
  bool first_level() const { return looks_.level == 0; }  // the last level was the first one
  long level() const { return looks_.level; }             // number of the last level
  long looks() const { return looks_.looks; }             // distances computed
  long sweeps() const { return looks_.sweeps; }           // paths tested

 private:
  void pair_groups();
  double least_distance(const GroupPair& pair, const SkinLimits& limits);

  std::shared_ptr<const SkinParts> parts_;
  bool every_pair_;
  float margin_;  // [m] motion of a node before groups are paired anew
  SkinLooks looks_;
  SkinMotion motion_;
  SkinBoxes boxes_;               // of the last step
  std::vector<GroupPair> pairs_;  // by first and second group, ascending
  std::vector<double> awake_;     // [m] path of each group, looked ahead
  float moved_ = 0.0F;            // [m] no node moved farther since groups were paired
  std::vector<NearParts> found_;
};

}  // namespace coupling::detail
