// SPDX-License-Identifier: Apache-2.0
// What lies beyond the finest rung, and what the others are off by.
#include <algorithm>
#include <cmath>
#include <elementary/exponential.hpp>
#include <elementary/hypot.hpp>
#include <limits>
#include <numbers>

#include "compare/students_t.hpp"
#include "ladder_runs.hpp"

namespace driver {
namespace {

// Orders taken for seen: a first-order method a little before its asymptotic range, up to one that converges
// as fast as any here.
constexpr double lowest_order = 0.7, highest_order = 4.6;

bool is_seen(double difference, const Statistics& a, const Statistics& b) {
  return std::abs(difference) > 2.0 * elementary::hypot(a.standard_error, b.standard_error);
}

// Richardson's limit of the last three values.
std::optional<Remainder> extrapolated(const std::vector<Statistics>& values, std::size_t at) {
  if (values.size() < 3) return std::nullopt;
  const Statistics* last = &values.back();
  const double before = last[-1].mean - last[-2].mean, after = last->mean - last[-1].mean;
  if (!is_seen(before, last[-1], last[-2]) || !is_seen(after, *last, last[-1])) return std::nullopt;
  if (!(before / after > 0.0)) return std::nullopt;
  const double ratio = before / after, order = elementary::log(ratio) / std::numbers::ln2;
  if (!(order >= lowest_order && order <= highest_order)) return std::nullopt;
  const double step = after / (ratio - 1.0);
  // What the limit, last + after^2 / (before - after), changes by with each of the three.
  const double by_after = (2.0 * ratio - 1.0) / ((ratio - 1.0) * (ratio - 1.0)),
               by_before = -1.0 / ((ratio - 1.0) * (ratio - 1.0));
  const double by_value[] = {-by_before, by_before - by_after, 1.0 + by_after};
  double error = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double by = (i + 3 < values.size() ? 0.0 : by_value[i + 3 - values.size()]) - (i == at ? 1.0 : 0.0);
    error = elementary::hypot(error, by * values[i].standard_error);
  }
  return Remainder{last->mean + step - values[at].mean, std::abs(step), error, order};
}

bool is_resolution(const LadderAxis& axis) {
  return axis.kind == AxisKind::halving || axis.kind == AxisKind::tightening;
}

bool is_assumption(const LadderResult& result, const LadderRung& rung) {
  return rung.axis && result.plan.axes[*rung.axis].kind == AxisKind::model;
}

// Of the values along an axis; infinite uncertainty if a finer one is missing.
Remainder remainder_of(const LadderResult& result, std::size_t index, std::size_t at) {
  const LadderAxis& axis = result.plan.axes[index];
  std::vector<Statistics> values;
  for (std::size_t c = axis.first; c < axis.choices.size(); ++c) {
    const auto rung = std::find_if(result.rungs.begin(), result.rungs.end(),
                                   [&](const LadderRung& r) { return r.axis == index && r.choice == c; });
    const LadderRung& found = c == axis.base ? result.rungs.front() : *rung;
    if (found.failure.empty())
      values.push_back(found.value);
    else if (c > axis.base)
      return {0.0, std::numeric_limits<double>::infinity(), 0.0, {}};
    else
      values.clear();
  }
  return remainder(values, at - (axis.choices.size() - values.size()), axis.kind);
}

LadderReference reference_of(const LadderResult& result) {
  const Statistics& finest = result.rungs[result.finest].value;
  const auto picks = finest_picks(result.plan);
  LadderReference reference{finest.mean, finest.standard_error, 0.0, {}};
  for (std::size_t a = 0; a < result.plan.axes.size(); ++a) {
    const LadderAxis& axis = result.plan.axes[a];
    if (!is_resolution(axis) || follows_finer_mesh(result.plan, axis)) continue;
    const Remainder rest = remainder_of(result, a, picks[a]);
    reference.value += rest.correction;
    reference.standard_error += rest.standard_error;
    reference.uncertainty = elementary::hypot(reference.uncertainty, rest.uncertainty);
    reference.remainders.emplace_back(axis.name, rest);
  }
  return reference;
}

// Share of a cost from which on another is cheaper: CPU times repeat to some percent.
constexpr double worth_it = 0.97;

// Fewer runs say too little of the scatter of a chaotic scene.
constexpr int fewest_runs = 16;

// Standard errors within which a mean lies but at the rate given; of single runs by the scatter of the
// probes.
double student(const LadderRung& rung, const LadderResult& result, double error_rate) {
  int runs = probes;
  if (result.chaotic) runs = result.rungs[result.finest].value.count;
  if (result.chaotic && rung.can_be_perturbed) runs = std::min(runs, rung.value.count);
  const StudentsT distribution(std::max(1, runs - 1));
  return quantile(complement(distribution, error_rate));
}

Verdict verdict_of(const LadderRung& rung, const LadderResult& result, double allowed) {
  const auto says_too_little = [](const LadderRung& r) {
    return r.can_be_perturbed && r.value.count < fewest_runs;
  };
  if (!rung.failure.empty() || rung.value.count == 0 || is_assumption(result, rung))
    return Verdict::not_judged;
  if (result.chaotic && (says_too_little(rung) || says_too_little(result.rungs[result.finest])))
    return Verdict::undecided;
  if (!(allowed > 0.0)) return Verdict::undecided;  // a share of nothing
  const double least = std::abs(rung.error) - rung.doubt, most = std::abs(rung.error) + rung.doubt;
  if (most <= allowed) return Verdict::inside;
  if (least > allowed) return Verdict::outside;
  const bool near = least >= (1.0 - bound_width) * allowed && most <= (1.0 + bound_width) * allowed;
  return near ? Verdict::on_the_bound : Verdict::undecided;
}

std::optional<ModelBand> model_band(const LadderResult& result) {
  std::optional<ModelBand> band;
  for (const LadderRung& rung : result.rungs) {
    if (!is_assumption(result, rung) || !rung.failure.empty() || rung.value.count == 0) continue;
    if (!band) band.emplace();
    const double change = change_of(result, rung).value;
    if (change < band->low) band->low = change, band->lowest = rung.name;
    if (change > band->high) band->high = change, band->highest = rung.name;
  }
  return band;
}

// By cost: what is more exact than all that is cheaper.
void mark_front(LadderResult& result, double floor) {
  std::vector<LadderRung*> by_cost;
  for (LadderRung& rung : result.rungs)
    if (rung.verdict != Verdict::not_judged) by_cost.push_back(&rung);
  std::stable_sort(by_cost.begin(), by_cost.end(),
                   [](const LadderRung* a, const LadderRung* b) { return a->cpu_seconds < b->cpu_seconds; });
  double least = std::numeric_limits<double>::infinity();
  int place = 0;
  for (LadderRung* rung : by_cost) {
    const double error = std::max(std::abs(rung->error), floor);
    if (!(error < least)) continue;
    least = error;
    rung->front = ++place;
  }
}

constexpr double small_part = 0.5;  // of the larger standard error: more runs of the smaller change little
constexpr double scatter = 2.0;     // standard errors below which a difference of
                                    // meshes may be nothing else

// Rungs that the reference rests on.
std::vector<std::size_t> reference_rungs(const LadderResult& result) {
  std::vector<std::size_t> rungs{0, result.finest};
  for (std::size_t r = 1; r < result.rungs.size(); ++r) {
    const LadderRung& rung = result.rungs[r];
    if (!rung.axis || r == result.finest) continue;
    const LadderAxis& axis = result.plan.axes[*rung.axis];
    const bool counts = is_resolution(axis) && !follows_finer_mesh(result.plan, axis);
    if (counts && rung.choice >= axis.first) rungs.push_back(r);
  }
  return rungs;
}

}  // namespace

Remainder remainder(const std::vector<Statistics>& values, std::size_t at, AxisKind kind) {
  if (kind == AxisKind::halving)
    if (const auto seen = extrapolated(values, at)) return *seen;
  Remainder rest;
  // What was seen beyond `at`, and once more the last difference.
  for (std::size_t i = at; i + 1 < values.size(); ++i)
    rest.uncertainty += std::abs(values[i + 1].mean - values[i].mean);
  if (values.size() > 1) rest.uncertainty += std::abs(values.back().mean - values[values.size() - 2].mean);
  return rest;
}

Change change_of(const LadderResult& result, const LadderRung& rung) {
  const LadderRung& full = result.rungs.front();
  if (&rung == &full) return {};
  return {rung.value.mean - full.value.mean,
          elementary::hypot(rung.value.standard_error, full.value.standard_error)};
}

void judge(LadderResult& result, double tolerance, double error_rate) {
  result.reference = reference_of(result);
  result.cheapest.reset();
  const LadderReference& reference = result.reference;
  const double allowed = tolerance * std::abs(reference.value - result.zero);
  for (std::size_t i = 0; i < result.rungs.size(); ++i) {
    LadderRung& rung = result.rungs[i];
    rung.error = rung.value.mean - reference.value;
    rung.standard_error = i == result.finest
                              ? reference.standard_error
                              : elementary::hypot(rung.value.standard_error, reference.standard_error);
    rung.doubt = student(rung, result, error_rate) * rung.standard_error + reference.uncertainty;
    rung.front = 0;
    rung.verdict = verdict_of(rung, result, allowed);
    if (rung.verdict == Verdict::inside &&
        (!result.cheapest || rung.cpu_seconds < worth_it * result.rungs[*result.cheapest].cpu_seconds))
      result.cheapest = i;
  }
  mark_front(result, least_share * allowed);
  result.model = model_band(result);
  if (result.model && result.cheapest) {
    const double error = result.rungs[*result.cheapest].error;
    result.model->cheapest_stands = std::max(error - result.model->low, result.model->high - error) +
                                        result.rungs[*result.cheapest].doubt <=
                                    allowed;
  }
  result.verdict = result.cheapest ? Verdict::inside : Verdict::undecided;
}

std::vector<std::size_t> open_rungs(const LadderResult& result, double tolerance) {
  const LadderReference& reference = result.reference;
  const double allowed = tolerance * std::abs(reference.value - result.zero);
  const double coarse = elementary::hypot(result.rungs[0].value.standard_error, reference.standard_error);
  std::vector<bool> open(result.rungs.size(), false);
  bool of_reference = false;
  for (std::size_t r = 0; r < result.rungs.size(); ++r) {
    const LadderRung& rung = result.rungs[r];
    if (rung.verdict != Verdict::undecided) continue;
    const double own = rung.can_be_perturbed ? rung.value.standard_error : 0.0;
    const bool runs_decide = std::abs(std::abs(rung.error) - allowed) > reference.uncertainty;
    if (!runs_decide && reference.uncertainty > scatter * coarse) continue;
    open[r] = runs_decide && own > small_part * reference.standard_error;
    of_reference = of_reference || !runs_decide || reference.standard_error > small_part * own;
  }
  if (of_reference)
    for (const std::size_t r : reference_rungs(result)) open[r] = true;
  std::vector<std::size_t> rungs;
  for (std::size_t r = 0; r < open.size(); ++r)
    if (open[r] && result.rungs[r].failure.empty() && result.rungs[r].can_be_perturbed) rungs.push_back(r);
  return rungs;
}

}  // namespace driver
