// SPDX-License-Identifier: Apache-2.0
// All fabric laws. A law is one header beside this one; it is known everywhere once it stands in the list.
#pragma once

#include "membrane/hencky.hpp"
#include "membrane/material.hpp"
#include "membrane/orthotropic.hpp"
#include "membrane/yarns.hpp"

namespace membrane {

/// A list of types.
template <class... Law>
struct LawList {
  /// How many.
  static constexpr int count = sizeof...(Law);
};

/// The laws; LawDefaults says what each has.
using FabricLaws = LawList<Isotropic, Orthotropic, Hencky, Yarns>;

/// Numbers that an aggregate of numbers holds, such as a law's Constants or Notes.
template <template <class> class Numbers>
inline constexpr int kNumbersIn = static_cast<int>(sizeof(Numbers<double>) / sizeof(double));

/// The largest of some numbers, at least 1.
template <int... kCount>
constexpr int greatest() {
  const int counts[] = {kCount...};
  int most = 1;
  for (const int count : counts) most = count > most ? count : most;
  return most;
}
/// Most constants of a law of the list.
template <class... Law>
constexpr int most_constants(LawList<Law...>) {
  return greatest<kNumbersIn<Law::template Constants>...>();
}
/// Most notes of a law of the list.
template <class... Law>
constexpr int most_notes(LawList<Law...>) {
  return greatest<kNumbersIn<Law::template Notes>...>();
}
/// Rooms for constants.
inline constexpr int kMostConstants = most_constants(FabricLaws{});
/// Rooms for notes.
inline constexpr int kMostNotes = most_notes(FabricLaws{});

}  // namespace membrane
