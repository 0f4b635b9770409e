// SPDX-License-Identifier: Apache-2.0
// Packs before and after folding: two sheets on each other, distances of layers, stretches.
#include "fold_pack.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "mesh/fold.hpp"

namespace mesh {
namespace {

// +1 and -1 for nodes of the upper and the lower sheet, 0 on the seam, by the area vectors around them.
std::vector<int> sheets_of(const Eigen::Matrix3Xd& nodes, const Eigen::Matrix3Xi& elements,
                           const PackSide& side) {
  constexpr double level = 0.1;  // of the area about a node; on the seam both sheets cancel
  Eigen::VectorXd up = Eigen::VectorXd::Zero(nodes.cols()), about = up;
  for (const auto& element : elements.colwise()) {
    const Eigen::Vector3d a = nodes.col(element[0]), b = nodes.col(element[1]), c = nodes.col(element[2]);
    const Eigen::Vector3d area = (b - a).cross(c - a);
    up(element).array() += side.sign * area[side.axis];
    about(element).array() += area.norm();
  }
  std::vector<int> sheets;
  for (Eigen::Index i = 0; i < nodes.cols(); ++i)
    sheets.push_back(std::abs(up[i]) <= level * about[i] ? 0 : up[i] > 0.0 ? 1 : -1);
  return sheets;
}

void require_two_sheets(const std::vector<int>& sheets, const Eigen::Matrix3Xi& elements) {
  for (const auto& element : elements.colwise()) {
    int low = 1, high = -1;
    for (const int node : element) {
      low = std::min(low, sheets[static_cast<std::size_t>(node)]);
      high = std::max(high, sheets[static_cast<std::size_t>(node)]);
    }
    if (high - low > 1 || (low == 0 && high == 0))
      throw std::invalid_argument(
          "press: needs two sheets that are sewn to each other at their rims; flatten other bags");
  }
}

Eigen::Matrix<double, 3, 2> sides(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes,
                                  const Eigen::Vector3i& element) {
  Eigen::Matrix<double, 3, 2> pair;
  pair << nodes.col(element[1]) - nodes.col(element[0]), nodes.col(element[2]) - nodes.col(element[0]);
  return pair;
}

// Elements by the cells of a grid across the thin axis.
class Columns {
 public:
  Columns(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes, const Eigen::Ref<const Eigen::Matrix3Xi>& elements,
          int thin_axis, const std::vector<bool>& left_out)
      : x_(nodes.row((thin_axis + 1) % 3)), y_(nodes.row((thin_axis + 2) % 3)) {
    count_ = std::max(1, static_cast<int>(std::sqrt(0.5 * static_cast<double>(elements.cols()))));
    cells_.resize(static_cast<std::size_t>(count_) * static_cast<std::size_t>(count_));
    low_x_ = x_.minCoeff();
    low_y_ = y_.minCoeff();
    const double size = std::max({x_.maxCoeff() - low_x_, y_.maxCoeff() - low_y_, 1e-300});
    step_ = size / count_;
    for (int e = 0; e < elements.cols(); ++e) {
      const Eigen::Vector3i corners = elements.col(e);
      const Eigen::Array3d x = x_(corners), y = y_(corners);
      if (left_out[static_cast<std::size_t>(e)] ||
          is_on_edge(nodes.col(corners[0]), nodes.col(corners[1]), nodes.col(corners[2]), thin_axis))
        continue;
      for (int i = cell(x.minCoeff() - low_x_); i <= cell(x.maxCoeff() - low_x_); ++i)
        for (int j = cell(y.minCoeff() - low_y_); j <= cell(y.maxCoeff() - low_y_); ++j)
          cells_[index(i, j)].push_back(e);
    }
  }
  const std::vector<int>& at(Eigen::Index node) const {
    return cells_[index(cell(x_[node] - low_x_), cell(y_[node] - low_y_))];
  }
  // Barycentric coordinates of a node in an element, as seen along the axis.
  Eigen::Array3d place(Eigen::Index node, const Eigen::Vector3i& corners) const {
    const Eigen::Array3d x = x_(corners).array() - x_[node], y = y_(corners).array() - y_[node];
    const Eigen::Array3d twice{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2],
                               x[0] * y[1] - x[1] * y[0]};
    return twice / twice.sum();
  }

 private:
  int cell(double along) const { return std::clamp(static_cast<int>(along / step_), 0, count_ - 1); }
  std::size_t index(int i, int j) const { return static_cast<std::size_t>(i * count_ + j); }

  Eigen::VectorXd x_, y_;
  int count_;
  double low_x_, low_y_, step_;
  std::vector<std::vector<int>> cells_;
};

std::vector<std::vector<int>> neighbours(const Eigen::Ref<const Eigen::Matrix3Xi>& elements,
                                         Eigen::Index nodes) {
  std::vector<std::vector<int>> about(static_cast<std::size_t>(nodes));
  for (const auto& element : elements.colwise())
    for (const int node : element)
      about[static_cast<std::size_t>(node)].insert(about[static_cast<std::size_t>(node)].end(),
                                                   element.begin(), element.end());
  return about;
}

// Nodes of elements that count, but for those of side walls.
std::vector<bool> nodes_of_layers(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes,
                                  const Eigen::Ref<const Eigen::Matrix3Xi>& elements, int thin_axis,
                                  const std::vector<bool>& left_out) {
  std::vector<bool> counts(static_cast<std::size_t>(nodes.cols()), false), in_wall = counts;
  for (int e = 0; e < elements.cols(); ++e) {
    const Eigen::Vector3i corners = elements.col(e);
    const bool wall =
        is_on_edge(nodes.col(corners[0]), nodes.col(corners[1]), nodes.col(corners[2]), thin_axis);
    for (const int node : corners) {
      if (!left_out[static_cast<std::size_t>(e)]) counts[static_cast<std::size_t>(node)] = true;
      if (wall) in_wall[static_cast<std::size_t>(node)] = true;
    }
  }
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = counts[i] && !in_wall[i];
  return counts;
}

}  // namespace

PackSide thin_side(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes, const std::vector<int>& fixed) {
  const Eigen::Vector3d low = nodes.rowwise().minCoeff(), high = nodes.rowwise().maxCoeff();
  PackSide side;
  (high - low).minCoeff(&side.axis);
  double mean = 0.0;
  for (const int node : fixed) mean += nodes(side.axis, node) / static_cast<double>(fixed.size());
  if (!fixed.empty() && 2.0 * mean > low[side.axis] + high[side.axis]) side.sign = -1.0;
  return side;
}

void Folding::press(double gap) {
  if (!(gap > 0.0 && std::isfinite(gap)))
    throw std::invalid_argument("gap: needs a finite number above 0 [m]");
  // A pack is thin. A wider gap would be found as one of the next fold's.
  double extent = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
    if (axis != side_.axis)
      extent = std::min(extent, nodes_.row(axis).maxCoeff() - nodes_.row(axis).minCoeff());
  if (gap > 0.1 * extent) {
    std::ostringstream text;
    text.precision(3);
    text << "gap = " << gap << " m, allowed: up to " << 0.1 * extent << " m, a tenth of the sheets' extent";
    throw std::invalid_argument(text.str());
  }
  const std::vector<int> sheets = sheets_of(nodes_, mesh_->elements, side_);
  require_two_sheets(sheets, mesh_->elements);
  const int base = fixed_.empty() ? -1 : sheets[static_cast<std::size_t>(fixed_.front())];
  const double plane =
      fixed_.empty() ? nodes_.row(side_.axis).minCoeff() : nodes_(side_.axis, fixed_.front());
  for (const int node : fixed_)
    if (sheets[static_cast<std::size_t>(node)] != base || nodes_(side_.axis, node) != plane)
      throw std::invalid_argument("press: the fixed nodes must lie in one plane and in one sheet");
  for (Eigen::Index i = 0; i < nodes_.cols(); ++i)
    nodes_(side_.axis, i) = plane + 0.5 * gap * side_.sign * (sheets[static_cast<std::size_t>(i)] - base);
}

bool is_on_edge(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, int thin_axis) {
  constexpr double steepest = 0.5;  // cosine of 60 degrees
  const Eigen::Vector3d area = (b - a).cross(c - a);
  return !(std::abs(area[thin_axis]) > steepest * area.norm());
}

// Gathered fabric is left out: its elements do not lie as the pack's layers do.
double Folding::layer_distance() const {
  std::vector<bool> left_out;
  for (const auto& element : mesh_->elements.colwise())
    left_out.push_back(std::ranges::any_of(
        element, [&](int node) { return bool{gathered_[static_cast<std::size_t>(node)]}; }));
  return least_layer_distance(nodes_, mesh_->elements, side_.axis, left_out);
}

double least_layer_distance(const Eigen::Ref<const Eigen::Matrix3Xd>& nodes,
                            const Eigen::Ref<const Eigen::Matrix3Xi>& elements, int thin_axis,
                            const std::vector<bool>& left_out) {
  constexpr double rounding = 1e-9;  // of barycentric coordinates
  const Columns columns(nodes, elements, thin_axis, left_out);
  const std::vector<bool> counts = nodes_of_layers(nodes, elements, thin_axis, left_out);
  const auto about = neighbours(elements, nodes.cols());
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index node = 0; node < nodes.cols(); ++node) {
    if (!counts[static_cast<std::size_t>(node)]) continue;
    const auto& near = about[static_cast<std::size_t>(node)];
    for (const int e : columns.at(node)) {
      const Eigen::Vector3i corners = elements.col(e);
      const Eigen::Array3d place = columns.place(node, corners);
      if (!(place.minCoeff() >= -rounding) || std::ranges::find_first_of(corners, near) != corners.end())
        continue;
      double height = 0.0;
      for (int i = 0; i < 3; ++i) height += place[i] * nodes(thin_axis, corners[i]);
      least = std::min(least, std::abs(height - nodes(thin_axis, node)));
    }
  }
  return least;
}

std::vector<std::array<double, 2>> principal_stretches(const Eigen::Ref<const Eigen::Matrix3Xd>& design,
                                                       const Eigen::Ref<const Eigen::Matrix3Xd>& shape,
                                                       const Eigen::Ref<const Eigen::Matrix3Xi>& elements) {
  std::vector<std::array<double, 2>> stretches;
  for (const auto& element : elements.colwise()) {
    const Eigen::Matrix<double, 3, 2> before = sides(design, element), after = sides(shape, element);
    // Eigenvalues of C = G0^-1 G with the metrics G = sides^T sides
    const Eigen::Matrix2d c = (before.transpose() * before).inverse() * (after.transpose() * after);
    const double middle = 0.5 * c.trace();
    const double apart = std::sqrt(std::max(0.0, middle * middle - c.determinant()));
    stretches.push_back({std::sqrt(std::max(0.0, middle - apart)), std::sqrt(std::max(0.0, middle + apart))});
  }
  return stretches;
}

}  // namespace mesh
