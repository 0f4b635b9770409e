// SPDX-License-Identifier: Apache-2.0
#include "mesh/fold.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

#include "checks.hpp"
#include "fold_pack.hpp"

namespace mesh {
namespace {

constexpr double spread = 0.02;   // of the gap: gathered nodes do not coincide
constexpr double spacing = 1.05;  // of upright strips, over that of the layers: makes up for the spread
constexpr double unstretched = 1e-3;

std::string metres(double value) {
  std::ostringstream text;
  text.precision(3);
  text << value << " m";
  return text.str();
}

[[noreturn]] void refuse(const std::string& message) {
  throw std::invalid_argument(message);
}

void require_gap(double gap) {
  if (!(gap > 0.0 && std::isfinite(gap))) refuse("gap = " + metres(gap) + ": needs a finite number above 0");
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// The part that stays: the fixed nodes, or the middle of a bag without any.
Range kept_part(const Eigen::Matrix3Xd& nodes, const std::vector<int>& fixed, int axis) {
  Range kept;
  for (const int node : fixed) kept.add(nodes(axis, node));
  if (fixed.empty()) kept.add(0.5 * (nodes.row(axis).minCoeff() + nodes.row(axis).maxCoeff()));
  return kept;
}

struct Step {
  double at, direction, up;  // up = -1 lays the flap under the pack
};

// Outermost lines first, the side of the first line of `at` before the other one.
std::vector<Step> steps_of(const FoldOptions& options, const Range& kept) {
  std::vector<Step> steps;
  for (const double first : {options.at.front(), 2.0 * kept.low - options.at.front()}) {
    const double direction = first > kept.low ? 1.0 : -1.0;
    std::vector<double> lines;
    for (const double at : options.at)
      if ((at > kept.low) == (direction > 0.0)) lines.push_back(at);
    std::ranges::sort(lines, [&](double a, double b) { return direction * a > direction * b; });
    if (options.type == FoldType::letter && lines.size() > 1)
      refuse(
          "at: a letter fold has one line on each side of the part that stays; use a roll or an accordion");
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const bool under = options.type == FoldType::accordion && (lines.size() - i) % 2 == 0;
      steps.push_back({lines[i], direction, under ? -1.0 : 1.0});
    }
  }
  return steps;
}

void check_lines(const FoldOptions& options, const Eigen::Matrix3Xd& nodes, const Range& kept) {
  const double low = nodes.row(options.axis).minCoeff(), high = nodes.row(options.axis).maxCoeff();
  if (options.at.empty()) refuse("at: needs the coordinate of a fold line");
  for (const double at : options.at) {
    if (!(at > low && at < high))
      refuse("at = " + metres(at) + ": the fold line must lie within the bag, between " + metres(low) +
             " and " + metres(high));
    if (at >= kept.low && at <= kept.high)
      refuse("at = " + metres(at) + ": the fold line must not cross the part that stays, " +
             metres(kept.low) + " to " + metres(kept.high));
    if (std::ranges::count(options.at, at) > 1) refuse("at = " + metres(at) + ": is given twice");
  }
}

}  // namespace

// One line. Coordinates: u across it, 0 on the line and above 0 on the flap; depth below the mirror plane.
// The fabric of a layer that crosses the line is upright up to the distance `upright` from the line, gathered
// on to `gathered`, in transition on to `reach`, and free beyond. Layers between the mirror plane and the
// flap only make room for the bend; below zero, depths count as above.
struct Folding::Crease {
  double at, direction, up;
  int axis;
  double mirror = 0.0;   // height of the mirror plane along the pack's side times `up`
  double highest = 0.0;  // depth of the highest layer that crosses the line
  double deepest = 0.0;  // largest depth of a layer near the line
  double element = 0.0;  // longest extent in u of the elements that cross the line
  double easing = 0.0;   // [m] length of the transition
  double inner = 0.0;    // fabric to be gathered on the upright side of a corner
  double outer = 0.0;    // the same on the flat side
  double slope = 0.0;    // gathered fabric keeps this share of its length

  bool is_upright(double u, double depth) const { return depth >= highest && std::abs(u) <= upright(depth); }
  double upright_easing(double depth) const { return std::min(easing, 2.0 * depth); }
  double upright(double depth) const { return depth + inner + 0.5 * upright_easing(depth); }
  double gathered(double depth) const {
    return spacing * (2.0 * deepest - depth) + inner + 0.5 * upright_easing(deepest) + outer;
  }
  double reach(double depth) const { return gathered(depth) + easing; }
  // Distance of a layer's corners from the line (M.61).
  double corner(double depth) const {
    return gathered(depth) + 0.5 * easing * (1.0 - slope) - slope * (gathered(depth) - upright(depth));
  }
  // Length of fabric that is first gathered, then over `length` more and more free.
  double eased(double u, double length) const {
    if (u <= 0.0) return slope * u;
    if (u >= length) return u - 0.5 * (1.0 - slope) * length;
    return slope * u + (1.0 - slope) * u * u / (2.0 * length);
  }
  // New distance from the line of fabric that lies flat.
  double flat(double u, double depth) const {
    if (u >= reach(depth)) return u;
    const double start = gathered(depth) + 0.5 * easing * (1.0 - slope);
    return start + eased(u - gathered(depth), easing);
  }
  // New distance from the mirror plane of fabric that stands upright.
  double rise(double u, double depth) const {
    const double length = upright_easing(depth), begin = upright(depth) - inner;
    return depth *
           (1.0 - (eased(begin - u, length) + slope * inner) / (eased(begin, length) + slope * inner));
  }
};

Folding::Folding(const Mesh& mesh, const Eigen::Matrix3Xd& start, const std::vector<int>& fixed,
                 const PackSide& side)
    : mesh_(&mesh),
      nodes_(start),
      fixed_(fixed),
      side_(side),
      gathered_(static_cast<std::size_t>(mesh.node_count()), false) {
  require_nodes("fold", mesh.elements, mesh.node_count());
  if (start.cols() != mesh.nodes.cols() || mesh.element_count() == 0)
    refuse("fold: needs a mesh, and one position for each of its nodes");
  if (!start.allFinite()) refuse("fold: a node is not finite");
  for (const int node : fixed)
    if (node < 0 || node >= mesh.node_count()) refuse("fold: the number of a fixed node is out of range");
}

// Finds the planes between which the layers near the line lie, and the elements that cross it.
Folding::Crease Folding::crease(const FoldOptions& options, double at, double direction, double up) const {
  Crease c{.at = at, .direction = direction, .up = up, .axis = options.axis};
  const Eigen::ArrayXd u = across(c), height = heights(c);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const double flap = u.maxCoeff();
  double below = -infinite, moving = -infinite, crossing = -infinite, bottom = infinite;  // heights
  for (const auto& element : mesh_->elements.colwise()) {
    const double top = height(element).maxCoeff(), last = u(element).maxCoeff(),
                 first = u(element).minCoeff();
    if (last > 0.0) moving = std::max(moving, top);
    if (first < 0.0 && last >= -flap - options.gap) below = std::max(below, top);
    if (first > 0.0 || last <= 0.0) continue;
    crossing = std::max(crossing, top);
    c.element = std::max(c.element, last - first);
  }
  c.mirror = 0.5 * (below + moving + spacing * options.gap);
  c.highest = c.mirror - crossing;
  for (const auto& element : mesh_->elements.colwise()) {
    const double lowest = height(element).minCoeff();
    if (u(element).maxCoeff() > lowest - c.mirror) bottom = std::min(bottom, lowest);
  }
  c.deepest = c.mirror - bottom;
  return c;
}

// Gathers fabric until no side of an element runs past a corner of the bend.
void Folding::gather(Crease& c, double gap) const {
  const Eigen::ArrayXd u = across(c), depth = c.mirror - heights(c);
  const auto each_side = [&](bool only_on_edge, auto&& action) {  // nodes a, b; distances on b's side
    for (const auto& element : mesh_->elements.colwise()) {
      if (only_on_edge && !on_edge(element)) continue;
      for (const int a : element)
        for (const int b : element)
          if (depth[a] >= c.highest && depth[b] >= c.highest)
            action(a, b, std::copysign(1.0, u[b]) * u[a], std::abs(u[b]));
    }
  };
  each_side(true, [&](int a, int b, double near, double far) {  // or they turn over in their plane
    if (std::abs(near) < depth[a] && far > depth[b]) c.inner = std::max(c.inner, far - depth[b]);
  });
  const double without = c.gathered(0.0);
  each_side(false, [&](int a, int b, double near, double far) {
    if (near < c.upright(depth[a]) && far > c.upright(depth[b]))
      c.outer = std::max(c.outer, far - (without - spacing * depth[b]));
  });
  c.slope = spread * gap / std::max(c.gathered(0.0), gap);
}

// Distances of the fixed nodes and of the flap's end from the line bound what a bend may take.
void Folding::require_free(const Crease& c) const {
  const double flap = across(c).maxCoeff();
  const std::string takes = "at = " + metres(c.at) + ": the bend over this line gathers the fabric within " +
                            metres(c.reach(0.0)) + " of it (pack " + metres(c.deepest) + " high, elements " +
                            metres(c.element) + " long), ";
  // Where a bend of this size would have room.
  const Range kept = kept_part(nodes_, fixed_, c.axis);
  const double stays = c.direction > 0.0 ? kept.high : kept.low, room = c.direction * c.reach(0.0),
               from = stays + room, to = c.at + c.direction * flap - room;
  const std::string limits =
      c.direction * (to - from) < 0.0
          ? ": no line has room on this side"
          : ", allowed: about " + metres(std::min(from, to)) + " to " + metres(std::max(from, to));
  const std::string remedy =
      limits + "; move the line, or take a finer mesh, a thinner pack or a smaller easing";
  if (flap < c.reach(0.0)) refuse(takes + "and the flap has only " + metres(flap) + remedy);
  bool moves = false;
  for (const int node : fixed_) {
    const double away = -c.direction * (nodes_(c.axis, node) - c.at);
    const double depth = std::abs(c.mirror - c.up * side_.sign * nodes_(side_.axis, node));
    moves = moves || away < c.reach(depth);
  }
  if (moves) refuse(takes + "and the fixed nodes are " + metres(std::abs(c.at - stays)) + " away" + remedy);
}

// True for an element of a side wall, across the layers.
bool Folding::on_edge(const Eigen::Vector3i& element) const {
  return is_on_edge(nodes_.col(element[0]), nodes_.col(element[1]), nodes_.col(element[2]), side_.axis);
}

Eigen::ArrayXd Folding::across(const Crease& c) const {
  return c.direction * (nodes_.row(c.axis).transpose().array() - c.at);
}

Eigen::ArrayXd Folding::heights(const Crease& c) const {
  return c.up * side_.sign * nodes_.row(side_.axis).transpose().array();
}

Eigen::Matrix3Xd Folding::laid(const Crease& c) const {
  Eigen::Matrix3Xd shape = nodes_;
  for (Eigen::Index i = 0; i < shape.cols(); ++i) {
    const double u = c.direction * (shape(c.axis, i) - c.at);
    const double depth = c.mirror - c.up * side_.sign * shape(side_.axis, i), layer = std::abs(depth);
    if (u < 0.0 && -u >= c.reach(layer)) continue;  // stays to the last bit
    const bool upright = c.is_upright(u, depth);
    const double away = std::abs(u) <= c.upright(layer) ? c.corner(layer) : c.flat(std::abs(u), layer);
    const double rise = upright ? c.rise(std::abs(u), depth) : depth;
    const double height = u < 0.0 ? c.mirror - rise : c.mirror + rise;
    shape(c.axis, i) = c.at - c.direction * away;
    shape(side_.axis, i) = c.up * side_.sign * height;
  }
  return shape;
}

void Folding::lay(const FoldOptions& options, double at, double direction, double up) {
  Crease c = crease(options, at, direction, up);
  gather(c, options.gap);
  const auto before = principal_stretches(mesh_->nodes, nodes_, mesh_->elements);
  const auto after = principal_stretches(mesh_->nodes, laid(c), mesh_->elements);
  bool stretches = false;
  for (std::size_t e = 0; e < after.size() && !stretches; ++e)
    stretches = after[e][1] > std::max(1.0, before[e][1]) + unstretched;
  if (stretches && options.easing > 0.0) {
    c = crease(options, at, direction, up);
    c.easing = options.easing * c.element;
    gather(c, options.gap);
  }
  require_free(c);
  for (Eigen::Index i = 0; i < nodes_.cols(); ++i) {
    const double depth = std::abs(c.mirror - up * side_.sign * nodes_(side_.axis, i));
    if (std::abs(nodes_(c.axis, i) - at) < c.reach(depth)) gathered_[static_cast<std::size_t>(i)] = true;
  }
  nodes_ = laid(c);
  lines_.push_back({at, 2.0 * c.deepest, c.reach(0.0), c.element, c.easing > 0.0});
}

void Folding::fold(const FoldOptions& options) {
  require_gap(options.gap);
  if (options.axis < 0 || options.axis > 2 || options.axis == side_.axis)
    refuse(std::string("axis: must lie in the plane of the pack, which is thin along ") + "xyz"[side_.axis]);
  if (!(options.easing >= 0.0 && options.easing <= 10.0))
    reject("fold", "easing", options.easing, "0 to 10 element lengths");
  const Range kept = kept_part(nodes_, fixed_, options.axis);
  check_lines(options, nodes_, kept);
  const double between = layer_distance();
  if (between < options.gap * (1.0 - 1e-9))
    refuse("gap = " + metres(options.gap) + ": layers of the pack are only " + metres(between) +
           " apart; press two sheets on each other first, flatten the bag less, or take a smaller gap");
  const double bottom = (side_.sign * nodes_.row(side_.axis)).minCoeff();
  for (const Step& step : steps_of(options, kept)) lay(options, step.at, step.direction, step.up);
  const double below = bottom - (side_.sign * nodes_.row(side_.axis)).minCoeff();
  if (below > 0.0)
    refuse("at: panels of the accordion reach " + metres(below) +
           " below the part that stays; each panel must be at least as wide as the next one outwards");
}

}  // namespace mesh
