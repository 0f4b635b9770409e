// SPDX-License-Identifier: Apache-2.0
// Memory of the program on huge pages. The libraries leave this choice to the program.
#pragma once

namespace driver::commands {

/// Puts the first 16 MB of the heap on huge pages, if the system allows: a bag's scene has some thousand
/// pages of 4 kB, and the first use of each takes microseconds. Call it once, as the program starts. Without
/// glibc it does nothing.
void use_huge_heap();

}  // namespace driver::commands
