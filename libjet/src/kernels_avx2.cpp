// SPDX-License-Identifier: Apache-2.0
// Compiled with the AVX2 instruction set; reached only on processors that have it.
#define JET_KERNELS avx2
#include "field/field_kernels.hpp"
#include "visibility/block_kernels.hpp"
#include "visibility/side_kernels.hpp"

namespace jet::avx2 {

const KernelTable kTable{
    list_needed, select_elements,  evaluate,  force,        project_nodes, code_nodes, project_listed,
    frustum_of,  classify_patches, list_bits, choose_boxes, merge,         find_pairs, meet_pairs};

}  // namespace jet::avx2
