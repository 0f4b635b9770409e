// SPDX-License-Identifier: Apache-2.0
#include "deck_openings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck_gas.hpp"
#include "export/deck_fabric.hpp"

namespace driver {
namespace {

DeckCurve of_overpressure(const gas::Curve& curve, double factor) {
  DeckCurve points;
  for (const auto& knot : curve.knots()) points.push_back({knot.time, factor * knot.value});
  constexpr double beyond = 1e9;  // [Pa] more than in any bag
  if (points.size() == 1) points.insert(points.begin(), {-beyond, points.front()[1]});
  points.push_back({points.back()[0] + beyond, points.back()[1]});
  return points;
}

// 1 while a trigger is on, else 0. It comes on and goes off at `times` in turn.
DeckCurve on_and_off(const std::vector<double>& times, double end) {
  const double jump = 1e-6 * end;
  DeckCurve points{{0.0, times.front() == 0.0 ? 1.0 : 0.0}};
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] == 0.0) continue;
    const double before = i % 2 == 0 ? 0.0 : 1.0;
    points.push_back({std::max(times[i], points.back()[0] + jump), before});
    points.push_back({points.back()[0] + jump, 1.0 - before});
  }
  points.push_back({points.back()[0] + 2.0 * end, points.back()[1]});
  return points;
}

// A curve of the time since a vent opens; closed before.
DeckCurve opened_at(double time, const gas::Curve& area, double end) {
  DeckCurve points = knots_of(area, time, end);
  if (time == 0.0) return points;
  const double value = value_on(points, time);
  std::erase_if(points, [&](const auto& point) { return point[0] <= time; });
  const double jump = std::min(1e-6 * end, 0.5 * time);
  points.insert(points.begin(), {{0.0, 0.0}, {time - jump, 0.0}, {time, value}});
  return points;
}

// Sets when a vent is open. If the deck cannot represent that, returns the reason.
std::string add_trigger(const Scene& scene, const gas::Vent& vent, DeckVent& opening) {
  const auto times = times_of(scene, vent.trigger);
  if (!times) {
    const std::size_t node = *vent.trigger;
    const auto& sensors = scene.gas->model.triggers.sensors;
    const bool by_pressure =
        node < sensors.size() && sensors[node].kind == gas::SensorKind::pressure && !sensors[node].reset;
    if (!by_pressure) return decided_by_run;
    opening.opens_at_overpressure = sensors[node].threshold;
    return {};
  }
  if (times->empty()) return never_on;
  if (times->size() == 1) {
    opening.opens_at = times->front();
    return {};
  }
  if (vent.area_of_time || vent.area_of_overpressure)
    return "its trigger goes off again, and its area is a curve";
  opening.of_time = on_and_off(*times, scene.time.end);
  return {};
}

}  // namespace

std::optional<std::vector<double>> times_of(const Scene& scene, std::optional<std::size_t> trigger) {
  if (!trigger) return std::vector{0.0};
  return gas::switching_times(scene.gas->model.triggers, *trigger, scene.time.end);
}

void add_vents(const Scene& scene, Deck& deck) {
  const gas::ControlVolumeModel& model = scene.gas->model;
  for (std::size_t i = 0; i < model.vents.size(); ++i) {
    const gas::Vent& vent = model.vents[i];
    DeckVent opening;
    opening.number = i;
    opening.area = vent.discharge_coefficient;
    if (const std::string why = add_trigger(scene, vent, opening); !why.empty()) {
      deck.omissions.push_back({fmt::format("vent.{}", i), why});
      continue;
    }
    if (vent.area_of_time)
      opening.of_time = opened_at(opening.opens_at, *vent.area_of_time, scene.time.end);
    else if (vent.area_of_overpressure)
      opening.of_overpressure = of_overpressure(*vent.area_of_overpressure, 1.0);
    else
      opening.area *= vent.area;
    deck.vents.push_back(std::move(opening));
  }
}

void add_leaks(const Scene& scene, Deck& deck) {
  const LeakLaw law = scene.bag->leak_law;
  if (law == LeakLaw::none) return;
  for (const DeckPart& part : deck.parts) {
    const double porosity = part.fabric.porosity;
    if (part.null_panel || porosity == 0.0) continue;
    DeckLeak leak{part.id, law == LeakLaw::printed ? porosity * porosity : porosity, std::nullopt};
    if (law == LeakLaw::table)
      leak.velocity = of_overpressure(*scene.gas->model.fabrics.front().velocity, porosity);
    deck.leaks.push_back(std::move(leak));
  }
}

}  // namespace driver
