// SPDX-License-Identifier: Apache-2.0
// [fabric] -> membrane::BagDescription.
#pragma once

#include <string>
#include <vector>

#include "engine/scene.hpp"

namespace driver {

/// [fabric]: properties of each element, compression and leak law (returned; its table goes to `model`,
/// which is null without gas); bag.elements are set.
LeakLaw read_fabric(TableReader& root, const mesh::Mesh& mesh, const std::vector<std::string>& null_panels,
                    membrane::BagDescription& bag, gas::ControlVolumeModel* model);
/// Least mass per area of a bag's fabric [kg/m2]; infinite if all of it is null.
double lightest_fabric(const membrane::BagDescription& bag);

}  // namespace driver
