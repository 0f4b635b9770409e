// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "mesh/mesh.hpp"

namespace mesh {

/// Largest number of elements that refine makes.
inline constexpr int kMostElements = 10'000'000;

/// Splits every element in four at the midpoints of its sides. Volume, area and panels stay; lengths halve.
/// Midpoints lie on the old elements, so the mesh comes no closer to a curved design shape; a generator with
/// more cells does. Old nodes keep their numbers, and new ones follow in the order of the elements, so that
/// the same elements with other nodes (an initial shape) are refined alike.
///
/// In `rim_only_panels` (null panels) only the sides on the rim are split, so they get no node inside. Throws
/// std::invalid_argument for an unknown panel, a node number or a panel index out of range, or a result of
/// more than kMostElements elements.
Mesh refine(const Mesh& mesh, std::span<const std::string> rim_only_panels = {});

}  // namespace mesh
