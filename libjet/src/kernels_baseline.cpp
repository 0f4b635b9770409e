// SPDX-License-Identifier: Apache-2.0
// Compiled for every processor of the target.
#define JET_KERNELS baseline
#include "edge_kernels.hpp"
#include "field_kernels.hpp"

namespace jet::baseline {

const KernelTable kTable{select_elements, evaluate,        project_nodes, project_listed, project_centroids,
                         make_rays,       look_at_patches, element_boxes, make_edges,     merge,
                         meet_pairs,      meet_edges,      meet_elements};

}  // namespace jet::baseline
