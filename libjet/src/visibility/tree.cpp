// SPDX-License-Identifier: Apache-2.0
// Compiled like predicates.cpp with -frounding-math -ftrapping-math.
#include "visibility/tree.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

#include "jet_tree/tree_route.hpp"
#include "visibility/one_by_one.hpp"

namespace jet {
namespace {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = CgalKernel::Point_3;
using Segment = CgalKernel::Segment_3;
using Triangle = CgalKernel::Triangle_3;
using Iterator = std::vector<Triangle>::const_iterator;
using Primitive = CGAL::AABB_triangle_primitive<CgalKernel, Iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<CgalKernel, Primitive>>;

Point point(const double* p) {
  return {p[0], p[1], p[2]};
}

bool meets(const Segment& segment, const CGAL::Bbox_3& box) {
  return CGAL::do_intersect(segment, box);
}

bool meets(const Point& p, const CGAL::Bbox_3& box) {
  for (int i = 0; i < 3; ++i) {
    if (p[i] < box.min(i) || p[i] > box.max(i)) return false;
  }
  return true;
}

/// Walk of the tree that asks `accept(element)` at the leaves and stops at the first yes.
template <class Accept>
struct FirstAccepted {
  const Iterator first;
  Accept accept;
  bool found = false;

  bool go_further() const { return !found; }
  template <class Query>
  void intersection(const Query&, const Primitive& primitive) {
    found = accept(static_cast<int>(primitive.id() - first));
  }
  template <class Query, class Node>
  bool do_intersect(const Query& query, const Node& node) const {
    return meets(query, node.bbox());
  }
};

}  // namespace

struct ElementTree::Impl {
  Surface surface;
  std::vector<Triangle> triangles;
  Tree tree;

  template <class Query, class Accept>
  bool any(const Query& query, Accept accept) const {
    FirstAccepted<Accept> walk{triangles.begin(), accept};
    tree.traversal(query, walk);
    return walk.found;
  }
};

ElementTree::ElementTree(const Surface& surface) : impl_(std::make_unique<Impl>()) {
  impl_->surface = surface;
  impl_->triangles.reserve(static_cast<std::size_t>(surface.count));
  for (int e = 0; e < surface.count; ++e) {
    impl_->triangles.emplace_back(point(surface.corner(e, 0)), point(surface.corner(e, 1)),
                                  point(surface.corner(e, 2)));
  }
  impl_->tree.rebuild(impl_->triangles.cbegin(), impl_->triangles.cend());
  impl_->tree.build();
}

ElementTree::~ElementTree() = default;

bool ElementTree::source_on_surface(exact::Kernel& kernel, const blocking::Ray& ray) const {
  return impl_->any(point(ray.source),
                    [&](int e) { return blocking::source_on(kernel, ray, impl_->surface, e); });
}

// Blockers of a moved source meet the closed segment of the unmoved one, so one search serves both.
bool ElementTree::blocked(exact::Kernel& kernel, const blocking::Ray& ray, int target_element) const {
  if (std::equal(ray.source, ray.source + 3, ray.target)) return false;
  return impl_->any(Segment(point(ray.source), point(ray.target)), [&](int e) {
    return e != target_element && !impl_->surface.never_blocks(e) &&
           blocking::blocks(kernel, ray, impl_->surface, e);
  });
}

namespace {

struct TreeSearch {
  const ElementTree& tree;
  exact::Kernel& kernel;

  bool source_on_surface(const blocking::Ray& ray) const { return tree.source_on_surface(kernel, ray); }
  bool blocked(const blocking::Ray& ray, int target) const { return tree.blocked(kernel, ray, target); }
};

VisibilityCounters query_by_tree(const Surface& surface, const RaySource& source,
                                 std::span<const int> candidates, std::span<std::uint8_t> lit) {
  exact::Kernel kernel;
  const ElementTree tree(surface);
  VisibilityCounters counters = query_by(TreeSearch{tree, kernel}, surface, source, candidates, lit);
  counters.tree_builds = 1;
  return counters;
}

}  // namespace

bool add_tree_route() {
  set_tree_route(query_by_tree);
  return true;
}

}  // namespace jet
