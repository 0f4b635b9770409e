// SPDX-License-Identifier: Apache-2.0
#include "base/named_units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace driver {
namespace {

struct TableRow {
  std::string_view si, name;
  NamedUnit unit;
};

constexpr double psi = 6894.757293168361;  // [Pa] of a pound-force, 4.4482216152605 N, per square inch
constexpr double pound = 0.45359237;       // [kg]

// Units of each quantity. Factor and divisor are whole numbers where they can be: with one of them 1, the
// result is rounded once.
constexpr TableRow rows[] = {
    {"s", "s", {}},
    {"s", "ms", {1.0, 1e3}},
    {"s", "us", {1.0, 1e6}},
    {"kg", "kg", {}},
    {"kg", "g", {1.0, 1e3}},
    {"kg", "mg", {1.0, 1e6}},
    {"kg", "t", {1e3}},
    {"kg", "lb", {pound}},
    {"kg/s", "kg/s", {}},
    {"kg/s", "g/s", {1.0, 1e3}},
    {"kg/s", "g/ms", {}},
    {"kg/s", "kg/ms", {1e3}},
    {"kg/s", "t/s", {1e3}},
    {"kg/s", "lb/s", {pound}},
    {"Pa", "Pa", {}},
    {"Pa", "hPa", {1e2}},
    {"Pa", "kPa", {1e3}},
    {"Pa", "MPa", {1e6}},
    {"Pa", "GPa", {1e9}},
    {"Pa", "mbar", {1e2}},
    {"Pa", "bar", {1e5}},
    {"Pa", "atm", {101325.0}},
    {"Pa", "psi", {psi}},
    {"K", "K", {}},
    {"K", "degC", {1.0, 1.0, 273.15}},
    {"K", "degF", {5.0, 9.0, 459.67 * 5.0 / 9.0}},
    {"m2", "m2", {}},
    {"m2", "cm2", {1.0, 1e4}},
    {"m2", "mm2", {1.0, 1e6}},
    {"m2", "in2", {6.4516, 1e4}},
    {"m3", "m3", {}},
    {"m3", "l", {1.0, 1e3}},
    {"m3", "cm3", {1.0, 1e6}},
    {"m3", "mm3", {1.0, 1e9}},
    {"m/s", "m/s", {}},
    {"m/s", "cm/s", {1.0, 1e2}},
    {"m/s", "mm/s", {1.0, 1e3}},
    {"m/s", "mm/ms", {}},
    {"N m", "N m", {}},
    {"N m", "N mm", {1.0, 1e3}},
    {"N m", "kN m", {1e3}},
    {"m", "m", {}},
    {"m", "cm", {1.0, 1e2}},
    {"m", "mm", {1.0, 1e3}},
    {"m/s2", "m/s2", {}},
    {"m/s2", "mm/s2", {1.0, 1e3}},
    {"m/s2", "mm/ms2", {1e3}},
    {"m/s2", "g", {9.80665}},
    {"rad", "rad", {}},
    {"rad", "deg", {M_PI, 180.0}},
    {"rad/s", "rad/s", {}},
    {"rad/s", "rad/ms", {1e3}},
    {"rad/s", "deg/s", {M_PI, 180.0}},
    {"N", "N", {}},
    {"N", "kN", {1e3}},
    {"J", "J", {}},
    {"J", "kJ", {1e3}},
    {"J", "mJ", {1.0, 1e3}},
    {"", "1", {}},
    {"", "%", {1.0, 1e2}},
};

// The name with ASCII letters alone.
std::string plain(std::string text) {
  constexpr std::pair<std::string_view, std::string_view> others[] = {{"²", "2"}, {"³", "3"},   {"µ", "u"},
                                                                      {"μ", "u"}, {"°", "deg"}, {"·", " "}};
  for (const auto& [letter, written] : others)
    for (auto at = text.find(letter); at != text.npos; at = text.find(letter, at + written.size()))
      text.replace(at, letter.size(), written);
  return text == "L" ? "l" : text;
}

const TableRow* find_row(std::string_view si, std::string_view name) {
  const auto* found =
      std::ranges::find_if(rows, [&](const auto& row) { return row.si == si && row.name == name; });
  return found == std::end(rows) ? nullptr : found;
}

// What a pressure says that it counts from; takes the word off the name.
PressureZero take_zero(std::string& name) {
  constexpr std::pair<std::string_view, PressureZero> words[] = {{" gauge", PressureZero::ambient},
                                                                 {" absolute", PressureZero::vacuum}};
  for (const auto& [word, zero] : words)
    if (name.ends_with(word)) {
      name.resize(name.size() - word.size());
      return zero;
    }
  for (const std::string unit : {"psi", "bar"})
    for (const auto& [word, zero] : words)
      if (name == unit + word[1]) {
        name = unit;
        return zero;
      }
  return PressureZero::none;
}

[[noreturn]] void refuse(const std::string& name, std::string_view si, PressureZero zero) {
  std::vector<std::string_view> names;
  for (const TableRow& row : rows)
    if (row.si == si) names.push_back(row.name);
  if (names.empty()) names.push_back(si);  // always known
  const bool has_zero = si == "Pa" && zero != PressureZero::none;
  throw std::invalid_argument(fmt::format("is \"{}\", allowed: {}{}", name, fmt::join(names, ", "),
                                          has_zero ? ", also with gauge or absolute" : ""));
}

}  // namespace

NamedUnit unit_named(const std::string& name, std::string_view si, PressureZero zero,
                     std::optional<double> ambient_pressure) {
  const std::string quantity = plain(std::string(si));
  std::string unit = plain(name);
  const PressureZero own = quantity == "Pa" ? take_zero(unit) : PressureZero::none;
  const TableRow* row = find_row(quantity, unit);
  const bool is_known = row || (unit == quantity && !unit.empty());
  if (!is_known || (own != PressureZero::none && zero == PressureZero::none)) refuse(name, quantity, zero);
  NamedUnit found = row ? row->unit : NamedUnit{};
  if (own == PressureZero::none || own == zero) return found;
  if (!ambient_pressure)
    throw std::invalid_argument(
        fmt::format("is \"{}\", which needs the ambient pressure, but there is none here", name));
  found.offset = own == PressureZero::ambient ? *ambient_pressure : -*ambient_pressure;
  return found;
}

}  // namespace driver
