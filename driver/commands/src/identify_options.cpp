// SPDX-License-Identifier: Apache-2.0
#include "identify_options.hpp"

#include <fmt/format.h>

#include <charconv>

#include "base/case_reader.hpp"
#include "tank_readings.hpp"
#include "validators.hpp"

namespace driver::commands {

void add_identify(CLI::App& app, IdentifyArguments& a) {
  auto* c = app.add_subcommand("identify", "tank test: mass flow and temperature from measured pressures");
  const auto add = [&](const char* name, auto& value, const char* text) {
    return c->add_option(name, value, text)->capture_default_str()->check(given);
  };
  c->add_option("DATA", a.file, "CSV of readings, with a header row; times from firing")->required();
  c->add_option("--out", a.out, "CSV of the curves, for a case file")->required()->check(named);
  c->add_option("--method", a.method, "average (temperature) or dual (pressure: tank and chamber)")
      ->required()
      ->check(CLI::IsMember({"average", "dual"}));
  c->add_option("--volume", a.volume, "volume of the tank [m3]")->required()->check(given);
  c->add_option("--mass", a.mass, "total mass that the inflator delivers [kg]")->required()->check(given);
  c->add_option("--gas", a.gas,
                "gas of the inflator: NAME, air or NAME=FRACTION,... (N2=0.7,CO2=0.3), see --by")
      ->required();
  add("--tank-gas", a.tank_gas, "gas in the tank before firing");
  add("--by", a.by, "meaning of the fractions of --gas and --tank-gas; air is always by mole")
      ->check(CLI::IsMember({"mass", "mole"}));
  add("--thermodynamics", a.thermodynamics, "cp")->check(CLI::IsMember({"nasa7", "constant"}));
  c->add_option("--species", a.species, "TOML file with more gases, [[gas.species]] as in a case")
      ->check(named);
  add("--initial-temperature", a.initial_temperature, "of the tank's gas [K]");
  add("--time-column", a.time_column, "name in the header");
  add("--tank-column", a.tank_column, "name in the header");
  add("--chamber-column", a.chamber_column, "name in the header");
  add("--time-unit", a.time_unit, "of the times");
  add("--tank-unit", a.tank_unit, "of the tank's pressure, absolute unless it says gauge (\"kPa gauge\")");
  c->add_option("--chamber-unit", a.chamber_unit, "of the chamber's pressure; default: Pa")->check(given);
  c->add_option("--ambient-pressure", a.ambient_pressure,
                fmt::format("that gauge pressures count from [Pa]; default: {}", standard_atmosphere))
      ->check(positive);
  add("--noise", a.noise, "the gauges' noise is a fixed share of the reading, or of the full scale")
      ->check(CLI::IsMember({"reading", "full-scale"}));
  add("--heat-loss", a.heat_loss,
      "to the walls: coefficient times area [W/K], or fit to the fall of the pressure after the flow");
  add("--threshold", a.threshold, "rows with |K| below this fraction of the largest are masked");
  add("--points", a.points, "rows of the curves, equally spaced");
  add("--draws", a.draws, "random draws behind the 95 % bands");
}

std::optional<double> heat_loss(const IdentifyArguments& a) {
  if (a.heat_loss == "fit") return std::nullopt;
  double value = 0.0;
  const char* end = a.heat_loss.data() + a.heat_loss.size();
  const auto [stop, error] = std::from_chars(a.heat_loss.data(), end, value);
  if (error != std::errc{} || stop != end)
    throw CaseError(fmt::format("--heat-loss {}: is neither a number [W/K] nor fit", a.heat_loss));
  return value;
}

}  // namespace driver::commands
