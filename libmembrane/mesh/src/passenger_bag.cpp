// SPDX-License-Identifier: Apache-2.0
#include "mesh/passenger_bag.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "checks.hpp"
#include "passenger_profile.hpp"

namespace mesh {
namespace {

[[noreturn]] void refuse(const char* field, double value, const std::string& allowed) {
  reject("passenger_bag", field, value, allowed);
}

void require_length(const char* field, double value) {
  if (!(value > 0.0 && std::isfinite(value))) refuse(field, value, "positive and finite");
}

void require_cells(const char* field, int value, int low, int high) {
  if (value < low || value > high) refuse(field, value, std::to_string(low) + " to " + std::to_string(high));
}

void check_lengths(const PassengerBagOptions& o) {
  require_length("depth", o.depth);
  require_length("width", o.width);
  require_length("height", o.height);
  require_length("back_radius", o.back_radius);
  require_length("front_radius", o.front_radius);
  if (o.back_radius + o.front_radius > o.depth)
    refuse("back_radius + front_radius", o.back_radius + o.front_radius, "at most depth");
  if (2.0 * o.back_radius > o.height) refuse("back_radius", o.back_radius, "at most height / 2");
  if (2.0 * o.front_radius > o.height) refuse("front_radius", o.front_radius, "at most height / 2");
}

void check_cells(const PassengerBagOptions& o) {
  constexpr int most = 100;  // the cost of smoothing grows with its fourth power
  require_cells("depth_cells", o.depth_cells, 4, most);
  require_cells("width_cells", o.width_cells, 2, most);
  require_cells("height_cells", o.height_cells, 3, most);
  require_cells("attachment_width_cells", o.attachment_width_cells, 2, o.width_cells);
  require_cells("attachment_height_cells", o.attachment_height_cells, 1, o.height_cells);
  require_cells("vent_depth_cell", o.vent_depth_cell, 1, o.depth_cells - 3);
  require_cells("vent_height_cell", o.vent_height_cell, 1, o.height_cells - 2);
  if (o.width_cells % 2 != 0) refuse("width_cells", o.width_cells, "even");
  if (o.attachment_width_cells % 2 != 0) refuse("attachment_width_cells", o.attachment_width_cells, "even");
  if ((o.attachment_height_cells - o.height_cells) % 2 != 0)
    refuse("attachment_height_cells", o.attachment_height_cells, "of the parity of height_cells");
  const double flat = o.height - 2.0 * o.back_radius;
  if (o.attachment_height_cells * rim_step(o) > flat)
    refuse("attachment_height_cells", o.attachment_height_cells,
           "small enough to lie on the flat of the back");
}

using Quad = std::array<int, 4>;  // nodes, counter-clockwise seen from outside

class PassengerBagBuilder {
  enum Panel { kMain, kSideLeft, kSideRight, kAttachment, kVent, kPanelCount };

 public:
  explicit PassengerBagBuilder(const PassengerBagOptions& options) : o_(options), side_(options) {
    add_nodes();
    add_main_panel();
    add_side_panel(kSideLeft);
    add_side_panel(kSideRight);
  }

  PassengerBag build() const {
    PassengerBag bag;
    bag.mesh.nodes = nodes_;
    bag.mesh.panel_names = {"main", "side_left", "side_right", "attachment", "vent"};
    std::vector<Eigen::Vector3i> elements;
    for (int panel = 0; panel < kPanelCount; ++panel)
      for (const Eigen::Vector3i& element : panels_[static_cast<std::size_t>(panel)]) {
        elements.push_back(element);
        bag.mesh.panel.push_back(panel);
      }
    bag.mesh.elements.resize(3, static_cast<Eigen::Index>(elements.size()));
    for (std::size_t e = 0; e < elements.size(); ++e)
      bag.mesh.elements.col(static_cast<Eigen::Index>(e)) = elements[e];
    bag.strap_anchors = strap_anchors();
    return bag;
  }

 private:
  int main_node(int r, int j) const { return r % rim_count(o_) * (o_.width_cells + 1) + j; }

  int side_node(Panel panel, int i, int k) const {
    if (const int r = side_.rim_index(i, k); r >= 0)
      return main_node(r, panel == kSideLeft ? 0 : o_.width_cells);
    const int interior = (o_.depth_cells - 1) * (o_.height_cells - 1);
    const int first = rim_count(o_) * (o_.width_cells + 1) + (panel == kSideLeft ? 0 : interior);
    return first + (i - 1) + (k - 1) * (o_.depth_cells - 1);
  }

  void add_nodes() {
    const int interior = (o_.depth_cells - 1) * (o_.height_cells - 1);
    nodes_.resize(3, rim_count(o_) * (o_.width_cells + 1) + 2 * interior);
    const std::vector<ProfilePoint> rim = rim_points(o_);
    for (int r = 0; r < rim_count(o_); ++r)
      for (int j = 0; j <= o_.width_cells; ++j) {
        const double y = o_.width * (2 * j - o_.width_cells) / (2 * o_.width_cells);
        const ProfilePoint& p = rim[static_cast<std::size_t>(r)];
        nodes_.col(main_node(r, j)) << p.x(), y, p.y();
      }
    for (const Panel panel : {kSideLeft, kSideRight})
      for (int k = 1; k < o_.height_cells; ++k)
        for (int i = 1; i < o_.depth_cells; ++i)
          nodes_.col(side_node(panel, i, k)) << side_(i, k).x(), (panel == kSideLeft ? -0.5 : 0.5) * o_.width,
              side_(i, k).y();
  }

  // Two elements of a cell; `first` takes the diagonal from corner 0 to corner 2.
  void add_cell(Panel panel, const Quad& q, bool first) {
    auto& elements = panels_[panel];
    if (first) {
      elements.emplace_back(q[0], q[1], q[2]);
      elements.emplace_back(q[0], q[2], q[3]);
    } else {
      elements.emplace_back(q[0], q[1], q[3]);
      elements.emplace_back(q[1], q[2], q[3]);
    }
  }

  bool in_attachment(int r, int j) const {
    return std::abs(2 * r + 1 - o_.height_cells) < o_.attachment_height_cells &&
           std::abs(2 * j + 1 - o_.width_cells) < o_.attachment_width_cells;
  }

  // Diagonals alternate, so that with an even width_cells they are mirror images about y = 0.
  void add_main_panel() {
    for (int r = 0; r < rim_count(o_); ++r)
      for (int j = 0; j < o_.width_cells; ++j)
        add_cell(in_attachment(r, j) ? kAttachment : kMain,
                 {main_node(r, j), main_node(r + 1, j), main_node(r + 1, j + 1), main_node(r, j + 1)},
                 (r + j) % 2 == 0);
  }

  bool in_vent(Panel panel, int i, int k) const {
    return panel == kSideRight && k == o_.vent_height_cell &&
           (i == o_.vent_depth_cell || i == o_.vent_depth_cell + 1);
  }

  void add_side_panel(Panel panel) {
    for (int k = 0; k < o_.height_cells; ++k)
      for (int i = 0; i < o_.depth_cells; ++i) {
        const int a = side_node(panel, i, k), b = side_node(panel, i + 1, k);
        const int c = side_node(panel, i + 1, k + 1), d = side_node(panel, i, k + 1);
        const Quad outward = panel == kSideLeft ? Quad{a, b, c, d} : Quad{a, d, c, b};
        add_cell(in_vent(panel, i, k) ? kVent : panel, outward, side_.rising_diagonal(i, k));
      }
  }

  std::array<std::array<int, 2>, 2> strap_anchors() const {
    const int j = o_.width_cells / 2;
    const int upper = (o_.height_cells + o_.attachment_height_cells) / 2;
    const int lower = o_.height_cells - upper;
    const int front = 2 * o_.height_cells + o_.depth_cells;  // the rim index opposite r is front - r
    return {{{main_node(upper, j), main_node(front - upper, j)},
             {main_node(lower, j), main_node(front - lower, j)}}};
  }

  PassengerBagOptions o_;
  SideGrid side_;
  Eigen::Matrix3Xd nodes_;
  std::array<std::vector<Eigen::Vector3i>, kPanelCount> panels_;
};

const PassengerBagOptions& checked(const PassengerBagOptions& options) {
  check_lengths(options);
  check_cells(options);
  return options;
}

}  // namespace

PassengerBag passenger_bag(const PassengerBagOptions& options) {
  return PassengerBagBuilder(checked(options)).build();
}

}  // namespace mesh
