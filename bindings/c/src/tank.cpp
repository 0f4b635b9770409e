// SPDX-License-Identifier: Apache-2.0
#include <gasjet/gas.h>

#include <span>

#include "arrays.hpp"
#include "tank_object.hpp"

using namespace border;

namespace {

/// Adds a part to a tank that has not begun. If the part is refused, the tank is unchanged.
template <class Add>
int add_part(gasjet_handle tank, Add&& add) {
  return call([&] {
    const Use<Tank> use(tank, "tank");
    if (use->started) refuse("tank", "has begun, allowed: parts before the first gasjet_tank_advance");
    TankParts parts = use->parts;
    add(parts);
    use->rebuild(std::move(parts));
  });
}

/// Changes parts at any time.
template <class Change>
int change_parts(gasjet_handle tank, Change&& change) {
  return call([&] {
    const Use<Tank> use(tank, "tank");
    TankParts parts = use->parts;
    change(parts);
    use->change(std::move(parts));
  });
}

std::shared_ptr<const Gas> gas_of(gasjet_handle gas) {
  auto found = std::dynamic_pointer_cast<const Gas>(find(gas, "gas"));
  if (!found) refuse("gas", "is a handle of another kind, allowed: a gas");
  return found;
}

gas::Vent& vent_of(TankParts& parts, int64_t vent) {
  const auto count = static_cast<int64_t>(parts.vents.size());
  if (count == 0) refuse("vent", "is " + std::to_string(vent) + ", but the tank has none");
  if (vent < 0 || vent >= count)
    refuse("vent", "is " + std::to_string(vent) + ", allowed: 0 to " + std::to_string(count - 1));
  return parts.vents[static_cast<std::size_t>(vent)];
}

gas::Curve curve_of(std::span<const double> time, const double* value, std::string_view argument,
                    gas::Outside outside) {
  std::vector<gas::Curve::Knot> knots;
  for (std::size_t i = 0; i < time.size(); ++i) knots.push_back({time[i], number(value[i], argument, 0.0)});
  return {std::move(knots), outside};
}

}  // namespace

int gasjet_tank_create(gasjet_handle gas, double pressure, double temperature, double volume,
                       double ambient_pressure, double tolerance, gasjet_handle* tank) {
  return call([&] {
    needed(tank, "tank");
    auto content = gas_of(gas);
    number(pressure, "pressure", 0.0);
    positive(temperature, "temperature");
    positive(volume, "volume");
    number(ambient_pressure, "ambient_pressure", 0.0);
    number(tolerance, "tolerance", 1e-13, 1e-2);
    gas::IntegratorOptions options;
    options.relative_tolerance = tolerance;
    *tank = keep(std::make_shared<Tank>(TankParts{
        std::move(content), pressure, temperature, volume, {ambient_pressure, temperature}, options}));
  });
}

int gasjet_tank_add_inflow(gasjet_handle tank, gasjet_handle gas, int64_t count, const double time[],
                           const double mass_flow[], const double temperature[], double start_time) {
  return add_part(tank, [&](TankParts& parts) {
    auto content = gas_of(gas);
    needed(time, "time");
    needed(mass_flow, "mass_flow");
    needed(temperature, "temperature");
    const std::span times(time, static_cast<std::size_t>(count_of(count, "count", 2)));
    for (const double t : times) number(t, "time");
    number(start_time, "start_time");
    parts.inflows.push_back({std::move(content), curve_of(times, mass_flow, "mass_flow", gas::Outside::zero),
                             curve_of(times, temperature, "temperature", gas::Outside::held), start_time});
  });
}

int gasjet_tank_add_vent(gasjet_handle tank, double discharge_coefficient, double area, double opens_at) {
  return add_part(tank, [&](TankParts& parts) {
    number(discharge_coefficient, "discharge_coefficient", 0.0, 1.0);
    number(area, "area", 0.0);
    number(opens_at, "opens_at", 0.0);
    parts.vents.push_back({discharge_coefficient, area});
    parts.opens_at.push_back(opens_at);
  });
}

int gasjet_tank_add_fabric(gasjet_handle tank, double leak_area) {
  return add_part(tank, [&](TankParts& parts) { parts.leak_area += number(leak_area, "leak_area", 0.0); });
}

int gasjet_tank_add_backflow(gasjet_handle tank, int64_t vent, gasjet_handle gas, double temperature) {
  return add_part(tank, [&](TankParts& parts) {
    vent_of(parts, vent).backflow = true;
    parts.outside = gas_of(gas);
    parts.ambient.temperature = positive(temperature, "temperature");
  });
}

int gasjet_tank_set_vent(gasjet_handle tank, int64_t vent, double area) {
  return change_parts(tank, [&](TankParts& parts) { vent_of(parts, vent).area = number(area, "area", 0.0); });
}

int gasjet_tank_set_heat_loss(gasjet_handle tank, double conductance, double outside_temperature) {
  return change_parts(tank, [&](TankParts& parts) {
    parts.heat_loss = {number(conductance, "conductance", 0.0),
                       positive(outside_temperature, "outside_temperature")};
  });
}

int gasjet_tank_advance(gasjet_handle tank, double time, double volume) {
  return call([&] {
    const Use<Tank> use(tank, "tank");
    if (!(number(time, "time") > use->time))
      refuse("time", "is " + shown(time) + ", allowed: later than the tank's, " + shown(use->time));
    use->advance(time, positive(volume, "volume"));
  });
}

int gasjet_tank_read(gasjet_handle tank, gasjet_tank_state* state) {
  return call([&] {
    const Use<Tank> use(tank, "tank");
    const auto point = gas::evaluate(use->model, use->state, use->volume, use->parts.leak_area, use->time);
    const gasjet_tank_state all{use->time,
                                point.pressure,
                                point.temperature,
                                use->volume,
                                point.mass,
                                use->state.internal_energy,
                                point.density,
                                point.gamma,
                                point.cp,
                                point.gas_constant,
                                point.inflow,
                                point.vent_mass_flow,
                                point.fabric_mass_flow,
                                point.backflow,
                                point.heat_loss};
    needed(state, "state") = finite(all, "state");
  });
}

int gasjet_tank_species(gasjet_handle tank, char text[], int64_t size, int64_t* needed) {
  return call([&] {
    const Use<Tank> use(tank, "tank");
    std::string names;
    for (std::size_t k = 0; k < use->model.thermo.size(); ++k)
      names += (k > 0 ? "\n" : "") + use->model.thermo.species(k).name;
    write_sized(names, text, size, needed);
  });
}

int gasjet_tank_masses(gasjet_handle tank, double mass[], double amount[], int64_t species_count) {
  return call([&] {
    const Use<Tank> use(tank, "tank");
    const std::vector<double>& all = use->state.masses;
    needed(mass, "mass");
    needed(amount, "amount");
    require_count(species_count, static_cast<int64_t>(all.size()), "species_count");
    for (std::size_t k = 0; k < all.size(); ++k) {
      mass[k] = all[k];
      amount[k] = all[k] / use->model.thermo.species(k).molar_mass;
    }
  });
}

int gasjet_tank_read_balance(gasjet_handle tank, gasjet_tank_balance* balance) {
  return call([&] {
    const Use<Tank> use(tank, "tank");
    needed(balance, "balance") = use->balance();
  });
}
