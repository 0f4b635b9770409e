// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "driver/case_reader.hpp"
#include "membrane/bag_model.hpp"
#include "scene/bag_mesh.hpp"

namespace driver {

/// What holds a bag, from [membrane]: fixed panels, rollers, straps and the plate.
void read_supports(TableReader& table, const BagMesh& source, membrane::BagDescription& bag);

}  // namespace driver
