// SPDX-License-Identifier: Apache-2.0
#include "skin_forces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace coupling::detail {
namespace {

using Eigen::Vector3d;

// Layers closer than half of their limit are that much stiffer in addition.
constexpr double kDeep = 20.0;

// Bound of the second derivative of E, times the sum of the weights, where parts are or are about to be.
double steepness_of(double stiffness, double limit, const Touch& touch) {
  const bool deep = std::min(touch.ahead, touch.closest.distance) < 0.5 * limit;
  return 2.0 * stiffness * (deep ? 1.0 + kDeep : 1.0);
}

// Of an element in a node's contact: two elements have a point on an edge in common, six or so a corner.
double share_of(const Closest& closest) {
  constexpr double shares[] = {1.0, 1.0 / 2.0, 1.0 / 6.0};
  return shares[(closest.weight.tail<3>().array() == 0.0).count()];
}

}  // namespace

SkinMemory::SkinMemory(const SkinParts& parts) : limits(parts), stiffness(parts.masses.size(), 0.0) {}

// Adds a repulsion of two points, the weights of which are positive in the first part, along the normal
// (K.44).
void SkinForces::push(const int (&node)[4], int corners, const double* weight, const Vector3d& normal,
                      double stiffness, double limit, double distance, double steepness) {
  const double depth = limit - distance, deep = std::max(0.0, depth - 0.5 * limit);
  result_.energy += 0.5 * stiffness * (depth * depth + kDeep * deep * deep);
  const Vector3d force = stiffness * (depth + kDeep * deep) * normal;
  for (int k = 0; k < corners; ++k) forces_.col(node[k]) += weight[k] * force;
  stiffen(node, corners, weight, steepness);
}

// The weights of each part sum to 1.
void SkinForces::stiffen(const int (&node)[4], int corners, const double* weight, double steepness) {
  for (int k = 0; k < corners; ++k) {
    if (weight[k] == 0.0) continue;
    double& sum = memory_.stiffness[static_cast<std::size_t>(node[k])];
    if (sum == 0.0) memory_.loaded.push_back(node[k]);
    sum += steepness * std::abs(weight[k]);
  }
}

// The same between a node and an edge or, if both are one, another node.
void SkinForces::push(int node, int first, int second, double stiffness, double limit, double steepness) {
  const Vector3d x = nodes_.col(node), a = nodes_.col(first), b = nodes_.col(second);
  const double t = first == second ? 0.0 : closest_on_segment(x, a, b);
  const Vector3d apart = (x - a) - t * (b - a);
  const double distance = apart.norm();
  if (!(distance < limit)) return;
  const double weight[] = {1.0, t - 1.0, -t};
  push({node, first, second, -1}, first == second ? 2 : 3, weight, apart / distance, stiffness, limit,
       distance, steepness);
}

void SkinForces::note(const Touch& touch) {
  ++result_.contacts;
  if (!(touch.closest.distance < result_.closest.gap)) return;
  result_.closest = named(parts_, touch.pair, touch.closest.distance);
}

// Where the force of a node begins or ends, and where its second half does (K.48).
void SkinForces::add_kinks(const Touch& touch, double stiffness, double limit) {
  const double now = touch.closest.distance, change = (now - touch.ahead) / kAhead;
  const auto crosses = [&](double place) { return (now < place) != (touch.ahead < place); };
  const double jump = (crosses(limit) ? 1.0 : 0.0) + (crosses(0.5 * limit) ? kDeep : 0.0);
  if (jump == 0.0) return;
  result_.kink_energy += share_of(touch.closest) * jump * stiffness * change * change;
}

void SkinForces::add_node(const Touch& touch) {
  const auto [node, triangle, edges] = touch.pair;
  const Closest& closest = touch.closest;
  const double limit = memory_.limits.of_node(node);
  const double stiffness = parts_.parameters.stiffness * parts_.node_weight[static_cast<std::size_t>(node)];
  add_kinks(touch, stiffness, limit);
  const Corners corners = corners_of(parts_, touch.pair);
  // What starts at its limit may touch in the first step.
  if (search_.first_level()) stiffen(corners.node, 4, closest.weight.data(), 2.0 * stiffness);
  if (!(closest.distance < limit)) return;
  note(touch);
  const double steepness = steepness_of(stiffness, limit, touch);
  push(corners.node, 4, closest.weight.data(), closest.normal, stiffness, limit, closest.distance, steepness);
  for (int k = 0; k < 3; ++k) {
    const int edge = parts_.triangle_edges(k, triangle), corner = corners.node[k + 1];
    if (parts_.shared_edges[static_cast<std::size_t>(edge)].owner == triangle)
      if (const int count = parts_.count_of_edge(edge, node); count != 0)
        push(node, corners.node[(k + 1) % 3 + 1], corners.node[(k + 2) % 3 + 1], count * stiffness, limit,
             count * steepness);
    if (parts_.shared_nodes[static_cast<std::size_t>(corner)].owner == triangle)
      if (const int count = parts_.count_of_node(corner, node); count != 0)
        push(node, corner, corner, count * stiffness, limit, count * steepness);
  }
}

namespace {

// Share of two edges with sides u and v in (K.44): it grows with the square of their sine up to 1 at `full`.
// Its derivative by u is slope along_u.
struct Angle {
  Angle(const Vector3d& u, const Vector3d& v, double full) {
    const double lu = u.norm(), lv = v.norm();
    if (!(lu > 0.0 && lv > 0.0)) return;
    const Vector3d e = u / lu, f = v / lv;
    const double cosine = e.dot(f), part = e.cross(f).squaredNorm() / (full * full);
    if (!(part < 1.0)) return;
    share = std::max(part * (2.0 - part), 1e-30);
    slope = 2.0 * (1.0 - part) / (full * full);
    along_u = -2.0 * cosine / lu * (f - cosine * e);
    along_v = -2.0 * cosine / lv * (e - cosine * f);
  }
  double share = 1.0, slope = 0.0;
  Vector3d along_u, along_v;
};

}  // namespace

// Edges touch by how much closer they are than their ends, which touch as nodes do. So parallel edges do not,
// whose closest points are not unique.
void SkinForces::add_edges(const Touch& touch) {
  const auto [first, second, edges] = touch.pair;
  const Closest& closest = touch.closest;
  const double limit = memory_.limits.of(touch.pair);
  if (!(closest.distance < limit)) return;
  const Corners corners = corners_of(parts_, touch.pair);
  const auto& n = corners.node;
  const int ends[4][3] = {{n[0], n[2], n[3]}, {n[1], n[2], n[3]}, {n[2], n[0], n[1]}, {n[3], n[0], n[1]}};
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 4; ++k) {
    // An end that touches no triangle at the other edge, as all are its neighbours, pushes like the rest of
    // its edge. Else the force would begin as a jump where the closest point leaves that end.
    if (parts_.count_of_edge(k < 2 ? second : first, ends[k][0]) > 0) continue;
    const Vector3d x = nodes_.col(ends[k][0]), a = nodes_.col(ends[k][1]), b = nodes_.col(ends[k][2]);
    const double t = closest_on_segment(x, a, b);
    const double squared = (x - a - t * (b - a)).squaredNorm();
    if (!(squared < least)) continue;
    least = squared;
    nearest = k;
  }
  if (!(std::sqrt(least) > (1.0 + 1e-12) * closest.distance)) return;  // an end is closest
  note(touch);
  const Vector3d u = nodes_.col(n[1]) - nodes_.col(n[0]), v = nodes_.col(n[3]) - nodes_.col(n[2]);
  const Angle angle(u, v, std::min(1.0, 2.0 * parts_.parameters.thickness / parts_.mean_edge));
  const double stiffness =
      parts_.parameters.stiffness * (parts_.edge_weight[static_cast<std::size_t>(first)] +
                                     parts_.edge_weight[static_cast<std::size_t>(second)]);
  const double energy = result_.energy;
  push(n, 4, closest.weight.data(), closest.normal, angle.share * stiffness, limit, closest.distance,
       steepness_of(angle.share * stiffness, limit, touch));
  if (nearest >= 0)
    push(ends[nearest][0], ends[nearest][1], ends[nearest][2], -angle.share * stiffness, limit, 0.0);
  if (!(angle.slope > 0.0)) return;
  // The energy grows with the angle, too.
  const double per_share = (result_.energy - energy) / angle.share;
  const Vector3d on_u = -per_share * angle.slope * angle.along_u,
                 on_v = -per_share * angle.slope * angle.along_v;
  forces_.col(n[1]) += on_u;
  forces_.col(n[0]) -= on_u;
  forces_.col(n[3]) += on_v;
  forces_.col(n[2]) -= on_v;
}

void SkinForces::add() {
  for (const Touch& touch : search_.touches()) memory_.limits.tell(touch.pair, touch.closest.distance);
  if (search_.first_level()) memory_.limits.set_from_told();
  for (const Touch& touch : search_.touches()) touch.pair.edges ? add_edges(touch) : add_node(touch);
  if (!search_.first_level()) memory_.limits.raise();
  for (const int n : memory_.loaded) {
    double& sum = memory_.stiffness[static_cast<std::size_t>(n)];
    result_.omega_squared = std::max(result_.omega_squared, sum / parts_.masses[static_cast<std::size_t>(n)]);
    sum = 0.0;
  }
  memory_.loaded.clear();
}

}  // namespace coupling::detail
