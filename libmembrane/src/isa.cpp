// SPDX-License-Identifier: Apache-2.0
#include "membrane/isa.hpp"

#include <stdexcept>

#include "kernel_table.hpp"

namespace membrane {

namespace {

bool has_avx2() {
#if defined(MEMBRANE_HAS_AVX2)
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

}  // namespace

Isa best_isa() {
  return has_avx2() ? Isa::avx2 : Isa::baseline;
}

const char* name_of(Isa isa) {
  switch (isa) {
    case Isa::scalar:
      return "scalar";
    case Isa::avx2:
      return "avx2";
    case Isa::baseline:
      return "baseline";
  }
  throw std::invalid_argument("isa: is not an enumerator");
}

const KernelTable& kernel_table(Isa isa) {
  if (isa == Isa::scalar) return baseline::kScalarTable;
#if defined(MEMBRANE_HAS_AVX2)
  if (isa == Isa::avx2) {
    if (!has_avx2())
      throw std::invalid_argument("isa: avx2, but this processor has baseline and scalar only");
    return avx2::kTable;
  }
#else
  if (isa == Isa::avx2) throw std::invalid_argument("isa: avx2, but this build has baseline and scalar only");
#endif
  if (isa != Isa::baseline) throw std::invalid_argument("isa: is not an enumerator");
  return baseline::kTable;
}

}  // namespace membrane
