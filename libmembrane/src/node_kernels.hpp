// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel_table.hpp"
#include "lanes.hpp"

// Kernels over nodes; the lanes of one node are (x, y, z, 0).
namespace membrane::MEMBRANE_KERNELS {

struct AdvanceParts {
  Lanes kinetic_before{}, kinetic_after{}, membrane{}, pressure{}, extra[kMaxExtraForces]{}, damped{};
  Lanes momentum_before{}, momentum_after{}, impulse{};
  double max_speed_squared = 0.0;
  double rate_bound_squared = 0.0;  // bound of the last kRateNodes nodes
};

struct KickFactors {
  Lanes tau, dt_after, old_share, new_factor, gravity, gauge_pressure;
};

// Sets coordinates below 1e-90 m to 0. A jet's load falls off as exp(-r^2); without this, nodes of a
// symmetric mesh would get tiny coordinates with slow, denormal products.
[[gnu::always_inline]] inline Lanes without_traces(Lanes x) {
  return select(x * x < Lanes(1e-180), Lanes(), x);
}

// Advances one node (M.9). The damping force -alpha m (v- + v+) / 2 leaves a scalar equation for v+.
[[gnu::always_inline]] inline void advance_node(const AdvanceArrays& s, const KickFactors& k, std::int64_t n,
                                                AdvanceParts& sums) {
  const Lanes mass = Lanes(s.mass[n]), inverse_mass = Lanes::load(s.inverse_mass + 4 * n), half = Lanes(0.5);
  const Lanes membrane = Lanes::load(s.membrane_force + 4 * n);
  const Lanes pressure = k.gauge_pressure * Lanes::load(s.volume_gradient + 4 * n);
  Lanes force = membrane + pressure;
  for (int i = 0; i < s.extra_count; ++i) force += Lanes::load(s.extra_force[i] + 4 * n);
  force += mass * k.gravity;
  const Lanes before = Lanes::load(s.velocity + 4 * n);
  const Lanes after = (before * k.old_share + k.tau * (inverse_mass * force)) * k.new_factor;
  const Lanes mean = half * (before + after);
  after.store(s.velocity + 4 * n);
  without_traces(Lanes::load(s.position + 4 * n) + k.dt_after * after).store(s.position + 4 * n);

  sums.membrane += membrane * mean;
  sums.pressure += pressure * mean;
  for (int i = 0; i < s.extra_count; ++i) sums.extra[i] += Lanes::load(s.extra_force[i] + 4 * n) * mean;
  sums.damped += mass * (mean * mean);
  const Lanes squared = after * after;
  sums.kinetic_before += mass * (before * before);
  sums.kinetic_after += mass * squared;
  sums.momentum_before += mass * before;
  sums.momentum_after += mass * after;
  sums.impulse += select(inverse_mass > Lanes(), force, Lanes());
  const double speed_squared = (squared[0] + squared[1]) + squared[2];
  sums.max_speed_squared = speed_squared > sums.max_speed_squared ? speed_squared : sums.max_speed_squared;
  const double rate_bound = speed_squared * s.node_gradient_squared[n];
  sums.rate_bound_squared = rate_bound > sums.rate_bound_squared ? rate_bound : sums.rate_bound_squared;
}

inline AdvanceTotals advance_totals(const AdvanceParts& sums, double tau) {
  AdvanceTotals t{};
  t.kinetic_before = 0.5 * sum_lanes(sums.kinetic_before);
  t.kinetic_after = 0.5 * sum_lanes(sums.kinetic_after);
  t.work_membrane = tau * sum_lanes(sums.membrane);
  t.work_pressure = tau * sum_lanes(sums.pressure);
  for (int i = 0; i < kMaxExtraForces; ++i) t.work_extra[i] = tau * sum_lanes(sums.extra[i]);
  t.damped = tau * sum_lanes(sums.damped);
  for (int c = 0; c < 3; ++c) {
    t.momentum_before[c] = sums.momentum_before[c];
    t.momentum_after[c] = sums.momentum_after[c];
    t.impulse[c] = tau * sums.impulse[c];
  }
  t.max_speed_squared = sums.max_speed_squared;
  return t;
}

inline void advance(const AdvanceArrays& s, int first, int last, AdvanceTotals& totals) {
  const double tau = 0.5 * (s.dt_before + s.dt_after);
  const double drag = 0.5 * tau * s.damping;
  const KickFactors factors{Lanes(tau),
                            Lanes(s.dt_after),
                            Lanes(1.0 - drag),
                            Lanes(1.0 / (1.0 + drag)),
                            Lanes::load(s.gravity),
                            Lanes(s.gauge_pressure)};
  AdvanceParts sums;
  for (int begin = first; begin < last; begin += kRateNodes) {
    const int end = begin + kRateNodes < last ? begin + kRateNodes : last;
    sums.rate_bound_squared = 0.0;
    for (int n = begin; n < end; ++n) advance_node(s, factors, n, sums);
    s.rate_bound_squared[begin / kRateNodes] = sums.rate_bound_squared;
  }
  totals = advance_totals(sums, tau);
}

}  // namespace membrane::MEMBRANE_KERNELS
