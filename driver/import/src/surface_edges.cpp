// SPDX-License-Identifier: Apache-2.0
#include "surface_edges.hpp"

#include <algorithm>
#include <set>

#include "import/bag_surface.hpp"

namespace driver::imported {
namespace {

std::array<int, 2> side(int a, int b) {
  return a < b ? std::array{a, b} : std::array{b, a};
}

// Free nodes on the way from a to b, between them, by their share of it.
std::vector<std::pair<double, int>> between(int a, int b, const std::vector<Eigen::Vector3d>& places,
                                            const std::vector<std::pair<double, int>>& by_x) {
  const Eigen::Vector3d& from = places[static_cast<std::size_t>(a)];
  const Eigen::Vector3d way = places[static_cast<std::size_t>(b)] - from;
  const double length = way.norm();
  constexpr double tolerance = 1e-3;  // of the side: what six digits of a deck leave
  std::vector<std::pair<double, int>> found;
  const double low = from.x() + std::min(0.0, way.x()) - tolerance * length,
               high = from.x() + std::max(0.0, way.x()) + tolerance * length;
  for (auto i = std::ranges::lower_bound(by_x, std::pair{low, -1}); i != by_x.end() && i->first <= high;
       ++i) {
    if (i->second == a || i->second == b) continue;
    const Eigen::Vector3d offset = places[static_cast<std::size_t>(i->second)] - from;
    const double share = offset.dot(way) / (length * length);
    if (share <= 0.01 || share >= 0.99) continue;
    if ((offset - share * way).norm() < tolerance * length) found.emplace_back(share, i->second);
  }
  std::ranges::sort(found);
  return found;
}

// The nodes of a chain of free sides from a to b over some of these nodes; empty if there is none.
std::vector<int> chain_to(int a, int b, const std::vector<std::pair<double, int>>& nodes,
                          const Sides& sides) {
  std::vector<int> chain;
  int last = a;
  for (const auto& [share, node] : nodes) {
    if (sides.count(last, node) != 1) continue;
    chain.push_back(node);
    last = node;
  }
  if (chain.empty() || sides.count(last, b) != 1) return {};
  return chain;
}

}  // namespace

Sides::Sides(const std::vector<Polygon>& polygons) {
  for (const Polygon& polygon : polygons)
    for (std::size_t i = 0; i < polygon.corners.size(); ++i)
      ++count_[side(polygon.corners[i], polygon.corners[(i + 1) % polygon.corners.size()])];
}

int Sides::count(int a, int b) const {
  const auto found = count_.find(side(a, b));
  return found == count_.end() ? 0 : found->second;
}

void Sides::add(int a, int b) {
  ++count_[side(a, b)];
}

int join_hanging_nodes(const std::vector<Eigen::Vector3d>& places, std::vector<Polygon>& polygons) {
  const Sides sides(polygons);
  std::set<int> rim;
  for (const auto& [nodes, count] : sides.all())
    if (count == 1) rim.insert(nodes.begin(), nodes.end());
  std::vector<std::pair<double, int>> by_x;
  for (const int node : rim) by_x.emplace_back(places[static_cast<std::size_t>(node)].x(), node);
  std::ranges::sort(by_x);
  int joined = 0;
  for (Polygon& polygon : polygons) {
    std::vector<int> corners;
    const std::size_t n = polygon.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      const int a = polygon.corners[i], b = polygon.corners[(i + 1) % n];
      corners.push_back(a);
      if (sides.count(a, b) != 1) continue;
      const auto nodes = chain_to(a, b, between(a, b, places, by_x), sides);
      corners.insert(corners.end(), nodes.begin(), nodes.end());
      joined += static_cast<int>(nodes.size());
    }
    polygon.corners = std::move(corners);
  }
  return joined;
}

std::vector<std::array<int, 3>> pieces_of(const Polygon& polygon,
                                          const std::function<Eigen::Vector3d(int)>& reference,
                                          Sides& sides) {
  const auto& c = polygon.corners;
  if (c.size() == 3) return {{c[0], c[1], c[2]}};
  if (c.size() == 4) {
    const double first = (reference(c[2]) - reference(c[0])).squaredNorm(),
                 second = (reference(c[3]) - reference(c[1])).squaredNorm();
    const bool free_first = sides.count(c[0], c[2]) == 0, free_second = sides.count(c[1], c[3]) == 0;
    const bool along_first = free_first && (first <= second || !free_second);
    along_first ? sides.add(c[0], c[2]) : sides.add(c[1], c[3]);
    if (along_first) return {{c[0], c[1], c[2]}, {c[0], c[2], c[3]}};
    return {{c[0], c[1], c[3]}, {c[1], c[2], c[3]}};
  }
  std::vector<Eigen::Vector3d> corners;
  for (const int node : c) corners.push_back(reference(node));
  auto pieces = triangles_of(corners);
  for (auto& piece : pieces)
    for (int& corner : piece) corner = c[static_cast<std::size_t>(corner)];
  return pieces;
}

Rims rims_of(const Eigen::Matrix3Xi& elements) {
  std::map<std::array<int, 2>, int> count;
  for (Eigen::Index e = 0; e < elements.cols(); ++e)
    for (Eigen::Index i = 0; i < 3; ++i) ++count[side(elements(i, e), elements((i + 1) % 3, e))];
  Rims found;
  for (const auto& [nodes, times] : count) found.seams += times > 2;
  std::map<int, int> next;  // along the cap: against the elements' own direction
  for (Eigen::Index e = 0; e < elements.cols(); ++e)
    for (Eigen::Index i = 0; i < 3; ++i) {
      const int a = elements(i, e), b = elements((i + 1) % 3, e);
      if (count[side(a, b)] == 1 && !next.emplace(b, a).second) found.shared.push_back(b);
    }
  if (!found.shared.empty()) return found;
  while (!next.empty()) {
    std::vector<int> rim{next.begin()->first};
    for (auto step = next.find(rim.back()); step != next.end(); step = next.find(rim.back())) {
      const int to = step->second;
      next.erase(step);
      if (to == rim.front()) break;
      rim.push_back(to);
    }
    found.rims.push_back(std::move(rim));
  }
  return found;
}

}  // namespace driver::imported
