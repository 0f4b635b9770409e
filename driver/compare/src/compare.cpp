// SPDX-License-Identifier: Apache-2.0
#include "compare/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_map>

#include "base/case_reader.hpp"
#include "column_names.hpp"
#include "filtered.hpp"
#include "mean_test.hpp"
#include "phase_lag.hpp"
#include "sampled.hpp"

namespace driver {
namespace {

constexpr double round_off_of_times = 1e-9;  // share of the reference's span: files have rounded decimal
                                             // times

// Columns by name, as a history may have thousands.
class Columns {
 public:
  explicit Columns(const History& history) { add(history); }
  void add(const History& history) {
    for (const auto& [name, values] : history.columns) values_.emplace(name, &values);
  }
  const std::vector<double>* find(const std::string& name) const {
    const auto found = values_.find(name);
    return found == values_.end() ? nullptr : found->second;
  }

 private:
  std::unordered_map<std::string_view, const std::vector<double>*> values_;
};

struct Window {
  std::size_t first = 0, count = 0;  // rows of the reference that mine covers
  bool whole = false;
  std::string text;
};

Window common_rows(const History& mine, const History& reference) {
  const double from = reference.time.front(), to = reference.time.back();
  const double slack = round_off_of_times * (to - from);
  Window window;
  for (std::size_t i = 0; i < reference.time.size(); ++i) {
    if (reference.time[i] < mine.time.front() - slack || reference.time[i] > mine.time.back() + slack)
      continue;
    if (window.count++ == 0) window.first = i;
  }
  window.whole = window.count == reference.time.size();
  window.text = fmt::format("covers {:.6g} to {:.6g} s, the reference {:.6g} to {:.6g} s", mine.time.front(),
                            mine.time.back(), from, to);
  return window;
}

std::vector<double> rows(const std::vector<double>& all, const Window& window) {
  const auto first = all.begin() + static_cast<std::ptrdiff_t>(window.first);
  return {first, first + static_cast<std::ptrdiff_t>(window.count)};
}

Peak peak(const std::vector<double>& time, const std::vector<double>& values) {
  Peak largest;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (i == 0 || std::abs(values[i]) > std::abs(largest.value)) largest = {values[i], time[i]};
  return largest;
}

// True if the band is as wide as the signal's own variation (for a constant signal, as its value), so that it
// decides nothing.
bool is_wider_than_signal(const QuantityDifference& q) {
  const auto [low, high] = std::minmax_element(q.expected.begin(), q.expected.end());
  const double size = std::max(std::abs(*low), std::abs(*high));
  if (size == 0.0) return false;
  constexpr double constant = 1e-6;  // relative variation that may be round-off of the band
  const double signal = *high - *low > constant * size ? *high - *low : size;
  auto sorted = q.band;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                   sorted.end());
  return sorted[sorted.size() / 2] >= signal;
}

void measure(const std::vector<double>& time, QuantityDifference& q) {
  std::vector<double> difference;
  for (std::size_t i = 0; i < time.size(); ++i) difference.push_back(q.values[i] - q.expected[i]);
  q.largest = peak(time, difference);
  q.largest.value = std::abs(q.largest.value);
  q.l2 = root_mean_square(time, difference);
  const double size = root_mean_square(time, q.expected);
  if (size > 0.0) q.relative = q.l2 / size;
  q.mine = peak(time, q.values);
  q.reference = peak(time, q.expected);
  q.phase_lag = phase_lag(time, q.values, q.expected);
}

void judge(const std::vector<double>& time, const std::vector<double>& doubt, bool of_means,
           QuantityDifference& q) {
  std::size_t outside = 0, unclear = 0, first = 0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double off = std::abs(q.values[i] - q.expected[i]);
    if (off > 0.0) q.share_of_band = std::max(q.share_of_band, q.band[i] > 0.0 ? off / q.band[i] : HUGE_VAL);
    if (off <= q.band[i]) continue;
    if (!(off > q.band[i] + doubt[i])) {  // the error between samples an instant apart may be infinite
      ++unclear;
    } else if (outside++ == 0) {
      first = i;
    }
  }
  if (outside > 0) {
    q.verdict = Verdict::outside;
    q.reason =
        fmt::format("{} of {} rows outside the band, first at {:.6g} s", outside, time.size(), time[first]);
  } else if (is_wider_than_signal(q)) {
    q.verdict = of_means ? Verdict::not_judged : Verdict::undecided;
    q.reason = of_means ? "too few runs to decide it" : "the band is as wide as the signal";
  } else if (unclear > 0) {
    q.verdict = Verdict::undecided;
    q.reason = fmt::format(
        "sampled too coarsely: {} of {} rows are outside the band by less than the error of interpolation",
        unclear, time.size());
  } else {
    q.verdict = Verdict::inside;
  }
}

struct Side {
  const std::vector<double>& time;
  Columns columns;
};

constexpr double round_off_of_means = 1e-6;  // share of the largest magnitude: means are written with fewer
                                             // digits

constexpr const char* no_band_text = "the reference has no band; use --tolerance";

// Criteria for all quantities.
struct Judgement {
  const Tolerance& tolerance;
  std::optional<MeanTest> test;  // if the reference is an ensemble
  bool mine_is_run = true;
  std::vector<double> no_band;  // zeros if the reference has no band, so that only the tolerance counts
};

double share_of(const std::string& name, const Tolerance& tolerance) {
  const auto own = tolerance.of.find(name);
  return own == tolerance.of.end() ? tolerance.share : own->second;
}

// Adds the effect of chance on the difference of both means.
void add_chance(const MeanTest& test, const std::vector<double>& time, const std::vector<double>& mine,
                const std::vector<double>& reference, QuantityDifference& q) {
  const auto errors = test.standard_errors(time, mine, reference);
  for (std::size_t i = 0; i < time.size(); ++i) q.band[i] += test.chance() * errors[i];
  const auto top = static_cast<std::size_t>(std::ranges::find(time, q.reference.time) - time.begin());
  const double change = q.band[top] + (test.seen() - test.chance()) * errors[top];
  if (q.reference.value != 0.0) q.seen = change / std::abs(q.reference.value);
}

QuantityDifference compare_quantity(const std::string& name, const Side& mine, const Columns& reference,
                                    const std::vector<double>& time, const Window& window,
                                    const Judgement& judgement) {
  QuantityDifference q;
  q.name = name;
  const auto* band = reference.find(name + band_suffix);
  const auto* error = judgement.test ? reference.find(name + standard_error_suffix) : nullptr;
  const auto* own_error = judgement.mine_is_run ? nullptr : mine.columns.find(name + standard_error_suffix);
  const auto* values = mine.columns.find(name);
  if (!judgement.no_band.empty() && share_of(name, judgement.tolerance) > 0.0) band = &judgement.no_band;
  if (!values || window.count == 0) {
    if (band || error) q.verdict = Verdict::undecided;
    q.reason = values ? "no common times: mine " + window.text : "mine does not have it";
    return q;
  }
  std::vector<double> doubt, own_errors;
  for (const double t : time) {
    const Sample sample = interpolate(mine.time, *values, t);
    q.values.push_back(sample.value);
    doubt.push_back(sample.doubt);
    if (own_error) own_errors.push_back(interpolate(mine.time, *own_error, t).value);
  }
  q.expected = rows(*reference.find(name), window);
  measure(time, q);
  if (!band && !error) {
    q.reason = no_band_text;
    return q;
  }
  q.band = band ? rows(*band, window) : std::vector<double>(window.count, 0.0);
  const double share = share_of(name, judgement.tolerance) + (error ? round_off_of_means : 0.0);
  for (double& width : q.band) width += share * std::abs(q.reference.value);
  if (error && !judgement.mine_is_run && !own_error) {
    q.verdict = Verdict::undecided;
    q.reason = "mine is a mean without its standard error";
    return q;
  }
  if (error) add_chance(*judgement.test, time, own_errors, rows(*error, window), q);
  judge(time, doubt, error != nullptr, q);
  if (!window.whole && q.verdict == Verdict::inside) {
    q.verdict = Verdict::undecided;
    q.reason = "mine " + window.text;
  }
  return q;
}

void conclude(Difference& difference) {
  const auto with = [&](Verdict verdict) {
    return std::find_if(difference.quantities.begin(), difference.quantities.end(),
                        [&](const auto& q) { return q.verdict == verdict; });
  };
  const auto end = difference.quantities.end();
  for (const Verdict worst : {Verdict::outside, Verdict::undecided}) {
    const auto found = with(worst);
    if (found == end) continue;
    difference.verdict = worst;
    difference.reason = found->name + ": " + found->reason;
    return;
  }
  const bool judged = with(Verdict::inside) != end;
  difference.verdict = judged ? Verdict::inside : Verdict::undecided;
  if (judged) return;
  difference.reason = difference.reference_runs > 1 ? "too few runs to decide" : no_band_text;
}

}  // namespace

const char* verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::inside:
      return "inside";
    case Verdict::outside:
      return "outside";
    case Verdict::on_the_bound:
      return "on the bound";
    case Verdict::undecided:
      return "undecided";
    case Verdict::not_judged:
      break;
  }
  return "not judged";
}

Difference compare(const History& mine, const History& reference, const std::vector<std::string>& only,
                   const Tolerance& tolerance) {
  const Filtered filtered = filtered_as(reference, mine);
  Side my_side{mine.time, Columns(mine)};
  my_side.columns.add(filtered.columns);
  const Columns expected(reference);
  check_bands(reference);
  const Window window = common_rows(mine, reference);
  Difference difference;
  difference.runs = mine.runs;
  difference.reference_runs = reference.runs;
  difference.time = rows(reference.time, window);
  const auto names = names_to_compare(reference, only, tolerance);
  Judgement judgement{tolerance, {}, mine.runs == 1, {}};
  if (reference.runs == 1 && !states_band(reference)) judgement.no_band.resize(reference.time.size());
  if (reference.runs > 1)
    judgement.test.emplace(mine.runs, reference.runs, names.size() * difference.time.size());
  for (const auto& name : names)
    difference.quantities.push_back(
        compare_quantity(name, my_side, expected, difference.time, window, judgement));
  for (auto& q : difference.quantities)
    if (const auto why = filtered.too_coarse.find(q.name); why != filtered.too_coarse.end())
      q.reason = why->second;
  conclude(difference);
  return difference;
}

}  // namespace driver
