// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace membrane {

/// Instruction sets that the kernels are compiled for. All three give the same bits: they use the same lanes
/// and the same order of operations, without contraction. `scalar` is the same source with one lane, the
/// oracle of the tests.
enum class Isa { scalar, baseline, avx2 };

/// The fastest instruction set that this processor has.
Isa best_isa();

/// Name of an instruction set: "scalar", "baseline" or "avx2".
const char* name_of(Isa isa);

}  // namespace membrane
