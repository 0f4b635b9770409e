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

namespace {

/// Free sides of elements in the direction of caps, which is against the elements' own.
class FreeSides {
 public:
  explicit FreeSides(const Eigen::Matrix3Xi& elements);
  int seams() const { return seams_; }
  std::vector<std::vector<int>> rims();
  const std::vector<int>& unclear() const { return unclear_; }

 private:
  void pair_at(int node, const std::vector<int>& after);
  int before(int node, int after) const;

  std::map<std::array<int, 2>, int> third_;  // of the element with this side, in its direction
  std::map<int, std::vector<int>> after_;    // nodes after a node, one a hole
  std::map<std::array<int, 2>, int> turn_;   // node after a way to a node that two holes share
  std::set<int> shared_;
  std::vector<int> unclear_;
  int seams_ = 0;
};

FreeSides::FreeSides(const Eigen::Matrix3Xi& elements) {
  std::map<std::array<int, 2>, int> count;
  for (Eigen::Index e = 0; e < elements.cols(); ++e)
    for (Eigen::Index i = 0; i < 3; ++i) {
      const int a = elements(i, e), b = elements((i + 1) % 3, e);
      ++count[side(a, b)];
      third_[{a, b}] = elements((i + 2) % 3, e);
    }
  for (const auto& [nodes, times] : count) seams_ += times > 2;
  if (seams_ > 0) return;
  for (const auto& [nodes, third] : third_)
    if (count[side(nodes[0], nodes[1])] == 1) after_[nodes[1]].push_back(nodes[0]);
  for (const auto& [node, after] : after_)
    if (after.size() > 1) {
      shared_.insert(node);
      pair_at(node, after);
    }
}

// The last node on the way to a node along the rim of the elements that the way on to `after` bounds.
int FreeSides::before(int node, int after) const {
  auto element = third_.find({after, node});
  for (std::size_t i = 0; element != third_.end() && i < third_.size(); ++i) {
    const int c = element->second;
    element = third_.find({c, node});
    if (element == third_.end()) return c;
  }
  return -1;
}

// Elements around a node that two holes share are two fans. Each hole lies between both, so its rim comes
// along one fan and goes along the other.
void FreeSides::pair_at(int node, const std::vector<int>& after) {
  if (after.size() != 2) {
    unclear_.push_back(node);
    return;
  }
  for (const auto& [mine, other] : {std::pair{after[0], after[1]}, std::pair{after[1], after[0]}}) {
    const int from = before(node, mine);
    if (from < 0) return unclear_.push_back(node);
    turn_[{from, node}] = other;
  }
}

std::vector<std::vector<int>> FreeSides::rims() {
  std::vector<std::vector<int>> rims;
  while (!after_.empty()) {
    auto start = std::ranges::find_if(after_, [&](const auto& n) { return !shared_.contains(n.first); });
    if (start == after_.end()) start = after_.begin();
    std::vector<int> rim{start->first};
    int from = -1, to = start->second.front();
    while (true) {
      const int at = rim.back();
      std::vector<int>& ways = after_[at];
      if (const auto turn = turn_.find({from, at}); turn != turn_.end())
        to = turn->second;
      else if (from >= 0)
        to = ways.front();
      std::erase(ways, to);
      if (ways.empty()) after_.erase(at);
      if (to == rim.front() || !after_.contains(to)) break;
      if (std::ranges::find(rim, to) != rim.end()) unclear_.push_back(to);
      rim.push_back(to);
      from = at;
    }
    rims.push_back(std::move(rim));
  }
  return rims;
}

}  // namespace

Rims rims_of(const Eigen::Matrix3Xi& elements) {
  FreeSides sides(elements);
  Rims found;
  found.seams = sides.seams();
  if (found.seams > 0) return found;
  if (sides.unclear().empty()) found.rims = sides.rims();
  found.shared = sides.unclear();
  if (!found.shared.empty()) found.rims.clear();
  return found;
}

}  // namespace driver::imported
