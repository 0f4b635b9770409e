// SPDX-License-Identifier: Apache-2.0
#include "inflate.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace mesh {
namespace {

struct Damaged {};

// The bits of a stream, from the lowest bit of each byte.
class Bits {
 public:
  explicit Bits(std::string_view bytes) : bytes_(bytes) {}

  unsigned take(int count) {
    while (held_ < count) {
      if (at_ == bytes_.size()) throw Damaged{};
      buffer_ |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes_[at_++])) << held_;
      held_ += 8;
    }
    const auto value = static_cast<unsigned>(buffer_ & ((std::uint64_t{1} << count) - 1));
    buffer_ >>= count;
    held_ -= count;
    return value;
  }
  void to_next_byte() { take(held_ % 8); }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
  std::uint64_t buffer_ = 0;
  int held_ = 0;
};

// Huffman codes, given by the number of bits of each symbol's (RFC 1951, 3.2.2).
class Codes {
 public:
  explicit Codes(std::span<const std::uint8_t> lengths) {
    for (const auto length : lengths) ++count_[length];
    count_[0] = 0;
    std::array<int, 17> begin{};
    for (std::size_t length = 1; length < 16; ++length) begin[length + 1] = begin[length] + count_[length];
    symbols_.resize(static_cast<std::size_t>(begin[16]));
    for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol)
      if (lengths[symbol] > 0)
        symbols_[static_cast<std::size_t>(begin[lengths[symbol]]++)] = static_cast<int>(symbol);
  }
  // The codes of one length are consecutive numbers, after those of shorter ones.
  int take(Bits& bits) const {
    int code = 0, first = 0, index = 0;
    for (std::size_t length = 1; length < 16; ++length) {
      code |= static_cast<int>(bits.take(1));
      if (code - first < count_[length] && code >= first)
        return symbols_[static_cast<std::size_t>(index + code - first)];
      index += count_[length];
      first = (first + count_[length]) << 1;
      code <<= 1;
    }
    throw Damaged{};
  }

 private:
  std::array<int, 16> count_{};  // of codes of each length
  std::vector<int> symbols_;     // in the order of their codes
};

struct Extra {
  int base, bits;
};
constexpr std::array<Extra, 29> kLengths = {
    {{3, 0},  {4, 0},  {5, 0},  {6, 0},   {7, 0},   {8, 0},   {9, 0},   {10, 0},  {11, 1}, {13, 1},
     {15, 1}, {17, 1}, {19, 2}, {23, 2},  {27, 2},  {31, 2},  {35, 3},  {43, 3},  {51, 3}, {59, 3},
     {67, 4}, {83, 4}, {99, 4}, {115, 4}, {131, 5}, {163, 5}, {195, 5}, {227, 5}, {258, 0}}};
constexpr std::array<Extra, 30> kDistances = {
    {{1, 0},     {2, 0},     {3, 0},     {4, 0},      {5, 1},      {7, 1},     {9, 2},     {13, 2},
     {17, 3},    {25, 3},    {33, 4},    {49, 4},     {65, 5},     {97, 5},    {129, 6},   {193, 6},
     {257, 7},   {385, 7},   {513, 8},   {769, 8},    {1025, 9},   {1537, 9},  {2049, 10}, {3073, 10},
     {4097, 11}, {6145, 11}, {8193, 12}, {12289, 12}, {16385, 13}, {24577, 13}}};

class Inflater {
 public:
  Inflater(std::string_view stream, std::size_t size) : bits_(stream), size_(size) {}

  std::string run() {
    const unsigned method = bits_.take(8), flags = bits_.take(8);
    if ((method & 15) != 8 || (method << 8 | flags) % 31 != 0 || (flags & 32) != 0) throw Damaged{};
    bool is_last = false;
    while (!is_last) {
      is_last = bits_.take(1) == 1;
      block(bits_.take(2));
    }
    if (out_.size() != size_) throw Damaged{};
    check();
    return std::move(out_);
  }

 private:
  void block(unsigned kind) {
    if (kind == 0) return stored();
    if (kind == 1) return compressed(fixed_literals(), Codes(std::vector<std::uint8_t>(30, 5)));
    if (kind != 2) throw Damaged{};
    const auto lengths = own_lengths();
    compressed(Codes(std::span(lengths).first(literals_)), Codes(std::span(lengths).subspan(literals_)));
  }

  void put(char byte) {
    if (out_.size() == size_) throw Damaged{};
    out_ += byte;
  }

  void stored() {
    bits_.to_next_byte();
    const unsigned length = bits_.take(16);
    if ((length ^ bits_.take(16)) != 0xffff) throw Damaged{};
    for (unsigned i = 0; i < length; ++i) put(static_cast<char>(bits_.take(8)));
  }

  static Codes fixed_literals() {
    std::array<std::uint8_t, 288> lengths;
    for (std::size_t i = 0; i < lengths.size(); ++i) lengths[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
    return Codes(lengths);
  }

  // The lengths of a block's own codes are coded too.
  std::vector<std::uint8_t> own_lengths() {
    static constexpr std::array<std::size_t, 19> order = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                          11, 4,  12, 3, 13, 2, 14, 1, 15};
    literals_ = 257 + bits_.take(5);
    const std::size_t all = literals_ + 1 + bits_.take(5), coded = 4 + bits_.take(4);
    std::array<std::uint8_t, 19> of_lengths{};
    for (std::size_t i = 0; i < coded; ++i) of_lengths[order[i]] = static_cast<std::uint8_t>(bits_.take(3));
    const Codes codes(of_lengths);
    std::vector<std::uint8_t> lengths;
    while (lengths.size() < all) {
      const int symbol = codes.take(bits_);
      if (symbol < 16) {
        lengths.push_back(static_cast<std::uint8_t>(symbol));
        continue;
      }
      if (symbol == 16 && lengths.empty()) throw Damaged{};
      const std::uint8_t repeated = symbol == 16 ? lengths.back() : std::uint8_t{0};
      const unsigned times = symbol == 16   ? 3 + bits_.take(2)
                             : symbol == 17 ? 3 + bits_.take(3)
                                            : 11 + bits_.take(7);
      lengths.insert(lengths.end(), times, repeated);
    }
    if (lengths.size() != all) throw Damaged{};
    return lengths;
  }

  int value_of(std::span<const Extra> list, int symbol) {
    if (symbol >= static_cast<int>(list.size())) throw Damaged{};
    const Extra& extra = list[static_cast<std::size_t>(symbol)];
    return extra.base + static_cast<int>(bits_.take(extra.bits));
  }

  void compressed(const Codes& literals, const Codes& distances) {
    for (;;) {
      const int symbol = literals.take(bits_);
      if (symbol == 256) return;
      if (symbol < 256) {
        put(static_cast<char>(symbol));
        continue;
      }
      const int length = value_of(kLengths, symbol - 257);
      const auto back = static_cast<std::size_t>(value_of(kDistances, distances.take(bits_)));
      if (back > out_.size()) throw Damaged{};
      for (int i = 0; i < length; ++i) put(out_[out_.size() - back]);
    }
  }

  // The sum of RFC 1950 comes last, its highest byte first.
  void check() {
    bits_.to_next_byte();
    std::uint32_t a = 1, b = 0, sum = 0;
    for (const char byte : out_) {
      a = (a + static_cast<unsigned char>(byte)) % 65521;
      b = (b + a) % 65521;
    }
    for (int i = 0; i < 4; ++i) sum = sum << 8 | bits_.take(8);
    if (sum != (b << 16 | a)) throw Damaged{};
  }

  Bits bits_;
  std::size_t size_;
  std::size_t literals_ = 0;
  std::string out_;
};

}  // namespace

std::optional<std::string> inflate(std::string_view stream, std::size_t size) {
  try {
    return Inflater(stream, size).run();
  } catch (const Damaged&) {
    return {};
  }
}

}  // namespace mesh
