// SPDX-License-Identifier: Apache-2.0
// Sets as bytes of eight bits.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>

namespace jet {

/// to = a without b. Precondition: the same size, a multiple of eight.
inline void and_not(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b,
                    std::span<std::uint8_t> to) {
  for (std::size_t i = 0; i < to.size(); i += 8) {
    std::uint64_t x, y;
    std::memcpy(&x, &a[i], 8);
    std::memcpy(&y, &b[i], 8);
    x &= ~y;
    std::memcpy(&to[i], &x, 8);
  }
}

}  // namespace jet
