// SPDX-License-Identifier: Apache-2.0
#include <gasjet/gas.h>

#include <optional>
#include <span>

#include "arrays.hpp"
#include "gas/integrator.hpp"
#include "gas_object.hpp"

using namespace border;

namespace {

/// Mass fractions of a gas in the numbering of the tank, which has more species.
std::vector<double> fractions_in(const gas::Thermo& all, const Gas& gas) {
  std::vector<double> fractions(all.size(), 0.0);
  for (std::size_t k = 0; k < gas.thermo.size(); ++k)
    fractions[all.index(gas.thermo.species(k).name)] = gas.mass_fractions[k];
  return fractions;
}

bool same(const gas::Species& a, const gas::Species& b) {
  return a.molar_mass == b.molar_mass && a.low == b.low && a.high == b.high && a.constant_cp == b.constant_cp;
}

/// Adds the species of a gas that are missing.
void add_species(const Gas& gas, std::vector<gas::Species>& species) {
  for (std::size_t k = 0; k < gas.thermo.size(); ++k) {
    const gas::Species& one = gas.thermo.species(k);
    const auto there =
        std::find_if(species.begin(), species.end(), [&](const auto& s) { return s.name == one.name; });
    if (there == species.end())
      species.push_back(one);
    else if (!same(*there, one))
      refuse("gas", "has another cp of " + one.name + " than the tank, allowed: the same constant_cp_at");
  }
}

struct Flow {
  std::shared_ptr<const Gas> gas;
  gas::Curve mass_flow, temperature;
  double start_time;
};

/// Parts of a tank, as given by calls.
struct Parts {
  std::shared_ptr<const Gas> gas;
  double pressure, temperature, volume;
  gas::Ambient ambient;
  gas::IntegratorOptions options;
  std::vector<Flow> inflows;
  std::vector<gas::Vent> vents;  // without triggers
  std::vector<double> opens_at;  // [Pa] opening pressure of each
  double leak_area = 0.0;        // [m2]
};

gas::ControlVolumeModel model_of(const Parts& parts) {
  std::vector<gas::Species> species;
  add_species(*parts.gas, species);
  for (const Flow& flow : parts.inflows) add_species(*flow.gas, species);
  gas::ControlVolumeModel model{gas::Thermo(species), parts.ambient, {}, parts.vents};
  for (const Flow& flow : parts.inflows)
    model.inflows.push_back(
        {fractions_in(model.thermo, *flow.gas), flow.mass_flow, flow.temperature, flow.start_time});
  for (std::size_t i = 0; i < parts.opens_at.size(); ++i) {
    if (parts.opens_at[i] == 0.0) continue;
    model.vents[i].trigger = model.triggers.sensors.size();
    model.triggers.sensors.push_back({gas::SensorKind::pressure, parts.opens_at[i]});
  }
  return model;
}

/// A tank with its parts, model, state and sums. Adding a part rebuilds it.
struct Tank : Object {
  explicit Tank(Parts given)
      : parts(std::move(given)),
        model(model_of(parts)),
        integrator(model, parts.options),
        state(gas::make_state(model, fractions_in(model.thermo, *parts.gas), parts.pressure,
                              parts.temperature, parts.volume)),
        volume(parts.volume),
        first_mass(mass()),
        first_energy(state.internal_energy) {}
  static constexpr const char* name = "a tank";
  static constexpr bool shared = false;

  double mass() const {
    double sum = 0.0;
    for (const double m : state.masses) sum += m;
    return sum;
  }
  void advance(double to, double new_volume) {
    const auto flux =
        integrator.advance(state, time, to, {volume, new_volume, parts.leak_area, parts.leak_area});
    time = to;
    volume = new_volume;
    started = true;
    sums.mass_in += flux.mass_in;
    sums.enthalpy_in += flux.enthalpy_in;
    sums.vent_mass_out += flux.vent_mass_out;
    sums.fabric_mass_out += flux.fabric_mass_out;
    sums.enthalpy_out += flux.enthalpy_out;
    sums.work += flux.work;
    sums.substeps += flux.steps;
  }
  gasjet_tank_balance balance() const {
    gasjet_tank_balance all = sums;
    all.mass_residual = mass() - first_mass - sums.mass_in + sums.vent_mass_out + sums.fabric_mass_out;
    all.energy_residual =
        state.internal_energy - first_energy - sums.enthalpy_in + sums.enthalpy_out + sums.work;
    return all;
  }

  Parts parts;
  gas::ControlVolumeModel model;
  gas::GasIntegrator integrator;
  gas::ControlVolumeState state;
  double volume, first_mass, first_energy;
  double time = 0.0;
  bool started = false;
  gasjet_tank_balance sums{};
};

/// Adds a part to a tank that has not begun. If the part is refused, the tank is unchanged.
template <class Add>
int add_part(gasjet_handle tank, Add&& add) {
  return call([&] {
    const Use<Tank> use(tank, "tank");
    if (use->started) refuse("tank", "has begun, allowed: parts before the first gasjet_tank_advance");
    Parts parts = use->parts;
    add(parts);
    Tank made(std::move(parts));
    use->parts = std::move(made.parts);
    use->model = std::move(made.model);
    use->integrator = std::move(made.integrator);
    use->state = std::move(made.state);
  });
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
    const auto content = std::dynamic_pointer_cast<const Gas>(find(gas, "gas"));
    if (!content) refuse("gas", "is a handle of another kind, allowed: a gas");
    number(pressure, "pressure", 0.0);
    positive(temperature, "temperature");
    positive(volume, "volume");
    number(ambient_pressure, "ambient_pressure", 0.0);
    number(tolerance, "tolerance", 1e-13, 1e-2);
    gas::IntegratorOptions options;
    options.relative_tolerance = tolerance;
    *tank = keep(std::make_shared<Tank>(
        Parts{content, pressure, temperature, volume, {ambient_pressure, temperature}, options, {}, {}, {}}));
  });
}

int gasjet_tank_add_inflow(gasjet_handle tank, gasjet_handle gas, int64_t count, const double time[],
                           const double mass_flow[], const double temperature[], double start_time) {
  return add_part(tank, [&](Parts& parts) {
    const auto content = std::dynamic_pointer_cast<const Gas>(find(gas, "gas"));
    if (!content) refuse("gas", "is a handle of another kind, allowed: a gas");
    needed(time, "time");
    needed(mass_flow, "mass_flow");
    needed(temperature, "temperature");
    const std::span times(time, static_cast<std::size_t>(count_of(count, "count", 2)));
    for (const double t : times) number(t, "time");
    number(start_time, "start_time");
    parts.inflows.push_back({content, curve_of(times, mass_flow, "mass_flow", gas::Outside::zero),
                             curve_of(times, temperature, "temperature", gas::Outside::held), start_time});
  });
}

int gasjet_tank_add_vent(gasjet_handle tank, double discharge_coefficient, double area, double opens_at) {
  return add_part(tank, [&](Parts& parts) {
    number(discharge_coefficient, "discharge_coefficient", 0.0, 1.0);
    number(area, "area", 0.0);
    number(opens_at, "opens_at", 0.0);
    parts.vents.push_back({discharge_coefficient, area});
    parts.opens_at.push_back(opens_at);
  });
}

int gasjet_tank_add_fabric(gasjet_handle tank, double leak_area) {
  return add_part(tank, [&](Parts& parts) { parts.leak_area += number(leak_area, "leak_area", 0.0); });
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
                                point.fabric_mass_flow};
    needed(state, "state") = finite(all, "state");
  });
}

int gasjet_tank_read_balance(gasjet_handle tank, gasjet_tank_balance* balance) {
  return call([&] {
    const Use<Tank> use(tank, "tank");
    needed(balance, "balance") = use->balance();
  });
}
