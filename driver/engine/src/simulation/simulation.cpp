// SPDX-License-Identifier: Apache-2.0
#include "engine/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <numeric>
#include <utility>

#include "base/progress.hpp"
#include "engine/stages.hpp"

namespace driver {
namespace {

// The scene, to be changed; a copy if somebody else has it, too.
Scene& own_scene(Moment& now) {
  if (now.scene.use_count() > 1) now.scene = std::make_shared<Scene>(*now.scene);
  std::atomic_thread_fence(std::memory_order_acquire);  // a copy of it may have been made by another thread
  return const_cast<Scene&>(*now.scene);                // made here, as the one given is kept
}

void require_ahead(const State& state, double time) {
  if (!(time >= state.time))
    throw std::invalid_argument(fmt::format(
        "time: is {:.6g} s, allowed: {:.6g} s, where the simulation is, or later", time, state.time));
}

}  // namespace

Simulation::Simulation(std::shared_ptr<const Scene> scene, int threads)
    : now_{scene, scene, make_state(*scene), false, {}, {}, {}, CallClock(threads)},
      loop_(*scene),
      executor_(std::make_shared<const Executor>(threads)) {}

Simulation::Simulation(const Simulation& other)
    : now_(other.now_), loop_(*other.now_.given), executor_(other.executor_) {
  loop_.go_on_from(other.loop_.progress());
}

// Copies value by value, so that arrays stay where they are.
Simulation& Simulation::operator=(const Simulation& other) {
  now_ = other.now_;
  loop_.go_on_from(other.loop_.progress());
  executor_ = other.executor_;
  return *this;
}

void Simulation::reset() {
  *this = static_cast<const Simulation&>(Simulation(now_.given, executor_->threads()));
}

void Simulation::take(const State& state, const LevelProgress& progress, bool evaluated) {
  now_.state = state;
  now_.evaluated = evaluated;
  loop_.go_on_from(progress);
}

void Simulation::watch(LevelSink sink, std::vector<LevelView> views) {
  loop_.watch(std::move(sink), std::move(views));
}

RunOutcome Simulation::outcome() const {
  RunOutcome outcome;
  outcome.status = !now_.failure.empty()       ? RunStatus::failed
                   : ended() && now_.evaluated ? RunStatus::done
                                               : RunStatus::interrupted;
  outcome.message = now_.failure;
  outcome.wall_seconds = now_.clock.wall();
  outcome.cpu_seconds = now_.clock.total();
  const auto& ticks = state().stage_ticks;
  const auto all = static_cast<double>(std::accumulate(ticks.begin(), ticks.end(), std::uint64_t{0}));
  for (std::size_t i = 0; i < ticks.size() && all > 0.0; ++i)
    outcome.stage_seconds[i] = outcome.cpu_seconds * static_cast<double>(ticks[i]) / all;
  conclude(scene(), state(), outcome);
  return outcome;
}

void Simulation::guarded(const std::function<void()>& work) {
  if (!now_.failure.empty()) throw SimulationError("failed before: " + now_.failure);
  try {
    work();
  } catch (const std::exception& error) {
    now_.failure = fmt::format("stage {} at {:.6g} s, step {}: {}", stage_name(state().stage), state().time,
                               state().steps, text_of(error));
    throw SimulationError(now_.failure);
  }
}

void Simulation::evaluate() {
  if (now_.evaluated) return;
  const CallClock::Call call(now_.clock);
  guarded([&] {
    loop_.evaluate(scene(), now_.state, *executor_, ended());
    if (ended()) loop_.complete_last(scene(), now_.state, *executor_);
    now_.evaluated = true;
  });
}

void Simulation::step_once() {
  evaluate();
  guarded([&] {
    loop_.advance(scene(), now_.state, *executor_);
    loop_.move_on(scene(), now_.state);
    now_.evaluated = false;
    for (const auto& change : std::exchange(now_.later, {})) change_now(change);
  });
}

void Simulation::step(long count) {
  if (count < 0) throw std::invalid_argument(fmt::format("count: is {}, allowed: 0 or more", count));
  if (ended() && count > 0)
    throw std::invalid_argument(fmt::format(
        "count: is {}, allowed: 0, as the scene is at its end, {:.6g} s; for more steps set a later "
        "scene.end_time at the start",
        count, state().time));
  const CallClock::Call call(now_.clock);
  for (long i = 0; i < count && !ended(); ++i) step_once();
}

void Simulation::advance(double time, const std::function<bool()>& stop) {
  require_ahead(state(), time);
  const CallClock::Call call(now_.clock);
  while (state().time < time && !ended() && !(stop && stop())) step_once();
}

void Simulation::advance_exactly(double time, const std::function<bool()>& stop) {
  require_ahead(state(), time);
  double& stop_at = now_.state.step.stop;
  if (now_.evaluated && !ended() && state().time < time && state().time + state().step.after > time)
    throw std::invalid_argument(
        fmt::format("time: is {:.6g} s, allowed: {:.6g} s or later, for the step that leaves {:.6g} s is "
                    "evaluated. Call before forces of this level are read",
                    time, state().time + state().step.after, state().time));
  const auto reset = [&](double*) { stop_at = std::numeric_limits<double>::infinity(); };
  stop_at = time;
  const std::unique_ptr<double, decltype(reset)> at_exit(&stop_at, reset);
  advance(time, stop);
}

void Simulation::change_now(const Moment::Change& change) {
  change(own_scene(now_), now_.state);
}

void Simulation::change_level(const Moment::Change& change) {
  if (now_.evaluated)
    now_.later.push_back(change);
  else
    change_now(change);
}

void Simulation::note(const Control& control) {
  const auto same = [&](const Control& c) { return c.kind == control.kind && c.part == control.part; };
  const auto found = std::ranges::find_if(now_.controls, same);
  if (found == now_.controls.end())
    now_.controls.push_back(control);
  else
    *found = control;
}

}  // namespace driver
