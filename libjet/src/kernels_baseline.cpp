// SPDX-License-Identifier: Apache-2.0
// Compiled for every processor of the target.
#define JET_KERNELS baseline
#include "block_kernels.hpp"
#include "field_kernels.hpp"

namespace jet::baseline {

const KernelTable kTable{select_elements, evaluate,        project_nodes, project_listed,  project_centroids,
                         make_rays,       look_at_patches, element_boxes, gather_elements, merge,
                         meet_pairs,      meet_blocks,     meet_elements};

}  // namespace jet::baseline
