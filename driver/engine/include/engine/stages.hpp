// SPDX-License-Identifier: Apache-2.0
// The stages of a step, one function each, in the order of step().
#pragma once

#include "engine/stage_clock.hpp"
#include "engine/step.hpp"

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
void forces(const Scene& scene, State& state, const Executor& executor);  // S3
void contact(const Scene& scene, State& state);                           // S4
void skin_contact(const Scene& scene, State& state);                      // S4, of the skin with itself
double contact_stiffness(const Scene& scene, const State& state);         // bound of its omega^2 at n [1/s2]
double skin_contact_stiffness(const Scene& scene, const State& state);    // likewise, of layers that touch
double deep_contact_stiffness(const Scene& scene, const State& state);  // what those that are close add to it
void choose_step(const Scene& scene, State& state, bool last);
void outlets(const Scene& scene, State& state);     // S5
void jet_fields(const Scene& scene, State& state);  // S6
void visibility(const Scene& scene, State& state);  // S7
void jet_forces(const Scene& scene, State& state);  // S3, of what S7 leaves lit
/// True if a jet damps the skin, which bounds the step (J.9).
bool jets_damp(const Scene& scene);
/// Scales the loads of S6 and S7 to the outlets that S5 has written anew; false, and nothing, if one of them
/// had no thrust before, or has none.
bool rescale_jets(State& state);
/// Counts the kick's jets.
void book_jets(const Scene& scene, State& state);
void prescribed_pressure(const Scene& scene, State& state);  // S3, its mean over the kick
/// Time that the step must not pass: the end, StepSizes::stop, the next multiple of meet_every,
/// or the next row's if history_exact.
double next_stop(const Scene& scene, const State& state);
void advance(const Scene& scene, State& state, const Executor& executor);   // S8
void volume(const Scene& scene, State& state, const Executor& executor);    // S9
void gas_ode(const Scene& scene, State& state, const Enclosure& before);    // S10
void ledger(const Scene& scene, State& state, const StepRequest& request);  // S11

/// Part of the kick at level n that lies before n: dt_before / (dt_before + dt_after).
double kick_share(const StepSizes& step);
/// Length of the kick at level n [s]: (dt_before + dt_after) / 2.
inline double kick_length(const StepSizes& step) {
  return 0.5 * (step.before + step.after);
}
/// Mean of a curve over the kick at level n (K.41); its value, if the kick has no length.
double kick_mean(const gas::Curve& curve, const StepSizes& step);
/// Part of the work of a prescribed force in the kick at level n that goes into the kinetic energy of n
/// (K.42) [J]. `power_before` [W] is the force times the velocity at n-1/2, `work` [J] that of the whole
/// kick.
double work_before_level(const StepSizes& step, double power_before, double work);
/// What the columns and the balance of level n need of positions, forces and velocities before S8.
void look_at_level(const Scene& scene, State& state);

}  // namespace driver
