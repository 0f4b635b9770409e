// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "membrane/mesh.hpp"

namespace membrane {

// Limit of what refine makes.
inline constexpr int kMostElements = 10'000'000;

/// Splits every element in four at the midpoints of its sides: volume, area and panels stay, lengths halve.
/// Midpoints lie on the old elements, so a curved design shape is not followed more closely (a generator's
/// cell counts do that). Old nodes keep their numbers, new ones follow in the order of the elements; the same
/// elements with other nodes (an initial shape) are refined alike. `rim_only_panels` (null panels) get no
/// node inside: only their sides on the rim are split. Throws std::invalid_argument for an unknown panel, a
/// node number out of range, or more than kMostElements.
Mesh refine(const Mesh& mesh, std::span<const std::string> rim_only_panels = {});

}  // namespace membrane
