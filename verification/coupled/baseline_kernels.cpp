// SPDX-License-Identifier: Apache-2.0
// The kernels of processors without AVX2, in place of those of the processor (linker option --wrap).
#include "kernel_table.hpp"
#include "membrane/isa.hpp"

membrane::Isa baseline_isa() __asm__("__wrap__ZN8membrane8best_isaEv");
const jet::KernelTable& baseline_table() __asm__("__wrap__ZN3jet12kernel_tableEv");

membrane::Isa baseline_isa() {
  return membrane::Isa::baseline;
}
const jet::KernelTable& baseline_table() {
  return jet::baseline::kTable;
}
