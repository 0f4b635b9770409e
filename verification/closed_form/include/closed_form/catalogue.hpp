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

/// One number that an entry takes.
struct Parameter {
  std::string name;                     // long name, as `--set name=value`
  std::string symbol;                   // short form, accepted as well; may be empty
  std::string unit;                     // SI; "1" when dimensionless
  std::optional<double> default_value;  // none: must be given
  std::string meaning;                  // with what is allowed
};

/// One closed form: what it is, and how to evaluate a row of it.
struct Entry {
  std::string name;                       // unique, snake_case
  std::string title;                      // one line for the list
  std::string equation;                   // plain text
  std::string source;                     // author and year, or "derived here"
  std::string validity;                   // range of the parameters; beyond it evaluate() refuses
  int digits = 0;                         // correct significant digits of the values
  std::vector<Parameter> parameters;      // in the order of the documentation
  std::vector<std::string> columns;       // names with unit suffix; the first is the abscissa if there is one
  std::vector<double> default_abscissae;  // empty: the entry has no abscissa and one row
  /// Values of columns (without the abscissa) at one abscissa; the map is complete.
  std::function<std::vector<double>(const ParameterMap&, double abscissa)> values;
  std::string family = {};  // gas, outflow, membrane, stability, jet, pendulum or coupled

  /// True if its rows run over an abscissa, such as time.
  bool has_abscissa() const { return !default_abscissae.empty(); }
};

/// What evaluate() gives.
struct Table {
  std::vector<std::string> columns;       // names with unit suffix
  std::vector<std::vector<double>> rows;  // rows[i].size() == columns.size()
};

/// All entries, sorted by family in the order of the documentation. Built once, thread-safe.
const std::vector<Entry>& catalogue();

/// Entry of that name; std::invalid_argument lists the names there are.
const Entry& find_entry(std::string_view name);

/// Complete map: defaults overwritten by given (long names or symbols). std::invalid_argument names an
/// unknown, doubly given, missing or non-finite parameter and says what is allowed.
ParameterMap complete_parameters(const Entry& entry, const ParameterMap& given);

/// Rows at abscissae (empty: the entry's own). std::invalid_argument for abscissae given to an entry without
/// one, for bad parameters as above, and for out-of-validity values as the closed form itself says, with the
/// parameters that were given; never a NaN out.
Table evaluate(const Entry& entry, const ParameterMap& given = {}, std::span<const double> abscissae = {});

}  // namespace closed_form
