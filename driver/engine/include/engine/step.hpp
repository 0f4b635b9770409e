// SPDX-License-Identifier: Apache-2.0
// One step of a scene: the eleven stages of docs/stages.md.
#pragma once

#include <functional>
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
  const std::function<void(const State&)>* before_advance = nullptr;  // called when all forces of n stand
};

/// Computes level n and advances the state to n+1. Does not allocate (a visibility search aside). Throws
/// StepError, gas::DomainError, membrane::MembraneError, jet::DomainError or coupling::ContactError.
void step(const Scene& scene, State& state, const StepRequest& request,
          const Executor& executor = Executor::serial());

/// The state at the start, gas point and forces included: what a forecast and other derived values read.
State state_at_start(const Scene& scene);

}  // namespace driver
