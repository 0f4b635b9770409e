// SPDX-License-Identifier: Apache-2.0
#define MEMBRANE_KERNELS baseline
#include "skin_kernels.hpp"

namespace membrane::baseline {

const KernelTable kTable = kTableOf<Lanes>;
const KernelTable kScalarTable = kTableOf<double>;

}  // namespace membrane::baseline
