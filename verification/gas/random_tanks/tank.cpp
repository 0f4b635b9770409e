// SPDX-License-Identifier: Apache-2.0
#include "tank.hpp"

#include <algorithm>
#include <limits>

namespace random_tanks {
namespace {

void print(std::ostream& out, const char* name, const std::vector<double>& values) {
  if (values.empty()) return;
  out << ' ' << name;
  for (const double v : values) out << ' ' << v;
}

void print(std::ostream& out, const char* name, const Table& table) {
  if (table.empty()) return;
  print(out, name, table.x);
  print(out, "->", table.y);
}

void print(std::ostream& out, Node node) {
  if (node) out << " node " << *node;
  out << '\n';
}

void print_triggers(std::ostream& out, const Tank& tank) {
  for (const SensorPlan& sensor : tank.sensors) {
    out << "sensor kind " << static_cast<int>(sensor.kind) << " threshold " << sensor.threshold;
    if (sensor.reset) out << " reset " << *sensor.reset;
    print(out, "signal", sensor.signal);
    out << '\n';
  }
  for (const GatePlan& gate : tank.gates) {
    out << "gate logic " << static_cast<int>(gate.logic) << " delay " << gate.delay << " latch " << gate.latch
        << " inputs";
    for (const std::size_t input : gate.inputs) out << ' ' << input;
    out << '\n';
  }
}

}  // namespace

double Table::at(double position) const {
  if (!(position > x.front())) return y.front();
  if (!(position < x.back())) return y.back();
  const auto i = static_cast<std::size_t>(std::ranges::upper_bound(x, position) - x.begin());
  return y[i - 1] + (y[i] - y[i - 1]) * ((position - x[i - 1]) / (x[i] - x[i - 1]));
}

std::ostream& operator<<(std::ostream& out, const Tank& tank) {
  const auto digits = out.precision(std::numeric_limits<double>::max_digits10);
  out << "seed " << tank.seed << " tolerance " << tank.tolerance << "\ngases";
  for (const Gas& gas : tank.gases) out << ' ' << gas.name << " R " << gas.gas_constant << " cp " << gas.cp;
  print(out, "\nstart", tank.start);
  out << " p " << tank.pressure << " T " << tank.temperature << "\nambient p " << tank.ambient_pressure
      << " T " << tank.ambient_temperature;
  print(out, "fractions", tank.ambient);
  out << "\nwalls " << tank.conductance << " W/K, outside " << tank.outside_temperature << " K\n";
  for (const Pulse& pulse : tank.pulses) {
    out << "pulse start " << pulse.start;
    print(out, "fractions", pulse.fractions);
    print(out, "mass_flow", pulse.mass_flow);
    print(out, "temperature", pulse.temperature);
    print(out, pulse.node);
  }
  for (const Hole& hole : tank.holes) {
    out << "hole Cd " << hole.discharge_coefficient << " area " << hole.area << " backflow " << hole.backflow;
    print(out, "area_of_time", hole.area_of_time);
    print(out, "area_of_overpressure", hole.area_of_overpressure);
    print(out, hole.node);
  }
  print_triggers(out, tank);
  print(out, "fabric_velocity", tank.fabric_velocity);
  print(out, "volume_of_overpressure", tank.volume_of_overpressure);
  print(out, "times", tank.times);
  print(out, "\nvolumes", tank.volumes);
  print(out, "\nbulges", tank.bulges);
  print(out, "\nleak_areas", tank.leak_areas);
  out.precision(digits);
  return out << '\n';
}

}  // namespace random_tanks
