// SPDX-License-Identifier: Apache-2.0
#include "engine/level_loop.hpp"

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
  membrane::Vectors position, velocity;
  std::vector<PendulumRun> pendulum;
  std::vector<BodyRun> body;
  if (state.bag) position = state.bag->position, velocity = state.bag->velocity;
  if (state.pendulum) pendulum.push_back(*state.pendulum);
  if (state.body) body.push_back(*state.body);
  advance(scene, state, executor);
  if (state.bag) state.bag->position = position, state.bag->velocity = velocity;
  if (state.pendulum) state.pendulum->motion = pendulum.front().motion;
  if (state.body) state.body->motion = body.front().motion;
}

void LevelLoop::move_on(const Scene& scene, State& state) const {
  const double stop = next_stop(scene, state);
  state.time = state.step.after >= stop - state.time ? stop : state.time + state.step.after;
  ++state.steps;
}

}  // namespace driver
