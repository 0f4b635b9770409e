// SPDX-License-Identifier: Apache-2.0
// What a measurement of cost says, as text, CSV and JSON.
#include <fmt/format.h>

#include "many_runs/cost.hpp"
#include "table_text.hpp"

namespace driver {
namespace {

using Json = nlohmann::ordered_json;

// [us] for each step of the variant.
double micro(const CostVariant& variant, double seconds) {
  return 1e6 * seconds / static_cast<double>(std::max(1L, variant.steps));
}

std::string variants_text(const CostResult& result) {
  std::string text = fmt::format("{:34} {:>5} {:>8} {:>10} {:>10} {:>10} {:>10} {:>8}\n", "variant", "runs",
                                 "steps", "CPU s", "median", "largest", "us a step", "ratio");
  const double base = result.variants.front().least();
  for (const CostVariant& v : result.variants) {
    if (v.cpu_seconds.empty()) {
      text += fmt::format("{:34} {}\n", v.name, v.failure);
      continue;
    }
    text += fmt::format("{:34} {:5} {:8} {:10.4g} {:10.4g} {:10.4g} {:10.4g} {:8.3f}\n", v.name,
                        v.cpu_seconds.size(), v.steps, v.least(), v.median(), v.largest(), 1e6 * v.per_step(),
                        v.least() / base);
  }
  for (const auto& reason : result.left_out) text += fmt::format("left out: {}\n", reason);
  return text;
}

struct CostPart {
  const char* name;
  const char* without;
};
constexpr CostPart cost_parts[] = {{"jet", cost_no_jet},
                                   {"hidden-element test", cost_no_occlusion},
                                   {"pendulum and contact", cost_no_contact},
                                   {"self-contact", cost_no_self_contact},
                                   {"files and rows", cost_no_files}};

double gas_seconds(const CostVariant& v) {
  return v.stage_seconds[static_cast<std::size_t>(Stage::gas_point)] +
         v.stage_seconds[static_cast<std::size_t>(Stage::gas)];
}

std::string effects_text(const CostResult& result) {
  const CostVariant& base = result.variants.front();
  std::string text = fmt::format("\n{:34} {:>10} {:>10} {:>10} {:>12} {:>12}\n", "what a part costs", "CPU s",
                                 "+-", "% of run", "by its steps", "by a step");
  for (const auto& [name, without] : cost_parts) {
    const CostVariant* v = result.find(without);
    if (!v) continue;
    const CostDifference d = cost_difference(base, *v);
    text += fmt::format("{:34} {:10.4g} {:10.2g} {:10.1f} {:12.4g} {:12.4g}\n", name, d.run_seconds,
                        d.scatter, 100.0 * d.run_seconds / base.least(), d.by_steps, d.by_cost);
  }
  return text + fmt::format("{:34} {:10.4g} {:>10} {:10.1f}\n", "gas, S2 and S10", gas_seconds(base), "",
                            100.0 * gas_seconds(base) / base.least());
}

// The stages side by side: what a part adds to a stage that is not its own shows in the difference.
std::string stages_text(const CostResult& result) {
  const CostVariant& base = result.variants.front();
  const CostVariant* other = result.find(cost_no_jet);
  std::string text = fmt::format("\n{:34} {:>10}", "us a step", "as it is");
  if (other) text += fmt::format(" {:>12} {:>10} {:>14}", "without jet", "the jet's", "its s a run");
  text += '\n';
  const auto row = [&](std::string_view name, double mine, double theirs) {
    text += fmt::format("{:34} {:10.3f}", name, micro(base, mine));
    if (other)
      text += fmt::format(" {:12.3f} {:10.3f} {:14.5f}", micro(*other, theirs),
                          micro(base, mine) - micro(*other, theirs), mine - theirs);
    text += '\n';
  };
  for (std::size_t s = 0; s < kStages; ++s) {
    const double theirs = other ? other->stage_seconds[s] : 0.0;
    if (base.stage_seconds[s] > 0.0 || theirs > 0.0)
      row(stage_name(static_cast<Stage>(s)), base.stage_seconds[s], theirs);
  }
  row("start, rows, files", base.rest_seconds, other ? other->rest_seconds : 0.0);
  row("sum", base.least(), other ? other->least() : 0.0);
  return text;
}

std::string jet_text(const CostResult& result) {
  const CostVariant* without = result.find(cost_no_jet);
  if (!without) return {};
  const CostVariant& base = result.variants.front();
  const CostDifference d = cost_difference(base, *without);
  return fmt::format(
      "\na run with jet over one without: {:.3f} by the least of each, a step {:.3f}\n"
      "  pair by pair, which a busy machine disturbs more: {:.3f} to {:.3f}, the middle half\n"
      "the paper's two runs: {:g} s / {:g} s = {:.2f}\n",
      d.ratio, base.per_step() / without->per_step(), d.low, d.high, paper_cpu_with_jet, paper_cpu_without,
      paper_cpu_with_jet / paper_cpu_without);
}

Json variant_json(const CostVariant& v) {
  Json json{{"variant", v.name}, {"options", as_options(v.overrides)}, {"writes_files", v.writes_files}};
  if (v.cpu_seconds.empty()) {
    json["failure"] = v.failure;
    return json;
  }
  json["steps"] = v.steps;
  json["cpu_s"] = {
      {"least", v.least()}, {"median", v.median()}, {"largest", v.largest()}, {"runs", v.cpu_seconds}};
  json["us_per_step"] = 1e6 * v.per_step();
  for (std::size_t s = 0; s < kStages; ++s)
    json["stage_cpu_s"][std::string(stage_name(static_cast<Stage>(s)))] = v.stage_seconds[s];
  json["stage_cpu_s"]["rest"] = v.rest_seconds;
  return json;
}

Json difference_json(const CostVariant& base, const CostVariant& v) {
  const CostDifference d = cost_difference(base, v);
  Json json{{"against", v.name},
            {"cpu_s", d.run_seconds},
            {"scatter_s", d.scatter},
            {"share_of_run", d.run_seconds / base.least()},
            {"by_steps_s", d.by_steps},
            {"by_cost_of_a_step_s", d.by_cost},
            {"more_steps", base.steps - v.steps},
            {"run_ratio", d.ratio},
            {"run_ratio_middle_half", {d.low, d.high}},
            {"step_ratio", base.per_step() / v.per_step()}};
  for (std::size_t s = 0; s < kStages; ++s)
    json["stage_cpu_s"][std::string(stage_name(static_cast<Stage>(s)))] =
        base.stage_seconds[s] - v.stage_seconds[s];
  json["stage_cpu_s"]["rest"] = base.rest_seconds - v.rest_seconds;
  return json;
}

}  // namespace

std::string cost_text(const CostResult& result) {
  const CostVariant& base = result.variants.front();
  std::string text = fmt::format("{}: CPU seconds of whole runs, {} thread{}", result.scene, result.threads,
                                 result.threads > 1 ? "s" : "");
  if (result.elements) text += fmt::format(", {} elements", *result.elements);
  text += "\n\n";
  if (base.cpu_seconds.empty()) return text + base.failure + '\n';
  return text + variants_text(result) + effects_text(result) + stages_text(result) + jet_text(result);
}

std::string cost_csv(const CostResult& result) {
  std::string text = "variant,runs,steps,cpu_s,median_cpu_s,largest_cpu_s,us_per_step,ns_per_element,ratio";
  for (std::size_t s = 0; s < kStages; ++s) text += fmt::format(",{}_us", stage_name(static_cast<Stage>(s)));
  text += ",rest_us\n";
  for (const CostVariant& v : result.variants) {
    if (v.cpu_seconds.empty()) continue;
    const double ns = result.elements ? 1e9 * v.per_step() / *result.elements : 0.0;
    text += fmt::format("{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{},{:.6g}", v.name, v.cpu_seconds.size(),
                        v.steps, v.least(), v.median(), v.largest(), 1e6 * v.per_step(),
                        result.elements ? fmt::format("{:.6g}", ns) : "",
                        v.least() / result.variants.front().least());
    for (const double seconds : v.stage_seconds) text += fmt::format(",{:.6g}", micro(v, seconds));
    text += fmt::format(",{:.6g}\n", micro(v, v.rest_seconds));
  }
  return text;
}

std::string cost_json(const CostResult& result, const Provenance& lines) {
  Json json{{"scene", result.scene}, {"runs", result.runs}, {"threads", result.threads}};
  if (result.elements) json["elements"] = *result.elements;
  for (const CostVariant& v : result.variants) json["variants"].push_back(variant_json(v));
  json["left_out"] = result.left_out;
  const CostVariant& base = result.variants.front();
  json["parts"] = Json::object();
  for (const auto& [name, without] : cost_parts)
    if (const CostVariant* v = result.find(without); v && !base.cpu_seconds.empty())
      json["parts"][name] = difference_json(base, *v);
  if (!base.cpu_seconds.empty()) json["parts"]["gas"] = {{"cpu_s", gas_seconds(base)}};
  json["paper"] = {{"cpu_s_with_jet", paper_cpu_with_jet},
                   {"cpu_s_without", paper_cpu_without},
                   {"run_ratio", paper_cpu_with_jet / paper_cpu_without}};
  return json_text(std::move(json), lines, {});
}

}  // namespace driver
