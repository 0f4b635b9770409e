// SPDX-License-Identifier: Apache-2.0
// One step of a scene: the eleven stages of docs/stages.md.
#pragma once

#include <stdexcept>

#include "base/executor.hpp"
#include "engine/scene.hpp"
#include "engine/state.hpp"

namespace driver {

/// The computation left its domain (exit code 3): a step above its bound. Models throw exceptions of their
/// own.
class StepError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What the caller wants of this step beside the motion.
struct StepRequest {
  bool record = false;  // work out what the columns (columns.hpp) read of level n
  bool last = false;    // level n is the end: the balance only, the state does not go on
};

/// S2 to S7: gas and forces of level n, and the size of the step that leaves it. Neither part of a step
/// allocates, but for a visibility search and lists of layers that come near each other. Both throw
/// StepError, gas::DomainError, membrane::MembraneError, jet::DomainError or coupling::ContactError.
void evaluate_level(const Scene& scene, State& state, const StepRequest& request,
                    const Executor& executor = Executor::serial());
/// S8 to S11: from level n, as evaluated for the same request, to n+1; the balances of n.
void advance_level(const Scene& scene, State& state, const StepRequest& request,
                   const Executor& executor = Executor::serial());

/// One step: both parts.
void step(const Scene& scene, State& state, const StepRequest& request,
          const Executor& executor = Executor::serial());

/// The state at the start, gas point and forces included: what a forecast and other derived values read.
State state_at_start(const Scene& scene);

}  // namespace driver
