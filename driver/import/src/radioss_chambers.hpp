// SPDX-License-Identifier: Apache-2.0
// Chambers that exchange gas as one chamber.
#pragma once

#include "radioss_tables.hpp"

namespace driver::imported {

/// Chambers of a bag. Call `take` for the surface of each, then `fill` for the gas of each.
class RadiossChambers {
 public:
  RadiossChambers(BagDeck& bag, ImportReport& report) : bag_(bag), report_(report) {}
  /// After the facets of a chamber were added to the bag.
  void take();
  /// Leaves out elements between two chambers.
  void join();
  /// After the gas of a chamber. Throws DeckFault if it starts in another state than the first one's.
  void fill(const RadiossContext& chamber);

 private:
  BagDeck& bag_;
  ImportReport& report_;
  std::vector<std::size_t> ends_;  // of the chambers among the bag's facets
  struct Start {
    double pressure, temperature;
    std::vector<std::pair<std::size_t, double>> gas;
    bool operator==(const Start&) const = default;
  };
  std::optional<Start> first_;
};

}  // namespace driver::imported
