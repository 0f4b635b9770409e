// SPDX-License-Identifier: Apache-2.0
// What a fuzzer's bytes say, and what a harness says of them.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

namespace fuzz {

/// Values one after the other; zeros after the end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  /// A whole number from `low` to `high`.
  int integer(int low, int high) { return low + static_cast<int>(raw<std::uint16_t>() % (high - low + 1)); }
  /// Any finite number: half of the time one of a few digits, where ties and degenerate shapes are.
  double number() {
    if (raw<std::uint8_t>() % 2 == 0) return 0.25 * raw<std::int8_t>();
    const double value = raw<double>();
    return std::isfinite(value) ? value : 0.0;
  }
  /// A number from `low` to `high`.
  double number(double low, double high) { return low + (high - low) * raw<std::uint32_t>() / 4294967295.0; }

 private:
  template <class T>
  T raw() {
    T value{};
    const std::size_t count = size_ < sizeof value ? size_ : sizeof value;
    std::memcpy(&value, data_, count);
    data_ += count;
    size_ -= count;
    return value;
  }
  const std::uint8_t* data_;
  std::size_t size_;
};

/// Ends the process, so that the fuzzer keeps the input.
inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

/// A file of the process with these bytes.
inline std::filesystem::path file_of(const std::uint8_t* data, std::size_t size, const std::string& ending) {
  static const std::string folder = [] {
    std::string pattern = (std::filesystem::temp_directory_path() / "gasjet_fuzz_XXXXXX").string();
    return std::string(mkdtemp(pattern.data()));
  }();
  const auto file = std::filesystem::path(folder) / ("input" + ending);
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  return file;
}

}  // namespace fuzz
