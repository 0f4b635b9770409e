// SPDX-License-Identifier: Apache-2.0
// Compiled with the AVX2 instruction set; reached only on processors that have it.
#define MEMBRANE_KERNELS avx2
#include "skin_kernels.hpp"

namespace membrane::avx2 {

const KernelTable kTable = kTableOf<Lanes>;

}  // namespace membrane::avx2
