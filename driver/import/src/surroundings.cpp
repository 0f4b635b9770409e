// SPDX-License-Identifier: Apache-2.0
#include "surroundings.hpp"

#include <fmt/format.h>

namespace driver::imported {

std::vector<long> Surroundings::own(const std::set<long>& nodes) const {
  std::vector<long> own;
  std::ranges::set_intersection(nodes, nodes_, std::back_inserter(own));
  return own;
}

void Surroundings::wall(const DeckCard& card, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                        const std::string& source, const std::string& how) {
  if (!((to - from).norm() > 0.0)) throw DeckFault(card.at, "both points of the normal are at one place");
  if (bag_.held.wall)
    return report_.left_out(card, Mapping::none, "a case has one plate: this one is left out");
  bag_.held.wall = BagWall{from, (to - from).normalized(), source};
  report_.became(card, {"membrane.plate.point", "membrane.plate.normal"}, Mapping::approximated, how);
}

void Surroundings::gravity(const DeckCard& card, const Knots& curve, const Eigen::Vector3d& along) {
  bag_.gravity.push_back({curve, along});
  report_.became(card, {"scene.gravity"}, Mapping::exact,
                 "acceleration of everything that moves, over time if its curve is not constant");
}

void Surroundings::layers(const DeckCard& card, double thickness, double friction, const char* field) {
  if (!(thickness > 0.0))
    return report_.left_out(card, Mapping::none,
                            fmt::format("no thickness ({}) is given, so layers pass through each other; set "
                                        "[membrane.self_contact] thickness by hand",
                                        field));
  bag_.held.layer_thickness = thickness;
  bag_.held.layer_friction = friction;
  report_.became(card, {"membrane.self_contact", "membrane.self_contact.thickness"}, Mapping::approximated,
                 "pressure between layers with the program's own penalty");
}

double Surroundings::length_of(const DeckLink& link) const {
  if (!has(link.from) || !has(link.to))
    throw DeckFault(
        link.at, "joins the bag to something else, which has no counterpart; allowed: two nodes of the bag");
  return (bag_.nodes.at(link.to) - bag_.nodes.at(link.from)).norm();
}

void Surroundings::strap(const DeckLink& link, const StrapLaw& law, const DeckCard& force,
                         const DeckCard& part) {
  bag_.held.straps.push_back({link.from, link.to, law.stiffness, length_of(link) + law.slack,
                              fmt::format("{} {}", text_.where(link.at), link.card->keyword)});
  const bool exact = law.misfit == 0.0;
  for (const DeckCard* card : {link.card, &part})
    report_.became(*card, {"membrane.strap.from_node", "membrane.strap.to_node"}, Mapping::exact,
                   "straps by node");
  report_.became(
      force, {"membrane.strap.stiffness", "membrane.strap.free_length"},
      exact ? Mapping::exact : Mapping::approximated,
      exact ? "a linear strap without compression"
            : fmt::format("a linear strap without compression: off by up to {:.2g} of the largest force",
                          law.misfit));
}

}  // namespace driver::imported
