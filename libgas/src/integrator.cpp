// SPDX-License-Identifier: Apache-2.0
#include "gas/integrator.hpp"

#include <algorithm>
#include <cmath>

#include "gas/error.hpp"
#include "require.hpp"
#include "substepper.hpp"

namespace gas {
namespace {

// Of the tolerance: by so much may a species that leaves faster than a sub-step be missing.
constexpr double kNegligible = 0.1;

// Of t, what a sum of steps is off by: a knot so close to the end of a step is that end. In a segment between
// the two an evacuated volume would fill within the rounding of t.
constexpr double kOneTime = 1e-14;

const ControlVolumeModel& validated(const ControlVolumeModel& model) {
  validate(model);
  return model;
}

const IntegratorOptions& validated(const IntegratorOptions& options) {
  require(options.relative_tolerance >= 1e-13 && options.relative_tolerance <= 1e-2, "relative_tolerance",
          options.relative_tolerance, "must be 1e-13 to 1e-2");
  require(options.fixed_step >= 0.0 && std::isfinite(options.fixed_step), "fixed_step [s]",
          options.fixed_step, "must be positive, or 0 for error control");
  require(options.maximum_steps > 0, "maximum_steps", options.maximum_steps, "must be positive");
  return options;
}

void require_path(const VolumePath& path) {
  for (const double v : {path.volume_begin, path.volume_end})
    if (!(v > 0.0 && std::isfinite(v)))
      throw DomainError("volume = " + to_text(v) + " m3: must be positive and finite");
  if (!(path.volume_bulge > -std::min(path.volume_begin, path.volume_end) &&
        std::isfinite(path.volume_bulge)))
    throw DomainError("volume bulge = " + to_text(path.volume_bulge) +
                      " m3: must be finite and above minus the smaller volume of the step's ends");
  for (const double a : {path.leak_area_begin, path.leak_area_end})
    if (!(a >= 0.0 && std::isfinite(a)))
      throw DomainError("leak area = " + to_text(a) + " m2: must be finite and not negative");
}

}  // namespace

class GasIntegrator::Implementation {
 public:
  Implementation(const ControlVolumeModel& model, const IntegratorOptions& options)
      : model_(validated(model)),
        balance_(model_,
                 validated(options).fixed_step > 0.0 ? 0.0 : kNegligible * options.relative_tolerance),
        network_(model_.triggers),
        substepper_(balance_, levels(), options),
        triggers_(model_.triggers.size()),
        before_(model_.triggers.size()),
        switchings_(model_.triggers.size()),
        outflows_(balance_.streams()),
        backflows_(balance_.backflows()) {}

  StepFluxes advance(ControlVolumeState& state, double t0, double t1, const VolumePath& path) {
    require_step(state, t0, t1);
    require_path(path);
    triggers_ = before_ = state.triggers;
    std::ranges::fill(switchings_, 0);
    substepper_.begin_step();
    balance_.begin_step(state, t0, t1, path);
    double a = t0;
    try {
      while (a < t1) a = advance_segment(a, t1);
    } catch (const TooStiff&) {
      require_no_chatter(t0, a);
      throw;
    }
    balance_.finish(state);
    state.triggers = triggers_;
    return fluxes();
  }

 private:
  /// Overpressures [Pa] that a sub-step must not step over.
  std::vector<double> levels() const {
    std::vector<double> all = balance_.levels();
    for (const Sensor& sensor : model_.triggers.sensors) {
      if (sensor.kind != SensorKind::kPressure) continue;
      all.push_back(sensor.threshold);
      if (sensor.reset) all.push_back(*sensor.reset);
    }
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  /// Integrates from a to the next break point or located event, t1 at the latest; returns the time reached.
  double advance_segment(double a, double t1) {
    double next = t1;
    bool watched = false;
    if (!triggers_.empty()) {
      watched = network_.watches_pressure(triggers_);
      const double overpressure = watched ? balance_.pressure(a) - model_.ambient.pressure : 0.0;
      network_.update(triggers_, a, substepper_.take_level().value_or(overpressure), model_.ambient.pressure);
      next = std::min(next, network_.next_break(triggers_, a));
      for (std::size_t i = 0; i < triggers_.size(); ++i) switchings_[i] += triggers_[i].on != before_[i].on;
      before_ = triggers_;
    }
    if (const double knot = balance_.next_break(triggers_, a); t1 - knot > kOneTime * std::abs(t1))
      next = std::min(next, knot);
    balance_.begin_segment(triggers_, a, next);
    if (balance_.needs_stepper() || watched) next = substepper_.integrate(balance_, a, next);
    balance_.end_segment(next);
    return next;
  }

  /// Throws if it was a pressure sensor that took the sub-steps, by what it opens and closes.
  void require_no_chatter(double t0, double t) const {
    constexpr int kOften = 100;
    for (std::size_t i = 0; i < model_.triggers.sensors.size(); ++i) {
      const Sensor& sensor = model_.triggers.sensors[i];
      if (sensor.kind != SensorKind::kPressure || switchings_[i] < kOften) continue;
      const double reset = sensor.reset.value_or(sensor.threshold);
      throw DomainError("pressure sensor " + std::to_string(i + 1) + ", on at " + to_text(sensor.threshold) +
                        " Pa and off at " + to_text(reset) + " Pa, keeps switching: " +
                        std::to_string(switchings_[i]) + " times from t = " + to_text(t0) +
                        " s to t = " + to_text(t) + " s, every " + to_text((t - t0) / switchings_[i]) +
                        " s, for what it opens and closes takes p back and forth between the two; " +
                        "a lower reset, a delay, or a smaller opening, is allowed");
    }
  }

  void require_step(const ControlVolumeState& state, double t0, double t1) const {
    require(std::isfinite(t0), "t0 [s]", t0, "must be finite");
    require(std::isfinite(t1) && t1 > t0, "t1 [s]", t1, "must be finite and later than t0");
    require(state.masses.size() == model_.thermo.size(), "number of masses",
            static_cast<double>(state.masses.size()), "must be one per species");
    require(state.triggers.size() == model_.triggers.size(), "number of triggers",
            static_cast<double>(state.triggers.size()), "must be one per node of the model's triggers");
    for (const double m : state.masses)
      require(std::isfinite(m) && m >= 0.0, "masses [kg]", m, "must be finite and not negative");
    require(std::isfinite(state.internal_energy), "internal_energy [J]", state.internal_energy,
            "must be finite");
  }

  StepFluxes fluxes() {
    StepFluxes f{};
    f.inflows = balance_.delivered();
    f.outflows = outflows_;
    f.backflows = backflows_;
    for (const StreamFlux& in : f.inflows) {
      f.mass_in += in.mass;
      f.enthalpy_in += in.enthalpy;
    }
    for (std::size_t s = 0; s < outflows_.size(); ++s) {
      outflows_[s] = {balance_.total(balance_.out_slot(s)), balance_.total(balance_.out_slot(s) + 1)};
      (s + 1 < outflows_.size() ? f.vent_mass_out : f.fabric_mass_out) += outflows_[s].mass;
      f.enthalpy_out += outflows_[s].enthalpy;
    }
    for (std::size_t j = 0; j < backflows_.size(); ++j) {
      const double mass = balance_.total(balance_.back_slot(j));
      backflows_[j] = {mass, balance_.back_enthalpy() * mass};
      f.backflow_mass += mass;
      f.backflow_enthalpy += backflows_[j].enthalpy;
    }
    f.work = balance_.total(balance_.work_slot());
    f.heat = balance_.total(balance_.heat_slot());
    f.steps = substepper_.accepted();
    f.evaluations = substepper_.evaluations();
    return f;
  }

  const ControlVolumeModel model_;
  FlowBalance balance_;
  TriggerNetwork network_;
  Substepper substepper_;
  TriggerState triggers_;
  TriggerState before_;          // at the last update
  std::vector<int> switchings_;  // of each node in this call
  std::vector<StreamFlux> outflows_, backflows_;
};

GasIntegrator::GasIntegrator(const ControlVolumeModel& model, const IntegratorOptions& options)
    : implementation_(std::make_unique<Implementation>(model, options)) {}

GasIntegrator::~GasIntegrator() = default;
GasIntegrator::GasIntegrator(GasIntegrator&&) noexcept = default;
GasIntegrator& GasIntegrator::operator=(GasIntegrator&&) noexcept = default;

StepFluxes GasIntegrator::advance(ControlVolumeState& state, double t0, double t1, const VolumePath& path) {
  return implementation_->advance(state, t0, t1, path);
}

}  // namespace gas
