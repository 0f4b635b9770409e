// SPDX-License-Identifier: Apache-2.0
#include "coupling/skin_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "check.hpp"
#include "skin_forces.hpp"
#include "skin_friction.hpp"

namespace coupling {

namespace detail {

struct SkinRun {
  SkinRun(const std::shared_ptr<const SkinParts>& parts, bool every_pair)
      : search(parts, every_pair), memory(*parts), friction(*parts) {}
  SkinSearch search;
  SkinMemory memory;
  SkinFriction friction;
};

}  // namespace detail

std::string text_of(const SkinPair& pair) {
  const auto number = [](int node) { return std::to_string(node); };
  if (pair.first[1] < 0)
    return "node " + number(pair.first[0]) + " and the element of nodes " + number(pair.second[0]) + ", " +
           number(pair.second[1]) + ", " + number(pair.second[2]);
  return "the edges of nodes " + number(pair.first[0]) + ", " + number(pair.first[1]) + " and " +
         number(pair.second[0]) + ", " + number(pair.second[1]);
}

SkinContactState::SkinContactState(std::unique_ptr<detail::SkinRun> run) : run_(std::move(run)) {}
SkinContactState::SkinContactState(const SkinContactState& other)
    : run_(std::make_unique<detail::SkinRun>(*other.run_)) {}
SkinContactState::SkinContactState(SkinContactState&&) noexcept = default;
SkinContactState& SkinContactState::operator=(const SkinContactState& other) {
  if (this != &other) run_ = std::make_unique<detail::SkinRun>(*other.run_);
  return *this;
}
SkinContactState& SkinContactState::operator=(SkinContactState&&) noexcept = default;
SkinContactState::~SkinContactState() = default;

int SkinContactState::limited_nodes() const {
  return static_cast<int>(run_->memory.limits.small_nodes().size());
}

double SkinContactState::smallest_limit() const {
  double least = run_->search.parts()->parameters.thickness;
  const detail::SkinLimits& limits = run_->memory.limits;
  for (const int n : limits.small_nodes()) least = std::min(least, limits.of_node(n));
  return least;
}

long SkinContactState::looks() const {
  return run_->search.looks();
}
long SkinContactState::sweeps() const {
  return run_->search.sweeps();
}

SkinContactRecord SkinContactState::record() const {
  const detail::SkinSearch& search = run_->search;
  SkinContactRecord record{search.level(),           search.looks(), search.sweeps(), search.now(), {}, {},
                           run_->friction.bristles()};
  run_->memory.limits.write(record);
  return record;
}

SkinContactModel::SkinContactModel(const Triangles& triangles, const Nodes& reference,
                                   std::span<const double> masses, const SkinContactParameters& parameters)
    : parameters_(parameters),
      parts_(std::make_shared<const detail::SkinParts>(triangles, reference, masses, parameters)) {}

SkinContactState SkinContactModel::make_state(bool every_pair) const {
  return SkinContactState(std::make_unique<detail::SkinRun>(parts_, every_pair));
}

SkinContactState SkinContactModel::make_state(const SkinContactRecord& record) const {
  const auto nodes = static_cast<Eigen::Index>(parts_->masses.size());
  const auto is_part = [](int number, Eigen::Index count) { return number >= 0 && number < count; };
  const bool fits = record.nodes.cols() == (record.level < 0 ? 0 : nodes) &&
                    record.node_limits.size() == parts_->masses.size() &&
                    record.edge_limits.size() == parts_->edges.size() &&
                    std::ranges::all_of(record.bristles, [&](const SkinBristle& one) {
                      return parameters_.friction > 0.0 && is_part(one.node, nodes) && is_part(one.side, 2) &&
                             is_part(one.triangle, parts_->triangles.cols());
                    });
  if (!fits) detail::reject("self_contact.record", "not of this model", "from a state of this model");
  SkinContactState state = make_state();
  state.run_->search.go_on_from(record);
  state.run_->memory.limits.read(record);
  state.run_->friction.set(record.bristles);
  return state;
}

SkinContactResult SkinContactModel::evaluate(SkinContactState& state, const Nodes& nodes,
                                             NodalForces forces) const {
  if (!state.run_ || state.run_->search.parts() != parts_)
    detail::reject("self_contact.state", "not of this model", "from make_state of this model");
  const auto count = static_cast<Eigen::Index>(parts_->masses.size());
  if (nodes.cols() != count || forces.cols() != count)
    detail::reject("self_contact.nodes and forces",
                   std::to_string(nodes.cols()) + " and " + std::to_string(forces.cols()) + " columns",
                   "one a node, " + std::to_string(count));
  detail::SkinRun& run = *state.run_;
  run.search.follow(nodes, run.memory.limits);
  SkinContactResult result;
  detail::SkinForces(run.search, nodes, run.memory, forces, result).add();
  run.friction.add(run.search.touches(), *parts_, run.memory.limits, run.search.now(), run.search.before(),
                   forces, result);
  // Sticking adds the same stiffness at right angles; a sliding force follows the depth.
  result.omega_squared *= std::sqrt(1.0 + parameters_.friction * parameters_.friction);
  result.approach = run.search.approach();
  return result;
}

double SkinContactModel::full_omega_squared() const {
  return parts_->full_omega_squared * std::sqrt(1.0 + parameters_.friction * parameters_.friction);
}

int SkinContactModel::node_count() const {
  return static_cast<int>(parts_->masses.size());
}

double default_skin_stiffness(double share, double other_omega_squared, double surface_density) {
  detail::require_positive("self_contact.stiffness_share", share);
  detail::require_positive("self_contact.other_omega_squared", other_omega_squared);
  detail::require_positive("self_contact.surface_density", surface_density);
  return share * other_omega_squared * surface_density / 4.0;
}

}  // namespace coupling
