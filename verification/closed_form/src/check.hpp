// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "closed_form/common.hpp"
#include "closed_form/membrane.hpp"

// Validity checks. Each returns the value, or throws std::invalid_argument, naming it and what is allowed.
namespace closed_form::check {

[[noreturn]] void refuse(std::string_view name, double value, std::string_view allowed);

double finite(std::string_view name, double value);
double positive(std::string_view name, double value);
double non_negative(std::string_view name, double value);

/// Further names and values, in this order.
template <class... More>
void finite(std::string_view name, double value, const More&... more) {
  finite(name, value);
  finite(more...);
}
template <class... More>
void positive(std::string_view name, double value, const More&... more) {
  positive(name, value);
  positive(more...);
}
template <class... More>
void non_negative(std::string_view name, double value, const More&... more) {
  non_negative(name, value);
  non_negative(more...);
}

/// low < value <= high.
double above_upto(std::string_view name, double value, double low, double high);
/// low <= value <= high.
double within(std::string_view name, double value, double low, double high);
/// low <= value < high.
double from_below(std::string_view name, double value, double low, double high);
int integer_within(std::string_view name, int value, int low, int high);

double heat_capacity_ratio(double value);
const PerfectGas& gas(const PerfectGas& gas);
/// Elastic constants and thickness; also the density if with_density.
const Sheet& sheet(const Sheet& sheet, bool with_density);

}  // namespace closed_form::check
