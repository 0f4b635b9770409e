// SPDX-License-Identifier: Apache-2.0
// All fabric laws. Each law is one header beside this one. The rest of the program knows it from this list.
#pragma once

#include "membrane/hencky.hpp"
#include "membrane/material.hpp"
#include "membrane/orthotropic.hpp"
#include "membrane/yarns.hpp"

namespace membrane {

/// A list of types.
template <class... Law>
struct LawList {
  /// Number of types.
  static constexpr int count = sizeof...(Law);
};

/// The laws; for their members see LawDefaults.
using FabricLaws = LawList<Isotropic, Orthotropic, Hencky, Yarns>;

/// Number of members of an aggregate of numbers, such as a law's Constants or Notes.
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
/// Largest number of constants of a law in the list.
template <class... Law>
constexpr int most_constants(LawList<Law...>) {
  return greatest<kNumbersIn<Law::template Constants>...>();
}
/// Largest number of notes of a law in the list.
template <class... Law>
constexpr int most_notes(LawList<Law...>) {
  return greatest<kNumbersIn<Law::template Notes>...>();
}
/// Room for constants.
inline constexpr int kMostConstants = most_constants(FabricLaws{});
/// Room for notes.
inline constexpr int kMostNotes = most_notes(FabricLaws{});

}  // namespace membrane
