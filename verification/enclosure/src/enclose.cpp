// SPDX-License-Identifier: Apache-2.0
#include "enclosure/enclose.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "bounds.hpp"
#include "sensed_walk.hpp"

namespace enclosure {
namespace {

std::vector<std::string> columns(const Scene& s) {
  std::vector<std::string> names{"pressure_Pa", "temperature_K", "volume_m3", "gas_mass_kg"};
  const auto add = [&](const char* kind, const std::string& name, const char* end) {
    names.push_back(std::string(kind).append(name).append(end));
  };
  for (const Species& species : s.species) add("mass_", species.name, "_kg");
  for (std::size_t i = 0; i < s.inflators.size(); ++i) add("inflator_", std::to_string(i), "_in_kg");
  for (std::size_t i = 0; i < s.holes.size(); ++i) add("vent_", std::to_string(i), "_out_kg");
  for (std::size_t i = 0; i < s.fabrics.size(); ++i)
    add("fabric_", s.fabrics.size() == 1 ? std::string() : std::to_string(i).append(1, '_'), "out_kg");
  for (std::size_t i = 0; i < s.holes.size(); ++i)
    if (s.holes[i].backflow) add("vent_", std::to_string(i), "_backflow_kg");
  return names;
}

/// Refuses a temperature outside the range of the polynomials.
void require_range(const Tank& tank, const Ball& temperature, const Ball& time) {
  if (tank.constant_cp) return;
  if ((temperature - Ball(tank.minimum_temperature)).is_positive() &&
      (Ball(tank.maximum_temperature) - temperature).is_positive())
    return;
  char text[160];
  std::snprintf(text, sizeof text, "at t = %.4g s the temperature, %.4g K, is not within %.4g to %.4g K",
                time.middle(), temperature.middle(), tank.minimum_temperature, tank.maximum_temperature);
  throw Refusal(text);
}

/// cv > 0: the temperature of an energy is unique, and an outflow cools. Over 64 parts of each range.
void require_heat_capacity(const Scene& s) {
  const auto above_r = [](const Species& gas, const std::array<double, 6>& a, const Ball& t) {
    const Balls cp(a.begin(), a.begin() + 5);
    return (polynomial(gas.constant_cp ? Balls{cp[0]} : cp, t) - Ball(1.0)).is_positive();
  };
  for (const Species& gas : s.species) {
    bool holds = above_r(gas, gas.low, Ball(0.0)) || !gas.constant_cp;
    for (int i = 0; i < 64 && !gas.constant_cp; ++i) {
      const auto part = [&](double from, double to) {
        return hull(Ball(from + (to - from) * i / 64.0), Ball(from + (to - from) * (i + 1) / 64.0));
      };
      holds = holds && above_r(gas, gas.low, part(gas.minimum_temperature, joint_temperature)) &&
              above_r(gas, gas.high, part(joint_temperature, gas.maximum_temperature));
    }
    if (!holds) throw Refusal("cp of " + gas.name + " is not above its gas constant at every temperature");
  }
}

Moment empty_moment(const Tank& tank, double time, std::size_t count) {
  Moment moment{time, std::vector<Bounds>(count, bounds(Ball(0.0)))};
  const Ball at(time);
  Ball volume;
  tank.scene.wave ? wave_series(*tank.scene.wave, {at, at}, volume.get(), 1)
                  : tank.volumes[0].series({at, at}, Mode::series, volume.get(), 1);
  moment.bounds[1] = bounds(Ball(tank.scene.initial_temperature));
  moment.bounds[2] = bounds(volume);
  return moment;
}

}  // namespace

Tube enclose(const Scene& scene, const Request& request) {
  const Tank tank(scene);
  if (request.times.empty() || !std::is_sorted(request.times.begin(), request.times.end()) ||
      !(request.times.front() >= 0.0) || !std::isfinite(request.times.back()))
    throw std::invalid_argument("enclosure: the times need to be 0 or later, finite, and to rise");
  if (!(request.width >= 1e-25 && request.width < 1.0))
    throw std::invalid_argument("enclosure: the width needs to be from 1e-25 to below 1");
  require_heat_capacity(scene);
  SensedWalk course(scene, 1e-5 * request.width);
  Tube tube;
  tube.columns = columns(scene);
  const std::clock_t begin = std::clock();
  for (double time : request.times) {
    const Ball end(time);
    if (!before(course.empty_until(), end)) {
      tube.moments.push_back(empty_moment(tank, time, tube.columns.size()));
      continue;
    }
    while (before(course.walk().time(), end)) {
      course.step(end);
      require_range(tank, course.walk().temperature(), course.walk().time());
      if (static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC > request.longest) {
        char text[160];
        std::snprintf(text, sizeof text,
                      "computing takes longer than %.3g s: %ld steps so far, to t = %.4g s of %.4g s",
                      request.longest, course.steps(), course.walk().time().middle(), request.times.back());
        throw Refusal(text);
      }
    }
    if (before(end, course.walk().time()) || course.is_open()) throw Refusal(too_close(end));
    Moment moment{time, {}};
    for (const Ball& value : course.walk().values()) moment.bounds.push_back(bounds(value));
    tube.moments.push_back(moment);
  }
  tube.steps = course.steps();
  tube.crossings = course.crossings();
  return tube;
}

}  // namespace enclosure
