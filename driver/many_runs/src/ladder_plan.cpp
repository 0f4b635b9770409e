// SPDX-License-Identifier: Apache-2.0
#include "ladder_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "many_runs/quantities.hpp"
#include "results/load_scene.hpp"

namespace driver {
namespace {

using Overrides = std::vector<std::string>;

// Steps of a coarser choice, as a share of the full case's, up to which it may save something. They are the
// same in each run, which times are not.
constexpr double most_steps = 1.03;

// The key of an override, or what it unsets.
std::string key_of(const std::string& text) {
  if (text.starts_with(unset_prefix)) return text.substr(unset_prefix.size());
  return text.substr(0, text.find('='));
}

// A held axis stays as the case has it: its choices go, and so do the overrides that would complete the case.
void hold_axes(LadderPlan& plan, const std::vector<std::string>& hold) {
  std::vector<std::string> names;
  for (const auto& axis : plan.axes) names.push_back(axis.name);
  for (const auto& name : hold)
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw CaseError(fmt::format("--hold {}: {}, allowed: {}", name.empty() ? "''" : name,
                                  name.empty() ? "a name is empty" : "the scene has no such axis",
                                  fmt::join(names, ", ")));
  std::erase_if(plan.axes, [&](const LadderAxis& axis) {
    return std::find(hold.begin(), hold.end(), axis.name) != hold.end();
  });
  if (plan.axes.empty()) throw CaseError("--hold: nothing is left to vary");
}

}  // namespace

bool follows_finer_mesh(const LadderPlan& plan, const LadderAxis& axis) {
  return axis.follows_mesh && std::any_of(plan.axes.begin(), plan.axes.end(), [](const LadderAxis& other) {
           return other.name == "mesh" && other.base + 1 < other.choices.size();
         });
}

std::vector<std::size_t> finest_picks(const LadderPlan& plan) {
  std::vector<std::size_t> picks;
  for (const LadderAxis& axis : plan.axes) {
    const bool finer = axis.kind == AxisKind::halving && !follows_finer_mesh(plan, axis);
    const int levels = axis.name == "mesh" ? plan.finer : 1;
    picks.push_back(
        std::min(axis.base + static_cast<std::size_t>(finer ? levels : 0), axis.choices.size() - 1));
  }
  return picks;
}

std::vector<std::string> combine(const LadderPlan& plan, const std::vector<std::size_t>& picks,
                                 const std::vector<std::string>& more) {
  Overrides all = more, kept;
  for (std::size_t a = 0; a < picks.size(); ++a)
    for (const auto& text : plan.axes[a].choices[picks[a]].overrides) all.push_back(text);
  const auto is_gone = [&](const std::string& text) {
    return std::any_of(all.begin(), all.end(), [&](const std::string& other) {
      return other.starts_with(unset_prefix) && key_of(text).starts_with(key_of(other) + '.');
    });
  };
  std::copy_if(all.begin(), all.end(), std::back_inserter(kept), [&](const auto& t) { return !is_gone(t); });
  return kept;
}

std::vector<std::pair<std::string, std::vector<std::size_t>>> combinations(const LadderResult& result) {
  const auto& axes = result.plan.axes;
  const LadderRung& full = result.rungs.front();
  std::vector<LadderRung> coarser;
  for (const LadderRung& r : result.rungs)
    if (r.axis && r.choice < axes[*r.axis].base && r.failure.empty() && r.value.count > 0 &&
        r.steps <= most_steps * full.steps)
      coarser.push_back(r);
  std::stable_sort(coarser.begin(), coarser.end(), [&](const LadderRung& a, const LadderRung& b) {
    return std::abs(a.value.mean - full.value.mean) < std::abs(b.value.mean - full.value.mean);
  });
  std::vector<std::size_t> picks;
  for (const auto& axis : axes) picks.push_back(axis.base);
  std::vector<std::pair<std::string, std::vector<std::size_t>>> list;
  for (const LadderRung& r : coarser) {
    if (r.choice >= picks[*r.axis]) continue;
    picks[*r.axis] = r.choice;
    list.emplace_back(axes[*r.axis].choices[r.choice].name, picks);
  }
  return list;
}

LadderPlan plan_ladder(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                       const std::string& quantity, const std::vector<std::string>& hold, int finer) {
  CaseDocument document(file, overrides);
  const Scene scene = load_scene(document);
  const CaseSettings settings(document);
  const std::string name = quantity_name(scene, quantity);
  LadderPlan plan;
  plan.finer = finer;
  add_effects(scene, settings, plan);
  add_resolutions(scene, settings, plan);
  hold_axes(plan, hold);
  if (scene.bag) add_no_membrane(file, overrides, scene, settings, name, plan);
  return plan;
}

}  // namespace driver
