// SPDX-License-Identifier: Apache-2.0
// Counts every heap allocation of a test program, those of Eigen included (which do not pass through operator
// new).
#pragma once

namespace support {

/// Allocations of the whole program so far, from any thread.
long allocations();

}  // namespace support
