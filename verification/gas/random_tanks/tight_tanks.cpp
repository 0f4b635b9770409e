// SPDX-License-Identifier: Apache-2.0
#include "tight_tanks.hpp"

namespace random_tanks {
namespace {

Tank tank_of(std::vector<Gas> gases, double pressure, double temperature, double end) {
  Tank tank;
  tank.tolerance = 1e-13;
  tank.gases = std::move(gases);
  tank.start.assign(tank.gases.size(), 0.0);
  tank.start[0] = 1.0;
  tank.ambient = tank.start;
  tank.pressure = pressure;
  tank.temperature = temperature;
  tank.ambient_pressure = 101325.0;
  tank.ambient_temperature = 293.15;
  tank.times = {0.0, 0.25 * end, 0.5 * end, 0.75 * end, end};
  tank.volumes.assign(5, 0.06);
  tank.leak_areas.assign(5, 0.0);
  tank.bulges.assign(4, 0.0);
  return tank;
}

}  // namespace

std::vector<Tank> tight_tanks() {
  std::vector<Tank> all;
  all.push_back(tank_of({{"light", 296.8, 1038.8}}, 5e5, 600.0, 0.3));  // choked, then not
  all.back().holes = {{0.9, 1e-3}};
  all.push_back(tank_of({{"N2"}, {"CO2"}, {"H2O"}}, 101325.0, 300.0, 0.05));  // through 1000 K
  all.back().pulses = {
      {{0.5, 0.3, 0.2}, {{0.0, 0.01, 0.05}, {1.0, 5.0, 2.0}}, {{0.0, 0.05}, {900.0, 1500.0}}}};
  all.back().conductance = 100.0;
  all.push_back(tank_of({{"N2"}, {"He"}}, 3e4, 500.0, 0.1));  // air in, choked, then not
  all.back().holes = {{0.8, 2e-3}};
  all.back().holes[0].backflow = true;
  all.back().ambient = {0.9, 0.1};
  all.push_back(tank_of({{"N2"}}, 3e5, 700.0, 0.05));  // openings by overpressure, screen and table
  all.back().holes = {{0.7, 0.0, {}, {{1e4, 3e5}, {1e-4, 2e-3}}}};
  all.back().leak_areas.assign(5, 1e-3);
  all.push_back(all.back());
  all.back().fabric_velocity = {{0.0, 5e4, 3e5}, {0.0, 20.0, 60.0}};
  all.back().leak_areas.assign(5, 5e-2);
  all.push_back(tank_of({{"N2"}}, 2e5, 400.0, 0.05));  // moves, and a hole that opens
  all.back().volumes = {0.06, 0.05, 0.05, 0.04, 0.06};
  all.back().holes = {{0.6, 0.0, {{0.0, 0.02, 0.05}, {0.0, 1e-3, 5e-4}}}};
  all.push_back(tank_of({{"light", 296.8, 1038.8}}, 4e5, 900.0,
                        0.3));  // cools, and blows down through a hole that opens
  all.back().holes = {{0.6, 0.0, {{0.0, 0.3}, {0.0, 2e-3}}}};
  all.back().conductance = 300.0;
  return all;
}

}  // namespace random_tanks
