// SPDX-License-Identifier: Apache-2.0
#include "gas/integrator.hpp"

#include <algorithm>
#include <cmath>

#include "gas/error.hpp"
#include "require.hpp"
#include "substepper.hpp"

namespace gas {
namespace {

// A species that leaves faster than a sub-step may be overdrawn by this share of the tolerance.
constexpr double kNegligible = 0.1;

// Relative error of t after many steps. A knot this close to the end of a step counts as the end: no segment
// may be as short as the rounding of t.
constexpr double kOneTime = 1e-14;

const ControlVolumeModel& validated(const ControlVolumeModel& model) {
  validate(model);
  return model;
}

const IntegratorOptions& validated(const IntegratorOptions& options) {
  require(options.method >= Method::dormand_prince_5 && options.method <= Method::rosenbrock_4, "method",
          static_cast<double>(options.method), "must be one of its enumerators");
  require(options.relative_tolerance >= 1e-13 && options.relative_tolerance <= 1e-2, "relative_tolerance",
          options.relative_tolerance, "must be 1e-13 to 1e-2");
  require(options.fixed_step >= 0.0 && std::isfinite(options.fixed_step), "fixed_step [s]",
          options.fixed_step, "must be positive, or 0 for error control");
  require(options.maximum_steps > 0, "maximum_steps", options.maximum_steps, "must be positive");
  return options;
}

void require_path(const VolumePath& path, bool has_volume) {
  for (const double v : {path.volume_begin, path.volume_end})
    if (has_volume && !(v > 0.0 && std::isfinite(v)))
      throw DomainError("volume = " + to_short_text(v) + " m3: must be positive and finite");
  if (has_volume && !(path.volume_bulge > -std::min(path.volume_begin, path.volume_end) &&
                      std::isfinite(path.volume_bulge)))
    throw DomainError("volume bulge = " + to_short_text(path.volume_bulge) +
                      " m3: must be finite and above minus the smaller volume of the step's ends");
  for (const double a : {path.leak_area_begin, path.leak_area_end})
    if (!(a >= 0.0 && std::isfinite(a)))
      throw DomainError("leak area = " + to_short_text(a) + " m2: must be finite and not negative");
}

}  // namespace

class GasIntegrator::Implementation {
 public:
  Implementation(const ControlVolumeModel& model, const IntegratorOptions& options)
      : model_(validated(model)),
        options_(options),
        network_(model_.triggers),
        boundary_(model_),
        ledger_(boundary_,
                validated(options).fixed_step > 0.0 ? 0.0 : kNegligible * options.relative_tolerance),
        substepper_(boundary_, ledger_, network_, options),
        triggers_(model_.triggers.size()),
        before_(model_.triggers.size()),
        switchings_(model_.triggers.size()),
        inflows_(model_.inflows.size()),
        outflows_(boundary_.slots().streams()),
        backflows_(boundary_.slots().backflows) {}

  const ControlVolumeModel& model() const { return model_; }
  const IntegratorOptions& options() const { return options_; }

  StepFluxes advance(ControlVolumeState& state, double t0, double t1, const VolumePath& path) {
    require_step(state, t0, t1);
    require_path(path, !model_.volume_of_overpressure);
    triggers_ = before_ = state.triggers;
    std::ranges::fill(switchings_, 0);
    boundary_.begin_step(t0, t1, path);
    const double work = stored_work(model_, state);
    ledger_.begin_step(state, work);
    substepper_.begin_step(state.temperature);
    double a = t0;
    try {
      while (a < t1) a = advance_segment(a, t1);
    } catch (const TooStiff&) {
      require_no_chatter(t0, a);
      throw;
    }
    finish(state, t1, work);
    return fluxes();
  }

 private:
  /// Integrates from a to the next break point or the switch of a pressure sensor, t1 at the latest; returns
  /// the time reached.
  double advance_segment(double a, double t1) {
    double next = t1;
    bool watched = false;
    if (!triggers_.empty()) {
      watched = network_.watches_pressure(triggers_);
      network_.update(triggers_, a, watched ? locate(a).overpressure : 0.0, model_.ambient.pressure);
      next = std::min(next, network_.next_break(triggers_, a));
      for (std::size_t i = 0; i < triggers_.size(); ++i) switchings_[i] += triggers_[i].on != before_[i].on;
      before_ = triggers_;
    }
    if (const double knot = boundary_.next_break(triggers_, a); t1 - knot > kOneTime * std::abs(t1))
      next = std::min(next, knot);
    boundary_.begin_segment(triggers_, a, next);
    const double length = boundary_.segment().length;
    ledger_.begin_segment();
    const double reached = needs_stepper() || watched ? substepper_.integrate(triggers_) : length;
    ledger_.deliver(reached);
    return reached < length ? a + reached : next;
  }

  /// True if anything but inflow changes the gas.
  bool needs_stepper() const {
    return boundary_.is_open() || boundary_.path().moves() || model_.heat_loss.conductance > 0.0;
  }

  /// The gas at t, between two segments.
  const UniformGas& locate(double t) {
    if (!substepper_.balance().locate(ledger_.gas(), t - boundary_.segment().begin))
      throw DomainError(range_text(model_) + "at t = " + to_short_text(t) + " s", t);
    return substepper_.balance().gas();
  }

  /// Sets `state` to time t1. The work of a volume that follows the pressure is known only there;
  /// `work_begin` is (G.19) at the begin.
  void finish(ControlVolumeState& state, double t1, double work_begin) {
    const UniformGas& gas = locate(t1);
    if (gas.beyond) throw DomainError(beyond_text(model_));
    const Vector& amount = ledger_.gas();
    state.internal_energy = amount.back() - gas.work;
    if (model_.volume_of_overpressure) ledger_.set_total(boundary_.slots().work(), gas.work - work_begin);
    std::copy_n(amount.begin(), state.masses.size(), state.masses.begin());
    if (gas.mass > 0.0) state.temperature = gas.temperature;
    state.triggers = triggers_;
  }

  /// Throws if a pressure sensor used up the sub-steps by switching again and again.
  void require_no_chatter(double t0, double t) const {
    constexpr int kOften = 100;
    for (std::size_t i = 0; i < model_.triggers.sensors.size(); ++i) {
      const Sensor& sensor = model_.triggers.sensors[i];
      if (sensor.kind != SensorKind::pressure || switchings_[i] < kOften) continue;
      const double reset = sensor.reset.value_or(sensor.threshold);
      throw DomainError("pressure sensor " + std::to_string(i + 1) + ", on at " + to_text(sensor.threshold) +
                        " Pa and off at " + to_text(reset) +
                        " Pa, keeps switching: " + std::to_string(switchings_[i]) +
                        " times from t = " + to_text_beside(t0, t) + " s to t = " + to_text_beside(t, t0) +
                        " s, every " + to_short_text((t - t0) / switchings_[i]) +
                        " s, because the openings that it switches move p to and fro between the two. " +
                        "Use a lower reset, a delay, or a smaller opening");
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
    for (const auto& [name, value] :
         {std::pair{"internal_energy [J]", state.internal_energy}, {"temperature [K]", state.temperature}})
      require(std::isfinite(value), name, value, "must be finite");
  }

  StepFluxes fluxes() {
    const Slots& slots = boundary_.slots();
    StepFluxes f{};
    f.inflows = inflows_;
    f.outflows = outflows_;
    f.backflows = backflows_;
    for (std::size_t i = 0; i < inflows_.size(); ++i) {
      inflows_[i] = ledger_.delivered(i);
      f.mass_in += inflows_[i].mass;
      f.enthalpy_in += inflows_[i].enthalpy;
    }
    for (std::size_t j = 0; j < outflows_.size(); ++j) {
      outflows_[j] = {ledger_.total(slots.mass(j)), ledger_.total(slots.enthalpy(j))};
      (j < slots.vents ? f.vent_mass_out : f.fabric_mass_out) += outflows_[j].mass;
      f.enthalpy_out += outflows_[j].enthalpy;
    }
    for (std::size_t j = 0; j < backflows_.size(); ++j) {
      const double mass = ledger_.total(slots.back(j));
      backflows_[j] = {mass, boundary_.ambient().enthalpy * mass};
      f.backflow_mass += mass;
      f.backflow_enthalpy += backflows_[j].enthalpy;
    }
    f.work = ledger_.total(slots.work());
    f.heat = ledger_.total(slots.heat());
    f.steps = substepper_.effort().accepted;
    f.evaluations = substepper_.effort().evaluations;
    f.moments = substepper_.moments();
    return f;
  }

  const ControlVolumeModel model_;
  const IntegratorOptions options_;
  TriggerNetwork network_;
  Boundary boundary_;
  Ledger ledger_;
  Substepper substepper_;
  TriggerState triggers_;
  TriggerState before_;          // triggers at the last update
  std::vector<int> switchings_;  // number of switchings of each node in this call
  std::vector<StreamFlux> inflows_, outflows_, backflows_;
};

GasIntegrator::GasIntegrator(const ControlVolumeModel& model, const IntegratorOptions& options)
    : implementation_(std::make_unique<Implementation>(model, options)) {}

GasIntegrator::GasIntegrator(const GasIntegrator& other)
    : implementation_(std::make_unique<Implementation>(other.implementation_->model(),
                                                       other.implementation_->options())) {}
GasIntegrator& GasIntegrator::operator=(const GasIntegrator& other) {
  return *this = GasIntegrator(other);
}
GasIntegrator::~GasIntegrator() = default;
GasIntegrator::GasIntegrator(GasIntegrator&&) noexcept = default;
GasIntegrator& GasIntegrator::operator=(GasIntegrator&&) noexcept = default;

StepFluxes GasIntegrator::advance(ControlVolumeState& state, double t0, double t1, const VolumePath& path) {
  return implementation_->advance(state, t0, t1, path);
}

}  // namespace gas
