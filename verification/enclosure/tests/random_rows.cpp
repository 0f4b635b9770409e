// SPDX-License-Identifier: Apache-2.0
#include "random_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <sstream>

namespace test {
namespace {

using closed_form::Entry;
using closed_form::ParameterMap;
using Row = std::vector<double>;

struct Draw {
  std::mt19937_64 bits;
  double operator()(double low, double high) {  // not by the library, whose distributions differ
    return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
  }
  bool chance(double share) { return (*this)(0.0, 1.0) < share; }

  // Often near `usual`, else far from it, or so near to one of `others` that differences lose their digits.
  double number(double usual, const Row& others) {
    if (chance(0.3)) return usual;
    if (chance(0.1)) return usual + (chance(0.5) ? 1.0 : -1.0);
    if (chance(0.1)) return usual * std::pow(10.0, (*this)(-4.0, 4.0));
    if (!chance(0.1)) return usual * std::exp((*this)(-0.5, 0.5));
    const double other = others[static_cast<std::size_t>((*this)(0.0, static_cast<double>(others.size())))];
    return other * (1.0 + (chance(0.5) ? 1.0 : -1.0) * std::pow(10.0, (*this)(-15.0, -1.0)));
  }
};

Row usual_values(const Entry& entry) {
  Row values{1.0, 3.14159265358979};
  for (const auto& p : entry.parameters) values.push_back(*p.default_value);
  if (entry.has_abscissa()) values.push_back(entry.default_abscissae.back());
  return values;
}

Row random_abscissa(const Entry& entry, Draw& draw, const Row& usual) {
  if (!entry.has_abscissa()) return {};
  const auto& own = entry.default_abscissae;
  if (draw.chance(0.3)) return {draw(own.front(), own.back())};
  if (draw.chance(0.3)) return {own.back() * std::pow(10.0, draw(-15.0, 0.0))};
  return {draw.number(own[own.size() / 2], usual)};
}

/// One that the form takes; its own if it takes none of a hundred.
std::pair<ParameterMap, Row> random_row(const Entry& entry, Draw& draw) {
  const Row usual = usual_values(entry);
  for (int attempt = 0; attempt < 100; ++attempt) try {
      ParameterMap parameters;
      for (const auto& p : entry.parameters) parameters[p.name] = draw.number(*p.default_value, usual);
      const Row abscissa = random_abscissa(entry, draw, usual);
      closed_form::evaluate_rounded(entry, parameters, abscissa);
      return {parameters, abscissa};
    } catch (const std::invalid_argument&) {  // outside the validity
    }
  return {{}, Row(entry.has_abscissa() ? 1 : 0, entry.has_abscissa() ? entry.default_abscissae.back() : 0.0)};
}

std::string text_of(const Entry& entry, const ParameterMap& parameters, const Row& abscissae) {
  std::ostringstream text;
  text.precision(17);
  text << entry.name;
  for (const auto& [name, value] : parameters) text << " --set " << name << '=' << value;
  for (const double x : abscissae) text << " --times " << x;
  return text.str();
}

/// The value is within a unit of the bounds; false if they are too wide to say more.
bool expect_within(const enclosure::Bounds& bounds, double value, double within) {
  const long double low = std::strtold(bounds.lower_text.c_str(), nullptr),
                    high = std::strtold(bounds.upper_text.c_str(), nullptr);
  // The double nearest to a decimal is off by 2^-53 of it, far less than a unit of 15 digits.
  EXPECT_LE(std::max(low - value, value - high), within * (1.0L + 1e-9L) + 0x1p-53L * std::fabs(value))
      << bounds.lower_text << " to " << bounds.upper_text << ", not " << value << " within " << within;
  return high - low <= 0.01L * within || low == high;
}

}  // namespace

enclosure::Question question_of(const Entry& entry, const ParameterMap& parameters, const Row& abscissae) {
  enclosure::Question question{entry.name, {}, entry.columns, abscissae};
  if (entry.has_abscissa()) question.columns.erase(question.columns.begin());
  for (const auto& p : entry.parameters)
    question.values[p.symbol.empty() ? p.name : p.symbol] = parameters.at(p.name);
  return question;
}

PrintedCount expect_printed(const Entry& entry, const ParameterMap& given, const Row& abscissae) {
  SCOPED_TRACE(text_of(entry, given, abscissae));
  const auto table = closed_form::evaluate_rounded(entry, given, abscissae);
  Row all;
  for (const Row& row : table.rows) all.push_back(row.front());
  const auto proved =
      enclosure::prove(question_of(entry, closed_form::complete_parameters(entry, given), all));
  PrintedCount count;
  for (std::size_t c = 0; c < proved.columns.size(); ++c) {
    const auto column =
        static_cast<std::size_t>(std::ranges::find(table.columns, proved.columns[c]) - table.columns.begin());
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const double value = table.rows[i][column], within = table.within[i][column];
      count.values += expect_within(proved.rows[i][c], value, within);
      count.shortened += within > 15.0 * std::pow(10.0, 1 - entry.digits) * std::abs(value);
    }
  }
  return count;
}

PrintedCount expect_printed_at_random(int rows_of_a_form, unsigned seed) {
  Draw draw{std::mt19937_64(seed)};
  const auto refused = enclosure::formula_names();
  PrintedCount sum;
  for (const Entry& entry : closed_form::catalogue())
    for (int i = 0; i < rows_of_a_form && refused.at(entry.name).empty(); ++i) {
      const auto [parameters, abscissa] = random_row(entry, draw);
      const PrintedCount count = expect_printed(entry, parameters, abscissa);
      sum.values += count.values;
      sum.shortened += count.shortened;
    }
  return sum;
}

}  // namespace test
