// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace driver {

/// Checksum of bytes: the 64-bit FNV-1a hash.
inline std::uint64_t checksum(std::string_view bytes, std::uint64_t start = 14695981039346656037U) {
  for (const char byte : bytes) start = (start ^ static_cast<unsigned char>(byte)) * 1099511628211U;
  return start;
}

}  // namespace driver
