// SPDX-License-Identifier: Apache-2.0
// The digits of a value that are left after rounding.
#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <stdexcept>

#include "closed_form/catalogue.hpp"

namespace closed_form {
namespace {

// With products of both signs, errors may cancel up and down, but not toward zero. WebAssembly rounds to
// nearest only: there all spreads are 0.
constexpr std::initializer_list<int> kDirections{FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

#ifdef FE_OVERFLOW
constexpr int kBeyond = FE_OVERFLOW | FE_DIVBYZERO;
#else
constexpr int kBeyond = 0;  // WebAssembly has no flags either
#endif

// The unit is at least this many spreads: half of it is for the spread, half for rounding to decimals.
constexpr double kSpreadsOfUnit = 3.0;

/// Rounds every operation in one direction while it lives.
class DirectedRounding {
 public:
  explicit DirectedRounding(int direction) { std::fesetround(direction); }
  ~DirectedRounding() { std::fesetround(before_); }
  DirectedRounding(const DirectedRounding&) = delete;
  DirectedRounding& operator=(const DirectedRounding&) = delete;

 private:
  int before_ = std::fegetround();
};

using Row = std::vector<double>;

// How far values of a row move with the direction of rounding. A direction in which the form refuses the
// row says nothing.
Row spreads(const Entry& entry, const ParameterMap& parameters, std::span<const double> abscissa,
            const Row& values) {
  Row spread(values.size());
  for (const int direction : kDirections) try {
      const DirectedRounding rounding(direction);
      const Row moved = evaluate(entry, parameters, abscissa).rows.front();
      for (std::size_t c = 0; c < moved.size(); ++c)
        spread[c] = std::max(spread[c], std::abs(moved[c] - values[c]));
    } catch (const std::invalid_argument&) {
    }
  return spread;
}

double power_of_ten(int exponent) {
  return std::strtod(("1e" + std::to_string(exponent)).c_str(), nullptr);
}

int exponent_of(double value) {
  return static_cast<int>(std::floor(std::log10(std::abs(value))));
}

/// A value with its last digit at a power of ten.
struct Rounded {
  double value = 0.0, unit = 0.0;
};

Rounded rounded(double value, double spread, int digits) {
  if (value == 0.0 && spread == 0.0) return {};
  int last = value == 0.0 ? -400 : exponent_of(value) + 1 - digits;
  if (spread > 0.0) last = std::max(last, static_cast<int>(std::ceil(std::log10(kSpreadsOfUnit * spread))));
  const double unit = power_of_ten(last);
  if (2.0 * std::abs(value) < unit) return {0.0, unit};
  char text[40];
  std::snprintf(text, sizeof text, "%.*e", std::max(0, exponent_of(value) - last), value);
  // Less than a unit, and more than half of one.
  return {std::abs(value) < unit ? std::copysign(unit, value) : std::strtod(text, nullptr), unit};
}

}  // namespace

RoundedTable evaluate_rounded(const Entry& entry, const ParameterMap& given,
                              std::span<const double> abscissae) {
  std::feclearexcept(kBeyond);
  RoundedTable table{evaluate(entry, given, abscissae), {}};
  if (std::fetestexcept(kBeyond) != 0)
    throw std::invalid_argument("a number on the way overflows at these parameters");
  for (Row& row : table.rows) {
    const std::span<const double> abscissa(row.data(), entry.has_abscissa() ? 1 : 0);
    const Row spread = spreads(entry, given, abscissa, row);
    Row& within = table.within.emplace_back(row.size());
    for (std::size_t c = abscissa.size(); c < row.size(); ++c) {
      const auto [value, unit] = rounded(row[c], spread[c], entry.digits);
      row[c] = value;
      within[c] = unit;
    }
  }
  return table;
}

}  // namespace closed_form
