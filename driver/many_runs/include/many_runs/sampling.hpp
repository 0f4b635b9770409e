// SPDX-License-Identifier: Apache-2.0
// Points of sampled designs, and Sobol indices of their results: plain numbers, no scenes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace driver {

/// One place in the unit cube for each factor, in [0, 1).
using UnitPoint = std::vector<double>;

/// Latin hypercube: each factor has one point in each of `count` equal intervals. The same for the same
/// `seed`. McKay, Beckman, Conover, Technometrics 21 (1979) 239.
std::vector<UnitPoint> latin_hypercube(int count, int factors, std::uint64_t seed);

/// The first `count` points of Sobol's sequence (GSL), from 1/2 on. Throws std::invalid_argument for more
/// than 40 factors, which GSL has no directions for.
std::vector<UnitPoint> sobol_sequence(int count, int factors);

/// Points for Sobol indices: for each of `rows` a point a, a point b, and for each factor a point that is a
/// with this factor's value of b. So there are rows * (factors + 2) points. Throws std::invalid_argument for
/// more than 20 factors. Saltelli et al., Comput. Phys. Commun. 181 (2010) 259.
std::vector<UnitPoint> sobol_index_points(int rows, int factors);

/// A value with the ends of its 95 % confidence interval.
struct Estimate {
  double value = 0.0, low = 0.0, high = 0.0;
};

/// Shares of the variance of one quantity that one factor explains: by itself, and with all others.
struct SobolIndex {
  Estimate first_order, total;
};

inline constexpr int fewest_sobol_rows = 8;

/// Indices of each factor from one value for each of sobol_index_points. A row with a value missing is left
/// out. First order by Saltelli (2010), total by Jansen (1999); the intervals are those of 1000 bootstrap
/// samples of the rows. Empty if fewer than 8 rows are whole or the values do not vary.
std::vector<SobolIndex> sobol_indices(std::span<const std::optional<double>> values, int factors);

}  // namespace driver
