// SPDX-License-Identifier: Apache-2.0
#include "enclosure/formula.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "bounds.hpp"
#include "expression.hpp"
#include "formula_texts.hpp"

namespace enclosure {
namespace {

/// A form as its text has it.
struct Form {
  std::string abscissa;  // empty: none
  std::string refusal;   // reason; empty: none
  std::vector<std::string> equations;
  std::map<std::string, std::string> refused;  // columns, with the reason
};

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// The name before a colon, and what comes after it.
std::pair<std::string, std::string> split(const std::string& line) {
  const auto colon = line.find(':');
  return {trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1))};
}

/// Reads the texts: `name(abscissa):` or `name:` begins a form, `name: reason` refuses one. Indented lines
/// are its equations or `column: reason`; a line indented further goes on with the one before.
std::map<std::string, Form> read_forms() {
  std::map<std::string, Form> forms;
  Form* form = nullptr;
  std::istringstream lines(formula_texts);
  for (std::string line; std::getline(lines, line);) {
    if (trimmed(line).empty() || line[0] == '#') continue;
    if (line[0] != ' ') {
      auto [head, reason] = split(line);
      const auto open = head.find('(');
      form = &forms[head.substr(0, open)];
      if (open != std::string::npos) form->abscissa = head.substr(open + 1, head.size() - open - 2);
      form->refusal = reason;
    } else if (line.starts_with("    ")) {
      form->equations.back().append(1, ' ').append(trimmed(line));
    } else if (line.find('=') == std::string::npos) {
      form->refused.insert(split(line));
    } else {
      form->equations.push_back(trimmed(line));
    }
  }
  return forms;
}

const std::map<std::string, Form>& forms() {
  static const std::map<std::string, Form> all = read_forms();
  return all;
}

/// Numbers of a form at one abscissa.
class Evaluation {
 public:
  Evaluation(const Form& form, const Question& question) {
    for (const auto& [name, value] : question.values) inputs_.emplace_back(reader_.declare(name), value);
    if (!form.abscissa.empty()) abscissa_ = reader_.declare(form.abscissa);
    for (const std::string& equation : form.equations) reader_.read(equation);
  }

  std::vector<Ball> at(double abscissa, const std::vector<std::string>& columns) const {
    Workspace w{std::vector<Complex>(reader_.slots())};
    for (const auto& [slot, value] : inputs_) w.values[slot] = value;
    if (abscissa_) w.values[*abscissa_] = abscissa;
    for (const Equation& equation : reader_.equations()) w.values[equation.slot] = equation.value(w);
    std::vector<Ball> row;
    for (const std::string& column : columns) row.push_back(real(w.values[reader_.slot(column)]));
    return row;
  }

 private:
  /// The formula's value is real: what a rectangle spans besides is rounding.
  static Ball real(const Complex& z) {
    Ball x;
    if (acb_is_finite(z.get()) && arb_contains_zero(acb_imagref(z.get())))
      arb_set(x.get(), z.real());
    else
      arb_indeterminate(x.get());
    return x;
  }

  Reader reader_;
  std::vector<std::pair<std::size_t, double>> inputs_;
  std::optional<std::size_t> abscissa_;
};

/// Its ends agree to 1e-20 of the number.
bool is_narrow(const Ball& x) {
  return arb_rel_accuracy_bits(x.get()) >= 68;
}

/// Nothing tells it from 0.
bool is_zero(const Ball& x) {
  return x.is_finite() && arb_contains_zero(x.get()) && x.radius() <= 5e-26;
}

/// Of each column the narrowest ball.
std::vector<Ball> narrow_row(const Evaluation& evaluation, double abscissa,
                             const std::vector<std::string>& columns) {
  std::vector<Ball> row;
  for (complex_bits = 192; complex_bits <= 1536; complex_bits *= 2) {
    auto next = evaluation.at(abscissa, columns);
    row.resize(next.size());
    for (std::size_t c = 0; c < row.size(); ++c)
      if (complex_bits == 192 || !is_narrow(row[c])) row[c] = std::move(next[c]);
    if (std::ranges::all_of(row, is_narrow)) break;
  }
  return row;
}

}  // namespace

ProvedForm prove(const Question& question) {
  const auto it = forms().find(question.name);
  if (it == forms().end()) throw Refusal("has no formula in ball arithmetic");
  const Form& form = it->second;
  if (!form.refusal.empty()) throw Refusal(form.refusal);
  ProvedForm proved;
  for (const std::string& column : question.columns) {
    const auto refused = form.refused.find(column);
    if (refused == form.refused.end())
      proved.columns.push_back(column);
    else
      proved.refused.insert(*refused);
  }
  const Evaluation evaluation(form, question);
  for (const double abscissa : question.abscissae) {
    auto& row = proved.rows.emplace_back();
    for (const Ball& x : narrow_row(evaluation, abscissa, proved.columns)) {
      if (!is_narrow(x) && !is_zero(x)) proved.wide.push_back({proved.rows.size() - 1, row.size()});
      row.push_back(bounds(x));
    }
  }
  return proved;
}

std::map<std::string, std::string> formula_names() {
  std::map<std::string, std::string> names;
  for (const auto& [name, form] : forms()) names.emplace(name, form.refusal);
  return names;
}

}  // namespace enclosure
