// SPDX-License-Identifier: Apache-2.0
// For a program without zlib.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "deflate.hpp"

namespace driver {
namespace {

// RFC 1950, section 8.2.
std::uint32_t adler32(const std::string& bytes) {
  std::uint32_t a = 1, b = 0;
  for (const char byte : bytes) {
    a = (a + static_cast<unsigned char>(byte)) % 65521;
    b = (b + a) % 65521;
  }
  return b << 16 | a;
}

}  // namespace

// Stored blocks of RFC 1951, section 3.2.4: whether it is the last, its length, the length's complement, the
// bytes.
std::string deflated(const std::string& bytes) {
  constexpr std::size_t longest = 65535;
  std::string packed = "\x78\x01";
  std::size_t begin = 0;
  do {
    const std::size_t length = std::min(longest, bytes.size() - begin);
    packed += begin + length == bytes.size() ? '\1' : '\0';
    for (const std::size_t number : {length, ~length})
      for (const int shift : {0, 8}) packed += static_cast<char>(number >> shift & 255U);
    packed.append(bytes, begin, length);
    begin += length;
  } while (begin < bytes.size());
  const std::uint32_t sum = adler32(bytes);
  for (const int shift : {24, 16, 8, 0}) packed += static_cast<char>(sum >> shift & 255U);
  return packed;
}

}  // namespace driver
