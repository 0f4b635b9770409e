// SPDX-License-Identifier: Apache-2.0
#include "check.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace closed_form::check {
namespace {

std::string interval(char open, double low, double high, char close) {
  std::ostringstream text;
  text.precision(10);
  text << "must lie in " << open << low << ", " << high << close;
  return text.str();
}

}  // namespace

void refuse(std::string_view name, double value, std::string_view allowed) {
  std::ostringstream text;
  text.precision(17);
  text << name << " = " << value << ": " << allowed;
  if (std::isnan(value)) text << " (not given)";
  throw std::invalid_argument(text.str());
}

double finite(std::string_view name, double value) {
  if (!std::isfinite(value)) refuse(name, value, "must be finite");
  return value;
}

double positive(std::string_view name, double value) {
  if (!(std::isfinite(value) && value > 0.0)) refuse(name, value, "must be finite and > 0");
  return value;
}

double non_negative(std::string_view name, double value) {
  if (!(std::isfinite(value) && value >= 0.0)) refuse(name, value, "must be finite and >= 0");
  return value;
}

double above_upto(std::string_view name, double value, double low, double high) {
  if (!(value > low && value <= high)) refuse(name, value, interval('(', low, high, ']'));
  return value;
}

double within(std::string_view name, double value, double low, double high) {
  if (!(value >= low && value <= high)) refuse(name, value, interval('[', low, high, ']'));
  return value;
}

double from_below(std::string_view name, double value, double low, double high) {
  if (!(value >= low && value < high)) refuse(name, value, interval('[', low, high, ')'));
  return value;
}

int integer_within(std::string_view name, int value, int low, int high) {
  if (value < low || value > high) refuse(name, value, interval('[', low, high, ']'));
  return value;
}

double heat_capacity_ratio(double value) {
  if (!(value > 1.0 && value < 3.0)) refuse("heat_capacity_ratio", value, interval('(', 1.0, 3.0, ')'));
  return value;
}

const PerfectGas& gas(const PerfectGas& gas) {
  positive("gas_constant", gas.gas_constant);
  heat_capacity_ratio(gas.heat_capacity_ratio);
  return gas;
}

const Sheet& sheet(const Sheet& sheet, bool with_density) {
  positive("young_modulus", sheet.young_modulus);
  above_upto("poisson_ratio", sheet.poisson_ratio, -1.0, 0.5);
  positive("thickness", sheet.thickness);
  if (with_density) positive("density", sheet.density);
  return sheet;
}

}  // namespace closed_form::check
