// SPDX-License-Identifier: Apache-2.0
#include "jet/visibility.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <numeric>

#include "checks.hpp"
#include "visibility/blocking.hpp"
#include "visibility/both_ways.hpp"
#include "visibility/closedness.hpp"
#include "visibility/filter.hpp"
#include "visibility/one_by_one.hpp"
#include "visibility/predicates.hpp"
#include "visibility/winding.hpp"

namespace jet {
namespace {

/// Tests every pair. With CGAL's predicates it is the oracle.
template <class Kernel>
struct BruteForce {
  const Surface& surface;
  Kernel& kernel;

  bool source_on_surface(const blocking::Ray& ray) const {
    for (int e = 0; e < surface.count; ++e) {
      if (blocking::source_on(kernel, ray, surface, e)) return true;
    }
    return false;
  }
  bool blocked(const blocking::Ray& ray, int target) const {
    for (int e = 0; e < surface.count; ++e) {
      if (e != target && !surface.never_blocks(e) && blocking::blocks(kernel, ray, surface, e)) return true;
    }
    return false;
  }
};

/// Filtered predicates, for rays whose source is known to be moved or not.
struct FilteredKernel : filter::Kernel {
  bool moved(const blocking::Ray& ray) const { return ray.moved == blocking::Moved::yes; }
};

// Written before the first query, if at all.
std::atomic<OtherRoute> tree_route{nullptr};

}  // namespace

void set_tree_route(OtherRoute route) {
  tree_route = route;
}
bool has_route(VisibilityRoute route) {
  if (static_cast<int>(route) < 0 || route > VisibilityRoute::brute_force)
    refuse("route is not an enumerator");
  return route != VisibilityRoute::cgal_tree || tree_route.load() != nullptr;
}

VisibilityCounters& VisibilityCounters::operator+=(const VisibilityCounters& other) {
  candidates += other.candidates;
  lit += other.lit;
  hidden += other.hidden;
  facing_away += other.facing_away;
  exact_calls += other.exact_calls;
  fallbacks += other.fallbacks;
  tree_builds += other.tree_builds;
  return *this;
}

struct VisibilityQuery::Impl {
  int node_count;  // nodes of the caller
  bool whole_is_closed;
  std::vector<std::array<int, 3>> triangles;  // they index `used` if there are unused nodes
  std::vector<Role> given_roles;
  std::vector<Role> roles;  // of the elements that are not left out
  bool closed;
  std::vector<int> used;  // nodes that elements use; empty if all are used
  Eigen::Matrix3Xd copy;  // coordinates of the nodes in `used`
  std::shared_ptr<const OrderedMesh> mesh;
  BothWays fast;

  int count() const { return static_cast<int>(triangles.size()); }
  int used_count() const { return used.empty() ? node_count : static_cast<int>(used.size()); }
  void prepare() {
    fast = {};
    fast.prepare(mesh, static_cast<std::size_t>(used_count()), closed);
  }

  /// Renumbers the triangles if some nodes belong to no element, so that these are never read.
  void leave_out_unused() {
    std::vector<int> number(static_cast<std::size_t>(node_count), -1);
    for (const Triangle& t : triangles)
      for (const int node : t) number[static_cast<std::size_t>(node)] = 0;
    for (int node = 0; node < node_count; ++node) {
      int& place = number[static_cast<std::size_t>(node)];
      if (place == 0) place = static_cast<int>(used.size()), used.push_back(node);
    }
    if (static_cast<int>(used.size()) == node_count) return used.clear();
    for (Triangle& t : triangles)
      for (int& node : t) node = number[static_cast<std::size_t>(node)];
    copy.resize(3, used_count());
  }

  Surface surface(const Points& nodes) {
    Surface all{nodes.data(), nodes.outerStride(), triangles.data(), roles.data(), count(), used_count()};
    if (used.empty()) return all;
    for (int i = 0; i < used_count(); ++i) copy.col(i) = nodes.col(used[static_cast<std::size_t>(i)]);
    all.nodes = copy.data(), all.stride = 3, all.names = used.data();
    return all;
  }

  void assign(std::span<const int> elements, const char* name, Role role) {
    for (const int e : elements) {
      require_index(name, e, count());
      roles[static_cast<std::size_t>(e)] = role;
    }
  }

  /// The routes check the nodes' coordinates.
  void check(const Points& nodes, const RaySource& source, std::span<const int> candidates) const {
    check_source(source);
    const auto last = static_cast<unsigned>(count() - 1);
    unsigned signs = 0;  // checked together; named only if one is bad
    for (const int e : candidates) signs |= static_cast<unsigned>(e) | (last - static_cast<unsigned>(e));
    for (std::size_t k = 0; signs >> 31 != 0 && k < candidates.size(); ++k)
      require_index("candidate", candidates[k], count());
    if (nodes.cols() != node_count)
      refuse("nodes has " + std::to_string(nodes.cols()) +
             " columns, allowed: " + std::to_string(node_count));
  }
};

VisibilityQuery::VisibilityQuery(const Triangles& triangles, int node_count, const SurfaceRoles& roles)
    : impl_(std::make_unique<Impl>()) {
  if (triangles.cols() == 0) refuse("mesh has no element, allowed: 1 or more");
  impl_->node_count = node_count;
  for (Eigen::Index e = 0; e < triangles.cols(); ++e) {
    for (int i = 0; i < 3; ++i) require_index("node index", triangles(i, e), node_count);
    impl_->triangles.push_back({triangles(0, e), triangles(1, e), triangles(2, e)});
  }
  impl_->roles.assign(impl_->triangles.size(), Role::fabric);
  impl_->assign(roles.attachment_elements, "attachment element", Role::attachment);
  impl_->assign(roles.null_elements, "null element", Role::null_panel);
  impl_->leave_out_unused();
  impl_->given_roles = impl_->roles;
  impl_->closed = impl_->whole_is_closed = is_closed(impl_->triangles);
  impl_->mesh = std::make_shared<const OrderedMesh>(impl_->triangles);
  impl_->prepare();
}

VisibilityQuery::VisibilityQuery(const VisibilityQuery& other) {
  const Impl& i = *other.impl_;
  impl_ = std::make_unique<Impl>(Impl{i.node_count,
                                      i.whole_is_closed,
                                      i.triangles,
                                      i.given_roles,
                                      i.roles,
                                      i.closed,
                                      i.used,
                                      i.copy,
                                      i.mesh,
                                      {}});
  impl_->prepare();
}
VisibilityQuery& VisibilityQuery::operator=(const VisibilityQuery& other) {
  return *this = VisibilityQuery(other);
}
VisibilityQuery::~VisibilityQuery() = default;
VisibilityQuery::VisibilityQuery(VisibilityQuery&&) noexcept = default;
VisibilityQuery& VisibilityQuery::operator=(VisibilityQuery&&) noexcept = default;

void VisibilityQuery::leave_out(std::span<const int> elements) {
  for (const int e : elements) require_index("element left out", e, impl_->count());
  impl_->roles = impl_->given_roles;
  impl_->assign(elements, "element left out", Role::absent);
  impl_->closed = impl_->whole_is_closed && elements.empty();
  impl_->prepare();
}

int VisibilityQuery::element_count() const {
  return impl_->count();
}
bool VisibilityQuery::closed() const {
  return impl_->closed;
}

VisibilityCounters VisibilityQuery::query(VisibilityRoute route, const Points& nodes, const RaySource& source,
                                          std::span<const int> candidates, std::span<std::uint8_t> lit,
                                          double displacement_bound) {
  impl_->fast.move_to(displacement_bound);  // for every route, even if the input is then refused
  impl_->check(nodes, source, candidates);
  if (lit.size() != candidates.size()) refuse("lit and candidates differ in size");
  if (!has_route(route)) refuse("route cgal_tree is not part of this program, allowed: fast, brute_force");
  const Surface surface = impl_->surface(nodes);
  if (candidates.empty() || route != VisibilityRoute::fast) check_nodes(surface);
  if (candidates.empty()) return {};
  exact::Kernel kernel;
  switch (route) {
    case VisibilityRoute::brute_force:
      return query_by(BruteForce<exact::Kernel>{surface, kernel}, surface, source, candidates, lit);
    case VisibilityRoute::cgal_tree:
      return tree_route.load()(surface, source, candidates, lit);
    case VisibilityRoute::fast:
      break;
  }
  return impl_->fast.query(surface, source, candidates, lit);
}

std::vector<std::optional<int>> VisibilityQuery::winding_numbers(const Points& nodes, const RaySource& source,
                                                                 std::span<const int> candidates) {
  impl_->check(nodes, source, candidates);
  std::vector<std::optional<int>> numbers(candidates.size());
  if (!impl_->closed) return numbers;
  const Surface surface = impl_->surface(nodes);
  check_nodes(surface);
  const winding::Box box = winding::bounding_box(surface);
  FilteredKernel kernel;
  const BruteForce<FilteredKernel> search{surface, kernel};
  std::map<std::array<double, 3>, std::optional<int>> of_source;  // many rays of a slot begin at one of its
                                                                  // ends
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    blocking::Ray ray = blocking::make_ray(surface, candidates[k], source);
    const auto [known, is_new] = of_source.try_emplace({ray.source[0], ray.source[1], ray.source[2]});
    if (is_new) {
      ray.moved = blocking::moved_if(search.source_on_surface(ray));
      known->second = winding::number(kernel, ray, surface, box);
    }
    numbers[k] = known->second;
  }
  return numbers;
}

std::vector<std::uint8_t> visible(const Points& nodes, const Triangles& triangles, const RaySource& source,
                                  VisibilityRoute route) {
  VisibilityQuery query(triangles, static_cast<int>(nodes.cols()));
  std::vector<int> all(static_cast<std::size_t>(triangles.cols()));
  std::iota(all.begin(), all.end(), 0);
  std::vector<std::uint8_t> lit(all.size());
  query.query(route, nodes, source, all, lit);
  return lit;
}

}  // namespace jet
