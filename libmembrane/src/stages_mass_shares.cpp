// SPDX-License-Identifier: Apache-2.0
// Shares of the nodes' mass (M.15, M.17): an element gains mass in the ratio of its bound of omega^2 to those
// of the elements around it.
#include "stages_mass_shares.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <span>

#include "blocks.hpp"
#include "membrane/stages.hpp"
#include "membrane/time_step.hpp"

namespace membrane {

namespace {

// Strain of a displacement of the corner with gradient g.
Eigen::Matrix<double, 3, 2> strain_operator(const Eigen::Vector2d& g) {
  Eigen::Matrix<double, 3, 2> b;
  b << g[0], 0.0, 0.0, g[1], g[1], g[0];
  return b;
}

// The largest eigenvalue of a symmetric 3 x 3 matrix, as its mean eigenvalue plus the largest root t of
// t^3 - c t - d, the characteristic polynomial after subtraction of that mean.
struct Eigenvalue {
  double mean = 0.0, c = 0.0, d = 0.0;
  double t = 0.0;  // at first a bound of the root
};

Eigenvalue bound_of(Eigen::Matrix3d a) {
  const double mean = a.trace() / 3.0;
  a.diagonal().array() -= mean;
  const double c = 0.5 * a.squaredNorm();
  return {mean, c, a.determinant(), 2.0 * std::sqrt(c / 3.0)};
}

// Newton's iteration, which descends from the bounds to the roots. Where it has ended it changes nothing, so
// some go on together: the processor overlaps their quotients.
void descend(std::span<Eigenvalue> all) {
  constexpr std::size_t together = 8;
  for (std::size_t first = 0; first < all.size(); first += together) {
    const auto some = all.subspan(first, std::min(together, all.size() - first));
    for (bool more = true; more;) {
      more = false;
      for (Eigenvalue& e : some) {
        const double next = e.t - (e.t * (e.t * e.t - e.c) - e.d) / (3.0 * e.t * e.t - e.c);
        if (!(next < e.t)) continue;
        e.t = next;
        more = true;
      }
    }
  }
}

// Of A L^T B M^-1 B^T L, the bound of the largest eigenvalue.
Eigenvalue material_eigenvalue(const ElementStiffness& e, const Eigen::Vector3d& mass) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (int a = 0; a < 3; ++a) {
    const Eigen::Matrix<double, 3, 2> b = e.factor.transpose() * strain_operator(e.gradient.col(a));
    sum += b * b.transpose() / mass[a];
  }
  return bound_of(sum);
}

// Largest eigenvalue of h A L^T B M^-1 B^T L.
double material_frequency(const ElementStiffness& e, const Eigen::Vector3d& mass) {
  Eigenvalue one = material_eigenvalue(e, mass);
  descend({&one, 1});
  return e.volume * (one.mean + one.t);
}

// omega^2 per principal stress: larger eigenvalue of a 2 x 2 matrix.
double geometric_frequency(const ElementStiffness& e, const Eigen::Vector3d& mass) {
  const Eigen::Matrix2d g = e.gradient * mass.cwiseInverse().asDiagonal() * e.gradient.transpose();
  const double half = 0.5 * (g(0, 0) - g(1, 1));
  return e.volume * (0.5 * (g(0, 0) + g(1, 1)) + std::sqrt(half * half + g(0, 1) * g(0, 1)));
}

std::span<const std::int32_t> around(const BagModel& m, int node) {
  const auto n = static_cast<std::size_t>(node);
  return std::span(m.corners.element)
      .subspan(static_cast<std::size_t>(m.corners.row_begin[n]),
               static_cast<std::size_t>(m.corners.row_begin[n + 1] - m.corners.row_begin[n]));
}

void update_frequency(const BagModel& m, MassShares& shares, int element) {
  const auto e = static_cast<std::size_t>(element);
  if (m.stiffness[e].volume == 0.0) return;
  const auto [group, lane] = place_of(m.elements, e);
  shares.frequency[group].material[lane] = material_frequency(m.stiffness[e], shares.mass.col(element));
  shares.frequency[group].geometric[lane] = geometric_frequency(m.stiffness[e], shares.mass.col(element));
}

// Multiplies the shares of a node by their elements' demands, and scales them to its mass.
void share_out(const BagModel& m, std::span<const double> demand, int node, Eigen::Matrix3Xd& mass) {
  const auto elements = around(m, node);
  const auto share = [&](std::int32_t e) -> double& {
    const auto corners = m.description.elements.col(e);
    return mass(corners[0] == node ? 0 : corners[1] == node ? 1 : 2, e);
  };
  double sum = 0.0;
  for (const std::int32_t e : elements) sum += share(e) *= demand[static_cast<std::size_t>(e)];
  for (const std::int32_t e : elements) share(e) *= m.node_mass[static_cast<std::size_t>(node)] / sum;
}

// True if an element around the node demands more.
bool is_asked(const BagModel& m, std::span<const double> demand, int node) {
  return std::ranges::any_of(around(m, node),
                             [&](std::int32_t e) { return demand[static_cast<std::size_t>(e)] > 1.0; });
}

// Calls f with the elements of a block.
template <class F>
void for_elements(const BagModel& m, int block, F&& f) {
  const ElementBlock& b = m.elements.block[static_cast<std::size_t>(block)];
  for (std::int32_t i = kLanes * b.first_group; i < kLanes * b.last_group; ++i)
    if (const std::int32_t e = m.elements.element[static_cast<std::size_t>(i)]; e >= 0) f(e);
}

}  // namespace

void tune_shares_as_sewn(BagModel& m) {
  constexpr int rounds = 20;  // more rounds improve the step by less than 1 %
  m.shares.frequency.assign(m.elements.group.size(), FrequencyGroup{});
  std::vector<double> frequency(m.stiffness.size());
  std::vector<Eigenvalue> eigenvalue(m.stiffness.size());  // 0 of null elements
  for (int round = 0; round <= rounds; ++round) {
    if (round > 0)
      for (int n = 0; n < m.node_count; ++n) share_out(m, frequency, n, m.shares.mass);
    for (std::size_t e = 0; e < frequency.size(); ++e)
      if (m.stiffness[e].volume > 0.0)
        eigenvalue[e] = material_eigenvalue(m.stiffness[e], m.shares.mass.col(static_cast<Eigen::Index>(e)));
    descend(eigenvalue);
    for (std::size_t e = 0; e < frequency.size(); ++e)
      frequency[e] = m.stiffness[e].volume * (eigenvalue[e].mean + eigenvalue[e].t);
  }
  for (int e = 0; e < m.element_count; ++e) update_frequency(m, m.shares, e);
  m.fabric_frequency = std::ranges::max(frequency);
}

void demand_block(const BagModel& model, BagState& state, int block) {
  constexpr double near =
      0.9;  // ratio to the largest bound; elements below keep their shares for later stretching
  const double enough = near * state.forces.element_frequency;
  for_elements(model, block, [&](int e) {
    const double frequency = element_response(model, state, e).frequency;
    state.share_demand[static_cast<std::size_t>(e)] =
        enough > 0.0 && frequency > enough ? frequency / enough : 1.0;
  });
}

void share_block(const BagModel& model, BagState& state, int block) {
  const int first = block * kNodeBlock, last = std::min(first + kNodeBlock, model.node_count);
  for (int n = first; n < last; ++n)
    if (is_asked(model, state.share_demand, n)) share_out(model, state.share_demand, n, state.shares.mass);
}

void frequency_block(const BagModel& model, BagState& state, int block) {
  for_elements(model, block, [&](int e) {
    const auto corners = model.description.elements.col(e);
    if (std::ranges::any_of(corners, [&](int n) { return is_asked(model, state.share_demand, n); }))
      update_frequency(model, state.shares, e);
  });
}

}  // namespace membrane
