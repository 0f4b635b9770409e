// SPDX-License-Identifier: Apache-2.0
#include "jet/subdivision.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "refuse.hpp"

namespace jet {
namespace {

[[noreturn]] void refuse_mesh(const std::string& name, long long value, const std::string& allowed) {
  refuse_value("jet subdivision " + name, static_cast<double>(value), allowed);
}

void require(const char* name, Eigen::Index value, Eigen::Index wanted) {
  if (value != wanted) refuse_mesh(std::string(name) + " columns", value, std::to_string(wanted));
}

void require_nodes(const Triangles& triangles, Eigen::Index node_count) {
  if (triangles.cols() == 0) return;
  const int low = triangles.minCoeff(), high = triangles.maxCoeff();
  if (low < 0 || high >= node_count)
    refuse_mesh("node index", low < 0 ? low : high, "0 to " + std::to_string(node_count - 1));
}

void check(const Triangles& triangles, int node_count, int n) {
  if (n < 1 || n > 64) refuse_mesh("n", n, "1 to 64");
  if (triangles.cols() < 1) refuse_mesh("element count", triangles.cols(), "1 or more");
  if (triangles.cols() > std::numeric_limits<int>::max() / (n * n))
    refuse_mesh("piece count", static_cast<long long>(triangles.cols()) * n * n, "2^31 - 1 or less");
  require_nodes(triangles, node_count);
}

/// Cuts one element after the other; the first element at an edge makes its nodes.
class Cutter {
 public:
  Cutter(int n, int node_count, std::vector<Subdivision::Node>& nodes)
      : n_(n), nodes_(nodes), grid_(static_cast<std::size_t>((n + 1) * (n + 1))) {
    for (int i = 0; i < node_count; ++i) nodes_.push_back({{i, i, i}, {1.0, 0.0, 0.0}});
  }

  void place_nodes(int a, int b, int c) {
    at(0, 0) = a, at(n_, 0) = b, at(0, n_) = c;
    for (int s = 1; s < n_; ++s) {
      at(s, 0) = on_edge(a, b, s);
      at(0, s) = on_edge(a, c, s);
      at(n_ - s, s) = on_edge(b, c, s);
    }
    for (int j = 1; j < n_; ++j)
      for (int i = 1; i + j < n_; ++i) at(i, j) = add({a, b, c}, {n_ - i - j, i, j});
  }

  template <class Columns>
  void write_pieces(Columns&& columns) {
    Eigen::Index piece = 0;
    for (int j = 0; j < n_; ++j)
      for (int i = 0; i + j < n_; ++i) {
        columns.col(piece++) << at(i, j), at(i + 1, j), at(i, j + 1);
        if (i + j < n_ - 1) columns.col(piece++) << at(i + 1, j), at(i + 1, j + 1), at(i, j + 1);
      }
  }

 private:
  /// Node of the current element, i steps from a towards b and j towards c.
  int& at(int i, int j) { return grid_[static_cast<std::size_t>(i + j * (n_ + 1))]; }

  int add(std::array<int, 3> parent, std::array<int, 3> steps) {
    const auto weight = [this](int s) { return static_cast<double>(s) / n_; };
    nodes_.push_back({parent, {weight(steps[0]), weight(steps[1]), weight(steps[2])}});
    return static_cast<int>(nodes_.size()) - 1;
  }

  /// Node `step` (1 to n - 1) from a towards b. The nodes of an edge run from its lower corner to its higher
  /// one.
  int on_edge(int a, int b, int step) {
    const auto [low, high] = std::minmax(a, b);
    const auto [it, fresh] = first_.try_emplace({low, high}, static_cast<int>(nodes_.size()));
    if (fresh)
      for (int s = 1; s < n_; ++s) add({low, high, high}, {n_ - s, s, 0});
    return it->second + (a < b ? step : n_ - step) - 1;
  }

  int n_;
  std::vector<Subdivision::Node>& nodes_;
  std::vector<int> grid_;
  std::map<std::pair<int, int>, int> first_;  // first node of each edge
};

}  // namespace

Subdivision::Subdivision(const Triangles& triangles, int node_count, int n) : pieces_(0) {
  check(triangles, node_count, n);
  pieces_ = n * n;
  triangles_.resize(3, triangles.cols() * pieces_);
  Cutter cutter(n, node_count, nodes_);
  for (Eigen::Index e = 0; e < triangles.cols(); ++e) {
    cutter.place_nodes(triangles(0, e), triangles(1, e), triangles(2, e));
    cutter.write_pieces(triangles_.middleCols(e * pieces_, pieces_));
  }
}

std::vector<int> Subdivision::pieces_of(std::span<const int> elements) const {
  std::vector<int> result;
  const auto count = triangles_.cols() / pieces_;
  for (const int element : elements)
    if (element < 0 || element >= count) refuse_mesh("element", element, "0 to " + std::to_string(count - 1));
  for (const int element : elements)
    for (int k = 0; k < pieces_; ++k) result.push_back(element * pieces_ + k);
  return result;
}

void Subdivision::interpolate(const Points& values, Eigen::Matrix3Xd& result) const {
  require("result", result.cols(), node_count());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const auto& [p, w] = nodes_[i];
    if (p[0] >= values.cols() || p[1] >= values.cols() || p[2] >= values.cols())
      refuse_mesh("values columns", values.cols(), "the mesh's node count");
    const auto column = static_cast<Eigen::Index>(i);
    if (w[0] == 1.0)
      result.col(column) = values.col(p[0]);
    else
      result.col(column) = w[0] * values.col(p[0]) + w[1] * values.col(p[1]) + w[2] * values.col(p[2]);
  }
}

void Subdivision::share_areas(const Points& area_vectors, Eigen::Matrix3Xd& result) const {
  require("result", result.cols(), area_vectors.cols() * pieces_);
  const double share = 1.0 / pieces_;
  for (Eigen::Index e = 0; e < area_vectors.cols(); ++e)
    for (int k = 0; k < pieces_; ++k) result.col(e * pieces_ + k) = share * area_vectors.col(e);
}

void Subdivision::average(const FieldState& pieces, FieldState& elements) const {
  require("field of the pieces", static_cast<Eigen::Index>(pieces.overpressure.size()),
          static_cast<Eigen::Index>(elements.overpressure.size()) * pieces_);
  for (const int e : elements.candidates) elements.overpressure[static_cast<std::size_t>(e)] = 0.0;
  elements.candidates.clear();
  for (const int piece : pieces.candidates) {  // ascending, so an element's pieces follow each other
    const int e = piece / pieces_;
    if (elements.candidates.empty() || elements.candidates.back() != e) elements.candidates.push_back(e);
    elements.overpressure[static_cast<std::size_t>(e)] +=
        pieces.overpressure[static_cast<std::size_t>(piece)];
  }
  for (const int e : elements.candidates) elements.overpressure[static_cast<std::size_t>(e)] /= pieces_;
  elements.restitution = pieces.restitution;
}

void corner_means(const Points& values, const Triangles& triangles, Eigen::Matrix3Xd& result) {
  require("means", result.cols(), triangles.cols());
  require_nodes(triangles, values.cols());
  for (Eigen::Index e = 0; e < triangles.cols(); ++e)
    result.col(e) =
        ((values.col(triangles(0, e)) + values.col(triangles(1, e))) + values.col(triangles(2, e))) / 3.0;
}

}  // namespace jet
