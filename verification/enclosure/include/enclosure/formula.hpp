// SPDX-License-Identifier: Apache-2.0
// Proved values of closed forms (docs/theory/enclosure.md).
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "enclosure/enclose.hpp"

namespace enclosure {

/// What is asked for of a closed form.
struct Question {
  std::string name;                      // of the closed form
  std::map<std::string, double> values;  // of its parameters, exact; by all names that they have
  std::vector<std::string> columns;      // names with unit suffix, without the abscissa
  std::vector<double> abscissae;         // exact; one of any value if the form has none
};

/// Columns that are proved, and why others are not.
struct ProvedForm {
  std::vector<std::string> columns;
  std::map<std::string, std::string> refused;  // reason by column
  std::vector<std::vector<Bounds>> rows;       // one for each abscissa, a value for each column
  /// Row and column of bounds wider than 1e-20 of the value: as far as they are known, or infinite.
  std::vector<std::pair<std::size_t, std::size_t>> wide;
};

/// Encloses the values of a formula of the folder `formulas`. The parameters must be within the validity of
/// the form. Throws Refusal for a form that has no formula, with the reason.
ProvedForm prove(const Question& question);

/// Names of all forms in `formulas`, with the reason why one is refused; empty: it is not.
std::map<std::string, std::string> formula_names();

}  // namespace enclosure
