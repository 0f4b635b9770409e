// SPDX-License-Identifier: Apache-2.0
#include "deck_gas.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <elementary/exponential.hpp>
#include <span>

#include "deck_openings.hpp"
#include "engine/stages.hpp"
#include "engine/step.hpp"
#include "membrane/time_step.hpp"

namespace driver {
namespace {

using Fractions = std::vector<double>;

constexpr double round_off = 1e-12;  // relative variation of a constant heat capacity

// Fits a parabola, which some programs use as molar heat capacity.
void fit_parabola(const gas::Thermo& thermo, const Fractions& fractions, double highest, DeckGas& mixture) {
  constexpr double lowest = 250.0, span = 50.0;  // [K]; `span` is the least that determines three numbers
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
  fit_parabola(thermo, fractions, highest, mixture);
  if (highest <= gas::kJointTemperature) return mixture;
  constexpr int points = 200;
  for (int i = 1; i <= points; ++i) {
    const double T = gas::kJointTemperature + (highest - gas::kJointTemperature) * i / points;
    double cp = 0.0;
    for (std::size_t j = mixture.cp.size(); j-- > 0;) cp = cp * T + mixture.cp[j];
    mixture.misfit = std::max(mixture.misfit, std::abs(cp / thermo.cp(fractions, T) - 1.0));
  }
  if (mixture.misfit <= round_off) mixture.misfit = 0.0;
  return mixture;
}

void add_inflators(const Scene& scene, double highest, Deck& deck) {
  const gas::ControlVolumeModel& model = scene.gas->model;
  for (std::size_t i = 0; i < model.inflows.size(); ++i) {
    const gas::Inflow& inflow = model.inflows[i];
    const auto times = times_of(scene, inflow.trigger);
    if (!times || times->empty()) {
      deck.omissions.push_back({fmt::format("inflator.{}", i), times ? never_on : decided_by_run});
      continue;
    }
    const double shift = times->front() + inflow.start_time;
    deck.inflators.push_back({mixture_of(model.thermo, inflow.mass_fractions, highest),
                              knots_of(inflow.mass_flow, shift, scene.time.end, true),
                              knots_of(inflow.temperature, shift, scene.time.end)});
  }
}

// Enthalpy of a deck's gas between two temperatures [J/kg], by the heat capacity in the deck.
double enthalpy_between(const DeckGas& mixture, DeckFormat format, double from, double to) {
  const std::span<const double> cp =
      format == DeckFormat::radioss ? std::span<const double>(mixture.cp) : mixture.parabola;
  double sum = 0.0;
  for (std::size_t j = cp.size(); j-- > 0;) {
    const auto power = static_cast<double>(j + 1);
    sum += cp[j] / power * (elementary::pow(to, power) - elementary::pow(from, power));
  }
  return sum;
}

// Temperature at which gas must enter a rigid volume to have there the internal energy of `temperature`.
double filling_temperature(const DeckGas& mixture, DeckFormat format, double temperature) {
  const double work = gas::kMolarGasConstant / mixture.molar_mass * temperature;  // [J/kg] p/rho
  double low = 0.0, high = temperature;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (enthalpy_between(mixture, format, middle, temperature) > work ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// A thousandth of the run, or twenty critical steps if longer: these give the area of a triangular pulse to a
// thousandth.
double pulse_of(const Scene& scene) {
  constexpr double steps = 20.0;
  const State start = state_at_start(scene);
  const double least = 1e-3 * scene.time.end,
               critical = membrane::critical_time_step(membrane::stiffness_shares(
                   scene.bag->model, *start.bag, start.gas_point.gamma, start.gas_point.pressure));
  return std::isfinite(critical) ? std::max(least, steps * critical) : least;
}

// Decks begin at ambient pressure. The gas of an initial overpressure enters at the temperature that gives
// the same internal energy in a rigid volume: at once if the deck has curves of mass, otherwise in a pulse.
void add_initial_overpressure(const Scene& scene, Deck& deck) {
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
  const double volume = mesh::enclosed_volume(bag.initial_position, bag.mesh.elements);
  const double R = gas.model.thermo.gas_constant(gas.initial_fractions);
  const double mass = excess * volume / (R * gas.initial_temperature), end = 2.0 * scene.time.end;
  const double temperature = filling_temperature(deck.initial_gas, deck.format, gas.initial_temperature);
  DeckInflator inflator{
      deck.initial_gas, {{0.0, mass}, {end, mass}}, {{0.0, temperature}, {end, temperature}}};
  inflator.of_mass = deck.format == DeckFormat::radioss;
  inflator.title = initial_overpressure_title;
  std::string when = "in the first cycle";
  if (!inflator.of_mass) {
    const double pulse = pulse_of(scene);
    inflator.mass_flow = {{0.0, 0.0}, {0.5 * pulse, 2.0 * mass / pulse}, {pulse, 0.0}, {end, 0.0}};
    when = fmt::format("within the first {:.3g} s; a bag that breathes as fast loses some of its first swing",
                       pulse);
  }
  deck.inflators.push_back(std::move(inflator));
  deck.notes.push_back(
      {"gas.initial.pressure",
       fmt::format("the initial overpressure of {:.6g} Pa comes from an additional inflator, {:.6g} kg {}",
                   excess, mass, when)});
}

void note_misfit(const DeckGas& gas, double highest, Deck& deck) {
  const bool parabola = deck.format == DeckFormat::lsdyna;
  const double misfit = parabola ? gas.parabola_misfit : gas.misfit;
  if (misfit == 0.0) return;
  const std::string text =
      fmt::format("cp of {} differs by up to {:.2g} % {} {:.0f} K", gas.name, 100.0 * misfit,
                  parabola ? "from 250 to" : "between 1000 and", highest);
  if (std::ranges::find(deck.notes, text, &DeckNote::text) == deck.notes.end())
    deck.notes.push_back({"gas.thermodynamics", text});
}

}  // namespace

// Decks extrapolate the last two knots. Therefore values outside the case's knots get knots of their own, and
// a jump becomes two knots a millionth of the scene's end apart.
DeckCurve knots_of(const gas::Curve& curve, double shift, double end, bool zero_before) {
  DeckCurve points;
  const double jump = 1e-6 * end;
  const auto add = [&](double time, double value) {
    if (!points.empty() && time <= points.back()[0]) time = points.back()[0] + jump;
    points.push_back({time, value});
  };
  const auto knots = curve.knots();
  const bool zero = curve.outside() == gas::Outside::zero;
  const double first = knots.front().time + shift;
  zero_before = zero_before || zero;
  if (zero_before && first > 0.0) add(std::min(0.0, first - 2.0 * jump), 0.0);
  if (zero_before && first > 0.0 && knots.front().value != 0.0) add(first - jump, 0.0);
  if (!zero_before && first > 0.0) add(0.0, knots.front().value);
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
  add_initial_overpressure(scene, deck);
  add_vents(scene, deck);
  add_leaks(scene, deck);
  note_misfit(deck.initial_gas, highest, deck);
  for (const auto& inflator : deck.inflators) note_misfit(inflator.gas, highest, deck);
}

}  // namespace driver
