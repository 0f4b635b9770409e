// SPDX-License-Identifier: Apache-2.0
// The stages of a step, one function each, in the order of step().
#pragma once

#include "driver/step.hpp"

namespace driver {

/// Runs blocks on the threads of the run; the blocks fix the order of every sum. Fewer than 16 blocks of 512,
/// some 100 us of work, are not worth handing out: a bag of 2744 elements has 6.
struct ParallelBlocks {
  static constexpr int fewest = 16;
  const Executor& executor;
  template <class F>
  void operator()(int count, F&& f) const {
    (count >= fewest ? executor : Executor::serial()).for_each(count, f);
  }
};

/// Volume [m3] and leak area [m2] that the gas sees.
struct Enclosure {
  double volume = 0.0;
  double leak_area = 0.0;
};
Enclosure enclosure(const Scene& scene, const State& state);

void gas_point(const Scene& scene, State& state);                         // S2
void outlets(const Scene& scene, State& state);                           // S3
void jet_fields(const Scene& scene, State& state);                        // S4
void visibility(const Scene& scene, State& state);                        // S5
void forces(const Scene& scene, State& state, const Executor& executor);  // S6
void contact(const Scene& scene, State& state);                           // S7
double contact_stiffness(const Scene& scene, const State& state);         // bound of its omega^2 at n [1/s2]
void choose_step(const Scene& scene, State& state, bool last);
/// Time that a step from `time` must not pass: the end, or the next row's if history_exact.
double next_stop(const Scene& scene, double time);
void advance(const Scene& scene, State& state, const Executor& executor);   // S8
void volume(const Scene& scene, State& state, const Executor& executor);    // S9
void gas_ode(const Scene& scene, State& state, const Enclosure& before);    // S10
void ledger(const Scene& scene, State& state, const StepRequest& request);  // S11

/// Part of the kick at level n that lies before n: dt_before / (dt_before + dt_after).
double kick_share(const StepSizes& step);
/// On the skin at the current positions [Pa]: prescribed, or that of the gas.
double overpressure(const Scene& scene, const State& state);
/// Largest distance of a node from where it started [m]; 0 without a bag.
double skin_displacement(const Scene& scene, const State& state);
/// Potential energy of the skin's weight at the current positions [J]; 0 without gravity.
double skin_gravity(const Scene& scene, const State& state);

}  // namespace driver
