// SPDX-License-Identifier: Apache-2.0
#include "second_route.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace second_route {
namespace {

int gsl_rates(double t, const double y[], double dydt[], void* parameters) {
  const auto& stretch = *static_cast<const Stretch*>(parameters);
  const std::size_t n = stretch.tank.start.masses.size() + 1;
  try {
    rates(stretch, t, {y, n}, {dydt, n});
  } catch (const std::exception&) {
    return GSL_EBADFUNC;
  }
  return GSL_SUCCESS;
}

int gsl_jacobian(double t, const double y[], double* dfdy, double dfdt[], void* parameters) {
  const auto& stretch = *static_cast<const Stretch*>(parameters);
  const std::size_t n = stretch.tank.start.masses.size() + 1;
  std::vector<double> point(y, y + n), base(n), moved(n);
  double mass = 0.0;
  for (std::size_t k = 0; k + 1 < n; ++k) mass += y[k];
  try {
    rates(stretch, t, point, base);
    for (std::size_t j = 0; j < n; ++j) {
      // sqrt(eps) of the size of the unknown; cv T is some 1e6 J/kg.
      const double change = 1e-8 * (j + 1 < n ? mass : 1e6 * mass);
      point[j] = y[j] + change;
      rates(stretch, t, point, moved);
      point[j] = y[j];
      for (std::size_t i = 0; i < n; ++i) dfdy[i * n + j] = (moved[i] - base[i]) / change;
    }
  } catch (const std::exception&) {
    return GSL_EBADFUNC;
  }
  for (std::size_t i = 0; i < n; ++i) dfdt[i] = 0.0;  // the curves are constant
  return GSL_SUCCESS;
}

}  // namespace

Tank benchmark_tank(double vent_area) {
  std::vector<gas::Species> species;
  for (const char* name : {"N2", "O2", "Ar", "CO2", "H2O"}) species.push_back(gas::nasa7_species(name));
  const gas::Thermo thermo(species);
  gas::ControlVolumeModel model{thermo, {101325.0, 293.15}, {}, {}};
  const std::vector<gas::Component> hot{{"N2", 0.5}, {"CO2", 0.2}, {"H2O", 0.3}};
  model.inflows.push_back({thermo.mass_fractions_by_mole(hot),
                           gas::Curve({{0.0, 1.0}, {kFilled, 1.0}}, gas::Outside::zero),
                           gas::Curve::constant(1200.0)});
  if (vent_area > 0.0) model.vents.push_back({1.0, vent_area});
  return {model, gas::make_state(model, thermo.mass_fractions_by_mole(gas::air_by_mole()), 101325.0, 293.15,
                                 kVolume)};
}

void add_inflow(const Stretch& stretch, double t, std::span<double> y) {
  const gas::ControlVolumeModel& model = stretch.tank.model;
  for (const gas::Inflow& in : model.inflows) {
    const double from = std::max(0.0, stretch.begin - in.start_time), to = t - in.start_time;
    if (!(to > from)) continue;
    const double mass = in.mass_flow.integral(from, to);
    for (std::size_t k = 0; k + 1 < y.size(); ++k) y[k] += mass * in.mass_fractions[k];
    y.back() += mass * model.thermo.enthalpy(in.mass_fractions, in.temperature.value(from));
  }
}

void rates(const Stretch& stretch, double t, std::span<const double> y, std::span<double> dydt) {
  const auto& [tank, begin, end, inflow] = stretch;
  const std::size_t n = y.size() - 1;
  t = std::clamp(t, std::nextafter(begin, end), std::nextafter(end, begin));
  std::vector<double> held(y.begin(), y.end());
  if (inflow == Inflow::closed_form) add_inflow(stretch, t, held);
  gas::ControlVolumeState state{{held.begin(), held.end() - 1}, held[n], tank.start.temperature, {}};
  for (double& m : state.masses) m = std::max(m, 0.0);
  const gas::GasPoint point = gas::evaluate(tank.model, state, tank.volume, tank.leak_area, t);
  const double out = point.vent_mass_flow + point.fabric_mass_flow;
  for (std::size_t k = 0; k < n; ++k) dydt[k] = -out * state.masses[k] / point.mass;
  dydt[n] = -out * (state.internal_energy + point.pressure * tank.volume) / point.mass;
  for (std::size_t i = 0; inflow == Inflow::stepped && i < tank.model.inflows.size(); ++i) {
    const gas::InflatorPoint in = gas::inflator_point(tank.model, i, t);
    const auto& fractions = tank.model.inflows[i].mass_fractions;
    for (std::size_t k = 0; k < n; ++k) dydt[k] += fractions[k] * in.mass_flow;
    if (in.mass_flow > 0.0) dydt[n] += in.mass_flow * tank.model.thermo.enthalpy(fractions, in.temperature);
  }
}

std::vector<double> scales(const Tank& tank) {
  const gas::GasPoint start = gas::evaluate(tank.model, tank.start, tank.volume, tank.leak_area, 0.0);
  std::vector<double> scale(tank.start.masses.size(), start.mass);
  scale.push_back(start.pressure * tank.volume / (start.gamma - 1.0));
  return scale;
}

std::vector<double> unknowns(const gas::ControlVolumeState& state) {
  std::vector<double> y(state.masses);
  y.push_back(state.internal_energy);
  return y;
}

gas::ControlVolumeState state_of(const Tank& tank, std::span<const double> y) {
  const std::vector<double> masses(y.begin(), y.end() - 1);
  return {masses,
          y.back(),
          tank.model.thermo.temperature_from_internal_energy(masses, y.back(), tank.start.temperature),
          {}};
}

std::vector<gas::ControlVolumeState> msbdf(const Tank& tank, double tolerance, Inflow inflow) {
  gsl_set_error_handler_off();
  std::vector<double> y = unknowns(tank.start);
  const std::vector<double> scale = scales(tank);
  std::vector<gas::ControlVolumeState> states;
  double t = 0.0;
  for (const double end : tank.stops) {
    Stretch stretch{tank, t, end, inflow};
    gsl_odeiv2_system system{gsl_rates, gsl_jacobian, y.size(), &stretch};
    gsl_odeiv2_driver* driver =
        gsl_odeiv2_driver_alloc_scaled_new(&system, gsl_odeiv2_step_msbdf, std::min(1e-9, 0.5 * (end - t)),
                                           tolerance, 0.0, 1.0, 0.0, scale.data());
    const int status = gsl_odeiv2_driver_apply(driver, &t, end, y.data());
    gsl_odeiv2_driver_free(driver);
    if (status != GSL_SUCCESS) throw std::runtime_error(gsl_strerror(status));
    if (inflow == Inflow::closed_form) add_inflow(stretch, end, y);
    states.push_back(state_of(tank, y));
  }
  return states;
}

}  // namespace second_route
