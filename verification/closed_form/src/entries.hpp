// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <vector>

#include "closed_form/catalogue.hpp"
#include "closed_form/common.hpp"
#include "closed_form/membrane.hpp"
#include "closed_form/pendulum.hpp"

// Building blocks of the catalogue's entries. Defaults are the reference cases of the suite.
namespace closed_form::entries {

using Parameters = std::vector<Parameter>;
using Row = std::vector<double>;

double get(const ParameterMap& values, const char* name);
/// A parameter that must be a whole number, else std::invalid_argument.
int whole(const ParameterMap& values, const char* name);
/// An abscissa that must be a whole number.
int whole_abscissa(const char* name, double value);
/// n + 1 equally spaced values.
Row range(double first, double last, int n);
Parameters joined(std::initializer_list<Parameters> lists);

Parameters gas_parameters();
PerfectGas gas_of(const ParameterMap& values);
/// For formulas without gamma: R only, and the gas with it.
Parameters gas_constant_parameter();
PerfectGas gas_of_constant(const ParameterMap& values);
/// volume, initial pressure and temperature.
Parameters tank_parameters(double volume, double pressure, double temperature);
Parameter ambient_pressure_parameter();
/// Columns of a tank's history, and its row.
std::vector<std::string> history_columns();
Row history(const GasState& state);
Parameters sheet_parameters(bool with_density);
Sheet sheet_of(const ParameterMap& values, bool with_density);
Parameters pendulum_parameters();
Pendulum pendulum_of(const ParameterMap& values);

void add_tanks(std::vector<Entry>& list);
void add_tank_tests(std::vector<Entry>& list);
void add_tank_test_readings(std::vector<Entry>& list);
void add_outflow(std::vector<Entry>& list);
void add_emptying_tanks(std::vector<Entry>& list);
void add_exchanging_tanks(std::vector<Entry>& list);
void add_bags(std::vector<Entry>& list);
void add_inflated_shapes(std::vector<Entry>& list);
void add_logarithmic_bags(std::vector<Entry>& list);
void add_discs(std::vector<Entry>& list);
void add_tension_and_waves(std::vector<Entry>& list);
void add_weave(std::vector<Entry>& list);
void add_stability(std::vector<Entry>& list);
void add_jets(std::vector<Entry>& list);
void add_jet_targets(std::vector<Entry>& list);
void add_shadows(std::vector<Entry>& list);
void add_pendulum(std::vector<Entry>& list);
void add_contact_and_coupled(std::vector<Entry>& list);

}  // namespace closed_form::entries
