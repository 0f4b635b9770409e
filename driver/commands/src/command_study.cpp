// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>

#include "base/progress.hpp"
#include "commands/command.hpp"
#include "input_files.hpp"
#include "many_runs/study.hpp"

namespace driver::commands {
namespace {

void print_plan(const StudyPlan& plan) {
  fmt::print("{}: {} points, {} factors, {} runs{}, {} quantities\n", plan.name, plan.points.size(),
             plan.factors.size(), plan.most_runs(), plan.stop ? " at most" : "", plan.quantities.size());
}

std::string seconds_text(double seconds) {
  return seconds < 10.0 ? fmt::format("{:.2g}", seconds) : fmt::format("{:.0f}", seconds);
}

// Prints the cost of all runs, estimated from a sample.
void print_cost(const StudyPlan& plan, const std::vector<RunRecord>& sample) {
  double seconds = 0.0;
  std::string each;
  for (const auto& run : sample) {
    seconds += run.cpu_seconds / static_cast<double>(sample.size());
    each += fmt::format("{}{} s at the {} point", each.empty() ? "" : ", ", seconds_text(run.cpu_seconds),
                        run.number == 0 ? "first" : "last");
  }
  fmt::print("about {} CPU s{}, an estimate from one run each: {}\n",
             seconds_text(seconds * static_cast<double>(plan.most_runs())), plan.stop ? " at most" : "",
             each);
  for (const auto& run : sample)
    if (!run.is_done())
      fmt::print("the run at the {} point is {}: {}\n", run.number == 0 ? "first" : "last", run.status,
                 run.message);
}

int check_study(const StudyPlan& plan) {
  std::fflush(stdout);  // show the plan before its runs begin
  catch_interrupt();
  const auto sample = sample_runs(plan);
  if (interrupted()) return exit_interrupted;
  print_cost(plan, sample);
  return exit_done;
}

void print(const StudySummary& summary, const std::filesystem::path& folder) {
  fmt::print("{} of {} runs: {} done, {} inaccurate, {} failed, {} refused; {:.4g} CPU s; results in {}\n",
             summary.runs, summary.asked, summary.done, summary.inaccurate, summary.failed, summary.refused,
             summary.cpu_seconds, folder.string());
  for (const auto& line : note_lines(summary)) fmt::print("{}\n", line);
}

}  // namespace

int study_run(const StudyArguments& arguments, const MakeCrew& make_crew) {
  const Share share = share_of(arguments.share);
  require_file(arguments.plan);
  const StudyPlan plan = read_study(arguments.plan);
  if (plan.stop && share.count > 1)
    throw CaseError(
        fmt::format("--share {}: a stop rule needs all runs: remove [stop], or run the plan in one process",
                    arguments.share));
  if (!arguments.quiet || arguments.only_check) print_plan(plan);
  if (arguments.only_check) return check_study(plan);
  const auto folder = arguments.out.empty() ? std::filesystem::path("results") / plan.name : arguments.out;
  const auto crew = make_crew(plan.id, study_work(plan, arguments.threads), arguments.threads);
  if (!crew) return exit_done;
  catch_interrupt();
  if (!run_study(plan, folder, share, *crew, arguments.quiet)) return tell_interrupted(folder);
  if (share.count > 1) return exit_done;
  const StudySummary summary = merge_study(folder);
  if (!arguments.quiet) print(summary, folder);
  return summary.failed + summary.refused + summary.inaccurate > 0 ? exit_domain : exit_done;
}

int study_merge(const std::filesystem::path& folder) {
  const StudySummary summary = merge_study(folder);
  print(summary, folder);
  if (!summary.complete()) return exit_undecided;
  return summary.failed + summary.refused + summary.inaccurate > 0 ? exit_domain : exit_done;
}

}  // namespace driver::commands
