// SPDX-License-Identifier: Apache-2.0
// State of each ray in the fast route.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "bits.hpp"
#include "jet/visibility.hpp"
#include "kernel_table.hpp"

namespace jet {

/// States of the rays to the candidates, by the candidates' places in the mesh's order. A ray is alive until
/// an element is found that may block it.
class RayStates {
 public:
  enum State : std::uint8_t { kLit = 0, kHidden = 1, kFacingAway = 2, kOpen = 4 };  // see count()

  void reserve(std::size_t patches) {
    states_.resize(8 * patches);
    open_.reserve(8 * patches);
    for (auto* bits : {&alive_, &chosen_}) bits->resize(patches);
    listed_.resize(8 * patches + 8);
  }

  /// Makes all rays lit; rays in `asked` (bits by patch) are alive.
  void reset(std::span<const std::uint8_t> asked) {
    std::fill(states_.begin(), states_.end(), kLit);
    std::copy(asked.begin(), asked.end(), alive_.begin());
    open_.clear();
  }

  State operator[](int place) const { return states_[static_cast<std::size_t>(place)]; }
  bool alive(int place) const { return (alive_[static_cast<std::size_t>(place / 8)] >> place % 8 & 1) != 0; }

  /// Sets the state of a ray that is no longer alive.
  void set(int place, State state) {
    settle(place, state);
    std::uint8_t& bits = alive_[static_cast<std::size_t>(place / 8)];
    bits = static_cast<std::uint8_t>(bits & ~(1 << place % 8));
    if (state == kOpen) open_.push_back(place);
  }
  /// Sets the final state of an open ray.
  void settle(int place, State state) { states_[static_cast<std::size_t>(place)] = state; }

  /// Places of the rays that are alive, ascending; without those in the set `without` (bits by patch). The
  /// lists share one workspace.
  std::span<const int> list_alive() { return list(alive_); }
  std::span<const int> list_alive(std::span<const std::uint8_t> without) {
    and_not(alive_, without, chosen_);
    return list(chosen_);
  }
  /// Places of the open rays, ascending, so that neighbours are together.
  std::span<const int> list_open() {
    std::fill(chosen_.begin(), chosen_.end(), std::uint8_t{0});
    for (const int place : open_) {
      std::uint8_t& bits = chosen_[static_cast<std::size_t>(place / 8)];
      bits = static_cast<std::uint8_t>(bits | int{(*this)[place] == kOpen} << place % 8);
    }
    return list(chosen_);
  }
  /// Places of the rays that were opened, in that order.
  const std::vector<int>& opened() const { return open_; }

  /// Writes whether the rays at `places` are lit, and counts them.
  VisibilityCounters count(std::span<const int> places, std::span<std::uint8_t> lit) const;

 private:
  std::span<const int> list(std::span<const std::uint8_t> bits) {
    const int count = kernel_table().list_bits(bits.data(), static_cast<int>(bits.size()), listed_.data());
    return std::span(listed_).first(static_cast<std::size_t>(count));
  }

  std::vector<State> states_;
  std::vector<std::uint8_t> alive_;   // by patch: bits of the rays
  std::vector<std::uint8_t> chosen_;  // workspace: bits of rays
  std::vector<int> open_, listed_;
};

// Counts the states by their bits, eight bytes at a time.
inline VisibilityCounters RayStates::count(std::span<const int> places, std::span<std::uint8_t> lit) const {
  VisibilityCounters counters;
  const State* states = states_.data();  // local, so that the bytes written cannot change it
  std::uint8_t* to = lit.data();
  for (const int place : places) *to++ = states[place];
  const auto take = [&](std::uint8_t* bytes, std::size_t count) {
    constexpr std::uint64_t ones = 0x0101010101010101u;
    std::uint64_t x = 0;
    std::memcpy(&x, bytes, count);
    counters.hidden += (x & ones) * ones >> 56;
    counters.facing_away += (x >> 1 & ones) * ones >> 56;
    x = ~(x | x >> 1) & ones;
    std::memcpy(bytes, &x, count);
  };
  static_assert(kHidden == 1 && kFacingAway == 2 && std::endian::native == std::endian::little);
  std::size_t i = 0;
  for (; i + 8 <= lit.size(); i += 8) take(&lit[i], 8);
  if (i < lit.size()) take(&lit[i], lit.size() - i);
  counters.candidates = lit.size();
  counters.lit = counters.candidates - counters.hidden - counters.facing_away;
  return counters;
}

}  // namespace jet
