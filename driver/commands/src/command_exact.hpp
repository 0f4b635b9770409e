// SPDX-License-Identifier: Apache-2.0
// What `gasjet exact` and `gasjet exact --proved` share.
#pragma once

#include "closed_form/catalogue.hpp"

namespace driver::commands {

/// Parameters of `--set name=value`. Throws CaseError for one that is no number or given twice.
closed_form::ParameterMap parse_parameters(const std::vector<std::string>& texts);

/// The columns of a printed table: those that depend on the abscissa.
std::vector<std::string> table_columns(const closed_form::Entry& entry);

}  // namespace driver::commands
