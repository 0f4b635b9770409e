// SPDX-License-Identifier: Apache-2.0
// Private to the mesh files: numbers as bytes of a binary file.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace mesh {

/// What the bytes of a number mean.
struct NumberType {
  enum class Kind { whole, unsigned_whole, real } kind;
  std::size_t size;  // [bytes] 1, 2, 4 or 8; of a real number 4 or 8
};

/// Order of the bytes of a number.
enum class ByteOrder { little, big };

/// The number at the beginning of `bytes`, which has its bytes. A whole number beyond 2^63 becomes negative.
template <class T>
T number_at(std::string_view bytes, ByteOrder order) {
  std::array<char, sizeof(T)> own;
  std::copy_n(bytes.begin(), sizeof(T), own.begin());
  const bool is_native = (order == ByteOrder::little) == (std::endian::native == std::endian::little);
  if (!is_native) std::ranges::reverse(own);
  T value;
  std::memcpy(&value, own.data(), sizeof value);
  return value;
}

inline long long whole_at(std::string_view bytes, NumberType type, ByteOrder order) {
  const bool is_signed = type.kind == NumberType::Kind::whole;
  switch (type.size) {
    case 1:
      return is_signed ? number_at<std::int8_t>(bytes, order) : number_at<std::uint8_t>(bytes, order);
    case 2:
      return is_signed ? number_at<std::int16_t>(bytes, order) : number_at<std::uint16_t>(bytes, order);
    case 4:
      return is_signed ? number_at<std::int32_t>(bytes, order)
                       : static_cast<long long>(number_at<std::uint32_t>(bytes, order));
    default:
      return number_at<std::int64_t>(bytes, order);
  }
}

inline double real_at(std::string_view bytes, NumberType type, ByteOrder order) {
  if (type.kind != NumberType::Kind::real) return static_cast<double>(whole_at(bytes, type, order));
  return type.size == 4 ? static_cast<double>(number_at<float>(bytes, order))
                        : number_at<double>(bytes, order);
}

}  // namespace mesh
