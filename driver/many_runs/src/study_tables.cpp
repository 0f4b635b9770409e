// SPDX-License-Identifier: Apache-2.0
#include "study_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "results/gnuplot.hpp"
#include "study_inputs.hpp"
#include "study_pictures.hpp"
#include "study_plan.hpp"
#include "table_text.hpp"

namespace driver {
namespace {

std::string results_text(const StudyPlan& plan, const RunJournal::Runs& runs) {
  std::string csv = "point,seed" + factor_names(plan);
  for (const auto& name : plan.quantities) csv += ',' + name;
  csv += ",status,steps,message\n";
  for (const auto& [number, run] : runs) {
    const std::size_t point = point_of(plan, number);
    fmt::format_to(std::back_inserter(csv), "{},{}{}", point, seed_of(plan, number),
                   level_cells(plan, point));
    for (const auto& value : run.values) csv += ',' + csv_cell(value);
    fmt::format_to(std::back_inserter(csv), ",{},{},{}\n", run.status, run.steps, csv_cell(run.message));
  }
  return csv;
}

std::string timing_text(const StudyPlan& plan, const RunJournal::Runs& runs) {
  std::string csv = "point,seed,steps,cpu_s\n";
  for (const auto& [number, run] : runs)
    fmt::format_to(std::back_inserter(csv), "{},{},{},{}\n", point_of(plan, number), seed_of(plan, number),
                   run.steps, run.cpu_seconds);
  return csv;
}

std::string point_name(const StudyPlan& plan, std::size_t p) {
  return fmt::format("point {} ({})", p, fmt::join(level_names(plan, plan.points[p]), ", "));
}

void add_missing(const StudyPlan& plan, const RunJournal::Runs& runs, StudySummary& summary) {
  std::map<std::size_t, std::vector<int>> seeds;
  for (const long number : asked_runs(plan, runs))
    if (!runs.contains(number)) seeds[point_of(plan, number)].push_back(seed_of(plan, number));
  constexpr std::size_t most = 3, most_seeds = 8;
  std::vector<std::string> points;
  for (const auto& [point, missing] : seeds) {
    if (points.size() == most) break;
    points.push_back(point_name(plan, point) + (missing.size() > most_seeds
                                                    ? fmt::format(", {} seeds", missing.size())
                                                    : fmt::format(", seed {}", fmt::join(missing, ", "))));
  }
  if (seeds.size() > most) points.push_back(fmt::format("{} more points", seeds.size() - most));
  if (!points.empty()) summary.notes.push_back(fmt::format("not run yet: {}", fmt::join(points, "; ")));
}

void add_claims(const StudyPlan& plan, const RunJournal::Runs& runs, StudySummary& summary) {
  const auto claims = stop_claims(plan, runs);
  summary.decided = std::ranges::count(claims, StopClaim::decided);
  summary.undecided = std::ranges::count(claims, StopClaim::undecided);
  for (std::size_t p = 0; p < claims.size(); ++p) {
    if (claims[p] != StopClaim::undecided) continue;
    summary.notes.push_back(fmt::format("not decided after {} seeds: {}, {}", plan.most_seeds(),
                                        point_name(plan, p), plan.stop->quantity));
  }
}

StudySummary summary_of(const StudyPlan& plan, const RunJournal::Runs& runs) {
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
  if (plan.stop) add_claims(plan, runs, summary);
  add_missing(plan, runs, summary);
  return summary;
}

std::string summary_text(const StudyPlan& plan, const ResultFolder& folder, const SpreadTable& spreads,
                         const StudySummary& s) {
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
  if (plan.stop) json["decided"] = s.decided, json["not_decided"] = s.undecided;
  if (!spreads.empty()) json["spread"] = spread_json(plan, spreads);
  if (!s.notes.empty()) json["notes"] = s.notes;
  return json_text(std::move(json), folder.lines(), {"run", "date"});
}

void draw(const std::string& name, const StudyPicture& picture, ResultFolder& results, StudyNotes& notes) {
  std::string problem = picture.why_not;
  if (problem.empty() && !(problem = draw_picture(results, name, picture.commands)).empty())
    problem += fmt::format("; its commands are in {}.gp", name);
  if (!problem.empty()) notes.push_back(fmt::format("{}.svg: not drawn, {}", name, problem));
}

void write_tables(const StudyPlan& plan, const RunJournal::Runs& runs, const std::string& comments,
                  const SpreadTable& spreads, ResultFolder& results, StudyNotes& notes) {
  results.write("results.csv", comments + results_text(plan, runs));
  results.write("timing.csv", comments + timing_text(plan, runs));
  results.write("means.csv", comments + means_text(plan, runs, notes));
  if (plan.analysis.pictures)
    draw("means", is_sampled(plan.design) ? trends_picture(plan, runs, spreads) : means_picture(plan, runs),
         results, notes);
  if (is_sampled(plan.design)) results.write("spread.csv", comments + spread_text(plan, spreads, notes));
  if (is_sampled(plan.design) && plan.design != StudyDesign::sobol_indices)
    results.write("effects.csv", comments + effects_text(plan, spreads, notes));
  if (plan.design == StudyDesign::sobol_indices) {
    const SobolTable table = sobol_table(plan, runs);
    results.write("sobol.csv", comments + sobol_text(plan, table, notes));
    if (plan.analysis.pictures) draw("sobol", sobol_picture(plan, table), results, notes);
  }
  if (plan.analysis.response_surface) {
    results.write("surface.csv", comments + surface_text(plan, runs, notes));
    if (plan.analysis.pictures) draw("surface", surface_picture(plan, runs), results, notes);
  }
  if (plan.analysis.convergence) {
    const auto fits = size_fits(plan, runs);
    results.write("convergence.csv", comments + convergence_text(plan, fits, notes));
    if (plan.analysis.pictures) draw("convergence", convergence_picture(plan, fits), results, notes);
  }
}

}  // namespace

std::string factor_names(const StudyPlan& plan) {
  std::string names;
  for (const auto& factor : plan.factors) names += ',' + csv_cell(factor.name);
  return names;
}

std::string level_cells(const StudyPlan& plan, std::size_t point) {
  std::string cells;
  for (const auto& name : level_names(plan, plan.points[point])) cells += ',' + csv_cell(name);
  return cells;
}

std::vector<std::string> note_lines(const StudySummary& summary) {
  constexpr std::size_t most = 10;
  std::vector<std::string> lines = summary.findings;
  if (summary.decided + summary.undecided > 0)
    lines.push_back(fmt::format("stop rule: {} decided, {} not decided", summary.decided, summary.undecided));
  for (std::size_t i = 0; i < std::min(most, summary.notes.size()); ++i) lines.push_back(summary.notes[i]);
  if (summary.notes.size() > most)
    lines.push_back(fmt::format("{} notes in all: study.json", summary.notes.size()));
  return lines;
}

StudySummary merge_study(const std::filesystem::path& folder) {
  std::error_code ignored;
  if (!std::filesystem::exists(folder / plan_copy, ignored))
    throw CaseError(
        fmt::format("{}: has no {}: name a folder of `gasjet study run`", folder.string(), plan_copy));
  const StudyPlan plan = read_study(folder / plan_copy);
  RunJournal journal(shape_of(plan), study_inputs(plan, folder));
  journal.read_shares(folder, "");
  const RunJournal::Runs& runs = journal.runs();
  Provenance lines = journal.build();
  std::erase_if(
      lines, [](const auto& line) { return line.first == "date"; });  // of one share: no fact of the results
  StudySummary summary = summary_of(plan, runs);
  ResultFolder results(folder, "study", true);
  results.begin(lines);
  Provenance head = results.lines();
  head.emplace_back(
      "status",
      fmt::format("{}, {} of {} runs, {} in no mean", summary.complete() ? "done" : "incomplete",
                  summary.runs, summary.asked, summary.inaccurate + summary.failed + summary.refused));
  const SpreadTable spreads = spread_table(plan, runs);
  summary.findings = spread_lines(plan, spreads);
  write_tables(plan, runs, comment_lines(head), spreads, results, summary.notes);
  results.write("study.json", summary_text(plan, results, spreads, summary));
  results.end(summary.complete() ? "done" : "incomplete");
  return summary;
}

}  // namespace driver
