// SPDX-License-Identifier: Apache-2.0
// Compiled for every processor of the target.
#define JET_KERNELS baseline
#include "field_kernels.hpp"
#include "touch_kernels.hpp"

namespace jet::baseline {

const KernelTable kTable{select_elements,  evaluate, project_nodes, project_centroids, ray_boxes,
                         element_boxes,    merge,    overlap,       shortlist,         rays_touching,
                         elements_touching};

}  // namespace jet::baseline
