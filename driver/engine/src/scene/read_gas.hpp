// SPDX-License-Identifier: Apache-2.0
// [gas], [tank], [[inflator]], [[vent]] -> GasPart.
#pragma once

#include <optional>
#include <vector>

#include "engine/scene.hpp"

namespace driver {

/// [gas], [[gas.species]], [[inflator]] (its gas), triggers, vents and the tank. `ambient` and `inflators`
/// are read but not finished: the jets are read from the latter later.
void read_gas(TableReader& root, std::optional<TableReader>& ambient, std::vector<TableReader>& inflators,
              Scene& scene);

}  // namespace driver
