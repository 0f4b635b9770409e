// SPDX-License-Identifier: Apache-2.0
// Values to bytes and back, by one list of them for both ways.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/checksum.hpp"
#include "membrane/vectors.hpp"

namespace driver {

/// Writes values, or reads what was written.
class Archive {
 public:
  Archive() = default;  // writes
  explicit Archive(std::string_view bytes) : in_(bytes), reads_(true) {}

  bool reads() const { return reads_; }
  bool at_end() const { return in_.empty(); }
  const std::string& written() const { return out_; }

  /// Values without pointers. Eigen's fixed sizes are such, though not by name.
  template <class... T>
  void plain(T&... values) {
    static_assert(((std::is_standard_layout_v<T> && !std::is_pointer_v<T>)&&...));
    (bytes(&values, sizeof(T)), ...);
  }
  template <class T, class Allocator>
  void list(std::vector<T, Allocator>& values) {
    static_assert(std::is_standard_layout_v<T>);
    values.resize(size_of(values.size(), sizeof(T)));
    bytes(values.data(), values.size() * sizeof(T));
  }
  /// A list whose length the case gives.
  template <class T>
  void whole(std::vector<T>& values) {
    const std::size_t count = values.size();
    list(values);
    require(values.size() == count);
  }
  void matrix(Eigen::Matrix3Xd& values) {
    values.resize(
        3, static_cast<Eigen::Index>(size_of(static_cast<std::size_t>(values.cols()), 3 * sizeof(double))));
    bytes(values.data(), static_cast<std::size_t>(values.size()) * sizeof(double));
  }
  void text(std::string& value) {
    value.resize(size_of(value.size(), 1));
    bytes(value.data(), value.size());
  }
  void vectors(membrane::Vectors& values) {
    const std::size_t count = size_of(static_cast<std::size_t>(values.count()), 4 * sizeof(double));
    if (count != static_cast<std::size_t>(values.count()))
      values = membrane::Vectors(static_cast<int>(count));
    bytes(values.data(), 4 * count * sizeof(double));
  }

 private:
  void bytes(void* data, std::size_t size) {
    if (size == 0) return;
    if (!reads_) {
      out_.append(static_cast<const char*>(data), size);
      return;
    }
    require(size <= in_.size());
    std::memcpy(data, in_.data(), size);
    in_.remove_prefix(size);
  }
  /// The number of elements that follow; there are at least so many bytes.
  std::size_t size_of(std::size_t now, std::size_t element) {
    std::uint64_t count = now;
    bytes(&count, sizeof count);
    if (reads_) require(count <= in_.size() / element && count <= std::numeric_limits<int>::max());
    return static_cast<std::size_t>(count);
  }
  static void require(bool good) {
    if (!good) throw std::invalid_argument("state: is damaged or cut off; allowed: bytes as they were saved");
  }

  std::string out_;
  std::string_view in_;
  bool reads_ = false;
};

}  // namespace driver
