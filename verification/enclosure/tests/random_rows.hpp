// SPDX-License-Identifier: Apache-2.0
// Rows of closed forms at random parameters, everyday and extreme, against their bounds.
#pragma once

#include "closed_form/catalogue.hpp"
#include "enclosure/formula.hpp"

namespace test {

/// The question for the bounds of an entry at complete parameters.
enclosure::Question question_of(const closed_form::Entry& entry, const closed_form::ParameterMap& parameters,
                                const std::vector<double>& abscissae);

/// Values printed and values with two digits or more less than the form states.
struct PrintedCount {
  int values = 0, shortened = 0;
};

/// Each printed value of these rows is within one unit of its last digit of the bounds.
PrintedCount expect_printed(const closed_form::Entry& entry, const closed_form::ParameterMap& given,
                            const std::vector<double>& abscissae);

/// The same of so many random rows of each form that has bounds.
PrintedCount expect_printed_at_random(int rows_of_a_form, unsigned seed);

}  // namespace test
