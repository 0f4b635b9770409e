// SPDX-License-Identifier: Apache-2.0
#include "compare/enclosure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/case_reader.hpp"
#include "base/csv_table.hpp"

namespace driver {
namespace {

const std::string lower_suffix = "_lower", upper_suffix = "_upper";

/// Index of the row of `times` at time t, to rounding; none if there is none.
std::optional<std::size_t> row_at(const std::vector<double>& times, double t) {
  const double reach = 4.0 * std::numeric_limits<double>::epsilon() * std::abs(t);
  const auto found = std::lower_bound(times.begin(), times.end(), t - reach);
  if (found == times.end() || *found > t + reach) return std::nullopt;
  return static_cast<std::size_t>(found - times.begin());
}

double magnitude_of(const std::vector<double>& lower, const std::vector<double>& upper) {
  double largest = 0.0;
  for (std::size_t i = 0; i < lower.size(); ++i)
    largest = std::max({largest, std::abs(lower[i]), std::abs(upper[i])});
  return largest;
}

EnclosedQuantity judge_quantity(const History& mine, const ProvedBounds& e, std::size_t c, double tolerance) {
  EnclosedQuantity q;
  q.name = e.columns[c];
  const std::vector<double>& values = *mine.find(q.name);
  const double scale = magnitude_of(e.lower[c], e.upper[c]), allowed = tolerance * scale;
  bool certain = true, outside = false;
  std::optional<double> missing;
  for (std::size_t i = 0; i < e.time.size(); ++i) {
    const auto row = row_at(mine.time, e.time[i]);
    if (!row) {
      missing = e.time[i];
      continue;
    }
    ++q.rows;
    const double value = values[*row], low = e.lower[c][i], high = e.upper[c][i];
    const double distance = std::max({low - value, value - high, 0.0});
    const double farthest = std::max(std::abs(value - low), std::abs(value - high));
    if (distance > q.distance) q.distance = distance, q.time = e.time[i];
    if (scale > 0.0) q.width = std::max(q.width, (high - low) / scale);
    outside = outside || distance > allowed;
    certain = certain && (tolerance > 0.0 ? farthest <= allowed : distance == 0.0);
  }
  q.share = scale > 0.0 ? q.distance / scale : 0.0;
  if (outside) {
    q.verdict = Verdict::outside;
    q.reason =
        fmt::format("off by {:.3g} or more at {:.6g} s, a share of {:.3g}", q.distance, q.time, q.share);
  } else if (missing) {
    q.reason = fmt::format("mine has no row at {} s", *missing);
  } else if (!certain) {
    q.reason = "the bounds are wider than the tolerance allows to tell";
  } else {
    q.verdict = Verdict::inside;
  }
  return q;
}

}  // namespace

ProvedBounds read_enclosure(const std::filesystem::path& file) {
  const CsvHeader header = read_csv_header(file, [](const std::string& name) { return name == "time_s"; });
  ProvedBounds e;
  std::vector<std::string> names{"time_s"};
  for (const std::string& name : header.names) {
    if (!name.ends_with(lower_suffix)) continue;
    e.columns.push_back(name.substr(0, name.size() - lower_suffix.size()));
    names.push_back(name);
    names.push_back(e.columns.back() + upper_suffix);
  }
  if (e.columns.empty())
    throw CaseError(
        fmt::format("{}: has no column NAME_lower, as `gasjet enclose` writes them", file.string()));
  CsvTable table = read_csv(file, names);
  e.time = table.values[0];
  for (std::size_t i = 1; i < e.time.size(); ++i)
    if (!(e.time[i] > e.time[i - 1])) table.fail(0, i, "is not later than the row before");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < e.columns.size(); ++c) {
    auto &low = table.values[2 * c + 1], &high = table.values[2 * c + 2];
    for (std::size_t i = 0; i < low.size(); ++i) {
      if (low[i] > high[i]) table.fail(2 * c + 1, i, "is above its upper bound");
      // The nearest double may lie inside of a decimal.
      low[i] = std::nextafter(low[i], -infinity);
      high[i] = std::nextafter(high[i], infinity);
    }
    e.lower.push_back(low);
    e.upper.push_back(high);
  }
  return e;
}

EnclosureVerdict judge(const History& mine, const ProvedBounds& enclosure,
                       const std::vector<std::string>& only, const Tolerance& tolerance) {
  const auto require_known = [&](const std::string& name) {
    if (std::ranges::find(enclosure.columns, name) == enclosure.columns.end())
      throw CaseError(fmt::format("{}: is no column of the enclosure; it has {}", name,
                                  fmt::join(enclosure.columns, ", ")));
    if (!mine.find(name)) throw CaseError(name + ": is no column of mine");
  };
  for (const auto& name : only) require_known(name);
  for (const auto& [name, share] : tolerance.of) require_known(name);
  EnclosureVerdict result;
  bool all = true;
  for (std::size_t c = 0; c < enclosure.columns.size(); ++c) {
    const std::string& name = enclosure.columns[c];
    if (!mine.find(name) || (!only.empty() && std::ranges::find(only, name) == only.end())) continue;
    const auto own = tolerance.of.find(name);
    result.quantities.push_back(
        judge_quantity(mine, enclosure, c, own == tolerance.of.end() ? tolerance.share : own->second));
    const Verdict verdict = result.quantities.back().verdict;
    if (verdict == Verdict::outside) result.verdict = Verdict::outside;
    all = all && verdict == Verdict::inside;
  }
  if (result.quantities.empty())
    throw CaseError(
        fmt::format("mine has no column of {}; give a history as MINE, and its bounds as REFERENCE",
                    fmt::join(enclosure.columns, ", ")));
  if (all) result.verdict = Verdict::inside;
  return result;
}

}  // namespace driver
