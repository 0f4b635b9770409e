// SPDX-License-Identifier: Apache-2.0
#include "forward.hpp"

#include <algorithm>
#include <cmath>

#include "gas/integrator.hpp"

namespace gas {

double forward_error(const TankTest& test, double initial_pressure, double conductance,
                     std::span<const IdentifiedPoint> points) {
  std::vector<Curve::Knot> flow, temperature;
  for (const IdentifiedPoint& point : points) {
    flow.push_back({point.time, point.mass_flow});
    temperature.push_back({point.time, point.temperature});
  }
  ControlVolumeModel model{test.thermo, {0.0, test.initial_temperature}, {}, {}};
  model.heat_loss = {std::max(0.0, conductance), test.initial_temperature};
  model.inflows.push_back(
      {test.inflator_fractions, Curve(flow, Outside::zero), Curve(temperature, Outside::held)});
  ControlVolumeState state =
      make_state(test.thermo, test.tank_fractions, initial_pressure, test.initial_temperature, test.volume);
  GasIntegrator integrator(model);
  double worst = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    integrator.advance(state, points[i - 1].time, points[i].time, {test.volume, test.volume, 0.0, 0.0});
    const double pressure = evaluate(model, state, test.volume, 0.0, points[i].time).pressure;
    worst = std::max(worst, std::abs(pressure / points[i].tank_pressure - 1.0));
  }
  return worst;
}

}  // namespace gas
