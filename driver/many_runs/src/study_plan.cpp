// SPDX-License-Identifier: Apache-2.0
#include "study_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "base/csv_table.hpp"
#include "base/run_id.hpp"
#include "base/text_file.hpp"
#include "engine/columns.hpp"
#include "engine/scene.hpp"
#include "many_runs/ensemble.hpp"
#include "many_runs/quantities.hpp"
#include "study_inputs.hpp"

namespace driver {
namespace {

// Each column of a table has a name of its own.
void check_names(TableReader& root, const StudyPlan& plan) {
  std::set<std::string> columns{"point",    "seed",     "status",   "steps",          "message",
                                "cpu_s",    "quantity", "mean",     "standard_error", "runs",
                                "left_out", "mean_low", "mean_high"};
  if (plan.base) columns.insert({"difference", "difference_standard_error", "pairs"});
  if (plan.analysis.convergence) columns.insert({"limit", "order", "coefficient", "residual", "sizes"});
  columns.insert(plan.quantities.begin(), plan.quantities.end());
  auto tables = root.tables("factor");
  for (std::size_t f = 0; f < tables.size(); ++f)
    if (columns.contains(plan.factors[f].name))
      tables[f].fail(tables[f].has("name") ? "name" : "key",
                     fmt::format("is \"{}\", which is another column of the results: use another name",
                                 plan.factors[f].name));
}

// Why the case is refused at a point; empty if it is not.
std::string refusal(const StudyPlan& plan, const StudyPoint& point) {
  try {
    study_scene(plan, study_overrides(plan, point));
  } catch (const CaseError& error) {
    return error.what();
  }
  return {};
}

// Of a point, in the file that it comes from.
[[noreturn]] void refuse_factor(const TableReader& table, const StudyPlan& plan, std::size_t factor,
                                std::size_t point, double value, const std::string& why) {
  const std::string message =
      fmt::format("with \"{}\" the case is refused: {}", plan.factors[factor].name_of(value), why);
  if (!plan.points_file.empty())
    read_csv(plan.points_file, {plan.factors[factor].name}).fail(0, point, message);
  table.fail("", message);
}

// A fault of the first point is that of the first factor with which the case is refused.
void check_first_point(std::vector<TableReader>& tables, const StudyPlan& plan) {
  if (refusal(plan, plan.points.front()).empty()) return;
  StudyPoint point;
  for (std::size_t f = 0; f < tables.size(); ++f) {
    point.push_back(plan.points.front()[f]);
    if (const auto why = refusal(plan, point); !why.empty())
      refuse_factor(tables[f], plan, f, 0, point[f], why);
  }
}

// The points that take one factor to its ends, the others as at the first point.
void check_points(TableReader& root, const StudyPlan& plan) {
  auto tables = root.tables("factor");
  check_first_point(tables, plan);
  for (std::size_t f = 0; f < plan.factors.size(); ++f) {
    std::vector<std::pair<double, std::size_t>> values;  // with a point that has it
    for (std::size_t i = 0; i < plan.factors[f].levels.size(); ++i)
      values.emplace_back(static_cast<double>(i), 0);
    if (values.empty()) {
      const auto [low, high] =
          std::ranges::minmax_element(plan.points, {}, [&](const StudyPoint& point) { return point[f]; });
      for (const auto& end : {low, high})
        values.emplace_back((*end)[f], static_cast<std::size_t>(end - plan.points.begin()));
    }
    StudyPoint point = plan.points.front();
    for (const auto& [value, number] : values) {
      point[f] = value;
      if (const auto why = refusal(plan, point); !why.empty())
        refuse_factor(tables[f], plan, f, number, value, why);
    }
  }
}

// A level's file may be read only with levels of others: no check of one factor meets it.
void note_files(const StudyPlan& plan) {
  for (const auto& factor : plan.factors)
    for (const auto& level : factor.levels) {
      auto overrides = plan.overrides;
      overrides.insert(overrides.end(), level.overrides.begin(), level.overrides.end());
      try {
        plan.inputs->check(CaseDocument(plan.case_file, overrides).named_files());
      } catch (const FileError&) {
        throw;
      } catch (const CaseError&) {  // what it changes is there with levels of others alone
      }
    }
}

std::vector<std::string> quantities_of(TableReader& table, const Scene& scene) {
  auto names = quantity_names(scene);
  const auto given = table.at("quantities").texts();
  if (given.empty()) return names;
  for (const auto& column : history_columns(scene)) names.push_back(column.name);
  const std::string shown = fmt::format("{}", fmt::join(names, ", "));
  for (auto& name : history_quantities(scene)) names.push_back(std::move(name));
  for (const auto& name : given)
    if (std::ranges::find(names, name) == names.end())
      table.fail("quantities",
                 fmt::format("has \"{}\", which the scene does not have; allowed: {}, and max(), min() "
                             "and integral() of a column of the history",
                             name, shown));
  for (auto name = given.begin(); name != given.end(); ++name)
    if (std::find(given.begin(), name, *name) != name)
      table.fail("quantities", fmt::format("has \"{}\" twice", *name));
  return given;
}

void check_perturbation(TableReader& table, const StudyPlan& plan, const Scene& scene) {
  if (plan.seeds == 0) return;
  if (!scene.bag) table.fail("seeds", "perturb the nodes of a membrane, but the scene has none");
  refuse_perturbation(table, "set", plan.overrides);
}

// The case with what the plan changes in it, a refusal of which is told at its place.
Scene base_scene(const TableReader& table, const StudyPlan& plan) {
  try {
    return study_scene(plan, plan.overrides);
  } catch (const CaseError& error) {
    const std::string why = error.what();
    for (const std::string key : {"set", "unset"})
      if (why.starts_with("--" + key)) table.fail(key, why.substr(key.size() + 3));
    throw;
  }
}

// Of the plan as it is, the case with its overrides and the files that both name.
void set_id(const CaseDocument& document, StudyPlan& plan) {
  const auto text = [](const CaseDocument& one) {
    const auto folder = one.file().parent_path();
    return one.text(folder.empty() ? "." : folder);
  };
  std::vector<std::string> facts{"study", text(document), text(CaseDocument(plan.case_file, plan.overrides))};
  plan.inputs->check_all();
  for (const auto& [file, digits] : plan.inputs->list()) facts.push_back(digits);
  plan.id = run_id(facts, {});
}

}  // namespace

StudyPlan read_study(const std::filesystem::path& file) {
  StudyPlan plan;
  plan.file = file;
  plan.text = read_text(file);
  plan.inputs = std::make_shared<StudyInputs>();
  CaseDocument document = CaseDocument::of_text(plan.text, file, {});
  TableReader root = document.root();
  root.allow_only({"analysis", "correlation", "factor", "limit", "stop", "study"});
  TableReader table = root.table("study");
  table.allow_only({"amplitude", "case", "design", "file", "name", "points", "quantities", "sampling_seed",
                    "seeds", "set", "unset"});
  plan.name = file_name(table, "name", file.stem().string());
  plan.case_file = table.beside_case(table.at("case").text());
  plan.overrides = read_overrides(table);
  plan.seeds = table.at("seeds").integer(0, 1'000'000, 0);
  plan.amplitude = table.at("amplitude").number(small_length, default_amplitude);
  read_factors(root, plan);
  read_correlations(root, plan);
  check_perturbation(table, plan, base_scene(table, plan));
  table.located("", [&] { plan.points = points_of(table, plan); });
  check_points(root, plan);
  note_files(plan);
  plan.quantities = quantities_of(table, study_scene(plan, study_overrides(plan, plan.points.front())));
  table.finish();
  read_analysis(root, plan);
  read_limits(root, plan);
  check_names(root, plan);
  root.finish();
  set_id(document, plan);
  return plan;
}

}  // namespace driver
