// SPDX-License-Identifier: Apache-2.0
#include "radioss_chambers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace driver::imported {

void RadiossChambers::take() {
  ends_.push_back(bag_.facets.size());
}

void RadiossChambers::join() {
  if (ends_.size() < 2) return;
  std::map<std::vector<long>, std::set<std::size_t>> chambers_at;  // by the nodes of an element
  std::vector<std::vector<long>> nodes_of;
  std::size_t chamber = 0;
  for (std::size_t i = 0; i < bag_.facets.size(); ++i) {
    while (i >= ends_[chamber]) ++chamber;
    nodes_of.push_back(bag_.facets[i].nodes);
    std::ranges::sort(nodes_of.back());
    chambers_at[nodes_of.back()].insert(chamber);
  }
  std::vector<Facet> outer;
  for (std::size_t i = 0; i < bag_.facets.size(); ++i)
    if (chambers_at[nodes_of[i]].size() < 2) outer.push_back(std::move(bag_.facets[i]));
  report_.note(fmt::format(
      "{} chambers are one with one pressure: {} elements between them are left out, and gas flows freely "
      "there",
      ends_.size(), nodes_of.size() - outer.size()));
  bag_.facets = std::move(outer);
}

void RadiossChambers::fill(const RadiossContext& chamber) {
  const Start start{bag_.ambient_pressure, bag_.initial_temperature, bag_.initial_gas.shares};
  if (!first_) first_ = start;
  if (start != *first_)
    throw DeckFault(chamber.volume.at,
                    "the chamber starts in another state than the first one, so they cannot be one; allowed: "
                    "the same Pext, T0 and gas");
}

}  // namespace driver::imported
