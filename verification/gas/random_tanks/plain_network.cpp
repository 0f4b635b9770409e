// SPDX-License-Identifier: Apache-2.0
#include "plain_network.hpp"

#include <algorithm>
#include <cmath>

namespace random_tanks {
namespace {

constexpr double kNear = 1e-12;  // of a pressure: where a step has landed on it

std::vector<double> crossings(const SensorPlan& sensor) {
  std::vector<double> times;
  const auto& [x, y] = sensor.signal;
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    if ((y[i] < sensor.threshold) != (y[i + 1] < sensor.threshold))
      times.push_back(x[i] + (sensor.threshold - y[i]) * (x[i + 1] - x[i]) / (y[i + 1] - y[i]));
  return times;
}

}  // namespace

PlainNetwork::PlainNetwork(const Tank& tank)
    : tank_(tank), nodes_(tank.sensors.size() + tank.gates.size()), slack_(1e-13 * tank.times.back()) {
  for (const SensorPlan& sensor : tank.sensors) crossings_.push_back(crossings(sensor));
}

bool PlainNetwork::sensor(std::size_t i, double t, double overpressure, double slack) const {
  const SensorPlan& plan = tank_.sensors[i];
  const auto near = [&](double level) { return slack * (tank_.ambient_pressure + std::abs(level)); };
  if (plan.kind == Watch::time) return t + slack_ >= plan.threshold;
  if (plan.kind == Watch::pressure)
    return nodes_[i].on ? !plan.reset || overpressure > *plan.reset + near(*plan.reset)
                        : overpressure >= plan.threshold - near(plan.threshold);
  // Its signal crosses at times that are known better than its value there.
  const auto passed = std::ranges::count_if(crossings_[i], [&](double c) { return c <= t + slack_; });
  return (plan.signal.y.front() >= plan.threshold) != (passed % 2 == 1);
}

bool PlainNetwork::gate(std::size_t i, double t) {
  const GatePlan& plan = tank_.gates[i];
  Memory& node = nodes_[tank_.sensors.size() + i];
  const auto on = [&](std::size_t k) { return nodes_[k].on; };
  const bool holds = plan.logic == Join::all   ? std::ranges::all_of(plan.inputs, on)
                     : plan.logic == Join::any ? std::ranges::any_of(plan.inputs, on)
                                               : !on(plan.inputs.front());
  if (holds) node.held = std::min(node.held, t);
  if (!holds && !plan.latch) node.held = kInfinity;
  return t + slack_ >= node.held + plan.delay;
}

void PlainNetwork::update(double t, double overpressure) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const bool was = nodes_[i].on, is_sensor = i < tank_.sensors.size();
    Memory& node = nodes_[i];
    node.on = is_sensor ? sensor(i, t, overpressure, kNear) : gate(i - tank_.sensors.size(), t);
    if (node.on && !was) node.since = t;
    if (!node.on) node.since = kInfinity;
    if (node.on) node.first_on = std::min(node.first_on, t);
    if (is_sensor && node.on != was && tank_.sensors[i].kind == Watch::pressure) ++switchings_;
  }
}

bool PlainNetwork::switches(double overpressure) const {
  for (std::size_t i = 0; i < tank_.sensors.size(); ++i)
    if (tank_.sensors[i].kind == Watch::pressure && sensor(i, 0.0, overpressure, 0.0) != nodes_[i].on)
      return true;
  return false;
}

bool PlainNetwork::watches() const {
  for (std::size_t i = 0; i < tank_.sensors.size(); ++i)
    if (tank_.sensors[i].kind == Watch::pressure && (!nodes_[i].on || tank_.sensors[i].reset)) return true;
  return false;
}

double PlainNetwork::next_break(double t) const {
  double next = kInfinity;
  const auto add = [&](double time) {
    if (time > t + slack_) next = std::min(next, time);
  };
  for (std::size_t i = 0; i < tank_.sensors.size(); ++i) {
    if (tank_.sensors[i].kind == Watch::time) add(tank_.sensors[i].threshold);
    for (const double c : crossings_[i]) add(c);
  }
  for (std::size_t i = 0; i < tank_.gates.size(); ++i)
    add(nodes_[tank_.sensors.size() + i].held + tank_.gates[i].delay);
  return next;
}

}  // namespace random_tanks
