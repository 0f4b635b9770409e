// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace membrane {

// Instruction sets the kernels are compiled for. All three give the same bits: same lanes, same order of
// operations, no contraction. `scalar` is the same source with one lane and serves as oracle.
enum class Isa { scalar, baseline, avx2 };

// The fastest of them that this processor runs.
Isa best_isa();

// `scalar`, `baseline` or `avx2`.
const char* name_of(Isa isa);

}  // namespace membrane
