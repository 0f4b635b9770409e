// SPDX-License-Identifier: Apache-2.0
#include "gas/integrator.hpp"

#include <algorithm>
#include <cmath>

#include "gas/error.hpp"
#include "require.hpp"
#include "substepper.hpp"

namespace gas {
namespace {

const ControlVolumeModel& validated(const ControlVolumeModel& model) {
  validate(model);
  return model;
}

const IntegratorOptions& validated(const IntegratorOptions& options) {
  require(options.relative_tolerance >= 1e-13 && options.relative_tolerance <= 1e-2, "relative_tolerance",
          options.relative_tolerance, "must be 1e-13 to 1e-2");
  require(options.maximum_steps > 0, "maximum_steps", options.maximum_steps, "must be positive");
  return options;
}

void require_path(const VolumePath& path) {
  for (const double v : {path.volume_begin, path.volume_end})
    if (!(v > 0.0 && std::isfinite(v)))
      throw DomainError("volume = " + to_text(v) + " m3: must be positive and finite");
  for (const double a : {path.leak_area_begin, path.leak_area_end})
    if (!(a >= 0.0 && std::isfinite(a)))
      throw DomainError("leak area = " + to_text(a) + " m2: must be finite and not negative");
}

}  // namespace

class GasIntegrator::Implementation {
 public:
  Implementation(const ControlVolumeModel& model, const IntegratorOptions& options)
      : model_(validated(model)),
        balance_(model_),
        substepper_(balance_.unknowns(), validated(options)),
        y_(balance_.unknowns()) {}

  StepFluxes advance(ControlVolumeState& state, double t0, double t1, const VolumePath& path) {
    require_step(state, t0, t1);
    require_path(path);
    std::ranges::fill(y_, 0.0);
    substepper_.begin_step();
    balance_.begin_step(state, t0, t1, path);
    for (double a = t0; a < t1;) {
      const double b = std::min(balance_.next_break(a), t1);
      balance_.begin_segment(a, b);
      if (balance_.is_open() || !balance_.is_rigid()) substepper_.integrate(balance_, y_, a, b);
      balance_.end_segment();
      a = b;
    }
    balance_.finish(y_, state);
    return fluxes();
  }

 private:
  void require_step(const ControlVolumeState& state, double t0, double t1) const {
    require(std::isfinite(t0), "t0 [s]", t0, "must be finite");
    require(std::isfinite(t1) && t1 > t0, "t1 [s]", t1, "must be finite and later than t0");
    require(state.masses.size() == model_.thermo.size(), "number of masses",
            static_cast<double>(state.masses.size()), "must be one per species");
    for (const double m : state.masses)
      require(std::isfinite(m) && m >= 0.0, "masses [kg]", m, "must be finite and not negative");
    require(std::isfinite(state.internal_energy), "internal_energy [J]", state.internal_energy,
            "must be finite");
  }

  StepFluxes fluxes() const {
    return {balance_.mass_in(),         balance_.enthalpy_in(),       y_[balance_.vent_slot()],
            y_[balance_.fabric_slot()], y_[balance_.enthalpy_slot()], y_[balance_.work_slot()],
            substepper_.accepted(),     substepper_.evaluations()};
  }

  const ControlVolumeModel model_;
  FlowBalance balance_;
  Substepper substepper_;
  FlowBalance::Vector y_;
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
