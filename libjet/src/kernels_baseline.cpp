// SPDX-License-Identifier: Apache-2.0
// Compiled for every processor of the target.
#define JET_KERNELS baseline
#include "field/field_kernels.hpp"
#include "visibility/block_kernels.hpp"
#include "visibility/side_kernels.hpp"

namespace jet::baseline {

const KernelTable kTable{
    list_needed, select_elements,  evaluate,  force,        project_nodes, code_nodes, project_listed,
    frustum_of,  classify_patches, list_bits, choose_boxes, merge,         find_pairs, meet_pairs};

}  // namespace jet::baseline
