// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>

#include "base/case_reader.hpp"
#include "import/import_deck.hpp"

namespace driver::imported {
namespace {

struct NamedUnit {
  std::string_view name;
  double si;
};

template <std::size_t N>
double unit_named(const std::array<NamedUnit, N>& units, std::string_view name, const std::string& all) {
  for (const NamedUnit& unit : units)
    if (unit.name == name) return unit.si;
  throw CaseError(fmt::format(
      "the units '{}' are not known, allowed: mass-length-time, such as kg-mm-ms, with kg, g, t, lbm or "
      "slinch, m, cm, mm, in or ft, and s, ms or us",
      all));
}

constexpr std::array masses{NamedUnit{"kg", 1.0}, NamedUnit{"g", 1e-3}, NamedUnit{"t", 1e3},
                            NamedUnit{"lbm", 0.45359237}, NamedUnit{"slinch", 175.12683524647636}};
constexpr std::array lengths{NamedUnit{"m", 1.0}, NamedUnit{"cm", 1e-2}, NamedUnit{"mm", 1e-3},
                             NamedUnit{"in", 0.0254}, NamedUnit{"ft", 0.3048}};
constexpr std::array times{NamedUnit{"s", 1.0}, NamedUnit{"ms", 1e-3}, NamedUnit{"us", 1e-6}};

}  // namespace

Units import_units(const std::string& name) {
  const auto first = name.find('-'), second = name.find('-', std::min(first, name.size() - 1) + 1);
  if (first == std::string::npos || second == std::string::npos)
    return {name, unit_named(masses, "", name), 1.0, 1.0, "", "", ""};  // throws
  const std::string_view text = name;
  return {name,
          unit_named(masses, text.substr(0, first), name),
          unit_named(lengths, text.substr(first + 1, second - first - 1), name),
          unit_named(times, text.substr(second + 1), name),
          "",
          "",
          ""};
}

}  // namespace driver::imported
