// SPDX-License-Identifier: Apache-2.0
// Parts of the measurement of a case's cost.
#pragma once

#include "engine/scene.hpp"
#include "many_runs/cost.hpp"

namespace driver {

/// The case as it is, and what it can be run without.
void add_variants(const Scene& scene, const CaseDocument& document, CostResult& result);

}  // namespace driver
