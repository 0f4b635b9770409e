// SPDX-License-Identifier: Apache-2.0
// Compiled with the AVX2 instruction set; reached only on processors that have it.
#define MEMBRANE_KERNELS avx2
#include "element_kernels.hpp"
#include "node_kernels.hpp"

namespace membrane::avx2 {

const KernelTable kTable{surface<Lanes>,
                         element_forces<IsotropicConstants, Compression::linear, Lanes>,
                         element_forces<IsotropicConstants, Compression::none, Lanes>,
                         element_forces<OrthotropicConstants, Compression::linear, Lanes>,
                         element_forces<OrthotropicConstants, Compression::none, Lanes>,
                         nodal_forces,
                         volume_gradient,
                         jet_forces,
                         advance};

}  // namespace membrane::avx2
