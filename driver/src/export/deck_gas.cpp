// SPDX-License-Identifier: Apache-2.0
#include "export/deck_gas.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "driver/step.hpp"
#include "membrane/time_step.hpp"
#include "step/stages.hpp"

namespace driver {
namespace {

using Fractions = std::vector<double>;

// The molar heat capacity of some programs is a parabola.
void fit_parabola(const gas::Thermo& thermo, const Fractions& fractions, double highest, DeckGas& mixture) {
  constexpr double lowest = 250.0, span = 50.0;  // [K]; span: at least, so that three numbers are determined
  constexpr int points = 200;
  highest = std::max(highest, lowest + span);
  Eigen::Matrix<double, points, 3> powers;
  Eigen::Matrix<double, points, 1> cp;
  for (int i = 0; i < points; ++i) {
    const double T = lowest + (highest - lowest) * i / (points - 1), scaled = T / highest;
    powers.row(i) << 1.0, scaled, scaled * scaled;
    cp(i) = thermo.cp(fractions, T);
  }
  const Eigen::Vector3d factors = powers.householderQr().solve(cp);
  mixture.parabola = {factors(0), factors(1) / highest, factors(2) / (highest * highest)};
  mixture.parabola_misfit = ((powers * factors).array() / cp.array() - 1.0).abs().maxCoeff();
  constexpr double round_off = 1e-12;  // of a constant heat capacity
  if (mixture.parabola_misfit > round_off) return;
  const bool constant = cp.maxCoeff() - cp.minCoeff() <= round_off * cp.maxCoeff();
  if (constant) mixture.parabola = {cp(0), 0.0, 0.0};
  mixture.parabola_misfit = 0.0;
}

DeckGas mixture_of(const gas::Thermo& thermo, const Fractions& fractions, double highest) {
  DeckGas mixture;
  double amount = 0.0;  // [mol] of 1 kg
  for (std::size_t k = 0; k < thermo.size(); ++k) {
    if (fractions[k] == 0.0) continue;
    const gas::Species& species = thermo.species(k);
    mixture.name += fmt::format("{}{}={:.6g}", mixture.name.empty() ? "" : " ", species.name, fractions[k]);
    amount += fractions[k] / species.molar_mass;
    for (std::size_t j = 0; j < mixture.cp.size(); ++j)
      mixture.cp[j] += fractions[k] * thermo.gas_constant(k) * species.low[j];
  }
  mixture.molar_mass = 1.0 / amount;
  for (double T = gas::kJointTemperature; T < highest; T += 10.0) {
    double cp = 0.0;
    for (std::size_t j = mixture.cp.size(); j-- > 0;) cp = cp * T + mixture.cp[j];
    mixture.misfit = std::max(mixture.misfit, std::abs(cp / thermo.cp(fractions, T) - 1.0));
  }
  fit_parabola(thermo, fractions, highest, mixture);
  return mixture;
}

DeckCurve of_overpressure(const gas::Curve& curve, double factor) {
  DeckCurve points;
  for (const auto& knot : curve.knots()) points.push_back({knot.time, factor * knot.value});
  constexpr double beyond = 1e9;  // [Pa] no bag has
  if (points.size() == 1) points.insert(points.begin(), {-beyond, points.front()[1]});
  points.push_back({points.back()[0] + beyond, points.back()[1]});
  return points;
}

// Time at which a trigger comes on whatever happens, if there is one.
std::optional<double> known_time(const gas::TriggerModel& triggers, std::optional<std::size_t> node) {
  if (!node) return 0.0;
  if (*node < triggers.sensors.size() && triggers.sensors[*node].kind == gas::SensorKind::time)
    return triggers.sensors[*node].threshold;
  return std::nullopt;
}

void add_inflators(const Scene& scene, double highest, Deck& deck) {
  const gas::ControlVolumeModel& model = scene.gas->model;
  for (std::size_t i = 0; i < model.inflows.size(); ++i) {
    const gas::Inflow& inflow = model.inflows[i];
    const auto fires = known_time(model.triggers, inflow.trigger);
    if (!fires) {
      deck.notes.push_back(
          {"inflator.trigger", fmt::format("inflator {} is left out: its trigger depends on the run", i)});
      continue;
    }
    const double shift = *fires + inflow.start_time;
    deck.inflators.push_back({mixture_of(model.thermo, inflow.mass_fractions, highest),
                              knots_of(inflow.mass_flow, shift, scene.time.end),
                              knots_of(inflow.temperature, shift, scene.time.end)});
  }
}

// A thousandth of the run, or what takes fifty steps of an explicit program: these give the area of a
// triangle to a thousandth.
double pulse_of(const Scene& scene) {
  constexpr double steps = 20.0;
  const State start = state_at_start(scene);
  const double least = 1e-3 * scene.time.end,
               critical = critical_step(
                   scene, membrane::stiffness_shares(scene.bag->model, *start.bag, start.gas_point.gamma,
                                                     start.gas_point.pressure));
  return std::isfinite(critical) ? std::max(least, steps * critical) : least;
}

// Decks begin at ambient pressure. What a case has above it comes in within a pulse, at the temperature that
// gives the same internal energy in a rigid volume.
void add_initial_overpressure(const Scene& scene, double highest, Deck& deck) {
  const GasPart& gas = *scene.gas;
  const double excess = gas.initial_pressure - scene.ambient.pressure;
  if (excess == 0.0) return;
  if (excess < 0.0) {
    deck.notes.push_back(
        {"gas.initial.pressure", fmt::format("the gas starts at ambient pressure, {:.6g} Pa higher "
                                             "than in the case",
                                             -excess)});
    return;
  }
  const BagPart& bag = *scene.bag;
  const double volume = membrane::enclosed_volume(bag.initial_position, bag.mesh.elements);
  const double R = gas.model.thermo.gas_constant(gas.initial_fractions);
  const double gamma = gas.model.thermo.gamma(gas.initial_fractions, gas.initial_temperature);
  const double mass = excess * volume / (R * gas.initial_temperature), pulse = pulse_of(scene);
  const double peak = 2.0 * mass / pulse;
  const double temperature = gas.initial_temperature / gamma;
  deck.inflators.push_back({mixture_of(gas.model.thermo, gas.initial_fractions, highest),
                            {{0.0, 0.0}, {0.5 * pulse, peak}, {pulse, 0.0}, {2.0 * scene.time.end, 0.0}},
                            {{0.0, temperature}, {2.0 * scene.time.end, temperature}}});
  deck.notes.push_back(
      {"gas.initial.pressure",
       fmt::format("the initial overpressure of {:.6g} Pa comes from an inflator of its own, "
                   "{:.6g} kg within the first {:.3g} s",
                   excess, mass, pulse)});
}

void add_vents(const Scene& scene, Deck& deck) {
  const gas::ControlVolumeModel& model = scene.gas->model;
  for (std::size_t i = 0; i < model.vents.size(); ++i) {
    const gas::Vent& vent = model.vents[i];
    DeckVent opening{vent.discharge_coefficient, std::nullopt, std::nullopt, 0.0, std::nullopt};
    if (const auto opens = known_time(model.triggers, vent.trigger)) {
      opening.opens_at = *opens;
    } else {
      const std::size_t node = *vent.trigger;
      const bool by_pressure = node < model.triggers.sensors.size() &&
                               model.triggers.sensors[node].kind == gas::SensorKind::pressure &&
                               !model.triggers.sensors[node].reset;
      if (!by_pressure) {
        deck.notes.push_back(
            {"vent.trigger", fmt::format("vent {} is left out: its trigger depends on the run", i)});
        continue;
      }
      opening.opens_at_overpressure = model.triggers.sensors[node].threshold;
    }
    if (vent.area_of_time)
      opening.of_time = knots_of(*vent.area_of_time, opening.opens_at, scene.time.end);
    else if (vent.area_of_overpressure)
      opening.of_overpressure = of_overpressure(*vent.area_of_overpressure, 1.0);
    else
      opening.area *= vent.area;
    deck.vents.push_back(std::move(opening));
  }
}

void add_leaks(const Scene& scene, Deck& deck) {
  const LeakLaw law = scene.bag->leak_law;
  if (law == LeakLaw::none) return;
  for (const DeckPart& part : deck.parts) {
    const double porosity = part.fabric.porosity;
    if (part.null_panel || porosity == 0.0) continue;
    DeckLeak leak{part.id, law == LeakLaw::printed ? porosity * porosity : porosity, std::nullopt};
    if (law == LeakLaw::table)
      leak.velocity = of_overpressure(*scene.gas->model.fabrics.front().velocity, porosity);
    deck.leaks.push_back(std::move(leak));
  }
}

void note_misfit(const DeckGas& gas, double highest, Deck& deck) {
  const bool parabola = deck.format == DeckFormat::lsdyna;
  const double misfit = parabola ? gas.parabola_misfit : gas.misfit;
  if (misfit == 0.0) return;
  deck.notes.push_back(
      {"gas.thermodynamics", fmt::format("cp of {}{} is off by up to {:.2g} up to {:.0f} K", gas.name,
                                         parabola ? "" : " above 1000 K", misfit, highest)});
}

}  // namespace

// Decks go on along the last two knots: what the case means beyond them is said by knots of their own, and a
// jump by two knots a millionth of the scene's end apart.
DeckCurve knots_of(const gas::Curve& curve, double shift, double end) {
  DeckCurve points;
  const double jump = 1e-6 * end;
  const auto add = [&](double time, double value) {
    if (!points.empty() && time <= points.back()[0]) time = points.back()[0] + jump;
    points.push_back({time, value});
  };
  const auto knots = curve.knots();
  const bool zero = curve.outside() == gas::Outside::zero;
  const double first = knots.front().time + shift;
  if (zero && first > 0.0) add(std::min(0.0, first - 2.0 * jump), 0.0);
  if (zero && first > 0.0 && knots.front().value != 0.0) add(first - jump, 0.0);
  if (!zero && first > 0.0) add(0.0, knots.front().value);
  for (const auto& knot : knots) add(knot.time + shift, knot.value);
  const double value = zero ? 0.0 : knots.back().value;
  if (zero && knots.back().value != 0.0) add(points.back()[0] + jump, 0.0);
  add(points.back()[0] + end, value);
  return points;
}

void add_gas(const Scene& scene, Deck& deck) {
  const GasPart& gas = *scene.gas;
  double highest = gas.initial_temperature;
  for (const auto& inflow : gas.model.inflows) highest = std::max(highest, inflow.temperature.maximum());
  deck.initial_gas = mixture_of(gas.model.thermo, gas.initial_fractions, highest);
  add_inflators(scene, highest, deck);
  add_initial_overpressure(scene, highest, deck);
  add_vents(scene, deck);
  add_leaks(scene, deck);
  note_misfit(deck.initial_gas, highest, deck);
  for (const auto& inflator : deck.inflators) note_misfit(inflator.gas, highest, deck);
}

}  // namespace driver
