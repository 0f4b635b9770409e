// SPDX-License-Identifier: Apache-2.0
#include "jet/visibility.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <mutex>
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

/// What queries on one mesh share.
struct VisibilityQuery::Mesh {
  int node_count = 0;  // nodes of the caller
  bool closed = false;
  std::vector<std::array<int, 3>> triangles{};  // they index `used` if there are unused nodes
  std::vector<Role> roles{};
  std::vector<int> used{};  // nodes that elements use; empty if all are used

  int count() const { return static_cast<int>(triangles.size()); }
  int used_count() const { return used.empty() ? node_count : static_cast<int>(used.size()); }
  /// Made by the first of the queries that needs it.
  const std::shared_ptr<const OrderedMesh>& order() const {
    std::call_once(once_, [&] { order_ = std::make_shared<const OrderedMesh>(triangles); });
    return order_;
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
  }
  static void assign(std::vector<Role>& roles, std::span<const int> elements, const char* name, Role role) {
    for (const int e : elements) {
      require_index(name, e, static_cast<int>(roles.size()));
      roles[static_cast<std::size_t>(e)] = role;
    }
  }

 private:
  mutable std::once_flag once_{};
  mutable std::shared_ptr<const OrderedMesh> order_{};
};

struct VisibilityQuery::Impl {
  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const std::vector<Role>> roles;  // of the elements that are not left out
  bool closed;
  std::optional<BothWays> fast{};  // workspace, made by the first query
  Eigen::Matrix3Xd copy{};         // coordinates of the nodes in use, if others are not

  int count() const { return mesh->count(); }
  void prepare() {
    if (fast) return;
    fast.emplace();
    fast->prepare(mesh->order(), static_cast<std::size_t>(mesh->used_count()), closed);
    make_copy();
  }
  void make_copy() {
    if (!mesh->used.empty()) copy.resize(3, mesh->used_count());
  }

  Surface surface(const Points& nodes) {
    const std::vector<int>& used = mesh->used;
    Surface all{nodes.data(), nodes.outerStride(), mesh->triangles.data(), roles->data(),
                count(),      mesh->used_count()};
    if (used.empty()) return all;
    for (int i = 0; i < mesh->used_count(); ++i) copy.col(i) = nodes.col(used[static_cast<std::size_t>(i)]);
    all.nodes = copy.data(), all.stride = 3, all.names = used.data();
    return all;
  }

  /// The routes check the nodes' coordinates.
  void check(const Points& nodes, const RaySource& source, std::span<const int> candidates) const {
    check_source(source);
    const auto last = static_cast<unsigned>(count() - 1);
    unsigned signs = 0;  // checked together; named only if one is bad
    for (const int e : candidates) signs |= static_cast<unsigned>(e) | (last - static_cast<unsigned>(e));
    for (std::size_t k = 0; signs >> 31 != 0 && k < candidates.size(); ++k)
      require_index("candidate", candidates[k], count());
    if (nodes.cols() != mesh->node_count)
      refuse("nodes has " + std::to_string(nodes.cols()) +
             " columns, allowed: " + std::to_string(mesh->node_count));
  }
};

VisibilityQuery::VisibilityQuery(const Triangles& triangles, int node_count, const SurfaceRoles& roles) {
  if (triangles.cols() == 0) refuse("mesh has no element, allowed: 1 or more");
  const auto mesh = std::make_shared<Mesh>();
  mesh->node_count = node_count;
  for (Eigen::Index e = 0; e < triangles.cols(); ++e) {
    for (int i = 0; i < 3; ++i) require_index("node index", triangles(i, e), node_count);
    mesh->triangles.push_back({triangles(0, e), triangles(1, e), triangles(2, e)});
  }
  mesh->roles.assign(mesh->triangles.size(), Role::fabric);
  Mesh::assign(mesh->roles, roles.attachment_elements, "attachment element", Role::attachment);
  Mesh::assign(mesh->roles, roles.null_elements, "null element", Role::null_panel);
  mesh->leave_out_unused();
  mesh->closed = is_closed(mesh->triangles);
  impl_ = std::make_unique<Impl>(Impl{mesh, {mesh, &mesh->roles}, mesh->closed});
}

VisibilityQuery::VisibilityQuery(const VisibilityQuery& other)
    : impl_(std::make_unique<Impl>(Impl{other.impl_->mesh, other.impl_->roles, other.impl_->closed})) {}
VisibilityQuery& VisibilityQuery::operator=(const VisibilityQuery& other) {
  return *this = VisibilityQuery(other);
}
VisibilityQuery::~VisibilityQuery() = default;
VisibilityQuery::VisibilityQuery(VisibilityQuery&&) noexcept = default;
VisibilityQuery& VisibilityQuery::operator=(VisibilityQuery&&) noexcept = default;

void VisibilityQuery::prepare() {
  impl_->prepare();
}

void VisibilityQuery::leave_out(std::span<const int> elements) {
  for (const int e : elements) require_index("element left out", e, impl_->count());
  auto roles = impl_->mesh->roles;
  Mesh::assign(roles, elements, "element left out", Role::absent);
  impl_->roles = std::make_shared<const std::vector<Role>>(std::move(roles));
  impl_->closed = impl_->mesh->closed && elements.empty();
  impl_->fast.reset();
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
  impl_->prepare();
  impl_->fast->move_to(displacement_bound);  // for every route, even if the input is then refused
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
  return impl_->fast->query(surface, source, candidates, lit);
}

std::vector<std::optional<int>> VisibilityQuery::winding_numbers(const Points& nodes, const RaySource& source,
                                                                 std::span<const int> candidates) {
  impl_->check(nodes, source, candidates);
  std::vector<std::optional<int>> numbers(candidates.size());
  if (!impl_->closed) return numbers;
  impl_->make_copy();
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
