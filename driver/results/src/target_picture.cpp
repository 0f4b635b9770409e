// SPDX-License-Identifier: Apache-2.0
#include "target_picture.hpp"

#include <algorithm>

#include "mesh/icosphere.hpp"

namespace driver {
namespace {

// Lines of the picture across one side, as numbers of the target's lines.
std::vector<int> picture_lines(int cells) {
  constexpr int most = 30;
  const int shown = std::min(cells, most);
  std::vector<int> lines;
  for (int i = 0; i <= shown; ++i) lines.push_back(i * cells / shown);
  return lines;
}

// The cell of the picture that holds each cell of the target, along one side.
std::vector<std::size_t> holders(const std::vector<int>& lines) {
  std::vector<std::size_t> list;
  for (int i = 0; i < lines.back(); ++i)
    list.push_back(static_cast<std::size_t>(std::ranges::upper_bound(lines, i) - lines.begin() - 1));
  return list;
}

}  // namespace

TargetPicture::TargetPicture(const TargetPart& target) {
  const std::vector<int> x = picture_lines(target.columns), y = picture_lines(target.rows);
  const int columns = static_cast<int>(x.size()) - 1, rows = static_cast<int>(y.size()) - 1;
  triangles_ = mesh::rectangle(columns, rows, 1.0, 1.0, mesh::Diagonals::union_jack).elements;
  nodes_.resize(3, std::ssize(x) * std::ssize(y));
  Eigen::Index n = 0;
  for (const int j : y)
    for (const int i : x) nodes_.col(n++) = target.nodes.col(i + j * (target.columns + 1));
  const std::vector<std::size_t> column_of = holders(x), row_of = holders(y);
  share_.assign((x.size() - 1) * (y.size() - 1), 0.0);
  for (const std::size_t row : row_of)
    for (const std::size_t column : column_of) {
      cell_of_.push_back(column + row * (x.size() - 1));
      share_[cell_of_.back()] += 2.0;
    }
  for (double& share : share_) share = 1.0 / share;
}

JetLoads TargetPicture::loads(const State& state) const {
  JetLoads means{std::vector<double>(2 * share_.size(), 0.0), std::vector<std::uint8_t>(2 * share_.size())};
  add_jet_loads(state, [&](std::size_t e, double pressure, std::uint8_t mask) {
    const std::size_t cell = cell_of_[e / 2], first = 2 * cell;
    for (const std::size_t triangle : {first, first + 1}) means.add(triangle, pressure * share_[cell], mask);
  });
  return means;
}

}  // namespace driver
