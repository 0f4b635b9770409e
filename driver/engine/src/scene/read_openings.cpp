// SPDX-License-Identifier: Apache-2.0
// [[vent]], [tank] with its fabric, [gas.heat_loss] -> GasPart.
#include "scene/read_openings.hpp"

#include <fmt/format.h>

#include "base/number_text.hpp"
#include "scene/gas_curve.hpp"
#include "scene/read_triggers.hpp"

namespace driver {
namespace {

gas::Vent read_vent(TableReader& table, TriggerNames& names) {
  gas::Vent vent{table.at("discharge_coefficient").number(positive_fraction, 1.0), 0.0};
  CurveReader area(table, "area");
  if (!table.is_table("area") || area.is_constant()) {
    vent.area = area.constant(positive.in("m²"));
  } else if (area.is_against("overpressure")) {
    table.located("area", [&] {
      vent.area_of_overpressure =
          to_gas_curve(area.curve(non_negative.in("m²"), "overpressure"), gas::Outside::held);
    });
  } else {
    table.located("area", [&] {
      vent.area_of_time = to_gas_curve(area.curve(non_negative.in("m²")), gas::Outside::held);
    });
  }
  vent.backflow = table.at("backflow").flag(false);
  vent.trigger = names.optional_node(table);
  return vent;
}

/// A fabric whose share is, for now, its leak area [m2].
gas::Fabric read_tank_fabric(TableReader& table, Scene& scene) {
  const double area = table.at("area").number(positive.in("m²"));
  const auto law =
      table.at("leak_law")
          .choice<LeakLaw>(
              {{"printed", LeakLaw::printed}, {"screen", LeakLaw::screen}, {"table", LeakLaw::table}},
              "printed");
  warn_of_screen(table.path(), law, scene);
  gas::Fabric fabric{area};
  if (law == LeakLaw::table) {
    fabric.velocity = read_leak_velocity(table);
  } else {
    const double porosity = table.at("porosity").number(positive_fraction);
    fabric.share = area * porosity * (law == LeakLaw::printed ? porosity : 1.0);
  }
  table.finish();
  return fabric;
}

/// [tank.fabric], or several as [[tank.fabric]]
void read_tank_fabrics(TableReader& tank, Scene& scene) {
  std::vector<TableReader> tables;
  if (tank.has("fabric") && tank.is_table("fabric"))
    tables.push_back(tank.table("fabric"));
  else
    tables = tank.tables("fabric");
  if (tables.empty()) return;
  std::vector<gas::Fabric> fabrics;
  double leak_area = 0.0;
  for (auto& table : tables) {
    fabrics.push_back(read_tank_fabric(table, scene));
    leak_area += fabrics.back().share;
  }
  if (!(leak_area > 0.0)) return;  // porosities whose squares are below the smallest number
  for (auto& fabric : fabrics) fabric.share /= leak_area;
  scene.gas->tank_leak_area = leak_area;
  scene.gas->model.fabrics = std::move(fabrics);
}

TankVolume read_wave(TableReader&& wave, double end_time) {
  TankVolume volume;
  volume.mean = wave.at("mean").number(gas_volume);
  volume.amplitude = wave.at("amplitude").number(positive.in("m³"));
  volume.frequency = wave.at("frequency").number(positive.in("1/s"));
  volume.phase = wave.at("phase").number(any_number.in("rad"), 0.0);
  constexpr double most_periods = 1e4;  // each is 512 pieces of the gas's equations
  if (volume.frequency * end_time > most_periods)
    wave.fail("frequency", fmt::format("is {}, allowed: at most {:g} ({:g} periods in end_time)",
                                       volume.frequency, most_periods / end_time, most_periods));
  if (!(volume.amplitude < volume.mean))
    wave.fail("amplitude", fmt::format("is {}, allowed: less than mean, {}", volume.amplitude, volume.mean));
  wave.finish();
  return volume;
}

void read_volume_of_time(TableReader& tank, double end_time, GasPart& part) {
  TankVolume volume;
  if (tank.has_in_table("volume", "mean"))
    volume = read_wave(tank.table("volume"), end_time);
  else
    tank.located("volume", [&] {
      volume.table = to_gas_curve(CurveReader(tank, "volume").curve(gas_volume), gas::Outside::held);
      if (const auto jump = volume.table->first_jump())
        throw std::invalid_argument(fmt::format(
            "jumps at {} s, allowed: one value at each time, as the work of a jump is unbounded", *jump));
    });
  part.rigid_volume = volume.at(0.0);
  part.tank_volume = volume;
}

void read_volume_of_overpressure(TableReader& tank, GasPart& part) {
  tank.located("volume", [&] {
    const auto curve =
        to_gas_curve(CurveReader(tank, "volume").curve(gas_volume, "overpressure"), gas::Outside::held);
    const double overpressure = part.initial_pressure - part.model.ambient.pressure;
    part.model.volume_of_overpressure = curve;
    gas::validate(part.model);
    if (overpressure > curve.knots().back().time)
      throw std::invalid_argument(fmt::format(
          "ends at an overpressure of {} Pa, allowed: that of the gas at the start, {:.3g} Pa, or more",
          curve.knots().back().time, three_digits_above(overpressure)));
    part.rigid_volume = curve.value(overpressure);
  });
}

}  // namespace

void warn_of_screen(const std::string& fabric, LeakLaw law, Scene& scene) {
  if (law == LeakLaw::screen)
    scene.warnings.push_back(
        fabric + ".leak_law = \"screen\" leaks 1/porosity times as much as the paper's printed law");
}

gas::Curve read_leak_velocity(TableReader& table) {
  const auto velocity = to_gas_curve(
      CurveReader(table, "velocity").curve(non_negative.in("m/s"), "overpressure"), gas::Outside::held);
  // The flow would jump where the overpressure changes its sign.
  if (const double leak_at_rest = velocity.value(0.0); leak_at_rest > 0.0)
    table.fail("velocity",
               fmt::format("is {} m/s without overpressure: begin with the knot (0, 0)", leak_at_rest));
  return velocity;
}

void read_vents(TableReader& root, TriggerNames& names, gas::ControlVolumeModel& model) {
  for (auto& table : root.tables("vent")) {
    model.vents.push_back(read_vent(table, names));
    table.finish();
  }
}

void read_tank(TableReader& root, Scene& scene) {
  auto tank = root.optional_table("tank");
  if (!tank) return;
  GasPart& part = *scene.gas;
  CurveReader volume(*tank, "volume");
  if (!tank->is_table("volume") || volume.is_constant())
    part.rigid_volume = volume.constant(gas_volume);
  else if (volume.is_against("overpressure"))
    read_volume_of_overpressure(*tank, part);
  else if (volume.is_against("time") || tank->has_in_table("volume", "mean"))
    read_volume_of_time(*tank, scene.time.end, part);
  else
    tank->fail("volume",
               "has neither time, nor overpressure, nor mean; allowed: a number, a curve {time, value}, a "
               "curve {overpressure, value} or a wave {mean, ...}");
  read_tank_fabrics(*tank, scene);
  tank->finish();
}

void read_heat_loss(TableReader& gas_table, Scene& scene) {
  auto table = gas_table.optional_table("heat_loss");
  if (!table) return;
  const double coefficient = table->at("coefficient").number(positive.in("W/(m² K)")),
               area = table->at("area").number(positive.in("m²"));
  scene.gas->heat_loss_coefficient = coefficient;
  scene.gas->model.heat_loss = {
      coefficient * area,
      table->at("outside_temperature").number(gas_temperature, scene.ambient.temperature, "ambient")};
  table->finish();
}

}  // namespace driver
