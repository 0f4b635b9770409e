// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/case_reader.hpp"
#include "engine/bag_mesh.hpp"
#include "membrane/bag_model.hpp"

namespace driver {

/// What holds a bag, from [membrane]: fixed panels, rollers, straps and the plate.
void read_supports(TableReader& table, const BagMesh& source, membrane::BagDescription& bag);

}  // namespace driver
