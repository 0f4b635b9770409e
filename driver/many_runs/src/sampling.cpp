// SPDX-License-Identifier: Apache-2.0
#include "many_runs/sampling.hpp"

#include <gsl/gsl_qrng.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>

namespace driver {
namespace {

constexpr int most_dimensions = 40;  // of GSL's Sobol sequence
constexpr int bootstrap_samples = 1000;
constexpr std::size_t fewest_rows = fewest_sobol_rows;

// By hand: the standard distributions differ between libraries.
double unit(std::mt19937_64& generator) {
  return static_cast<double>(generator() >> 11) * 0x1p-53;
}

std::size_t below(std::mt19937_64& generator, std::size_t count) {
  return std::min(static_cast<std::size_t>(unit(generator) * static_cast<double>(count)), count - 1);
}

// The values of one row: of a, of b, and of a with one factor of b.
struct Row {
  double a = 0.0, b = 0.0;
  std::vector<double> mixed;
};

std::vector<Row> whole_rows(std::span<const std::optional<double>> values, int factors) {
  const std::size_t width = static_cast<std::size_t>(factors) + 2;
  std::vector<Row> rows;
  for (std::size_t begin = 0; begin + width <= values.size(); begin += width) {
    const auto part = values.subspan(begin, width);
    if (!std::ranges::all_of(part, [](const auto& value) { return value.has_value(); })) continue;
    Row row{*part[0], *part[1], {}};
    for (const auto& value : part.subspan(2)) row.mixed.push_back(*value);
    rows.push_back(std::move(row));
  }
  return rows;
}

struct Pair {
  double first_order, total;
};

// Of the rows that `chosen` numbers. Values are centred first: the estimator's error grows with the mean.
std::vector<Pair> indices(const std::vector<Row>& rows, const std::vector<std::size_t>& chosen, int factors) {
  const double n = static_cast<double>(chosen.size());
  double mean = 0.0, variance = 0.0;
  for (const std::size_t j : chosen) mean += (rows[j].a + rows[j].b) / (2.0 * n);
  for (const std::size_t j : chosen)
    variance +=
        ((rows[j].a - mean) * (rows[j].a - mean) + (rows[j].b - mean) * (rows[j].b - mean)) / (2.0 * n);
  std::vector<Pair> list;
  for (std::size_t i = 0; i < static_cast<std::size_t>(factors); ++i) {
    double first = 0.0, total = 0.0;
    for (const std::size_t j : chosen) {
      const Row& row = rows[j];
      first += (row.b - mean) * (row.mixed[i] - row.a) / n;
      total += (row.a - row.mixed[i]) * (row.a - row.mixed[i]) / (2.0 * n);
    }
    list.push_back({first / variance, total / variance});
  }
  return list;
}

Estimate estimate(double value, std::vector<double> samples) {
  std::ranges::sort(samples);
  const auto at = [&](double share) {
    return samples[static_cast<std::size_t>(share * static_cast<double>(samples.size() - 1))];
  };
  return {value, at(0.025), at(0.975)};
}

}  // namespace

std::vector<UnitPoint> latin_hypercube(int count, int factors, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<UnitPoint> points(static_cast<std::size_t>(count),
                                UnitPoint(static_cast<std::size_t>(factors)));
  std::vector<std::size_t> place(points.size());
  for (std::size_t f = 0; f < static_cast<std::size_t>(factors); ++f) {
    std::iota(place.begin(), place.end(), std::size_t{0});
    for (std::size_t i = place.size(); i > 1; --i) std::swap(place[i - 1], place[below(generator, i)]);
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i][f] = (static_cast<double>(place[i]) + unit(generator)) / static_cast<double>(count);
  }
  return points;
}

std::vector<UnitPoint> sobol_sequence(int count, int factors) {
  if (factors > most_dimensions)
    throw std::invalid_argument("has more than " + std::to_string(most_dimensions) +
                                " dimensions, which Sobol's sequence is not tabulated for");
  gsl_qrng* sequence = gsl_qrng_alloc(gsl_qrng_sobol, static_cast<unsigned>(factors));
  std::vector<UnitPoint> points(static_cast<std::size_t>(count),
                                UnitPoint(static_cast<std::size_t>(factors)));
  for (UnitPoint& point : points) gsl_qrng_get(sequence, point.data());
  gsl_qrng_free(sequence);
  return points;
}

std::vector<UnitPoint> sobol_index_points(int rows, int factors) {
  const auto k = static_cast<std::ptrdiff_t>(factors);
  std::vector<UnitPoint> points;
  for (const UnitPoint& both : sobol_sequence(rows, 2 * factors)) {
    const UnitPoint a(both.begin(), both.begin() + k), b(both.begin() + k, both.end());
    points.push_back(a);
    points.push_back(b);
    for (std::size_t i = 0; i < a.size(); ++i) {
      points.push_back(a);
      points.back()[i] = b[i];
    }
  }
  return points;
}

std::vector<SobolIndex> sobol_indices(std::span<const std::optional<double>> values, int factors) {
  const auto rows = whole_rows(values, factors);
  if (rows.size() < fewest_rows) return {};
  const auto varies = [&](const Row& row) { return row.a != rows.front().a || row.b != rows.front().a; };
  if (std::ranges::none_of(rows, varies)) return {};
  std::vector<std::size_t> chosen(rows.size());
  std::iota(chosen.begin(), chosen.end(), std::size_t{0});
  const auto best = indices(rows, chosen, factors);
  std::vector<std::array<std::vector<double>, 2>> samples(best.size());
  std::mt19937_64 generator(1);
  for (int s = 0; s < bootstrap_samples; ++s) {
    for (auto& j : chosen) j = below(generator, rows.size());
    const auto sample = indices(rows, chosen, factors);
    for (std::size_t i = 0; i < sample.size(); ++i)
      if (std::isfinite(sample[i].total)) {
        samples[i][0].push_back(sample[i].first_order);
        samples[i][1].push_back(sample[i].total);
      }
  }
  std::vector<SobolIndex> result;
  for (std::size_t i = 0; i < best.size(); ++i)
    result.push_back({estimate(best[i].first_order, samples[i][0]), estimate(best[i].total, samples[i][1])});
  return result;
}

}  // namespace driver
