// SPDX-License-Identifier: Apache-2.0
// Compiled with the AVX2 instruction set; reached only on processors that have it.
#define JET_KERNELS avx2
#include "field_kernels.hpp"
#include "touch_kernels.hpp"

namespace jet::avx2 {

const KernelTable kTable{select_elements,  evaluate, project_nodes, project_centroids, ray_boxes,
                         element_boxes,    merge,    overlap,       shortlist,         rays_touching,
                         elements_touching};

}  // namespace jet::avx2
