// SPDX-License-Identifier: Apache-2.0
#include "claim.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <set>
#include <sstream>

namespace claim {

namespace {

std::string number(double value) {
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

// Columns, one tab apart: kind (near, order, threshold), test, source file, tag, what, why, then
// near: computed, exact, tolerance; order: errors (spaces between), orders, low, high;
// threshold: failure, formula, predicted, measured, unit, low, high, past.
void write_row(const char* kind, const Claim& claim, const Where& where,
               std::initializer_list<std::string> values) {
  const char* folder = std::getenv("GASJET_CLAIMS");
  if (folder == nullptr) return;
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  std::string test = info->test_suite_name();
  test.append(1, '.').append(info->name());
  std::string file = where.file;
  file.erase(0, file.rfind("verification/"));
  std::string name = test;
  for (char& c : name)
    if (c == '/') c = '_';
  static std::set<std::string> begun;  // by this process; a file of an earlier one is replaced
  const auto mode = begun.insert(name).second ? std::ios::trunc : std::ios::app;
  std::ofstream out(std::filesystem::path(folder) / name.append(".tsv"), mode);
  out << kind << '\t' << test << '\t' << file << '\t' << claim.equation << '\t' << claim.what << '\t'
      << claim.why;
  for (const auto& value : values) out << '\t' << value;
  out << '\n';
  if (!out.flush()) ADD_FAILURE() << "cannot write to the folder of GASJET_CLAIMS, " << folder;
}

}  // namespace

void expect_near(const Claim& claim, double computed, double exact, double tolerance, Where where) {
  if (!(std::abs(computed - exact) <= tolerance))
    ADD_FAILURE_AT(where.file, where.line)
        << claim.what << ": " << number(computed) << ", exact " << number(exact) << ", differs by "
        << std::abs(computed - exact) << ", allowed " << tolerance;
  write_row("near", claim, where, {number(computed), number(exact), number(tolerance)});
}

void expect_relative(const Claim& claim, double computed, double exact, double tolerance, Where where) {
  expect_near(claim, computed, exact, tolerance * std::abs(exact), where);
}

void expect_order(const Claim& claim, const std::vector<double>& errors, double low, double high,
                  double ratio, Where where) {
  if (errors.size() < 3) ADD_FAILURE_AT(where.file, where.line) << "an order needs three errors";
  std::ostringstream orders, all;
  orders.precision(17);
  all.precision(17);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    all << (i == 0 ? "" : " ") << errors[i];
    if (i == 0) continue;
    const double order = std::log(errors[i - 1] / errors[i]) / std::log(ratio);
    orders << (i == 1 ? "" : " ") << order;
    if (!(order > low && order < high))
      ADD_FAILURE_AT(where.file, where.line)
          << claim.what << ": order " << order << " from error " << errors[i - 1] << " to " << errors[i]
          << ", allowed " << low << " to " << high;
  }
  write_row("order", claim, where, {all.str(), orders.str(), number(low), number(high)});
}

void expect_threshold(const Claim& claim, const Threshold& t, double low, double high, Where where) {
  const double ratio = t.measured / t.predicted;
  if (!(ratio >= low && ratio <= high))
    ADD_FAILURE_AT(where.file, where.line)
        << t.failure << ": measured " << t.measured << " " << t.unit << ", predicted " << t.predicted
        << ", ratio " << ratio << ", allowed " << low << " to " << high;
  write_row("threshold", claim, where,
            {t.failure, t.formula, number(t.predicted), number(t.measured), t.unit, number(low), number(high),
             t.past});
}

}  // namespace claim
