// SPDX-License-Identifier: Apache-2.0
#include "engine/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>
#include <numbers>
#include <utility>

#include "base/number_text.hpp"
#include "base/progress.hpp"
#include "coupling/side.hpp"
#include "engine/drift.hpp"
#include "engine/impactor.hpp"
#include "engine/stage_clock.hpp"
#include "step/taut_straps.hpp"

namespace driver {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Whether a bag makes more and more energy. As a run begins, errors are large beside the little energy there
// is.
class BlowUp {
 public:
  bool is_at(const Scene& scene, const State& state) {
    if (!scene.bag || scene.time.unsafe_step || !(state.peaks.energy_scale > 0.0)) return false;
    const double before =
        std::exchange(share_, std::abs(state.level.energy_residual) / state.peaks.energy_scale);
    return before > kDriftInaccurate && share_ >= before && energy_drift(state) > kDriftInaccurate;
  }

 private:
  double share_ = 0.0;  // of the residual at the last recorded level
};

void run_steps(const Scene& scene, State& state, LevelLoop& levels, const Executor& executor,
               const std::function<bool()>& stop_wanted, TautStraps& straps, RunOutcome& outcome) {
  BlowUp blow_up;
  bool blown_up = false;
  for (;;) {
    const bool stop = stop_wanted ? stop_wanted() : interrupted();
    const bool last = stop || blown_up || state.time >= scene.time.end;
    levels.evaluate(scene, state, executor, last);
    levels.advance(scene, state, executor);
    straps.look(state);
    if (stop) outcome.status = RunStatus::interrupted;
    if (blown_up) outcome.status = RunStatus::inaccurate;
    if (last) return;
    blown_up = levels.recorded() && blow_up.is_at(scene, state);
    levels.move_on(scene, state);
  }
}

void judge_drift(const Scene& scene, const State& state, RunOutcome& outcome) {
  const double drift = energy_drift(state);
  const bool stopped = outcome.status == RunStatus::inaccurate;
  if (!stopped && !(drift > kDriftWarned)) return;
  if (!stopped && (outcome.status != RunStatus::done || drift <= kDriftInaccurate)) {
    outcome.warning = drift_text(scene, state);
    return;
  }
  outcome.status = RunStatus::inaccurate;
  outcome.message = drift_text(scene, state);
  if (stopped) outcome.message = fmt::format("stopped at {:.4g} s: {}", state.time, outcome.message);
}

// Why a node of the triggers was never on.
std::string never_on(const Scene& scene, const State& state, std::size_t node) {
  const auto& sensors = scene.gas->model.triggers.sensors;
  if (node >= sensors.size() || sensors[node].kind != gas::SensorKind::pressure)
    return "its trigger was never on";
  const double largest = state.peaks.pressure - scene.ambient.pressure;
  return fmt::format("its sensor comes on at {} Pa, but the largest overpressure was {} Pa",
                     digits_beside(sensors[node].threshold, largest),
                     digits_beside(largest, sensors[node].threshold));
}

// Vents and inflators that wait for a trigger which never came on. Other vents have an area, or say so in the
// case.
void note_never_on(const Scene& scene, const State& state, RunOutcome& outcome) {
  if (!scene.gas) return;
  const auto note = [&](const auto& parts, std::string_view name, std::string_view done) {
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (const auto node = parts[i].trigger; node && !std::isfinite(state.gas.triggers[*node].first_on))
        outcome.notes.push_back(
            fmt::format("{}.{} never {}: {}", name, i, done, never_on(scene, state, *node)));
  };
  note(scene.gas->model.vents, "vent", "opened");
  note(scene.gas->model.inflows, "inflator", "fired");
}

// A measured fabric beyond what was measured.
void note_held_velocities(const Scene& scene, const State& state, RunOutcome& outcome) {
  if (!scene.gas) return;
  const double largest = state.peaks.pressure - scene.ambient.pressure;
  for (const gas::Fabric& fabric : scene.gas->model.fabrics) {
    if (!fabric.velocity) continue;
    const double end = fabric.velocity->knots().back().time;
    if (largest <= end) continue;
    outcome.notes.push_back(fmt::format(
        "{}.velocity ends at {} Pa and was held above; the largest overpressure was {} Pa",
        scene.bag ? "fabric" : "tank.fabric", digits_beside(end, largest), digits_beside(largest, end)));
    return;
  }
}

// Outlets stay where they are, also if a bag that nothing holds flies off.
void note_left_outlets(const Scene& scene, const State& state, RunOutcome& outcome) {
  if (!state.bag) return;
  const auto position = state.bag->position.map();
  const double size = (position.rowwise().maxCoeff() - position.rowwise().minCoeff()).norm();
  for (const JetPart& part : scene.jets) {
    const jet::JetModel& jet = part.field.model();
    const Eigen::Vector3d inside = jet.centre + 1e-6 * size * jet.axis;
    if (coupling::winding_number(scene.bag->mesh.elements, position, inside) > 0.5) continue;
    outcome.notes.push_back(
        fmt::format("{}: the outlet is outside the bag at the end, so its jet meets nothing: if "
                    "the bag has flown off, hold it by membrane.fixed_panels",
                    part.path));
  }
}

// A run that was cut short may have ended before the bag was full.
bool sees_all_inflow(const Scene& scene) {
  return !scene.gas || std::ranges::all_of(scene.gas->model.inflows, [&](const gas::Inflow& inflow) {
    const auto& flow = inflow.mass_flow;
    return flow.is_constant() || inflow.start_time + flow.knots().back().time <= scene.time.end;
  });
}

// What stands or flies past what it is there for.
void note_untouched(const Scene& scene, const State& state, RunOutcome& outcome) {
  if (scene.target && !(state.peaks.jet_force > 0.0))
    outcome.notes.emplace_back("target: no jet ever met it");
  if (!scene.contact || state.peaks.first_contact >= 0.0 || !sees_all_inflow(scene)) return;
  const auto gap = [&](const Eigen::Matrix3Xd& nodes, const coupling::Pose& pose) {
    return coupling::smallest_gap(scene.bag->mesh.elements, nodes, scene.impactor, pose).distance;
  };
  outcome.notes.push_back(fmt::format(
      "{}: the impactor never touched the bag: its distance was {:.3g} m at the start and {:.3g} m at the "
      "end",
      scene.pendulum ? "pendulum" : "impactor", gap(scene.bag->initial_position, impactor_start(scene)),
      gap(state.bag->position.map(), state.level.impactor)));
}

}  // namespace

const char* status_name(RunStatus status) {
  switch (status) {
    case RunStatus::done:
      return "done";
    case RunStatus::interrupted:
      return "interrupted";
    case RunStatus::inaccurate:
      return "inaccurate";
    case RunStatus::failed:
      break;
  }
  return "failed";
}

void conclude(const Scene& scene, const State& state, RunOutcome& outcome) {
  if (outcome.status == RunStatus::done && state.time >= scene.time.end) {
    note_never_on(scene, state, outcome);
    note_held_velocities(scene, state, outcome);
    note_left_outlets(scene, state, outcome);
    note_untouched(scene, state, outcome);
  }
  judge_drift(scene, state, outcome);
}

RunOutcome run_scene(const Scene& scene, State& state, const LevelSink& sink,
                     const std::vector<LevelView>& views, const Executor& executor,
                     const std::function<bool()>& stop) {
  RunOutcome outcome;
  const auto start = std::chrono::steady_clock::now();
  const StageClock clock(executor.threads() == 1);
  TautStraps straps(scene);
  LevelLoop levels(scene);
  levels.watch(sink, views);
  const auto fail = [&](const std::exception& error) {
    outcome.status = RunStatus::failed;
    outcome.out_of_memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
    outcome.message = fmt::format("stage {} at {:.6g} s, step {}: {}", stage_name(state.stage), state.time,
                                  state.steps, text_of(error));
  };
  try {
    run_steps(scene, state, levels, executor, stop, straps, outcome);
  } catch (const std::exception& error) {
    // A stage refused what an earlier one computed (a coordinate out of range, say), or memory ran out.
    fail(error);
  }
  outcome.wall_seconds = seconds_since(start);
  outcome.stage_seconds = clock.seconds(state);
  outcome.cpu_seconds = clock.total();
  const bool to_end = outcome.status == RunStatus::done && state.time >= scene.time.end;
  conclude(scene, state, outcome);
  if (to_end && sees_all_inflow(scene)) straps.note(scene, outcome);
  return outcome;
}

}  // namespace driver
