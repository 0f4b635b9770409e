// SPDX-License-Identifier: Apache-2.0
#include "many_runs/ladder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/progress.hpp"
#include "engine/stages.hpp"
#include "ladder/rung_runs.hpp"
#include "results/load_scene.hpp"

namespace driver {
namespace {

using Picks = std::vector<std::size_t>;

constexpr double at_ambient = 1e-7;  // of the ambient pressure: from there on a volume counts as equalised

// Of the quantity, so that a tolerance can be a share of it.
void need_size(LadderResult& result, double value, const char* where) {
  if (std::abs(value - result.zero) <= at_ambient * std::abs(result.zero))
    result.reason = fmt::format(
        "{} is {:g} in {}, the value that it counts from: no tolerance is a share of that; "
        "a quantity that ends elsewhere, or a peak, is allowed",
        result.quantity, result.zero, where);
}

class LadderRun {
 public:
  LadderRun(const std::filesystem::path& file, const Scene& scene, const std::vector<std::string>& user,
            const LadderOptions& options, Crew& crew, LadderResult& result, Journal& journal)
      : file_(file),
        scene_(scene),
        options_(options),
        result_(result),
        journal_(journal),
        runs_(scene, user, options, crew, result, journal) {
    for (const auto& axis : result.plan.axes) full_.push_back(axis.base);
  }

  void run() {
    add("full", full_);
    runs_.probe();
    if (result_.reason.empty()) runs_.run(0, "full case");
    if (const Statistics& full = result_.rungs.front().value; full.count > 0)
      need_size(result_, full.mean, "the full case");
    if (!result_.reason.empty()) return;
    add_finest();
    add_alternatives();
    add_as_it_is();
    add_rungs_without_membrane();
    runs_.run(1, "rungs");
    if (!result_.reason.empty()) return;
    const std::size_t before = result_.rungs.size();
    add_combinations();
    runs_.run(before, "combinations");
    runs_.look_again();
  }

 private:
  LadderRung& add(std::string name, const Picks& picks) {
    LadderRung rung;
    rung.name = std::move(name);
    rung.differs = picks == full_ ? rung.name : differing(picks);
    rung.overrides = combine(result_.plan, picks);
    rung.can_be_perturbed = scene_.bag.has_value();
    return result_.rungs.emplace_back(std::move(rung));
  }

  std::string differing(const Picks& picks) const {
    std::vector<std::string> names;
    for (std::size_t a = 0; a < picks.size(); ++a)
      if (picks[a] != full_[a]) names.push_back(result_.plan.axes[a].choices[picks[a]].name);
    return fmt::format("{}", fmt::join(names, ", "));
  }

  bool is_new(const std::vector<std::string>& overrides) const {
    return std::none_of(result_.rungs.begin(), result_.rungs.end(),
                        [&](const LadderRung& r) { return r.overrides == overrides; });
  }

  void add_finest() {
    const Picks picks = finest_picks(result_.plan);
    if (picks == full_) return;
    add("finest", picks);
    result_.finest = 1;
  }

  void add_as_it_is() {
    if (const auto same = std::find_if(result_.rungs.begin() + 1, result_.rungs.end(),
                                       [](const LadderRung& r) { return r.overrides.empty(); });
        same != result_.rungs.end())
      same->name = "as it is: " + same->name;
    if (!is_new({})) return;
    LadderRung& rung = result_.rungs.emplace_back();
    rung.name = rung.differs = "as it is";
    rung.can_be_perturbed = scene_.bag.has_value();
  }

  void add_alternatives() {
    for (std::size_t a = 0; a < full_.size(); ++a) {
      const LadderAxis& axis = result_.plan.axes[a];
      for (std::size_t c = 0; c < axis.choices.size(); ++c) {
        if (c == axis.base) continue;
        Picks picks = full_;
        picks[a] = c;
        const bool is_finest = picks == finest_picks(result_.plan);
        LadderRung& rung = is_finest ? result_.rungs[result_.finest] : add(axis.choices[c].name, picks);
        if (is_finest) rung.name += ": " + axis.choices[c].name;
        rung.axis = a;
        rung.choice = c;
      }
    }
  }

  void add_rungs_without_membrane() {
    if (!result_.plan.no_membrane) return;
    add_without_membrane(bag_by_volume(file_, runs_.overrides(0), options_.quiet, result_.plan, journal_));
    add_without_membrane(rigid_tank(result_.plan));
  }

  void add_without_membrane(const std::optional<LadderChoice>& choice) {
    if (!choice) return;
    LadderRung& rung = result_.rungs.emplace_back();
    rung.name = rung.differs = choice->name;
    rung.overrides = combine(result_.plan, full_, choice->overrides);
  }

  void add_combinations() {
    for (const auto& [name, picks] : combinations(result_))
      if (is_new(combine(result_.plan, picks))) add("and " + name, picks);
  }

  const std::filesystem::path& file_;
  const Scene& scene_;
  const LadderOptions& options_;
  LadderResult& result_;
  Journal& journal_;
  RungRuns runs_;
  Picks full_;
};

}  // namespace

LadderResult run_ladder(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                        const LadderPlan& plan, const LadderOptions& options, Crew& crew,
                        ResultFolder* folder) {
  LadderResult result;
  result.plan = plan;
  CaseDocument document(file, overrides);
  const Scene scene = load_scene(document);
  result.quantity = quantity_name(scene, options.quantity);
  if (result.quantity.ends_with("pressure_Pa")) result.zero = scene.ambient.pressure;
  Journal journal(folder);
  if (journal.size() > 0 && !options.quiet)
    tell(fmt::format("{}: goes on after {} runs that are done", one_line(scene.name), journal.size()));
  LadderRun(file, scene, overrides, options, crew, result, journal).run();
  if (interrupted() || !result.reason.empty()) return result;
  judge(result, options.tolerance, options.error_rate / (result.chaotic ? ladder_looks(options) : 1));
  need_size(result, result.reference.value, "the reference");
  return result;
}

LadderResult run_ladder(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                        const LadderOptions& options, int threads) {
  const auto plan = plan_ladder(file, overrides, options.quantity, options.hold, options.finer);
  CaseDocument document(file, overrides);
  const auto work = ladder_work(file, quantity_name(load_scene(document), options.quantity));
  return run_ladder(file, overrides, plan, options, *thread_crew(work, threads), nullptr);
}

}  // namespace driver
