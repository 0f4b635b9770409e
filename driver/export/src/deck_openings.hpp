// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "export/deck.hpp"

namespace driver {

inline constexpr const char* decided_by_run = "its trigger depends on the run, by pressure or contact";
inline constexpr const char* never_on = "its trigger does not come on before end_time";

/// When a trigger comes on and goes off in turn, nothing if the run decides; without a trigger on from 0.
std::optional<std::vector<double>> times_of(const Scene& scene, std::optional<std::size_t> trigger);

/// Vents of the scene, and the fabric of the deck's parts that leaks.
void add_vents(const Scene& scene, Deck& deck);
void add_leaks(const Scene& scene, Deck& deck);

}  // namespace driver
