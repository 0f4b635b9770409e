// SPDX-License-Identifier: Apache-2.0
// Tank test analysis: mass flow and temperature of an inflator from measured pressures.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "argument_list.hpp"
#include "base/case_reader.hpp"
#include "base/csv_table.hpp"
#include "base/progress.hpp"
#include "commands/command.hpp"
#include "engine/species.hpp"
#include "identify_options.hpp"
#include "input_files.hpp"
#include "results/results.hpp"
#include "tank_readings.hpp"
#include "tank_test/identify.hpp"
#include "tank_test/smoothing_spline.hpp"

namespace driver::commands {
namespace {

constexpr double kThinned = 0.1;  // share of an atmosphere: few tanks are evacuated further before a
                                  // test

/// Reads NAME or NAME=FRACTION,...; "air" alone means its four species.
std::vector<gas::Component> read_composition(const std::string& option, const std::string& text) {
  if (text == "air") return gas::air_by_mole();
  std::vector<gas::Component> parts;
  for (const auto& part : split(text, ',')) {
    const auto equals = std::min(part.find('='), part.size());
    double fraction = 1.0;
    const char* end = part.data() + part.size();
    if (equals < part.size()) {
      const auto [stop, error] = std::from_chars(part.data() + equals + 1, end, fraction);
      if (error != std::errc{} || stop != end)
        throw CaseError(fmt::format("{} {}: '{}' is not NAME=FRACTION", option, text, part));
    }
    parts.push_back({part.substr(0, equals), fraction});
  }
  return parts;
}

/// Runs `action`; turns its std::invalid_argument into an error of the option.
template <typename Action>
auto of_option(const std::string& option, const Action& action) {
  try {
    return action();
  } catch (const std::invalid_argument& error) {
    throw CaseError(fmt::format("{}: {}", option, error.what()));
  }
}

/// The species by name, including those of the file --species, of which nothing else is read.
SpeciesCatalogue catalogue(const IdentifyArguments& a) {
  SpeciesCatalogue species(a.thermodynamics == "nasa7" ? Thermodynamics::nasa7 : Thermodynamics::constant_cp,
                           gas::kReferenceTemperature);
  if (a.species.empty()) return species;
  CaseDocument document(a.species, {});
  TableReader root = document.root(), table = root.table("gas");
  if (!table.has("species")) table.fail("species", "is missing, needed: [[gas.species]]");
  species.read(table);
  return species;
}

gas::TankTest tank_test(const IdentifyArguments& a) {
  const SpeciesCatalogue known = catalogue(a);
  const auto own = read_composition("--tank-gas", a.tank_gas), in = read_composition("--gas", a.gas);
  std::vector<gas::Species> species;
  const auto add = [&](const std::string& option, const std::vector<gas::Component>& parts) {
    for (const auto& part : parts) {
      if (std::ranges::find(species, part.species, &gas::Species::name) != species.end()) continue;
      species.push_back(of_option(option, [&] { return known.named(part.species); }));
    }
  };
  add("--tank-gas", own);
  add("--gas", in);
  const gas::Thermo thermo(species);
  const auto fractions = [&](const std::string& option, const std::string& text,
                             const std::vector<gas::Component>& parts) {
    return of_option(option + " " + text, [&] {
      return a.by == "mole" || text == "air" ? thermo.mass_fractions_by_mole(parts)
                                             : thermo.mass_fractions_by_mass(parts);
    });
  };
  return {thermo,
          a.volume,
          a.initial_temperature,
          fractions("--tank-gas", a.tank_gas, own),
          fractions("--gas", a.gas, in),
          a.mass};
}

/// The library's message with the name of the option as typed.
std::string as_typed(const std::string& message) {
  static const std::pair<const char*, const char*> options[] = {
      {"volume", "--volume"},
      {"total_mass", "--mass"},
      {"initial_temperature", "--initial-temperature"},
      {"threshold", "--threshold"},
      {"points", "--points"},
      {"draws", "--draws"},
      {"heat_loss", "--heat-loss"}};
  for (const auto& [name, option] : options)
    if (message.starts_with(std::string(name) + " "))
      return option + message.substr(std::string(name).size());
  return "identify: " + message;
}

gas::Identified analyse(const IdentifyArguments& a, const gas::TankTest& test, const CsvTable& table) {
  gas::TankReadings readings{table.values[0], table.values[1], {}};
  if (table.values.size() > 2) readings.chamber = table.values[2];
  const bool of_reading = a.noise == "reading";
  const auto loss = heat_loss(a);
  try {
    return gas::identify(test, readings,
                         {.points = a.points,
                          .threshold = a.threshold,
                          .draws = a.draws,
                          .noise = of_reading ? gas::Noise::of_reading : gas::Noise::of_full_scale,
                          .heat_loss = loss.value_or(0.0),
                          .fit_heat_loss = !loss});
  } catch (const gas::ReadingError& error) {
    const std::size_t column = error.series == "time" ? 0 : error.series == "tank pressure" ? 1 : 2;
    std::string what = error.what();
    if (column > 0 && table.values[column][error.index] < kThinned * standard_atmosphere)
      what += "; pressures are absolute unless their unit says gauge";
    if (column == 2 && of_reading)
      what += "; for noise that is constant over the record use --noise full-scale";
    table.fail(column, error.index, what);
  } catch (const std::invalid_argument& error) {
    throw CaseError(as_typed(error.what()));
  }
}

std::string text(const gas::Band& band) {
  return fmt::format("{:.6g} to {:.6g}", band.low, band.high);
}

std::string text(const IdentifyArguments& a, const gas::Smoothing& s) {
  return fmt::format("noise {:.4g} % of the {}, {:.4g} degrees of freedom, lambda {:.4g}", 100.0 * s.noise,
                     a.noise == "reading" ? "reading" : "largest reading", s.degrees_of_freedom, s.parameter);
}

std::string bands(const IdentifyArguments& a, const gas::Identified& found) {
  const std::string share = fmt::format("{} of {} draws do not fit", found.misfits, a.draws);
  if (found.tank_clipping || found.chamber_clipping)
    return "none: a gauge is cut off, which spoils the whole record";
  if (!found.fits) return "none: a tank with these curves misses the record by more than the noise";
  if (!found.bands) return "none: " + share + " the range of temperatures, more than a tenth";
  const char* text = "pointwise 95 %, from the pressures' noise alone";
  return found.misfits == 0
             ? text
             : fmt::format("{}; {}, the other draws give the bands, which are too narrow there", text, share);
}

/// Lines above the table and on the screen.
Provenance findings(const IdentifyArguments& a, const gas::Identified& found) {
  const bool dual = a.method == "dual";
  const auto masked = std::ranges::count_if(found.points, [](const auto& p) { return p.masked; });
  const auto peak = std::ranges::max_element(found.points, {}, &gas::IdentifiedPoint::enthalpy_flow);
  Provenance lines{
      {"method", dual ? "dual pressure" : "average temperature"},
      {"gas", fmt::format("{} by {} into {}, {} cp, tank of {} m3, {} kg, {} K at first", a.gas, a.by,
                          a.tank_gas, a.thermodynamics, a.volume, a.mass, a.initial_temperature)},
      {"tank_pressure", text(a, found.tank)}};
  if (const auto units = units_text(a); !units.empty()) lines.push_back({"units", units});
  if (!a.species.empty()) lines.push_back({"species", "built-in and " + a.species.string()});
  if (dual) lines.push_back({"chamber_pressure", text(a, found.chamber)});
  const auto with_band = [&](double value, const gas::Band& band) {
    return fmt::format("{:.6g}, {}", value, found.bands ? "95 %: " + text(band) : "no band");
  };
  lines.push_back({"initial_pressure_Pa",
                   fmt::format("{:.6g}, from the flat readings at the start", found.initial_pressure)});
  if (!heat_loss(a))
    lines.push_back(
        {"heat_loss_W_K", fmt::format("{:.6g}, 95 %: {}, from the fall of the pressure after {:.4g} s",
                                      found.heat_loss, text(found.heat_loss_band), found.tail_start)});
  else if (found.heat_loss > 0.0)
    lines.push_back({"heat_loss_W_K", fmt::format("{:.6g}, as given", found.heat_loss)});
  lines.push_back({"mean_temperature_K", with_band(found.mean_temperature, found.mean_temperature_band)});
  if (dual) lines.push_back({"outlet_CdA_m2", with_band(found.effective_area, found.effective_area_band)});
  double worst = 0.0;
  for (const auto& point : found.points)
    if (!point.masked) worst = std::max(worst, point.amplification);
  lines.push_back(
      {"amplification", fmt::format("deviation of K relative to one reading: {:.3g} at the largest K ({:.5g} "
                                    "kg K/s), up to {:.3g} above the threshold ({:.5g})",
                                    peak->amplification, peak->enthalpy_flow, worst, found.threshold)});
  lines.push_back(
      {"masked", fmt::format("{} of {} rows, K below {} of its largest or 4 of its standard deviations",
                             masked, found.points.size(), a.threshold)});
  lines.push_back(
      {"forward_model",
       fmt::format("a tank with these curves differs from the smoothed tank pressure by at most {:.2g} %",
                   100.0 * found.forward_error)});
  const auto claimed = std::ranges::count_if(found.points, [](const auto& p) { return p.band_claimed; });
  lines.push_back({"bands", bands(a, found)});
  lines.push_back(
      {"band_claimed", fmt::format("{} of {} rows: none where masked, where the tank pressure bends too "
                                   "sharply for the smoothing, or where the band ends at the gas's range of "
                                   "temperatures; none at all with fewer than 30 readings in the burn",
                                   claimed, found.points.size())});
  lines.push_back({"bias", dual ? "temperature is constant where masked"
                                : "mass_flow is wrong by the factor T_s/mean_temperature at each moment, "
                                  "which the bands do not contain"});
  return lines;
}

/// Adds a line about a gauge that is cut off.
void add_clipping(const char* gauge, const std::optional<gas::Clipping>& clipping, const char* advice,
                  std::vector<std::string>& doubts) {
  if (!clipping) return;
  doubts.push_back(
      fmt::format("the {} pressure is cut off at {:.6g} Pa from {:.4g} to {:.4g} s: {} readings equal the "
                  "largest; no band is claimed; use a gauge of a larger range{}",
                  gauge, clipping->pressure, clipping->first, clipping->last, clipping->count, advice));
}

/// Warnings about a result that the record or the options make doubtful.
std::vector<std::string> doubts(const gas::Identified& found) {
  std::vector<std::string> doubts;
  const auto& points = found.points;
  const double first = points.front().tank_pressure;
  if (first < kThinned * standard_atmosphere)
    doubts.push_back(
        fmt::format("the tank is at {:.3g} Pa at first, less than a tenth of an atmosphere: check that "
                    "pressures are absolute, or give --tank-unit",
                    first));
  add_clipping("tank", found.tank_clipping, "", doubts);
  add_clipping("chamber", found.chamber_clipping, " or --method average", doubts);
  if (!found.fits)
    doubts.push_back(
        fmt::format("a tank with these curves differs from the smoothed tank pressure by {:.2g} %, noise "
                    "explains {:.2g} %: check that pressures are absolute, use more --points for sharp "
                    "pulses, and --heat-loss fit for a tank that loses heat",
                    100.0 * found.forward_error, 100.0 * found.forward_noise));
  constexpr double longest = 5.0;  // [s] of a record; inflators burn for a tenth of a second
  if (const double length = points.back().time - points.front().time; length > longest)
    doubts.push_back(
        fmt::format("the record is {:.3g} s long: check that times are in seconds, or "
                    "give --time-unit",
                    length));
  const auto peak = std::ranges::max_element(points, {}, &gas::IdentifiedPoint::mass_flow);
  if (!points.back().masked)
    doubts.push_back(
        fmt::format("the record ends while gas still flows ({:.2g} % of the largest flow), but the method "
                    "assumes that all of --mass is in the tank by then",
                    100.0 * points.back().mass_flow / peak->mass_flow));
  return doubts;
}

void write_curve(const std::filesystem::path& file, const Provenance& lines, const gas::Identified& found) {
  fmt::memory_buffer out;
  const auto to = std::back_inserter(out);
  fmt::format_to(to, "{}", comment_lines(lines));
  fmt::format_to(to,
                 "time_s,mass_flow_kg_s,mass_flow_low_kg_s,mass_flow_high_kg_s,temperature_K,"
                 "temperature_low_K,temperature_high_K,tank_pressure_Pa,chamber_pressure_Pa,"
                 "enthalpy_flow_kg_K_s,amplification,masked,band_claimed\n");
  for (const auto& p : found.points)
    fmt::format_to(to,
                   "{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{:.6g},{:.4g},{:d},{:d}\n",
                   p.time, p.mass_flow, p.mass_flow_band.low, p.mass_flow_band.high, p.temperature,
                   p.temperature_band.low, p.temperature_band.high, p.tank_pressure, p.chamber_pressure,
                   p.enthalpy_flow, p.amplification, p.masked, p.band_claimed);
  replace_file(file, fmt::to_string(out));
}

}  // namespace

int identify(const IdentifyArguments& arguments) {
  refuse_same_file("--out", arguments.out, {arguments.file, arguments.species});
  const gas::TankTest test = tank_test(arguments);
  const CsvTable table = read_readings(arguments);
  const gas::Identified found = analyse(arguments, test, table);
  Provenance lines = provenance(arguments.file, {});
  lines.front().first = "data";
  std::erase_if(lines, [](const auto& line) { return line.first == "options"; });
  const Provenance results = findings(arguments, found);
  lines.insert(lines.end(), results.begin(), results.end());
  for (const auto& doubt : doubts(found)) {
    lines.push_back({"warning", doubt});
    tell("warning: " + doubt);
  }
  write_curve(arguments.out, lines, found);
  fmt::print("{}: {} readings over {:.4g} s\n", arguments.file.string(), table.rows(),
             table.values[0].back() - table.values[0].front());
  for (const auto& [key, value] : results) fmt::print("  {}: {}\n", key, value);
  fmt::print(
      "{}: mass_flow_kg_s and temperature_K are curves for a case file\ntemperature_K is that of the gas at "
      "rest: a jet needs jet.temperature = \"stagnation\"\n",
      arguments.out.string());
  return exit_done;
}

}  // namespace driver::commands
