// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "export/deck.hpp"

namespace driver {

inline constexpr const char* decided_by_run = "its trigger depends on the run, by pressure or contact";
inline constexpr const char* never_on = "its trigger does not come on before end_time";

/// Times at which a trigger comes on and goes off in turn; empty if only a run can tell. Without a trigger:
/// on from 0.
std::optional<std::vector<double>> times_of(const Scene& scene, std::optional<std::size_t> trigger);

/// Adds the vents of the scene and the leaking fabric of the deck's parts.
void add_vents(const Scene& scene, Deck& deck);
void add_leaks(const Scene& scene, Deck& deck);

}  // namespace driver
