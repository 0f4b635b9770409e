// SPDX-License-Identifier: Apache-2.0
// The kernels of processors without AVX2, in place of those of the processor (linker option --wrap).
#include "kernel_table.hpp"
#include "membrane/isa.hpp"

extern "C" {
membrane::Isa __wrap__ZN8membrane8best_isaEv();
const jet::KernelTable& __wrap__ZN3jet12kernel_tableEv();

membrane::Isa __wrap__ZN8membrane8best_isaEv() {
  return membrane::Isa::baseline;
}
const jet::KernelTable& __wrap__ZN3jet12kernel_tableEv() {
  return jet::baseline::kTable;
}
}
