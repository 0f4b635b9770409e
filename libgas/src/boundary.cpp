// SPDX-License-Identifier: Apache-2.0
#include "boundary.hpp"

#include <algorithm>
#include <cmath>

#include "limits.hpp"

namespace gas {
namespace {

bool lets_air_in(const ControlVolumeModel& model) {
  return std::ranges::any_of(model.vents, &Vent::backflow);
}

}  // namespace

double laminar_overpressure(const ControlVolumeModel& model) {
  return model.laminar_share * model.ambient.pressure;
}

double opened_at(const Vent& vent, const TriggerState& triggers) {
  return vent.trigger ? triggers[*vent.trigger].since : 0.0;
}

const Fabric& fabric_of(const ControlVolumeModel& model, std::size_t i) {
  static const Fabric whole{1.0};
  return model.fabrics.empty() ? whole : model.fabrics[i];
}

double heat_flow(const ControlVolumeModel& model, double temperature) {
  return model.heat_loss.conductance * (temperature - model.heat_loss.outside_temperature);
}

AmbientGas::AmbientGas(const ControlVolumeModel& model)
    : pressure(model.ambient.pressure), temperature(model.ambient.temperature) {
  if (!lets_air_in(model)) return;
  mixture = model.thermo.mixture(model.ambient.mass_fractions);
  gas_constant = mixture.gas_constant_sum / mixture.mass;
  gamma = mixture.cp(temperature) / mixture.cv(temperature);
  enthalpy = mixture.enthalpy(temperature) / mixture.mass;
}

Boundary::Boundary(const ControlVolumeModel& model)
    : model_(model),
      ambient_(model),
      slots_{model.thermo.size(), model.vents.size(), model.fabric_count(),
             lets_air_in(model) ? model.vents.size() : 0},
      inflows_(model),
      areas_(model.vents.size()) {}

void Boundary::begin_step(double t0, double t1, const VolumePath& path) {
  path_ = {t0, 0.0, 1.0 / (t1 - t0), path};
  segment_ = {t0, 0.0};
  if (!model_.volume_of_overpressure) return;
  path_.path.volume_begin = path_.path.volume_end = path_.path.volume_bulge = 0.0;  // not read
}

void Boundary::begin_segment(const TriggerState& triggers, double a, double b) {
  segment_ = {a, b - a};
  path_.begin = (a - path_.t0) * path_.per_second;
  inflows_.begin_segment(triggers, a, b);
  for (std::size_t j = 0; j < areas_.size(); ++j) {
    const Vent& vent = model_.vents[j];
    Curve::Piece piece{0.0, vent.area_of_overpressure ? 1.0 : vent.area, 0.0};
    if (vent.trigger && !triggers[*vent.trigger].on) {
      piece.value = 0.0;
    } else if (vent.area_of_time) {
      const double start = opened_at(vent, triggers);
      const double begin = local_time({&*vent.area_of_time}, start, a);
      piece = vent.area_of_time->piece(0.5 * (a + b) - start);
      piece = {0.0, piece.at(begin), piece.slope};
    }
    const double cd = vent.discharge_coefficient;
    areas_[j] = {piece.origin, cd * piece.value, cd * piece.slope};
  }
}

double Boundary::next_break(const TriggerState& triggers, double t) const {
  double next = inflows_.next_break(triggers, t);
  for (const Vent& vent : model_.vents) {
    const double start = opened_at(vent, triggers);
    if (!vent.area_of_time || start == kInfinity) continue;
    const Curve& area = *vent.area_of_time;
    const double knot = start + area.next_knot(local_time({&area}, start, t));
    next = std::min(next, std::max(knot, std::nextafter(t, kInfinity)));
  }
  return next;
}

bool Boundary::has_open_vent() const {
  for (std::size_t j = 0; j < areas_.size(); ++j)
    if (is_open(j)) return true;
  return false;
}

bool Boundary::has_backflow() const {
  for (std::size_t j = 0; j < slots_.backflows; ++j)
    if (model_.vents[j].backflow && is_open(j)) return true;
  return false;
}

}  // namespace gas
