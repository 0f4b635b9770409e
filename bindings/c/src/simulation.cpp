// SPDX-License-Identifier: Apache-2.0
// Simulations: create, step, read.
#include <gasjet/simulation.h>

#include <algorithm>

#include "arrays.hpp"
#include "base/checksum.hpp"
#include "engine/saved_state.hpp"
#include "forecast/jet_peak.hpp"
#include "results/load_scene.hpp"
#include "results/results.hpp"
#include "results/skin_checks.hpp"
#include "results/summary.hpp"
#include "sim_object.hpp"

using namespace border;

namespace {

std::shared_ptr<const driver::Scene> scene_of(driver::CaseDocument& document) {
  driver::Scene scene = driver::load_scene(document);
  driver::add_jet_warnings(scene);
  driver::add_skin_warning(scene);
  scene.driven = true;
  for (const driver::Setting& setting : document.settings())
    scene.digest = driver::checksum(setting.path + "=" + setting.value + "\n", scene.digest);
  return std::make_shared<const driver::Scene>(std::move(scene));
}

void require_no_folder(const Sim& sim) {
  if (sim.folder) refuse("sim", "writes a folder, allowed: a simulation without one, or a finished one");
}

}  // namespace

int gasjet_sim_create(const char* case_file, const char* case_text, const char* overrides, const char* out,
                      int threads, gasjet_handle* sim) {
  return call_driver([&](Environment&) {
    needed(sim, "sim");
    const Order order = order_of(case_file, overrides, out, threads);
    driver::CaseDocument document = document_of(order, case_text);
    const auto made = std::make_shared<Sim>(driver::Simulation(scene_of(document), threads),
                                            driver::provenance(order.file, order.overrides));
    if (!order.out.empty()) made->open(order.out, {.quiet = true, .document = &document});
    *sim = keep(made);
  });
}

int gasjet_sim_clone(gasjet_handle sim, gasjet_handle* clone) {
  return call([&] {
    const Use<Sim> use(sim, "sim");
    needed(clone, "clone") = keep(std::make_shared<Sim>(*use));
  });
}

int gasjet_sim_assign(gasjet_handle sim, gasjet_handle from) {
  return call([&] {
    if (sim == from) refuse("from", "is the simulation itself, allowed: another one");
    const Use<Sim> use(sim, "sim");
    const Use<Sim> other(from, "from");
    require_no_folder(*use);
    if (use->simulation.now().given != other->simulation.now().given)
      refuse("from", "is of another case, allowed: a clone, or what this was cloned from");
    use->simulation = other->simulation;
    use->tables = other->tables;
    use->checks.go_on_as(other->seen());
  });
}

int gasjet_sim_save(gasjet_handle sim, uint8_t bytes[], int64_t size, int64_t* needed_size) {
  return call([&] {
    const Use<Sim> use(sim, "sim");
    const std::string all = driver::saved(use->simulation);
    needed(needed_size, "needed") = static_cast<int64_t>(all.size());
    if (bytes == nullptr && size == 0) return;
    needed(bytes, "bytes");
    if (size < static_cast<int64_t>(all.size()))
      refuse("size", "is " + std::to_string(size) + ", allowed: " + std::to_string(all.size()) + " or more");
    std::copy(all.begin(), all.end(), reinterpret_cast<char*>(bytes));
  });
}

int gasjet_sim_restore(gasjet_handle sim, const uint8_t bytes[], int64_t size) {
  return call_driver([&](Environment&) {
    const Use<Sim> use(sim, "sim");
    needed(bytes, "bytes");
    if (size < 1) refuse("size", "is " + std::to_string(size) + ", allowed: 1 or more");
    require_no_folder(*use);
    driver::restore(use->simulation, {reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size)});
    use->checks.go_on_from(use->state());
  });
}

int gasjet_sim_reset(gasjet_handle sim) {
  return call_driver([&](Environment&) {
    const Use<Sim> use(sim, "sim");
    require_no_folder(*use);
    use->simulation.reset();
    for (Table& table : use->tables) table = Table(table.columns);
    use->checks.go_on_as(driver::SkinChecks(*use->simulation.now().given));
  });
}

int gasjet_sim_time(gasjet_handle sim, double* time, int64_t* steps, int* ended) {
  return call([&] {
    const Use<Sim> use(sim, "sim");
    needed(steps, "steps");
    needed(ended, "ended");
    needed(time, "time") = use->state().time;
    *steps = use->state().steps;
    *ended = use->simulation.ended() ? 1 : 0;
  });
}

int gasjet_sim_evaluate(gasjet_handle sim, double* step, double* limit) {
  return call([&] {
    const Use<Sim> use(sim, "sim");
    needed(step, "step");
    needed(limit, "limit");
    use->simulation.evaluate();
    *step = use->simulation.ended() ? 0.0 : use->state().step.after;
    *limit = use->state().step.critical;
  });
}

int gasjet_sim_step(gasjet_handle sim, int64_t count) {
  return call([&] { Use<Sim>(sim, "sim")->simulation.step(count); });
}

int gasjet_sim_advance(gasjet_handle sim, double time, int exactly, gasjet_progress progress, void* user) {
  return call([&](Environment& environment) {
    const Use<Sim> use(sim, "sim");
    driver::Simulation& simulation = use->simulation;
    Callback callback(progress, user, use->scene().time.end, environment);
    const auto stop = [&] {
      callback.level(simulation.state().time);
      return callback.stopped();
    };
    if (exactly != 0)
      simulation.advance_exactly(time, stop);
    else
      simulation.advance(time, stop);
    if (callback.thrown())
      throw Failure(GASJET_STOPPED, "progress: threw an exception, allowed: to return a number");
    if (callback.stopped()) throw Failure(GASJET_STOPPED, "progress: stopped the simulation");
  });
}

int gasjet_sim_finish(gasjet_handle sim) {
  return call_driver([&](Environment&) { Use<Sim>(sim, "sim")->finish(); });
}

int gasjet_sim_results(gasjet_handle sim, gasjet_handle* run) {
  return call([&] {
    const Use<Sim> use(sim, "sim");
    needed(run, "run");
    driver::Simulation& simulation = use->simulation;
    if (simulation.ended() && simulation.now().failure.empty()) simulation.evaluate();
    const auto made = std::make_shared<Run>(use->scene());
    made->tables = use->tables;
    driver::RunOutcome outcome = simulation.outcome();
    use->seen().note(outcome);
    made->summary =
        driver::summary_text(use->scene(), use->state(), outcome, use->seen().found(), use->lines);
    *run = keep(made);
  });
}

int gasjet_sim_record(gasjet_handle sim, int every) {
  return call([&] { Use<Sim>(sim, "sim")->simulation.record_all(every != 0); });
}
