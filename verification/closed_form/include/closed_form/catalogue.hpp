// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace closed_form {

/// Parameter values by long name.
using ParameterMap = std::map<std::string, double, std::less<>>;

/// A parameter of an entry.
struct Parameter {
  std::string name;                     // long name, as in `--set name=value`
  std::string symbol;                   // short name, accepted as well; may be empty
  std::string unit;                     // SI; "1" when dimensionless
  std::optional<double> default_value;  // none: must be given
  std::string meaning;                  // with the range allowed
};

/// One closed form: its description, and how to compute a row of it.
struct Entry {
  std::string name;      // unique, snake_case
  std::string title;     // one line for the list
  std::string equation;  // plain text
  std::string source;    // author and year, or "derived here"
  /// Range of the parameters; evaluate() refuses values outside.
  std::string validity;
  int digits = 0;                     // significant digits that are correct
  std::vector<Parameter> parameters;  // in the order of the documentation
  /// Names with unit suffix. The first one is the abscissa, if there is one.
  std::vector<std::string> columns;
  /// Empty: the entry has no abscissa and one row.
  std::vector<double> default_abscissae;
  /// Values of the columns, without the abscissa, at one abscissa. The map is complete.
  std::function<std::vector<double>(const ParameterMap&, double abscissa)> values;
  /// Columns that do not depend on the abscissa, as the time of an end: no part of a history.
  std::vector<std::string> constants = {};
  std::string family = {};  // gas, outflow, membrane, stability, jet, pendulum or coupled

  /// True if the rows run over an abscissa, such as time.
  bool has_abscissa() const { return !default_abscissae.empty(); }
  /// True if the column is among the constants.
  bool is_constant(const std::string& column) const;
};

/// Result of evaluate().
struct Table {
  std::vector<std::string> columns;       // names with unit suffix
  std::vector<std::vector<double>> rows;  // rows[i].size() == columns.size()
};

/// All entries, sorted by family in the order of the documentation. Built once; thread-safe.
const std::vector<Entry>& catalogue();

/// The entry `name`. Throws std::invalid_argument, listing the names, if there is none.
const Entry& find_entry(std::string_view name);

/// Complete map: the defaults, replaced by those given (by long name or symbol). Throws std::invalid_argument
/// for a parameter that is unknown, given twice, missing or not finite, and says what is allowed.
ParameterMap complete_parameters(const Entry& entry, const ParameterMap& given);

/// Rows of an entry at the abscissae (empty: the entry's own). Never returns a NaN. Throws
/// std::invalid_argument for
/// - abscissae given to an entry without one,
/// - bad parameters as above,
/// - values outside the validity, as the closed form reports them, with the parameters given.
Table evaluate(const Entry& entry, const ParameterMap& given = {}, std::span<const double> abscissae = {});

/// Values without the digits that rounding spoils.
struct RoundedTable : Table {
  /// A unit of the last digit of each value, a power of ten: the exact value is within it. 0: no rounding
  /// took part, as of the abscissa.
  std::vector<std::vector<double>> within;
};

/// The rows of evaluate(), with the digits that are left and at most Entry::digits of them; 0 where none is.
/// Each row is computed four times, every operation rounded to nearest, up, down and toward zero: the spread
/// estimates what rounding does. Where the machine has one rounding only, Entry::digits are taken as left.
/// Throws as evaluate(), and for a number on the way that overflows.
RoundedTable evaluate_rounded(const Entry& entry, const ParameterMap& given = {},
                              std::span<const double> abscissae = {});

}  // namespace closed_form
