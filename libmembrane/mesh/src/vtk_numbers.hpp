// SPDX-License-Identifier: Apache-2.0
// Private to the reader of legacy VTK files: numbers of their arrays, in words or in bytes.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "mesh_tokens.hpp"
#include "number_bytes.hpp"

namespace mesh {

/// A type of a legacy file. Of `bit`, eight values are one byte; a string has its length before it.
struct VtkType {
  std::string name;  // in capitals
  NumberType number;
  bool is_whole() const { return name != "STRING" && number.kind != NumberType::Kind::real; }
};

/// Reads numbers of a legacy file.
class VtkNumbers {
 public:
  explicit VtkNumbers(TokenReader& words) : words_(words) {}

  void set_binary() { is_binary_ = true; }
  bool is_binary() const { return is_binary_; }

  /// Reads the name of a type.
  VtkType type(const char* what) {
    using Kind = NumberType::Kind;
    struct Known {
      std::string_view name;
      NumberType number;
    };
    static constexpr std::array<Known, 17> known = {{{"BIT", {Kind::unsigned_whole, 1}},
                                                     {"UNSIGNED_CHAR", {Kind::unsigned_whole, 1}},
                                                     {"CHAR", {Kind::whole, 1}},
                                                     {"SIGNED_CHAR", {Kind::whole, 1}},
                                                     {"UNSIGNED_SHORT", {Kind::unsigned_whole, 2}},
                                                     {"SHORT", {Kind::whole, 2}},
                                                     {"UNSIGNED_INT", {Kind::unsigned_whole, 4}},
                                                     {"INT", {Kind::whole, 4}},
                                                     {"UNSIGNED_LONG", {Kind::unsigned_whole, 8}},
                                                     {"LONG", {Kind::whole, 8}},
                                                     {"VTKIDTYPE", {Kind::whole, 4}},  // VTK writes an int
                                                     {"VTKTYPEINT64", {Kind::whole, 8}},
                                                     {"VTKTYPEUINT64", {Kind::unsigned_whole, 8}},
                                                     {"FLOAT", {Kind::real, 4}},
                                                     {"DOUBLE", {Kind::real, 8}},
                                                     {"STRING", {Kind::unsigned_whole, 1}},
                                                     {"UTF8_STRING", {Kind::unsigned_whole, 1}}}};
    const MeshWord word = words_.word(what);
    const std::string name = upper_case(word.text);
    for (const Known& one : known)
      if (one.name == name) return {name == "UTF8_STRING" ? "STRING" : name, one.number};
    words_.fail(word, shown(word.text) + " is not a type of VTK, such as int or float");
  }

  /// Goes from the line before an array to its first number.
  void begin() {
    if (is_binary_) words_.next_line();
  }
  double real(const char* what, const VtkType& type) {
    if (!is_binary_) return words_.number(what);
    const double value = real_at(words_.bytes(type.number.size, what), type.number, ByteOrder::big);
    if (!std::isfinite(value)) words_.fail({}, std::string(what) + " is not finite");
    return value;
  }
  long long whole(const char* what, const VtkType& type, long long low, long long high) {
    if (!is_binary_) return words_.integer(what, low, high);
    const long long value = any(what, type);
    if (value < low || value > high)
      words_.fail({}, std::string(what) + " is " + std::to_string(value) +
                          ", allowed: " + std::to_string(low) + " to " + std::to_string(high));
    return value;
  }
  /// All values of an array of whole numbers.
  std::vector<long long> wholes(std::size_t count, const VtkType& type) {
    begin();
    std::vector<long long> values;
    if (is_binary_ && type.name == "BIT") return bits(count);
    for (std::size_t i = 0; i < count; ++i)
      values.push_back(is_binary_ ? any("a value", type)
                                  : words_.integer("a value", std::numeric_limits<long long>::min(),
                                                   std::numeric_limits<long long>::max()));
    return values;
  }
  /// Skips the values of an array.
  void skip(std::size_t count, const VtkType& type) {
    begin();
    if (is_binary_ && type.name == "STRING") return skip_strings(count);
    if (is_binary_ && type.name == "BIT") return skip_bytes((count + 7) / 8);
    if (is_binary_) return skip_bytes(count * type.number.size);
    for (std::size_t i = 0; i < count; ++i) words_.word("a value");
  }

 private:
  long long any(const char* what, const VtkType& type) {
    return whole_at(words_.bytes(type.number.size, what), type.number, ByteOrder::big);
  }
  void skip_bytes(std::size_t count) { words_.bytes(count, "a value"); }

  std::vector<long long> bits(std::size_t count) {
    const std::string_view bytes = words_.bytes((count + 7) / 8, "a value");
    std::vector<long long> values;
    for (std::size_t i = 0; i < count; ++i)
      values.push_back((static_cast<unsigned char>(bytes[i / 8]) >> (7 - i % 8)) & 1);
    return values;
  }

  // The first two bits say how many bytes the length of a string has: 8, 4, 2 or 1.
  void skip_strings(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto first = static_cast<unsigned char>(words_.bytes(1, "a string").front());
      std::size_t length = first & 0x3f;
      for (int more = (8 >> (first >> 6)) - 1; more > 0; --more)
        length = length << 8 | static_cast<unsigned char>(words_.bytes(1, "a string").front());
      skip_bytes(length);
    }
  }

  TokenReader& words_;
  bool is_binary_ = false;
};

}  // namespace mesh
