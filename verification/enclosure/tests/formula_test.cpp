// SPDX-License-Identifier: Apache-2.0
// The closed forms of the catalogue against their formulas in ball arithmetic.
#include "enclosure/formula.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "random_rows.hpp"

namespace {

using closed_form::Entry;
using closed_form::ParameterMap;
using Row = std::vector<double>;

using test::question_of;

/// Abscissae of the form's own, the first and the last among them.
Row some_abscissae(const Entry& entry, std::size_t count) {
  const auto& all = entry.default_abscissae;
  Row some;
  for (std::size_t i = 0; i < count && entry.has_abscissa(); ++i)
    some.push_back(all[i * (all.size() - 1) / (count - 1)]);
  some.erase(std::unique(some.begin(), some.end()), some.end());
  return some;
}

/// What a number that is correct to so many digits may be off by: half a unit of the last of them.
double half_a_unit(double value, int digits) {
  return 0.5 * std::pow(10.0, std::floor(std::log10(std::abs(value))) + 1 - digits);
}

/// The printed values are within the bounds, or off by what their digits leave open. A value of which the
/// bounds leave open whether it is 0 has the digits of the largest in its column.
void expect_digits(const Entry& entry, const ParameterMap& given, const Row& abscissae) {
  const auto table = closed_form::evaluate(entry, given, abscissae);
  const auto parameters = closed_form::complete_parameters(entry, given);
  const auto proved =
      enclosure::prove(question_of(entry, parameters, entry.has_abscissa() ? abscissae : Row{0.0}));
  ASSERT_EQ(proved.rows.size(), table.rows.size());
  for (std::size_t c = 0; c < proved.columns.size(); ++c) {
    const auto column =
        static_cast<std::size_t>(std::ranges::find(table.columns, proved.columns[c]) - table.columns.begin());
    double largest = 0.0;
    for (const auto& row : table.rows) largest = std::max(largest, std::abs(row[column]));
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const double value = table.rows[i][column];
      const auto& b = proved.rows[i][c];
      const bool may_be_0 = b.lower <= 0.0 && b.upper >= 0.0;
      // A double on each side, and what the bounds themselves leave open.
      EXPECT_LE(b.upper - b.lower, 4.5e-16 * std::abs(value) + 1e-25) << proved.columns[c];
      if (b.lower <= value && value <= b.upper) continue;
      EXPECT_LE(std::max(b.lower - value, value - b.upper),
                half_a_unit(may_be_0 ? largest : value, entry.digits))
          << proved.columns[c] << " in row " << i << ": " << value << " is not in " << b.lower_text << " to "
          << b.upper_text;
    }
  }
}

// Each form has a formula or a reason why not.
TEST(formula, digits_of_the_catalogue_are_proved) {
  const auto refused = enclosure::formula_names();
  EXPECT_EQ(refused.size(), closed_form::catalogue().size());
  for (const Entry& entry : closed_form::catalogue()) {
    SCOPED_TRACE(entry.name);
    ASSERT_TRUE(refused.contains(entry.name));
    if (!refused.at(entry.name).empty())
      EXPECT_THROW(enclosure::prove({entry.name, {}, {}, {}}), enclosure::Refusal);
    else
      EXPECT_NO_THROW(expect_digits(entry, {}, some_abscissae(entry, 6)));
  }
}

/// One parameter changed: by 1 %, or to the next whole number.
ParameterMap changed(const Entry& entry, const closed_form::Parameter& p) {
  const double value = *p.default_value;
  for (const double other : {0.99 * value, value - 1.0, value + 1.0}) try {
      if (other == value) continue;
      closed_form::evaluate(entry, {{p.name, other}}, some_abscissae(entry, 2));
      return {{p.name, other}};
    } catch (const std::invalid_argument&) {  // the form has another validity
    }
  return {};
}

// So every parameter stands where the form has it.
TEST(formula, digits_are_proved_for_changed_parameters) {
  const auto refused = enclosure::formula_names();
  for (const Entry& entry : closed_form::catalogue())
    for (const auto& p : entry.parameters) {
      if (!refused.at(entry.name).empty()) continue;
      SCOPED_TRACE(entry.name + " " + p.name);
      const ParameterMap given = changed(entry, p);
      EXPECT_FALSE(given.empty());
      EXPECT_NO_THROW(expect_digits(entry, given, some_abscissae(entry, 2)));
    }
}

}  // namespace
