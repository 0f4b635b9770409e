// SPDX-License-Identifier: Apache-2.0
// Private to the reader of Gmsh files: their numbers, in words or in bytes.
#pragma once

#include <cmath>
#include <string>

#include "mesh_tokens.hpp"
#include "number_bytes.hpp"

namespace mesh {

/// Reads numbers of a Gmsh file.
class GmshNumbers {
 public:
  static constexpr long long most = 2'000'000'000;  // number of a node, an element or a group

  explicit GmshNumbers(TokenReader& words) : words_(words) {}

  /// From here on numbers may be bytes; the next one is an int of value 1 and says their order.
  void set_binary() {
    words_.next_line();
    is_binary_ = true;
    const std::string_view one = words_.bytes(4, "the number 1");
    if (number_at<std::int32_t>(one, ByteOrder::little) != 1) order_ = ByteOrder::big;
    if (number_at<std::int32_t>(one, order_) != 1)
      words_.fail({}, "the number 1, which says the order of bytes, is missing");
  }
  bool is_binary() const { return is_binary_; }

  /// Goes from the line before numbers to the first of them.
  void begin() {
    if (is_binary_) words_.next_line();
  }
  /// Where the next number is.
  MeshWord place(const char* what) { return is_binary_ ? MeshWord{} : words_.peek(what); }

  long long integer(const char* what, long long low, long long high, std::size_t size = 4) {
    if (!is_binary_) return words_.integer(what, low, high);
    const long long value = whole_at(words_.bytes(size, what), {NumberType::Kind::whole, size}, order_);
    if (value < low || value > high)
      words_.fail({}, std::string(what) + " is " + std::to_string(value) + ", allowed: a whole number from " +
                          std::to_string(low) + " to " + std::to_string(high));
    return value;
  }
  /// Numbers of nodes and elements have eight bytes since version 4, and four before.
  void set_item_size(std::size_t size) { item_size_ = size; }
  /// The number of a node or an element.
  long long item(const char* what) { return integer(what, 1, most, item_size_); }
  /// The number of a group or an entity.
  long long tag(const char* what) { return integer(what, -most, most); }
  /// A number of items that follow, in eight bytes.
  std::size_t count(const char* what) {
    if (!is_binary_) return words_.count(what);
    return static_cast<std::size_t>(integer(what, 0, static_cast<long long>(words_.left()), 8));
  }
  double number(const char* what) {
    if (!is_binary_) return words_.number(what);
    const double value = number_at<double>(words_.bytes(8, what), order_);
    if (!std::isfinite(value)) words_.fail({}, std::string(what) + " is not finite");
    return value;
  }

 private:
  TokenReader& words_;
  bool is_binary_ = false;
  std::size_t item_size_ = 4;
  ByteOrder order_ = ByteOrder::little;
};

}  // namespace mesh
