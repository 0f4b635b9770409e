// SPDX-License-Identifier: Apache-2.0
// The tables of a study.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "driver/study_analysis.hpp"
#include "study/parts.hpp"

namespace driver {
namespace {

// Quotes only where a comma, a quote or a line end needs them (RFC 4180).
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c == '\n' || c == '\r' ? ' ' : c);
  return quoted + '"';
}

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : std::string();
}

std::string factor_names(const StudyPlan& plan) {
  std::string names;
  for (const auto& factor : plan.factors) names += ',' + cell(factor.name);
  return names;
}

std::string inputs(const StudyPlan& plan, std::size_t point) {
  std::string cells;
  for (const auto& level : plan.points[point].levels) cells += ',' + cell(level.name);
  return cells;
}

std::string results_text(const StudyPlan& plan, const StudyRuns& runs) {
  std::string csv = "point,seed" + factor_names(plan);
  for (const auto& name : plan.quantities) csv += ',' + name;
  csv += ",status,steps,message\n";
  for (const auto& [number, run] : runs) {
    const std::size_t point = point_of(plan, number);
    fmt::format_to(std::back_inserter(csv), "{},{}{}", point, seed_of(plan, number), inputs(plan, point));
    for (const auto& value : run.values) csv += ',' + cell(value);
    fmt::format_to(std::back_inserter(csv), ",{},{},{}\n", run.status, run.steps, cell(run.message));
  }
  return csv;
}

std::string timing_text(const StudyPlan& plan, const StudyRuns& runs) {
  std::string csv = "point,seed,steps,cpu_s\n";
  for (const auto& [number, run] : runs)
    fmt::format_to(std::back_inserter(csv), "{},{},{},{}\n", point_of(plan, number), seed_of(plan, number),
                   run.steps, run.cpu_seconds);
  return csv;
}

std::vector<double> list_of(const std::map<int, double>& values) {
  std::vector<double> list;
  for (const auto& [seed, value] : values) list.push_back(value);
  return list;
}

// A standard error of one run is not known: an empty cell.
std::string statistics_cells(const Statistics& s) {
  return fmt::format("{},{},{}", s.count > 0 ? cell(std::optional(s.mean)) : "",
                     s.count > 1 ? cell(std::optional(s.standard_error)) : "", s.count);
}

std::string means_text(const StudyPlan& plan, const StudyRuns& runs) {
  std::string csv = "point" + factor_names(plan) + ",quantity,mean,standard_error,runs";
  if (plan.base) csv += ",difference,difference_standard_error,pairs";
  csv += '\n';
  for (std::size_t p = 0; p < plan.points.size(); ++p)
    for (std::size_t q = 0; q < plan.quantities.size(); ++q) {
      csv += fmt::format("{}{},{},{}", p, inputs(plan, p), plan.quantities[q],
                         statistics_cells(statistics(list_of(values_at(plan, runs, p, q)))));
      if (plan.base) csv += ',' + statistics_cells(statistics(differences(plan, runs, p, q)));
      csv += '\n';
    }
  return csv;
}

// The mean over the seeds of each point.
std::vector<std::optional<double>> point_means(const StudyPlan& plan, const StudyRuns& runs, std::size_t q) {
  std::vector<std::optional<double>> means;
  for (std::size_t p = 0; p < plan.points.size(); ++p) {
    const auto values = list_of(values_at(plan, runs, p, q));
    means.push_back(values.empty() ? std::nullopt : std::optional(statistics(values).mean));
  }
  return means;
}

std::string sobol_text(const StudyPlan& plan, const StudyRuns& runs) {
  std::string csv =
      "quantity,factor,first_order,first_order_low,first_order_high,total,total_low,total_high\n";
  for (std::size_t q = 0; q < plan.quantities.size(); ++q) {
    const auto list = sobol_indices(point_means(plan, runs, q), static_cast<int>(plan.factors.size()));
    for (std::size_t f = 0; f < list.size(); ++f)
      csv += fmt::format("{},{},{},{},{},{},{},{}\n", plan.quantities[q], cell(plan.factors[f].name),
                         list[f].first_order.value, list[f].first_order.low, list[f].first_order.high,
                         list[f].total.value, list[f].total.low, list[f].total.high);
  }
  return csv;
}

std::string surface_text(const StudyPlan& plan, const StudyRuns& runs) {
  std::string csv = "quantity,term,coefficient,standard_error,residual_deviation,explained\n";
  const auto scaled = scaled_points(plan);
  for (std::size_t q = 0; scaled && q < plan.quantities.size(); ++q) {
    const auto means = point_means(plan, runs, q);
    std::vector<std::vector<double>> points;
    std::vector<double> values;
    for (std::size_t p = 0; p < means.size(); ++p)
      if (means[p]) points.push_back((*scaled)[p]), values.push_back(*means[p]);
    const auto surface = fit_surface(points, values);
    if (!surface) continue;
    for (const auto& term : surface->terms) {
      std::vector<std::string> names;
      for (const int f : term.factors) names.push_back(plan.factors[static_cast<std::size_t>(f)].name);
      csv +=
          fmt::format("{},{},{},{},{},{}\n", plan.quantities[q],
                      names.empty() ? "1" : cell(fmt::format("{}", fmt::join(names, " * "))),
                      term.coefficient, term.standard_error, surface->residual_deviation, surface->explained);
    }
  }
  return csv;
}

// One fit for each set of levels of the other factors.
std::string convergence_text(const StudyPlan& plan, const StudyRuns& runs) {
  const std::size_t size = *plan.convergence;
  const auto groups = size_groups(plan);
  std::string csv = "quantity" + factor_names(plan) + ",limit,order,coefficient,residual,sizes\n";
  for (std::size_t q = 0; q < plan.quantities.size(); ++q) {
    const auto means = point_means(plan, runs, q);
    for (const auto& [others, points] : groups) {
      std::vector<double> sizes, values;
      for (const std::size_t p : points)
        if (means[p]) sizes.push_back(*plan.points[p].levels[size].number), values.push_back(*means[p]);
      const auto fit = fit_convergence(sizes, values);
      std::string cells;
      for (const auto& other : others) cells += ',' + cell(other);
      csv += plan.quantities[q] + cells;
      csv += fit ? fmt::format(",{},{},{},{},{}\n", fit->limit, fit->order, fit->coefficient, fit->residual,
                               sizes.size())
                 : fmt::format(",,,,,{}\n", sizes.size());
    }
  }
  return csv;
}

StudySummary summary_of(const StudyPlan& plan, const StudyRuns& runs) {
  StudySummary summary;
  summary.asked = static_cast<long>(asked_runs(plan, runs).size());
  for (const long number : asked_runs(plan, runs)) summary.runs += runs.contains(number);
  for (const auto& [number, run] : runs) {
    summary.done += run.status == "done";
    summary.inaccurate += run.status == "inaccurate";
    summary.failed += run.status == "failed";
    summary.refused += run.status == "refused";
    summary.cpu_seconds += run.cpu_seconds;
  }
  return summary;
}

std::string summary_text(const StudyPlan& plan, const ResultFolder& folder, const StudySummary& s) {
  nlohmann::ordered_json json{{"study", plan.name},
                              {"status", s.complete() ? "done" : "incomplete"},
                              {"run", folder.run()},
                              {"points", plan.points.size()},
                              {"runs_asked", s.asked},
                              {"runs_ended", s.runs},
                              {"done", s.done},
                              {"inaccurate", s.inaccurate},
                              {"failed", s.failed},
                              {"refused", s.refused},
                              {"in_no_mean", s.inaccurate + s.failed + s.refused}};
  for (const auto& [key, value] : folder.lines())
    if (key != "run" && key != "date") json["build"][key] = value;
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace

bool is_study_file(const std::string& name) {
  constexpr const char* names[] = {"results.csv", "timing.csv",  "means.csv",      "study.json",
                                   "sobol.csv",   "surface.csv", "convergence.csv"};
  return std::ranges::find(names, name) != std::end(names);
}

StudySummary merge_study(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder / plan_copy))
    throw CaseError(
        fmt::format("{}: holds no {}, a folder of `gasjet study run` is needed", folder.string(), plan_copy));
  const StudyPlan plan = read_study(folder / plan_copy);
  auto [runs, lines] = read_shares(folder, plan, SharesOf::any_build);
  std::erase_if(
      lines, [](const auto& line) { return line.first == "date"; });  // of one share: no fact of the results
  const StudySummary summary = summary_of(plan, runs);
  ResultFolder results(folder, "study", is_study_file);
  results.begin(lines);
  Provenance head = results.lines();
  head.emplace_back(
      "status",
      fmt::format("{}, {} of {} runs, {} in no mean", summary.complete() ? "done" : "incomplete",
                  summary.runs, summary.asked, summary.inaccurate + summary.failed + summary.refused));
  const std::string comments = comment_lines(head);
  results.write("results.csv", comments + results_text(plan, runs));
  results.write("timing.csv", comments + timing_text(plan, runs));
  results.write("means.csv", comments + means_text(plan, runs));
  if (plan.design == StudyDesign::sobol_indices)
    results.write("sobol.csv", comments + sobol_text(plan, runs));
  if (plan.response_surface) results.write("surface.csv", comments + surface_text(plan, runs));
  if (plan.convergence) results.write("convergence.csv", comments + convergence_text(plan, runs));
  results.write("study.json", summary_text(plan, results, summary));
  results.end(summary.complete() ? "done" : "incomplete");
  return summary;
}

}  // namespace driver
