// SPDX-License-Identifier: Apache-2.0
// [inflator.jet] -> JetPart.
#pragma once

#include <cstddef>

#include "engine/scene.hpp"

namespace driver {

/// [inflator.jet], or [[inflator.jet]] with shares of the flow, of inflator `index`
void read_jets(TableReader& inflator, std::size_t index, Scene& scene);

}  // namespace driver
