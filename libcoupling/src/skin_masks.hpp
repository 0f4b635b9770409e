// SPDX-License-Identifier: Apache-2.0
// Which parts of two groups may touch: neighbours may not.
#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace coupling::detail {

struct SkinParts;

/// Bits of the parts of two groups, for pairs of groups that have neighbours.
class PartMasks {
 public:
  PartMasks() = default;
  explicit PartMasks(const SkinParts& parts);
  /// One word for each element of the second group, for each of the first one if that is another, and for
  /// each edge of the first one. Its bits are the nodes of the other group, or edges of the second one, that
  /// may touch it. Null if all may.
  const std::uint64_t* of(int first, int second) const;

 private:
  std::vector<std::pair<int, int>> pairs_;  // ascending
  std::vector<std::size_t> start_;          // of each pair's words
  std::vector<std::uint64_t> words_;
};

}  // namespace coupling::detail
