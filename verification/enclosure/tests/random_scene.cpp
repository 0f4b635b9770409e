// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "second_route.hpp"

namespace test {

using enclosure::Curve;
using enclosure::Scene;

RandomScene random_scene(unsigned seed) {
  Draw draw(seed);
  const auto chance = [&](double share) { return draw(0.0, 1.0) < share; };
  RandomScene result{tank(draw), draw(0.005, 0.05)};
  Scene& s = result.scene;
  const double end = result.end, v = s.volume[0].value, pa = s.ambient_pressure;
  const double mass = 1e5 * v / 9e4, area = v / end / 300.0;  // sizes
  const bool polynomials = chance(0.4);
  s.species.clear();
  for (const char* name : {"a", "b"}) {
    if (!s.species.empty() && chance(0.5)) break;
    s.species.push_back(gas(draw(0.004, 0.05), draw(2.6, 4.5), name));
    if (!polynomials) continue;
    auto& g = s.species.back();
    g.constant_cp = false;
    g.minimum_temperature = 150.0;
    g.maximum_temperature = 2500.0;
    g.low = {g.low[0], draw(-2e-4, 1e-3), draw(-1e-7, 1e-7), 0, 0, draw(-2000.0, 2000.0)};
    g.high = {g.low[0] + draw(-0.1, 0.3), g.low[1], g.low[2], 0, 0, 0};
    g.high[5] = g.low[5] + (g.low[0] - g.high[0]) * 1000.0;  // h is continuous
  }
  const bool two = s.species.size() == 2;
  const auto fractions = [&] {
    const double y = two ? draw(0.0, 1.0) : 1.0;
    return two ? std::vector<double>{y, 1.0 - y} : std::vector<double>{1.0};
  };
  s.initial_fractions = fractions();
  s.initial_pressure = chance(0.3) ? pa : chance(0.3) ? draw(0.2, 0.9) * pa : draw(1.1, 8.0) * pa;
  s.initial_temperature = draw(280.0, 1100.0);
  s.ambient_fractions = fractions();
  // The literal root would turn the rounding of a start at p_a into a flow.
  if (chance(0.5) || s.initial_pressure == pa) s.laminar_share = 1e-8;
  if (chance(0.3))
    s.volume = {{0.0, v}, {draw(0.2, 0.7) * end, v * draw(0.8, 1.3)}, {end, v * draw(0.8, 1.5)}};
  if (chance(0.15)) s.wave = enclosure::Wave{v, draw(0.0, 0.3) * v, draw(0.2, 2.0) / end, draw(0.0, 6.0)};
  for (int i = chance(0.6) + chance(0.3); i > 0; --i) {
    const double length = draw(0.2, 1.0) * end, flow = draw(0.1, 4.0) * mass / length,
                 t = draw(300.0, 1400.0);
    s.inflators.push_back({fractions(),
                           {{0.0, chance(0.5) ? 0.0 : flow}, {0.3 * length, flow}, {length, 0.3 * flow}},
                           {{0.0, t}},
                           chance(0.5) ? 0.0 : draw(0.0, 0.5) * end});
    if (chance(0.3)) s.inflators.back().temperature = {{0.0, t}, {length, draw(300.0, 1400.0)}};
  }
  for (int i = chance(0.6) + chance(0.2); i > 0; --i) {
    const double a = area * draw(0.1, 3.0);
    s.holes.push_back({draw(0.5, 1.0), {{0.0, a}}, {}, chance(0.5)});
    if (chance(0.2)) s.holes.back().area = {{0.0, 0.0}, {draw(0.2, 0.9) * end, a}};
    if (chance(0.2)) s.holes.back().area_of_overpressure = Curve{{draw(0.0, 0.2) * pa, 0.0}, {2.0 * pa, a}};
  }
  if (chance(0.3)) {
    s.fabrics = {{area * draw(0.1, 2.0)}};
    if (chance(0.5))
      s.fabrics[0].velocity = Curve{{0.0, 0.0}, {draw(0.1, 1.0) * pa, 50.0}, {5.0 * pa, 200.0}};
  }
  if (chance(0.4)) s.wall_conductance = draw(0.1, 3.0) * mass * 700.0 / end;
  return result;
}

}  // namespace test
