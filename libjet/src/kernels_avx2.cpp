// SPDX-License-Identifier: Apache-2.0
// Compiled with the AVX2 instruction set; reached only on processors that have it.
#define JET_KERNELS avx2
#include "edge_kernels.hpp"
#include "field_kernels.hpp"

namespace jet::avx2 {

const KernelTable kTable{select_elements, evaluate,        project_nodes, project_listed, project_centroids,
                         make_rays,       look_at_patches, element_boxes, make_edges,     merge,
                         meet_pairs,      meet_edges,      meet_elements};

}  // namespace jet::avx2
