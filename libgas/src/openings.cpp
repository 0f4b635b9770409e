// SPDX-License-Identifier: Apache-2.0
#include "openings.hpp"

#include <algorithm>
#include <cmath>

#include "infinity.hpp"

namespace gas {
namespace {

void add_knots(const std::optional<Curve>& curve, std::vector<double>& knots) {
  if (!curve || curve->is_constant()) return;
  for (const Curve::Knot& knot : curve->knots()) knots.push_back(knot.time);
}

Curve::Piece scaled(double factor, Curve::Piece piece) {
  return {piece.origin, factor * piece.value, factor * piece.slope};
}

double opened_at(const Vent& vent, const TriggerState& triggers) {
  return vent.trigger ? triggers[*vent.trigger].since : 0.0;
}

}  // namespace

Openings::Openings(const ControlVolumeModel& model) : model_(model) {
  for (const Vent& vent : model.vents) {
    vents_.push_back({{0.0, vent.discharge_coefficient * vent.area, 0.0},
                      vent.area_of_overpressure.has_value(),
                      !vent.trigger});
    any_backflow_ = any_backflow_ || vent.backflow;
  }
  enter_band(0.0);
}

std::vector<double> Openings::knots() const {
  std::vector<double> knots;
  for (const Vent& vent : model_.vents) add_knots(vent.area_of_overpressure, knots);
  add_knots(model_.fabric_velocity, knots);
  std::ranges::sort(knots);
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  return knots;
}

double Openings::next_break(const TriggerState& triggers, double t) const {
  double next = kInfinity;
  for (const Vent& vent : model_.vents) {
    if (!vent.area_of_time) continue;
    const double start = opened_at(vent, triggers);
    if (start == kInfinity) continue;
    const double knot = start + vent.area_of_time->next_knot(t - start);
    next = std::min(next, std::max(knot, std::nextafter(t, kInfinity)));
  }
  return next;
}

void Openings::begin_segment(const TriggerState& triggers, double a, double b) {
  for (std::size_t j = 0; j < vents_.size(); ++j) {
    const Vent& vent = model_.vents[j];
    if (vent.trigger) vents_[j].open = triggers[*vent.trigger].on;
    if (!vent.area_of_time || !vents_[j].open) continue;
    const double start = opened_at(vent, triggers);
    vents_[j].piece = scaled(vent.discharge_coefficient, vent.area_of_time->piece(0.5 * (a + b) - start));
    vents_[j].piece.origin += start;
  }
}

void Openings::enter_band(double overpressure) {
  for (std::size_t j = 0; j < vents_.size(); ++j)
    if (vents_[j].of_overpressure)
      vents_[j].piece = scaled(model_.vents[j].discharge_coefficient,
                               model_.vents[j].area_of_overpressure->piece(overpressure));
  if (model_.fabric_velocity) fabric_ = model_.fabric_velocity->piece(overpressure);
}

bool Openings::is_open() const {
  return std::ranges::any_of(vents_, [](const Opening& o) {
    return o.open && (o.piece.value > 0.0 || o.piece.slope != 0.0 || o.of_overpressure);
  });
}

double Openings::effective_area(std::size_t j, double t, double overpressure) const {
  const Opening& o = vents_[j];
  if (!o.open) return 0.0;
  if (o.piece.slope == 0.0) return o.piece.value;
  return std::max(0.0, o.piece.at(o.of_overpressure ? overpressure : t));
}

double Openings::fabric_velocity(double overpressure) const {
  return std::max(0.0, fabric_.at(overpressure));
}

}  // namespace gas
