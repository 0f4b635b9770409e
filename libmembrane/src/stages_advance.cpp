// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>

#include "checks.hpp"
#include "kernel_table.hpp"
#include "membrane/error.hpp"
#include "membrane/stages.hpp"

namespace membrane {

namespace {

// Forces of some scenes only, each with its term of work in the energy balance.
struct ExtraForce {
  const Vectors* force;
  double KickWork::*work;
};
struct ExtraForces {
  ExtraForce item[kMaxExtraForces];
  int count = 0;
};

ExtraForces extra_forces(const BagState& state) {
  ExtraForces extra;
  for (const ExtraForce& candidate :
       {ExtraForce{&state.jet_force, &KickWork::jet}, ExtraForce{&state.support_force, &KickWork::support},
        ExtraForce{&state.contact_force, &KickWork::contact}, ExtraForce{&state.own_force, &KickWork::own},
        ExtraForce{&state.viscous.force, &KickWork::damping}})
    if (!candidate.force->empty()) extra.item[extra.count++] = candidate;
  return extra;
}

AdvanceArrays advance_arrays(const BagModel& model, BagState& state, const ExtraForces& extra) {
  AdvanceArrays a{};
  a.position = state.position.data();
  a.velocity = state.velocity.data();
  a.membrane_force = state.membrane_force.data();
  a.volume_gradient = state.volume_gradient.data();
  a.gauge_pressure = state.gauge_pressure;
  a.extra_count = extra.count;
  for (int i = 0; i < extra.count; ++i) a.extra_force[i] = extra.item[i].force->data();
  a.mass = model.node_mass.data();
  a.inverse_mass = model.inverse_mass.data();
  a.node_gradient_squared = model.node_gradient_squared.data();
  a.rate_bound_squared = state.rate_bound_squared.data();
  for (int c = 0; c < 3; ++c) a.gravity[c] = state.gravity[c];
  a.damping = model.description.mass_damping;
  return a;
}

void add(AdvanceSums& sums, const AdvanceSums& block) {
  sums.kinetic_before += block.kinetic_before;
  sums.kinetic_after += block.kinetic_after;
  sums.kinetic_product += block.kinetic_product;
  sums.momentum_before += block.momentum_before;
  sums.momentum_after += block.momentum_after;
  sums.impulse += block.impulse;
  sums.max_speed_squared = std::max(sums.max_speed_squared, block.max_speed_squared);
  for (const auto term : {&KickWork::membrane, &KickWork::pressure, &KickWork::jet, &KickWork::support,
                          &KickWork::contact, &KickWork::own, &KickWork::damping})
    sums.work.*term += block.work.*term;
}

void check_motion(const BagModel& model, const BagState& state, const AdvanceSums& sums) {
  if (std::isfinite(sums.kinetic_after)) return;
  for (int n = 0; n < model.node_count; ++n)
    if (!std::isfinite(state.velocity.map().col(n).squaredNorm()))
      throw MembraneError("stage advance: the velocity of node " + std::to_string(n) + " is not finite");
  throw MembraneError("stage advance: the kinetic energy is not finite");
}

}  // namespace

void check_steps(double dt_before, double dt_after) {
  require_not_negative("advance", "dt_before", dt_before);
  require_positive("advance", "dt_after", dt_after);
}

void advance_block(const BagModel& model, BagState& state, double dt_before, double dt_after, int block) {
  const int first = block * kNodeBlock, last = std::min(first + kNodeBlock, model.node_count);
  const ExtraForces extra = extra_forces(state);
  AdvanceArrays arrays = advance_arrays(model, state, extra);
  arrays.dt_before = dt_before;
  arrays.dt_after = dt_after;
  AdvanceTotals t{};
  kernel_table(model.description.isa).advance(arrays, first, last, t);

  AdvanceSums sums;
  sums.work.membrane = t.work_membrane;
  sums.work.pressure = t.work_pressure;
  sums.work.damping = -model.description.mass_damping * t.damped;
  for (int i = 0; i < extra.count; ++i) sums.work.*(extra.item[i].work) += t.work_extra[i];
  sums.kinetic_before = t.kinetic_before;
  sums.kinetic_after = t.kinetic_after;
  // m v- . v+ / 2 = m mean^2 - (kinetic_before + kinetic_after) / 2, and t.damped is tau m mean^2.
  sums.kinetic_product =
      t.damped / (0.5 * (dt_before + dt_after)) - 0.5 * (t.kinetic_before + t.kinetic_after);
  sums.momentum_before = Eigen::Map<const Eigen::Vector3d>(t.momentum_before);
  sums.momentum_after = Eigen::Map<const Eigen::Vector3d>(t.momentum_after);
  sums.impulse = Eigen::Map<const Eigen::Vector3d>(t.impulse);
  sums.max_speed_squared = t.max_speed_squared;
  state.block[static_cast<std::size_t>(block)].advance = sums;
}

void sum_advance(const BagModel& model, BagState& state, double dt_before, double dt_after) {
  AdvanceSums sums;
  for (int b = 0; b < node_blocks(model); ++b) add(sums, state.block[static_cast<std::size_t>(b)].advance);
  // Gravity's work needs no sum of its own: sum of m g . v_mean = g . (mean momentum).
  sums.work.gravity =
      0.25 * (dt_before + dt_after) * state.gravity.dot(sums.momentum_before + sums.momentum_after);
  check_motion(model, state, sums);
  state.advance = sums;
}

double level_kinetic(double kinetic_before, double kinetic_after, double kinetic_product, double dt_before,
                     double dt_after) {
  check_steps(dt_before, dt_after);
  const double late = dt_before > 0.0 ? dt_before / (dt_before + dt_after) : 0.0, early = 1.0 - late;
  return early * (early - late) * kinetic_before + late * (late - early) * kinetic_after +
         4.0 * early * late * kinetic_product;
}

double level_kinetic(const AdvanceSums& sums, double dt_before, double dt_after) {
  return level_kinetic(sums.kinetic_before, sums.kinetic_after, sums.kinetic_product, dt_before, dt_after);
}

}  // namespace membrane
