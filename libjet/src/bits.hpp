// SPDX-License-Identifier: Apache-2.0
// Sets as bits in bytes, padded to a multiple of 32 bytes. Kernels share no inline code with other files, so
// floats.hpp has some of these functions too.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

namespace jet {

inline std::size_t set_bytes(std::size_t bytes) {
  return (bytes + 31) / 32 * 32;
}

/// to = a without b. Precondition: the same size.
inline void and_not(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b,
                    std::span<std::uint8_t> to) {
  const std::size_t count = to.size();
#ifndef __clang__
#pragma GCC ivdep  // `to` is a or b, or overlaps neither
#endif
  for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<std::uint8_t>(a[i] & ~b[i]);
}

/// Number of bytes that are not 0.
inline int count_used(std::span<const std::uint8_t> bytes) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 8) {
    constexpr std::uint64_t low = 0x7f7f7f7f7f7f7f7fu, ones = 0x0101010101010101u;
    std::uint64_t x;
    std::memcpy(&x, &bytes[i], 8);
    count += ((((x & low) + low) | x) >> 7 & ones) * ones >> 56;
  }
  return static_cast<int>(count);
}

/// Packs bytes of 0 or 1 as bits, eight to a byte. Precondition: eight times as many bytes.
inline void pack(std::span<const std::uint8_t> bytes, std::span<std::uint8_t> bits) {
  for (std::size_t i = 0; i < bits.size(); ++i) {
    static_assert(std::endian::native == std::endian::little);
    std::uint64_t eight;
    std::memcpy(&eight, &bytes[8 * i], 8);
    bits[i] = static_cast<std::uint8_t>(eight * 0x0102040810204080u >> 56);  // byte j to bit 56 + j
  }
}

}  // namespace jet
