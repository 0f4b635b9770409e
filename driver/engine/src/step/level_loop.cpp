// SPDX-License-Identifier: Apache-2.0
#include "engine/level_loop.hpp"

#include <optional>
#include <utility>

#include "engine/stages.hpp"

namespace driver {

LevelView at_multiples(double interval, std::function<void(const State&)> show) {
  return {
      [schedule = Schedule(interval)](const State& state, bool) mutable { return schedule.due(state.time); },
      std::move(show)};
}

void LevelLoop::watch(LevelSink sink, std::vector<LevelView> views) {
  sink_ = std::move(sink);
  views_ = std::move(views);
  due_.clear();
}

void LevelLoop::evaluate(const Scene& scene, State& state, const Executor& executor, bool last) {
  const bool due = progress_.history.due(state.time);
  progress_.request = {.record = due || last || progress_.all, .last = last};
  due_.clear();
  for (const LevelView& view : views_)
    if (view.due(state, last)) due_.push_back(&view);
  evaluate_level(scene, state, progress_.request, executor);
  for (const LevelView* view : due_) view->show(state);
}

void LevelLoop::advance(const Scene& scene, State& state, const Executor& executor) {
  advance_level(scene, state, progress_.request, executor);
  if (sink_) sink_(progress_.request.record, state);
}

void LevelLoop::complete_last(const Scene& scene, State& state, const Executor& executor) {
  const auto bag =
      state.bag ? std::optional(std::pair(state.bag->position, state.bag->velocity)) : std::nullopt;
  const auto pendulum = state.pendulum ? std::optional(state.pendulum->motion) : std::nullopt;
  const auto body = state.body ? std::optional(state.body->motion) : std::nullopt;
  advance(scene, state, executor);
  if (bag) {
    state.bag->position = bag->first;
    state.bag->velocity = bag->second;
  }
  if (pendulum) state.pendulum->motion = *pendulum;
  if (body) state.body->motion = *body;
}

void LevelLoop::move_on(const Scene& scene, State& state) const {
  const double stop = next_stop(scene, state);
  state.time = state.step.after >= stop - state.time ? stop : state.time + state.step.after;
  ++state.steps;
}

}  // namespace driver
