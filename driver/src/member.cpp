// SPDX-License-Identifier: Apache-2.0
#include "member.hpp"

#include <fmt/format.h>

#include <ctime>

#include "driver/channel_filter.hpp"

namespace driver {
namespace {

double thread_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

std::vector<Column<RunQuantities>> quantity_columns(const Scene& scene) {
  std::vector<Column<RunQuantities>> columns;
#define GASJET_COLUMN(name) columns.emplace_back(#name, &RunQuantities::name)
  if (scene.has_volume()) {
    GASJET_COLUMN(peak_pressure_Pa);
    GASJET_COLUMN(peak_volume_m3);
  }
  if (scene.pendulum) {
    GASJET_COLUMN(final_angle_rad);
    GASJET_COLUMN(peak_cg_acceleration_m_s2);
    GASJET_COLUMN(peak_cg_acceleration_cfc180_m_s2);
    GASJET_COLUMN(contact_impulse_Ns);
    GASJET_COLUMN(path_impulse_Ns);
    GASJET_COLUMN(first_contact_s);
  }
#undef GASJET_COLUMN
  return columns;
}

Member run_member(const Scene& scene) {
  const double start = thread_cpu_seconds();
  State state = make_state(scene);
  Member member;
  PlanarSignal acceleration;
  double level = 0.0;  // [s] time of the level that the sink sees
  member.outcome = run_scene(scene, state, [&](const StepRecords* records, const State& now) {
    if (records) member.rows.push_back(records->history);
    if (!now.pendulum) return;
    acceleration.time.push_back(level);
    acceleration.first.push_back(now.pendulum->acceleration.tangential);
    acceleration.second.push_back(now.pendulum->acceleration.radial);
    level += now.step.after;
  });
  member.cpu_seconds = thread_cpu_seconds() - start;
  member.quantities = {state.peaks.pressure,
                       state.peaks.volume,
                       state.level.pendulum_angle,
                       state.peaks.cg_acceleration,
                       filtered_peak(acceleration, impactor_channel_class),
                       state.flows.contact_impulse,
                       state.flows.path_impulse,
                       state.peaks.first_contact};
  return member;
}

std::vector<std::string> perturbed(std::vector<std::string> overrides, double amplitude, int seed) {
  overrides.push_back(fmt::format("membrane.perturbation={:e}", amplitude));
  overrides.push_back(fmt::format("membrane.perturbation_seed={}", seed));
  return overrides;
}

}  // namespace driver
