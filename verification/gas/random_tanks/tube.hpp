// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "enclosure/enclose.hpp"
#include "libgas_route.hpp"
#include "tank.hpp"

/// Random tanks as scenes for proved bounds.
namespace random_tanks {

/// None of a tank whose volume follows the pressure.
std::optional<enclosure::Scene> scene_of(const Tank& tank, const std::string& csv);

/// Bounds of p, T and m at a time [s].
struct Proved {
  double time;
  std::array<double, 3> lower, upper;
};

/// The bounds of a tube at its times.
std::vector<Proved> proved(const enclosure::Tube& tube);

/// Largest distance of a run's p, T and m from bounds at the ends of calls, relative.
double distance(const Computed& run, const std::vector<Proved>& bounds);

/// That of libgas; not a number if it refuses. Throws enclosure::Refusal.
double distance_to_tube(const Tank& tank, const enclosure::Scene& scene, double width, double longest);

/// What ships of a tank: its bounds at the middle and the end, and the steps that they took.
struct ShippedTube {
  long steps = 0;
  std::vector<Proved> bounds;
};

/// Width of the bounds that ship.
inline constexpr double kShippedWidth = 1e-10;
/// Computes them, in at most so many seconds. Throws enclosure::Refusal.
ShippedTube compute_shipped(const Tank& tank, const enclosure::Scene& scene, double longest);
/// Reads verification/enclosure/tubes/random_tanks.csv, by seed.
std::map<std::uint64_t, ShippedTube> read_shipped(const std::string& csv);

}  // namespace random_tanks
