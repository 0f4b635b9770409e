// SPDX-License-Identifier: Apache-2.0
#include "driver/compare.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_map>

#include "compare/phase_lag.hpp"
#include "compare/sampled.hpp"
#include "driver/case_reader.hpp"

namespace driver {
namespace {

constexpr double round_off_of_times = 1e-9;  // of the reference's span: times pass through decimal files

bool is_band(const std::string& name) {
  return name.size() > std::string(band_suffix).size() && name.ends_with(band_suffix);
}

// A history may have thousands of columns.
class Columns {
 public:
  explicit Columns(const History& history) {
    for (const auto& [name, values] : history.columns) values_.emplace(name, &values);
  }
  const std::vector<double>* find(const std::string& name) const {
    const auto found = values_.find(name);
    return found == values_.end() ? nullptr : found->second;
  }

 private:
  std::unordered_map<std::string_view, const std::vector<double>*> values_;
};

void check_name(const char* option, const std::string& name, const std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw CaseError(fmt::format("{} {}: {}, allowed are {}", option, name.empty() ? "''" : name,
                                name.empty() ? "a name is empty" : "the reference has no such quantity",
                                fmt::join(names, ", ")));
}

std::vector<std::string> names_to_compare(const History& reference, const std::vector<std::string>& only,
                                          const Tolerance& tolerance) {
  std::vector<std::string> names;
  for (const auto& [name, values] : reference.columns)
    if (!is_band(name)) names.push_back(name);
  for (const auto& name : only) {
    if (std::count(only.begin(), only.end(), name) > 1)
      throw CaseError(fmt::format("--columns {}: is given twice, once is allowed", name));
    check_name("--columns", name, names);
  }
  for (const auto& [name, share] : tolerance.of) check_name("--tolerance", name, names);
  return only.empty() ? names : only;
}

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

// A band as wide as the signal's own variation tells nothing; of a constant signal, as wide as its value.
bool is_wider_than_signal(const QuantityDifference& q) {
  const auto [low, high] = std::minmax_element(q.expected.begin(), q.expected.end());
  const double size = std::max(std::abs(*low), std::abs(*high));
  if (size == 0.0) return false;
  constexpr double constant = 1e-6;  // of its size: what the band's own round-off may look like
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

void judge(const std::vector<double>& time, const std::vector<double>& doubt, QuantityDifference& q) {
  std::size_t outside = 0, unclear = 0, first = 0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double off = std::abs(q.values[i] - q.expected[i]);
    if (off > 0.0) q.share_of_band = std::max(q.share_of_band, q.band[i] > 0.0 ? off / q.band[i] : HUGE_VAL);
    if (off <= q.band[i]) continue;
    if (!(off > q.band[i] + doubt[i])) {  // the doubt between samples an instant apart may be infinite
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
    q.verdict = Verdict::undecided;
    q.reason = "the band is as wide as the signal";
  } else if (unclear > 0) {
    q.verdict = Verdict::undecided;
    q.reason =
        fmt::format("sampled too coarsely: {} of {} rows outside the band by less than interpolation may err",
                    unclear, time.size());
  } else {
    q.verdict = Verdict::inside;
  }
}

struct Side {
  const std::vector<double>& time;
  Columns columns;
};

QuantityDifference compare_quantity(const std::string& name, const Side& mine, const Columns& reference,
                                    const std::vector<double>& time, const Window& window,
                                    const Tolerance& tolerance) {
  QuantityDifference q;
  q.name = name;
  const auto* band = reference.find(name + band_suffix);
  const auto* values = mine.columns.find(name);
  if (!values || window.count == 0) {
    if (band) q.verdict = Verdict::undecided;
    q.reason = values ? "no common times: mine " + window.text : "mine does not have it";
    return q;
  }
  std::vector<double> doubt;
  for (const double t : time) {
    const Sample sample = interpolate(mine.time, *values, t);
    q.values.push_back(sample.value);
    doubt.push_back(sample.doubt);
  }
  q.expected = rows(*reference.find(name), window);
  measure(time, q);
  if (!band) {
    q.reason = "the reference states no band";
    return q;
  }
  q.band = rows(*band, window);
  const auto own = tolerance.of.find(name);
  const double share = own == tolerance.of.end() ? tolerance.share : own->second;
  for (double& width : q.band) width += share * std::abs(q.reference.value);
  judge(time, doubt, q);
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
  if (!judged) difference.reason = "the reference states no band";
}

void check_bands(const History& reference, const Columns& columns) {
  for (const auto& [name, values] : reference.columns) {
    if (!is_band(name)) continue;
    const std::string quantity = name.substr(0, name.size() - std::string(band_suffix).size());
    if (!columns.find(quantity))
      throw CaseError(fmt::format("{}: the reference has a band but no column {}", name, quantity));
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] < 0.0)
        throw CaseError(fmt::format("{}: {} at {:.6g} s: a half width of 0 or more is allowed", name,
                                    values[i], reference.time[i]));
  }
}

}  // namespace

const char* verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::inside:
      return "inside";
    case Verdict::outside:
      return "outside";
    case Verdict::undecided:
      return "undecided";
    case Verdict::not_judged:
      break;
  }
  return "not judged";
}

const std::vector<double>* History::find(const std::string& name) const {
  for (const auto& [own, values] : columns)
    if (own == name) return &values;
  return nullptr;
}

Difference compare(const History& mine, const History& reference, const std::vector<std::string>& only,
                   const Tolerance& tolerance) {
  const Side my_side{mine.time, Columns(mine)};
  const Columns expected(reference);
  check_bands(reference, expected);
  const Window window = common_rows(mine, reference);
  Difference difference;
  difference.time = rows(reference.time, window);
  for (const auto& name : names_to_compare(reference, only, tolerance))
    difference.quantities.push_back(
        compare_quantity(name, my_side, expected, difference.time, window, tolerance));
  conclude(difference);
  return difference;
}

}  // namespace driver
