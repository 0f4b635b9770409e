// SPDX-License-Identifier: Apache-2.0
#define MEMBRANE_KERNELS baseline
#include "element_kernels.hpp"
#include "node_kernels.hpp"

namespace membrane::baseline {

const KernelTable kTable{surface<Lanes>,
                         element_forces<IsotropicConstants, Compression::linear, Lanes>,
                         element_forces<IsotropicConstants, Compression::none, Lanes>,
                         element_forces<OrthotropicConstants, Compression::linear, Lanes>,
                         element_forces<OrthotropicConstants, Compression::none, Lanes>,
                         nodal_forces,
                         volume_gradient,
                         jet_forces,
                         advance};

const KernelTable kScalarTable{surface<double>,
                               element_forces<IsotropicConstants, Compression::linear, double>,
                               element_forces<IsotropicConstants, Compression::none, double>,
                               element_forces<OrthotropicConstants, Compression::linear, double>,
                               element_forces<OrthotropicConstants, Compression::none, double>,
                               nodal_forces,
                               volume_gradient,
                               jet_forces,
                               advance};

}  // namespace membrane::baseline
