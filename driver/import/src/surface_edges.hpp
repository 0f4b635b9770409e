// SPDX-License-Identifier: Apache-2.0
// Edges of a bag under construction: nodes that hang on them, sides of elements, rims of holes.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <map>
#include <vector>

namespace driver::imported {

struct Polygon {
  std::vector<int> corners;
  int panel;
};

/// How many polygons have each side.
class Sides {
 public:
  explicit Sides(const std::vector<Polygon>& polygons);
  int count(int a, int b) const;
  void add(int a, int b);
  const std::map<std::array<int, 2>, int>& all() const { return count_; }

 private:
  std::map<std::array<int, 2>, int> count_;
};

/// Inserts nodes that lie on a free side of a polygon, if free sides join them to its ends. Returns their
/// number.
int join_hanging_nodes(const std::vector<Eigen::Vector3d>& places, std::vector<Polygon>& polygons);

/// A polygon as triangles by the stress-free places: quads along the shorter diagonal that is not a side
/// already.
std::vector<std::array<int, 3>> pieces_of(const Polygon& polygon,
                                          const std::function<Eigen::Vector3d(int)>& reference, Sides& sides);

/// The holes of a surface. Two may share a node.
struct Rims {
  std::vector<std::vector<int>> rims;  // each in the direction of a cap that faces outward
  int seams = 0;                       // edges of more than two elements
  std::vector<int> shared;             // nodes where rims cannot be told apart; `rims` is then empty
};
Rims rims_of(const Eigen::Matrix3Xi& elements);

}  // namespace driver::imported
