// SPDX-License-Identifier: Apache-2.0
#include "openings.hpp"

#include <algorithm>
#include <cmath>

#include "inflow_segment.hpp"
#include "limits.hpp"

namespace gas {
namespace {

double opened_at(const Vent& vent, const TriggerState& triggers) {
  return vent.trigger ? triggers[*vent.trigger].since : 0.0;
}

/// On the clock of the vent's area of time.
double time_open(const Vent& vent, const TriggerState& triggers, double t) {
  return local_time({&*vent.area_of_time}, opened_at(vent, triggers), t);
}

}  // namespace

double effective_area(const Vent& vent, const TriggerState& triggers, double time, double overpressure) {
  if (vent.trigger && !triggers.at(*vent.trigger).on) return 0.0;
  const double area = vent.area_of_overpressure ? vent.area_of_overpressure->value(overpressure)
                      : vent.area_of_time       ? vent.area_of_time->value(time_open(vent, triggers, time))
                                                : vent.area;
  return vent.discharge_coefficient * area;
}

Openings::Openings(const ControlVolumeModel& model)
    : model_(model), pieces_(model.vents.size()), open_(model.vents.size()) {}

double Openings::next_break(const TriggerState& triggers, double t) const {
  double next = kInfinity;
  for (const Vent& vent : model_.vents) {
    if (!vent.area_of_time) continue;
    const double start = opened_at(vent, triggers);
    if (start == kInfinity) continue;
    const double knot = start + vent.area_of_time->next_knot(time_open(vent, triggers, t));
    next = std::min(next, std::max(knot, std::nextafter(t, kInfinity)));
  }
  return next;
}

void Openings::begin_segment(const TriggerState& triggers, double a, double b) {
  is_open_ = has_backflow_ = false;
  for (std::size_t j = 0; j < pieces_.size(); ++j) {
    const Vent& vent = model_.vents[j];
    open_[j] = !vent.trigger || triggers[*vent.trigger].on;
    if (!open_[j]) continue;
    const double start = opened_at(vent, triggers);
    Curve::Piece piece{0.0, vent.area_of_overpressure ? 1.0 : vent.area, 0.0};
    if (vent.area_of_time) {
      piece = vent.area_of_time->piece(0.5 * (a + b) - start);
      piece.origin += start;
    }
    const double cd = vent.discharge_coefficient;
    pieces_[j] = {piece.origin, cd * piece.value, cd * piece.slope};
    open_[j] = pieces_[j].value > 0.0 || pieces_[j].slope != 0.0;
    is_open_ = is_open_ || open_[j];
    has_backflow_ = has_backflow_ || (open_[j] && vent.backflow);
  }
}

std::vector<double> overpressure_knots(const ControlVolumeModel& model) {
  std::vector<double> knots;
  const auto add = [&](const std::optional<Curve>& curve) {
    if (!curve || curve->is_constant()) return;
    for (const Curve::Knot& knot : curve->knots()) knots.push_back(knot.time);
  };
  for (const Vent& vent : model.vents) add(vent.area_of_overpressure);
  for (const Fabric& fabric : model.fabrics) add(fabric.velocity);
  add(model.volume_of_overpressure);
  std::ranges::sort(knots);
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  return knots;
}

}  // namespace gas
