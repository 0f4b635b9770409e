// SPDX-License-Identifier: Apache-2.0
#include "many_runs/ladder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/progress.hpp"
#include "ladder_plan.hpp"
#include "ladder_runs.hpp"
#include "many_runs/quantities.hpp"
#include "many_runs/sequential_test.hpp"
#include "results/load_scene.hpp"

namespace driver {
namespace {

using Picks = std::vector<std::size_t>;

constexpr double at_ambient = 1e-7;  // of the ambient pressure: from there on a volume counts as equalised

// Of the quantity, so that a tolerance can be a share of it.
void need_size(LadderResult& result, double value, const char* where) {
  if (std::abs(value - result.zero) <= at_ambient * std::abs(result.zero))
    result.reason = fmt::format(
        "{} is {:g} in {}, its zero, so no tolerance can be a share of it: "
        "choose a quantity that ends elsewhere, or a peak",
        result.quantity, result.zero, where);
}

class LadderRun {
 public:
  LadderRun(const std::filesystem::path& file, const Scene& scene, const std::vector<std::string>& user,
            const LadderOptions& options, Crew& crew, LadderResult& result, ResultFolder* folder)
      : file_(file),
        scene_(scene),
        user_(user),
        options_(options),
        result_(result),
        runs_(scene, options, crew, result, folder) {
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
    if (const auto volume = volume_by_pressure()) add_without_membrane("volume by pressure", *volume);
    if (result_.plan.design_volume > 0.0)
      add_without_membrane("rigid tank", fmt::format("{}", result_.plan.design_volume));
    else
      result_.plan.left_out.emplace_back("rigid tank: the design shape is flat");
  }

  std::optional<std::string> volume_by_pressure() {
    auto volume = runs_.kept_volume();
    if (volume) return volume;
    const auto overrides = joined(user_, result_.rungs.front().overrides);
    volume = bag_by_volume(file_, overrides, options_.quiet, result_.plan);
    if (volume) runs_.keep_volume(*volume);
    return volume;
  }

  void add_without_membrane(const char* name, const std::string& volume) {
    LadderRung& rung = result_.rungs.emplace_back();
    rung.name = rung.differs = name;
    rung.overrides = combine(result_.plan, full_, without_membrane(result_.plan, volume));
  }

  void add_combinations() {
    for (const auto& [name, picks] : combinations(result_))
      if (is_new(combine(result_.plan, picks))) add("and " + name, picks);
  }

  const std::filesystem::path& file_;
  const Scene& scene_;
  const std::vector<std::string>& user_;
  const LadderOptions& options_;
  LadderResult& result_;
  RungRuns runs_;
  Picks full_;
};

}  // namespace

CrewWork ladder_work(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                     const std::string& quantity, int workers) {
  const auto load = [=](const auto& more) { return load_variant(file, overrides, more); };
  return run_work({{load, {quantity}}}, workers);
}

LadderResult run_ladder(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                        const LadderPlan& plan, const LadderOptions& options, Crew& crew,
                        ResultFolder* folder) {
  LadderResult result;
  result.plan = plan;
  CaseDocument document(file, overrides);
  const Scene scene = load_scene(document);
  result.quantity = quantity_name(scene, options.quantity);
  if (result.quantity.ends_with("pressure_Pa")) result.zero = scene.ambient.pressure;
  LadderRun(file, scene, overrides, options, crew, result, folder).run();
  if (interrupted() || !result.reason.empty()) return result;
  judge(result, options.tolerance,
        options.error_rate / (result.chaotic ? looks(options.runs, options.most_runs) : 1));
  need_size(result, result.reference.value, "the reference");
  return result;
}

LadderResult run_ladder(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                        const LadderOptions& options, int threads) {
  const auto plan = plan_ladder(file, overrides, options.quantity, options.hold, options.finer);
  CaseDocument document(file, overrides);
  const auto work =
      ladder_work(file, overrides, quantity_name(load_scene(document), options.quantity), threads);
  return run_ladder(file, overrides, plan, options, *thread_crew(work, threads), nullptr);
}

}  // namespace driver
