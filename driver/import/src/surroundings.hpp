// SPDX-License-Identifier: Apache-2.0
// What holds, pulls and stops a bag, as the mappings of both programs share it.
#pragma once

#include "deck_tables.hpp"
#include "strap_curves.hpp"

namespace driver::imported {

/// Adds straps, a plate, gravity and layers to the bag, and says so in the report.
class Surroundings {
 public:
  Surroundings(BagDeck& bag, const DeckText& text, ImportReport& report)
      : bag_(bag), text_(text), report_(report), nodes_(nodes_of(bag)) {}

  bool has(long node) const { return nodes_.contains(node); }
  bool has_any(const auto& nodes) const {
    return std::ranges::any_of(nodes, [this](long node) { return has(node); });
  }
  std::vector<long> own(const std::set<long>& nodes) const;

  /// A plate from a point on it and one along its normal [m]. Throws DeckFault if they are at one place.
  void wall(const DeckCard& card, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
            const std::string& source, const std::string& how);
  /// `curve`: factor over time, of which the last one counts; empty for 1. `along`: acceleration [m/s2].
  void gravity(const DeckCard& card, const Knots& curve, const Eigen::Vector3d& along);
  /// `field`: name of the thickness [m], without which nothing is mapped.
  void layers(const DeckCard& card, double thickness, double friction, const char* field);
  /// Straps of some links; strap(link) throws DeckFault for one that is none.
  template <class Strap>
  void straps(const std::vector<DeckLink>& links, Strap&& strap) {
    for (const DeckLink& link : links)
      if (has(link.from) || has(link.to)) report_.guard(*link.card, [&] { strap(link); });
  }
  /// Distance of both nodes at the start [m]. Throws DeckFault if one is not of the bag.
  double length_of(const DeckLink& link) const;
  /// `force`: the card with the stiffness; `part`: that of the link's part.
  void strap(const DeckLink& link, const StrapLaw& law, const DeckCard& force, const DeckCard& part);

 private:
  BagDeck& bag_;
  const DeckText& text_;
  ImportReport& report_;
  std::set<long> nodes_;
};

}  // namespace driver::imported
