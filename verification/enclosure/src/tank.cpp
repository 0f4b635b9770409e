// SPDX-License-Identifier: Apache-2.0
#include "tank.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "enclosure/enclose.hpp"
#include "network.hpp"

namespace enclosure {
namespace {

void require(bool condition, const std::string& what) {
  if (!condition) throw std::invalid_argument("enclosure: " + what);
}

void check_curve(const Curve& curve, const std::string& name, bool may_jump) {
  require(!curve.empty(), name + " has no knot; give one or more");
  for (std::size_t i = 0; i < curve.size(); ++i) {
    require(std::isfinite(curve[i].at) && std::isfinite(curve[i].value),
            name + " has a value that is not finite");
    if (i == 0) continue;
    require(curve[i].at >= curve[i - 1].at, name + " has knots that fall; order them");
    if (curve[i].at == curve[i - 1].at && !may_jump)
      throw Refusal(name + " jumps: the solution across a jump in p is not defined; make it a slope");
  }
}

void check_not_negative(const Curve& curve, const std::string& name, bool may_jump) {
  check_curve(curve, name, may_jump);
  for (const Knot& knot : curve) require(knot.value >= 0.0, name + " is negative");
}

void check_fractions(const std::vector<double>& fractions, std::size_t count, const std::string& name) {
  require(fractions.size() == count, name + " needs one mass fraction per species");
  double sum = 0.0;
  for (double y : fractions) {
    require(y >= 0.0, name + " has a negative mass fraction");
    sum += y;
  }
  require(std::abs(sum - 1.0) < 1e-9, name + " has mass fractions whose sum is not 1");
}

void check_openings(const Scene& s) {
  for (const Hole& hole : s.holes) {
    require(hole.discharge_coefficient >= 0.0, "a discharge coefficient is negative");
    if (hole.area_of_overpressure)
      check_not_negative(*hole.area_of_overpressure, "the area of a hole over pressure", false);
    else
      check_not_negative(hole.area, "the area of a hole", true);
    if (hole.backflow) check_fractions(s.ambient_fractions, s.species.size(), "the ambient gas");
  }
  for (const Fabric& fabric : s.fabrics) {
    require(fabric.coefficient >= 0.0, "the area of a fabric is negative");
    check_not_negative(fabric.share, "the share of a fabric", true);
    if (fabric.velocity) check_not_negative(*fabric.velocity, "the velocity through a fabric", false);
  }
}

void check_network(const Scene& s) {
  const auto node_exists = [&](std::size_t i, std::size_t before) {
    require(i < before, "a node that does not exist, or is not earlier, is named");
  };
  for (const Sensor& sensor : s.sensors) {
    require(std::is_sorted(sensor.switching.begin(), sensor.switching.end(), std::less_equal<>()),
            "the times at which a sensor switches do not rise");
    require(!sensor.reset || (sensor.threshold && *sensor.reset < *sensor.threshold),
            "the reset of a sensor is not below its threshold");
  }
  const std::size_t sensors = s.sensors.size(), all = sensors + s.gates.size();
  for (std::size_t i = 0; i < s.gates.size(); ++i) {
    require(!s.gates[i].inputs.empty() && s.gates[i].delay >= 0.0,
            "a gate has no input, or a negative delay");
    for (std::size_t input : s.gates[i].inputs) node_exists(input, sensors + i);
  }
  for (const Inflator& inflator : s.inflators)
    if (inflator.node) node_exists(*inflator.node, all);
  for (const Hole& hole : s.holes)
    if (hole.node) node_exists(*hole.node, all);
}

void check(const Scene& s) {
  check_network(s);
  require(!s.species.empty(), "the scene has no species");
  check_fractions(s.initial_fractions, s.species.size(), "the initial gas");
  require(s.initial_pressure >= 0.0, "the initial pressure is negative");
  require(s.initial_pressure == 0.0 || s.initial_temperature > 0.0,
          "the initial temperature is not positive");
  require(s.ambient_pressure >= 0.0, "the ambient pressure is negative");
  require(s.ambient_temperature > 0.0, "the ambient temperature is not positive");
  require(s.laminar_share >= 0.0, "laminar_share is negative");
  require(s.wall_conductance >= 0.0, "the conductance of the walls is negative");
  if (!s.wave) check_curve(s.volume, "the volume", false);
  require(s.bulges.empty() || (!s.wave && s.bulges.size() + 1 == s.volume.size()),
          "the volume needs one bulge between every two knots, or none");
  for (const Inflator& inflator : s.inflators) {
    check_fractions(inflator.mass_fractions, s.species.size(), "an inflator");
    check_not_negative(inflator.mass_flow, "a mass flow", true);
    check_curve(inflator.temperature, "the temperature of an inflator", true);
    require(inflator.mass_flow.size() == 1 || inflator.mass_flow.front().at >= 0.0,
            "a mass flow begins before its inflator fires");
  }
  check_openings(s);
}

}  // namespace

Balls shares_of(const std::vector<double>& fractions) {
  Balls result(fractions.begin(), fractions.end());
  Ball sum;
  for (const Ball& y : result) sum = sum + y;
  for (Ball& y : result) y = y / sum;
  return result;
}

Balls Tank::enthalpy(const std::vector<double>& fractions, bool high) const {
  Balls c(6);
  const Balls y = shares_of(fractions);
  const Ball joint(joint_temperature);
  for (std::size_t k = 0; k < species(); ++k) {
    const auto powers = [&](const std::array<double, 6>& a) {
      Balls h{Ball(a[5])};
      for (std::size_t j = 0; j < 5; ++j) h.push_back(Ball(a[j]) / Ball(static_cast<double>(j + 1)));
      return h;
    };
    const Balls h = powers(high ? scene.species[k].high : scene.species[k].low);
    const Ball zero = polynomial(powers(scene.species[k].low), joint) - joint;
    const Ball factor = y[k] * gas_constants[k];
    for (std::size_t j = 0; j < 6; ++j) c[j] = c[j] + factor * h[j];
    if (!constant_cp) c[0] = c[0] - factor * zero;
  }
  if (constant_cp) c.resize(2);
  return c;
}

Balls Tank::internal_energy(const std::vector<double>& fractions, bool high) const {
  Balls c = enthalpy(fractions, high);
  const Balls y = shares_of(fractions);
  for (std::size_t k = 0; k < species(); ++k) c[1] = c[1] - y[k] * gas_constants[k];
  return c;
}

std::optional<double> Tank::watched_level(std::size_t i) const {
  const Sensor& sensor = scene.sensors[i];
  if (!sensor.threshold || !sensors_that_act(scene)[i]) return {};
  return is_on(i) ? sensor.reset : sensor.threshold;
}

Tank::Tank(const Scene& given, const std::vector<Balls>& switched)
    : scene(given), events(switched), maximum_temperature(std::numeric_limits<double>::infinity()) {
  check(scene);
  events.resize(scene.sensors.size());
  const std::vector<Balls> switching = switching_times(scene, events);
  for (const Species& s : scene.species) {
    gas_constants.push_back(Ball(8.31446261815324) / Ball(s.molar_mass));  // CODATA 2018, exact
    constant_cp = constant_cp && s.constant_cp;
    minimum_temperature = std::max(minimum_temperature, s.minimum_temperature);
    maximum_temperature = std::min(maximum_temperature, s.maximum_temperature);
  }
  for (const Inflator& inflator : scene.inflators) {
    const bool waits = inflator.node && switching[*inflator.node].empty();
    const Ball start =
        later(inflator.node && !waits ? switching[*inflator.node][0] : Ball(0.0), Ball(inflator.start));
    const Piecewise temperature(inflator.temperature, start, false);
    inflows.push_back({Piecewise(waits ? Curve{{0.0, 0.0}} : inflator.mass_flow, start, true),
                       temperature.through(enthalpy(inflator.mass_fractions, false),
                                           enthalpy(inflator.mass_fractions, true), joint_temperature)});
  }
  std::vector<Ball> levels;
  const double pa = scene.ambient_pressure;
  if (pa > 0.0 && !(scene.holes.empty() && scene.fabrics.empty())) levels.emplace_back(0.0);
  const auto add_levels = [&](const Curve& curve) {
    for (const Knot& knot : curve)
      if (knot.at != 0.0 && curve.size() > 1) levels.emplace_back(knot.at);
  };
  for (const Hole& hole : scene.holes) {
    const bool of_time = !hole.area_of_overpressure;
    const Curve area = of_time ? hole.area : Curve{{0.0, 1.0}};
    areas.push_back(hole.node ? Piecewise::switched(area, switching[*hole.node])
                              : Piecewise(area, Ball(0.0), false));
    if (!of_time) add_levels(*hole.area_of_overpressure);
    has_backflow = has_backflow || hole.backflow;
  }
  for (const Fabric& fabric : scene.fabrics) {
    shares.emplace_back(fabric.share, Ball(0.0), false);
    if (fabric.velocity) add_levels(*fabric.velocity);
  }
  if (!scene.wave) {
    volumes.emplace_back(scene.volume, Ball(0.0), false);
    volumes.back().bend(scene.bulges);
  }
  if (has_backflow) {
    const bool high = scene.ambient_temperature > joint_temperature;
    const Ball t(scene.ambient_temperature);
    const Balls y = shares_of(scene.ambient_fractions);
    for (std::size_t k = 0; k < species(); ++k)
      ambient.gas_constant = ambient.gas_constant + y[k] * gas_constants[k];
    const Balls h = enthalpy(scene.ambient_fractions, high);
    Ball cp;
    for (std::size_t j = h.size(); j-- > 1;) cp = cp * t + h[j] * Ball(static_cast<double>(j));
    ambient.gamma = cp / (cp - ambient.gas_constant);
    ambient.enthalpy = polynomial(h, t);
    const Ball g = ambient.gamma, one(1.0);
    levels.push_back(Ball(pa) * (exp(g / (g - one) * log(Ball(2.0) / (g + one))) - one));
  }
  const auto watched = [&](const Ball& level) {
    for (std::size_t i = 0; i < scene.sensors.size(); ++i)
      if (const auto at = watched_level(i); at && arb_equal(Ball(*at).get(), level.get())) return true;
    return false;
  };
  for (std::size_t i = 0; i < scene.sensors.size(); ++i)
    if (const auto level = watched_level(i)) levels.emplace_back(*level);
  std::sort(levels.begin(), levels.end(),
            [](const Ball& a, const Ball& b) { return a.middle() < b.middle(); });
  for (const Ball& level : levels)
    if (surfaces.empty() || !arb_equal(surfaces.back().offset.get(), level.get()))
      surfaces.push_back({Surface::Kind::level, level, watched(level)});
  if (pa > 0.0 && !scene.holes.empty()) surfaces.push_back({Surface::Kind::sonic});
  if (!constant_cp) {
    surfaces.push_back({Surface::Kind::joint});
    surfaces.push_back({Surface::Kind::joint_energy});
  }
}

Balls Tank::breaks() const {
  Balls all;
  const auto add = [&](const Piecewise& f) { all.insert(all.end(), f.breaks().begin(), f.breaks().end()); };
  for (const InflowFunctions& inflow : inflows) {
    add(inflow.flow);
    add(inflow.enthalpy);
  }
  for (const Piecewise& area : areas) add(area);
  for (const Piecewise& share : shares) add(share);
  for (const Piecewise& volume : volumes) add(volume);
  return all;
}

}  // namespace enclosure
