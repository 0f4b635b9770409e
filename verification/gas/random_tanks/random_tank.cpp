// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <random>

#include "tank.hpp"

namespace random_tanks {
namespace {

constexpr double kUsualAmbient = 101325.0;  // [Pa]

/// Random numbers whose bits no library decides.
struct Dice {
  std::mt19937_64 engine;
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
  }
  double log_between(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  bool chance(double share) { return between(0.0, 1.0) < share; }
  int below(int n) { return static_cast<int>(engine() % static_cast<unsigned>(n)); }
};

/// Draws the parts of one tank; sizes of flows, areas and walls follow its volume and duration.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : dice_{std::mt19937_64(seed)} {
    tank_.seed = seed;
    for (int i = 0; i < 10; ++i) dice_.engine();
  }

  Tank tank() {
    tank_.tolerance = dice_.chance(0.4) ? 1e-10 : std::pow(10.0, -static_cast<double>(4 + dice_.below(7)));
    gases();
    start();
    if (dice_.chance(0.35)) triggers();
    for (int n = dice_.below(4); n > 0; --n) pulse();
    for (int n = dice_.below(4); n > 0; --n) hole();
    if (dice_.chance(0.4)) {
      tank_.conductance = dice_.log_between(0.1, 30.0) * mass_ * 700.0 / end_;
      tank_.outside_temperature = dice_.between(280.0, 900.0);
    }
    path();
    return std::move(tank_);
  }

 private:
  std::vector<double> fractions() {
    std::vector<double> y(tank_.gases.size());
    double sum = 0.0;
    for (double& f : y) sum += f = dice_.chance(0.7) ? dice_.between(0.0, 1.0) : 0.0;
    if (sum == 0.0) sum = y[static_cast<std::size_t>(dice_.below(static_cast<int>(y.size())))] = 1.0;
    for (double& f : y) f /= sum;
    return y;
  }

  void gases() {
    if (constant_ = dice_.chance(0.3); constant_) {
      for (const char* name : {"light", "heavy"})
        if (tank_.gases.empty() || dice_.chance(0.5)) {
          const double r = dice_.log_between(150.0, 2500.0);
          tank_.gases.push_back({name, r, r * dice_.between(2.5, 6.0)});
        }
      return;
    }
    tank_.gases.push_back({"N2"});
    for (const char* name : {"CO2", "He", "H2O", "O2"})
      if (dice_.chance(0.4)) tank_.gases.push_back({name});
  }

  void start() {
    const double v = dice_.log_between(1e-6, 1.0);
    const double p_a = dice_.chance(0.9)   ? kUsualAmbient
                       : dice_.chance(0.2) ? 0.0
                                           : dice_.log_between(1e3, 1e6);
    tank_.ambient_pressure = p_a;
    tank_.ambient_temperature = dice_.between(230.0, 400.0);
    tank_.ambient = fractions();
    tank_.start = fractions();
    const double p = kUsualAmbient;
    const double pressures[] = {p_a,
                                p_a,
                                0.0,
                                dice_.log_between(1e3, 0.9 * p),
                                dice_.log_between(1.1 * p, 20 * p),
                                dice_.log_between(1.1 * p, 20 * p)};
    tank_.pressure = pressures[dice_.below(6)];
    tank_.temperature = dice_.between(250.0, 1200.0);
    const double ends[] = {200.0, 200.0 * (1.0 + dice_.log_between(1e-9, 0.1)), 1000.0, 6000.0,
                           6000.0 * (1.0 - dice_.log_between(1e-9, 0.1))};
    if (dice_.chance(0.08)) tank_.temperature = ends[dice_.below(5)];
    end_ = dice_.log_between(1e-3, 1.0);
    mass_ = p * v / (300.0 * 300.0);
    area_ = dice_.log_between(1e-2, 30.0) * v / end_ / 300.0;
    const int calls = dice_.chance(0.5) ? 1 : 20;
    for (int i = 0; i <= calls; ++i) tank_.times.push_back(end_ * i / calls);
    tank_.volumes.assign(tank_.times.size(), v);
    tank_.leak_areas.assign(tank_.times.size(), 0.0);
    tank_.bulges.assign(tank_.times.size() - 1, 0.0);
  }

  SensorPlan sensor() {
    const int kind = dice_.below(4);
    if (kind == 0) return {Watch::time, dice_.between(-0.1, 1.0) * end_};
    if (kind == 1) {
      Table signal;
      for (int i = 0; i < 5; ++i) {
        signal.x.push_back(end_ * (0.2 * i + dice_.between(0.0, 0.15)));
        signal.y.push_back(dice_.between(-1.0, 1.0));
      }
      return {Watch::signal, dice_.between(-0.5, 0.5), {}, signal};
    }
    SensorPlan plan{Watch::pressure, dice_.log_between(1e3, 1e6)};
    if (dice_.chance(0.5)) plan.reset = plan.threshold * dice_.between(-0.2, 0.9);
    return plan;
  }

  void triggers() {
    const int sensors = 1 + dice_.below(3), gates = dice_.below(3);
    for (int i = 0; i < sensors; ++i) tank_.sensors.push_back(sensor());
    for (int i = 0; i < gates; ++i) {
      GatePlan gate{static_cast<Join>(dice_.below(3)),
                    {},
                    dice_.chance(0.5) ? dice_.between(0.0, 0.2) * end_ : 0.0,
                    dice_.chance(0.3)};
      const int inputs = gate.logic == Join::negated ? 1 : 1 + dice_.below(std::min(2, sensors + i));
      for (int k = 0; k < inputs; ++k)
        gate.inputs.push_back(static_cast<std::size_t>(dice_.below(sensors + i)));
      tank_.gates.push_back(gate);
    }
  }

  Node node() {
    const int nodes = static_cast<int>(tank_.sensors.size() + tank_.gates.size());
    if (nodes == 0 || dice_.chance(0.4)) return {};
    return static_cast<std::size_t>(dice_.below(nodes));
  }

  double inflow_temperature() { return dice_.between(300.0, 1500.0); }

  void pulse() {
    const double length = dice_.between(0.05, 0.6) * end_;
    const double flow = dice_.log_between(0.05, 10.0) * mass_ / length;
    Pulse pulse{fractions(),
                {{0.0, dice_.between(0.1, 0.5) * length, length},
                 {dice_.chance(0.5) ? 0.0 : flow, flow * dice_.between(0.5, 1.0),
                  dice_.chance(0.5) ? 0.0 : 0.3 * flow}},
                {{0.0}, {inflow_temperature()}},
                dice_.between(0.0, 0.5) * end_,
                node()};
    if (dice_.chance(0.5)) pulse.temperature = {{0.0, length}, {inflow_temperature(), inflow_temperature()}};
    if (pulse.node) pulse.start *= 0.2;
    tank_.pulses.push_back(pulse);
  }

  void hole() {
    Hole hole{dice_.between(0.4, 1.0), area_ * dice_.log_between(0.1, 10.0)};
    const int kind = dice_.below(5);
    const double a = hole.area;
    if (kind == 1)
      hole.area_of_time = {
          {0.0, dice_.between(0.1, 0.9) * end_, end_},
          {a * dice_.between(0.0, 1.0), a, dice_.chance(0.3) ? 0.0 : a * dice_.between(0.0, 1.0)}};
    if (kind == 2)
      hole.area_of_overpressure = {{0.0, dice_.log_between(100.0, 1e5), 2e5},
                                   {dice_.chance(0.5) ? 0.0 : 0.2 * a, a, 2.0 * a}};
    hole.backflow = dice_.chance(0.5);
    hole.node = node();
    tank_.holes.push_back(hole);
  }

  void path() {
    const double v = tank_.volumes.front();
    const std::size_t calls = tank_.bulges.size();
    if (dice_.chance(0.3)) fabric();
    if (dice_.chance(0.1)) return follow_pressure(v);
    const int kind = dice_.below(6);
    if (kind > 1) return;  // a third moves
    const double growth = dice_.between(-0.4, 0.6), wave = kind == 1 ? dice_.between(-0.3, 0.3) : 0.0;
    const auto volume = [&](double x) { return v * (1.0 + growth * x) * (1.0 + wave * std::sin(9.0 * x)); };
    for (std::size_t i = 0; i <= calls; ++i)
      tank_.volumes[i] = volume(static_cast<double>(i) / static_cast<double>(calls));
    for (std::size_t i = 0; kind == 1 && i < calls; ++i)
      tank_.bulges[i] = dice_.between(-0.1, 0.1) * std::min(tank_.volumes[i], tank_.volumes[i + 1]);
  }

  void fabric() {
    const double leak = area_ * dice_.log_between(0.1, 5.0);
    const bool moves = dice_.chance(0.5);
    for (double& a : tank_.leak_areas) a = leak * (moves ? dice_.between(0.0, 1.0) : 1.0);
    if (dice_.chance(0.4))
      tank_.fabric_velocity = {{0.0, dice_.log_between(1e2, 1e4), 5e4},
                               {0.0, dice_.between(1.0, 50.0), 300.0}};
  }

  void follow_pressure(double v) {
    const double p_a = tank_.ambient_pressure;
    const double first = dice_.chance(0.5) ? 0.0 : -dice_.between(0.0, 0.5) * p_a;
    tank_.volume_of_overpressure = {{first, first + dice_.log_between(10.0, 1e4), first + 1e5, first + 1e7},
                                    {v, v * dice_.between(1.0, 5.0), 6.0 * v, 20.0 * v}};
    const double inside = tank_.volume_of_overpressure.at(tank_.pressure - p_a);
    std::ranges::fill(tank_.volumes, inside);
  }

  Dice dice_;
  Tank tank_;
  bool constant_ = false;
  double end_ = 0.0, mass_ = 0.0, area_ = 0.0;  // [s], [kg], [m2]: sizes
};

}  // namespace

Tank random_tank(std::uint64_t seed) {
  return Draw(seed).tank();
}

}  // namespace random_tanks
