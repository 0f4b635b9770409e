// SPDX-License-Identifier: Apache-2.0
#include "closed_form/catalogue.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "check.hpp"
#include "closed_form/gas.hpp"

namespace {

using namespace closed_form;
using test::expect_refused;

class CatalogueEntry : public testing::TestWithParam<std::size_t> {
 protected:
  const Entry& entry() const { return catalogue()[GetParam()]; }
};

TEST_P(CatalogueEntry, is_complete_and_evaluates) {
  const Entry& e = entry();
  SCOPED_TRACE(e.name);
  for (const std::string* text : {&e.title, &e.family, &e.equation, &e.source, &e.validity})
    EXPECT_FALSE(text->empty());
  EXPECT_GE(e.digits, 2);
  EXPECT_LE(e.digits, 17);
  std::set<std::string> names;
  for (const Parameter& p : e.parameters) {
    EXPECT_TRUE(names.insert(p.name).second) << p.name;
    EXPECT_TRUE(p.symbol.empty() || names.insert(p.symbol).second) << p.symbol;
    EXPECT_FALSE(p.unit.empty());
    EXPECT_FALSE(p.meaning.empty());
  }
  EXPECT_EQ(std::set<std::string>(e.columns.begin(), e.columns.end()).size(), e.columns.size());
  const Table table = evaluate(e);
  EXPECT_EQ(table.rows.size(), e.has_abscissa() ? e.default_abscissae.size() : 1u);
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), e.columns.size());
}

// A value to change to: 1 % off, except where that leaves the validity or the branch that depends on it.
double changed_value(const Entry& entry, const Parameter& parameter) {
  static const std::map<std::string, double> special{
      {"screen_law", 1.0}, {"stagnation", 1.0},         {"m", 2.0},
      {"n", 2.0},          {"diameters", 1.0},          {"order", 2.0},
      {"offset", 0.4},     {"omega_structure_dt", 3.0}, {"reflection", 1.99}};
  const auto it = special.find(parameter.name);
  EXPECT_TRUE(parameter.default_value.has_value()) << entry.name;
  return it == special.end() ? *parameter.default_value * 0.99 : it->second;
}

// Columns change when a parameter does: none is accepted and then forgotten.
TEST_P(CatalogueEntry, every_parameter_reaches_its_formula) {
  const Entry& e = entry();
  const Table reference = evaluate(e);
  for (const Parameter& p : e.parameters) {
    if ((e.name == "vented_fill_steady" || e.name == "proportional_blowdown") && p.name == "ambient_pressure")
      continue;  // a validity limit only
    EXPECT_NE(evaluate(e, {{p.name, changed_value(e, p)}}).rows, reference.rows) << e.name << "." << p.name;
  }
}

// Whatever is asked, the answer is a refusal that names the parameter, or numbers.
TEST_P(CatalogueEntry, extreme_parameters_are_refused_by_name_or_give_numbers) {
  const Entry& e = entry();
  for (const Parameter& p : e.parameters)
    for (const double value : {0.0, -1.0, -*p.default_value, 1e300, -1e300, 1e-300}) {
      try {
        for (const auto& row : evaluate(e, {{p.name, value}}).rows)
          for (const double x : row) EXPECT_TRUE(std::isfinite(x)) << p.name << " = " << value;
      } catch (const std::invalid_argument& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find(p.name), std::string::npos) << p.name << " = " << value << ": " << message;
      }
    }
}

// A table over time compares with a history: all of its columns are states, others are named as constants.
TEST_P(CatalogueEntry, constants_do_not_depend_on_the_abscissa_and_states_are_the_rest) {
  const Entry& e = entry();
  const Table table = evaluate(e);
  const std::set<std::string> states{"pressure_Pa", "temperature_K", "gas_mass_kg", "inflow_temperature_K"};
  for (std::size_t c = 0; c < e.columns.size(); ++c) {
    const std::string& name = e.columns[c];
    const bool same = std::ranges::all_of(table.rows, [&](auto& row) { return row[c] == table.rows[0][c]; });
    if (e.is_constant(name)) {
      EXPECT_TRUE(same && c > 0) << name;
    } else if (e.columns.front() == "time_s" && e.has_abscissa()) {
      EXPECT_TRUE(!same || states.contains(name)) << name;
    }
  }
  for (const std::string& name : e.constants)
    EXPECT_NE(std::find(e.columns.begin(), e.columns.end(), name), e.columns.end()) << name;
}

INSTANTIATE_TEST_SUITE_P(All, CatalogueEntry, testing::Range(std::size_t{0}, catalogue().size()),
                         [](const auto& tested) { return catalogue()[tested.param].name; });

TEST(Catalogue, names_are_unique_and_more_than_forty) {
  std::set<std::string> names;
  for (const Entry& e : catalogue()) EXPECT_TRUE(names.insert(e.name).second) << e.name;
  EXPECT_GE(names.size(), 40u);
}

TEST(Catalogue, row_eq_closed_form_and_symbols_name_parameters) {
  const std::vector<double> times{0.0, 0.02, 0.05};
  const Entry& entry = find_entry("tank_fill");
  const Table table = evaluate(entry, {{"V", 0.03}, {"inflow_temperature", 900.0}}, times);
  ASSERT_EQ(table.rows.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const GasState s = tank_fill({{}, 0.03, 101325.0, 293.15, 1.0, 900.0}, times[i]);
    EXPECT_EQ(table.rows[i], (std::vector<double>{times[i], s.pressure, s.temperature, s.mass}));
  }
  EXPECT_EQ(table.columns,
            (std::vector<std::string>{"time_s", "pressure_Pa", "temperature_K", "gas_mass_kg"}));
}

TEST(Catalogue, bad_requests_are_refused_by_name) {
  const Entry& fill = find_entry("tank_fill");
  expect_refused([] { find_entry("tank_fil"); }, "tank_fill, tank_fill_pulse");
  expect_refused([] { find_entry("tank_fil"); }, "; is 'tank_fill' meant?");
  EXPECT_THROW(find_entry(std::string(100000, 'x')), std::invalid_argument);
  expect_refused([&] { evaluate(fill, {{"volum", 1.0}}); }, "volum; allowed: gas_constant");
  expect_refused([&] { evaluate(fill, {{"volume", -1.0}}); }, "volume = -1");
  expect_refused([&] { evaluate(fill, {{"V", 1.0}, {"volume", 1.0}}); }, "given twice");
  expect_refused([&] { evaluate(fill, {{"volume", NAN}}); }, "volume");
  expect_refused([&] { evaluate(fill, {}, std::vector<double>{NAN}); }, "time_s");
  expect_refused([&] { evaluate(fill, {}, std::vector<double>{-1.0}); }, "time");
  expect_refused([] { evaluate(find_entry("drum_frequency"), {{"order", 1.5}}); }, "order");
  expect_refused([] { evaluate(find_entry("blowdown_times"), {}, std::vector<double>{1.0}); }, "abscissa");
  Entry needy = fill;
  needy.parameters[2].default_value.reset();
  expect_refused([&] { evaluate(needy); }, "missing parameter volume [m3]");
}

}  // namespace
