// SPDX-License-Identifier: Apache-2.0
#include "kernel_table.hpp"

namespace jet {

const KernelTable& kernel_table() {
#if defined(JET_HAS_AVX2)
  if (__builtin_cpu_supports("avx2") != 0) return avx2::kTable;
#endif
  return baseline::kTable;
}

}  // namespace jet
