// SPDX-License-Identifier: Apache-2.0
#include "vtk_xml_data.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "inflate.hpp"
#include "mesh/mesh_file.hpp"
#include "mesh_text.hpp"

namespace mesh {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

std::optional<unsigned> digit_of(char c) {
  if (c >= 'A' && c <= 'Z') return static_cast<unsigned>(c - 'A');
  if (c >= 'a' && c <= 'z') return static_cast<unsigned>(c - 'a' + 26);
  if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0' + 52);
  if (c == '+') return 62u;
  if (c == '/') return 63u;
  return {};
}

// Takes at least `size` bytes, in groups of four digits, off the text; fewer if the digits end. A part may
// end with = and another one follow.
std::string take_base64(std::string_view& text, std::size_t size) {
  std::string bytes;
  unsigned group = 0;
  int digits = 0, padding = 0;
  std::size_t at = 0;
  for (; at < text.size() && bytes.size() < size; ++at) {
    if (kBlanks.find(text[at]) != std::string_view::npos) continue;
    const auto digit = text[at] == '=' ? std::optional(0u) : digit_of(text[at]);
    if (!digit) break;
    if (text[at] == '=') ++padding;
    group = group << 6 | *digit;
    if (++digits < 4) continue;
    for (int i = 0; i < 3 - std::min(padding, 2); ++i)
      bytes += static_cast<char>(group >> (16 - 8 * i) & 255);
    group = 0, digits = 0, padding = 0;
  }
  text.remove_prefix(at);
  return bytes;
}

std::string take_raw(std::string_view& text, std::size_t size) {
  const std::string_view bytes = text.substr(0, size);
  text.remove_prefix(bytes.size());
  return std::string(bytes);
}

}  // namespace

void VtkXmlArray::fail(const std::string& message) const {
  tags_->fail(tag_.begin, "array " + shown(name()) + ": " + message);
}

NumberType VtkXmlArray::type() const {
  using Kind = NumberType::Kind;
  struct Known {
    std::string_view name;
    NumberType type;
  };
  static constexpr std::array<Known, 10> known = {{{"Int8", {Kind::whole, 1}},
                                                   {"UInt8", {Kind::unsigned_whole, 1}},
                                                   {"Int16", {Kind::whole, 2}},
                                                   {"UInt16", {Kind::unsigned_whole, 2}},
                                                   {"Int32", {Kind::whole, 4}},
                                                   {"UInt32", {Kind::unsigned_whole, 4}},
                                                   {"Int64", {Kind::whole, 8}},
                                                   {"UInt64", {Kind::unsigned_whole, 8}},
                                                   {"Float32", {Kind::real, 4}},
                                                   {"Float64", {Kind::real, 8}}}};
  for (const Known& one : known)
    if (tag_["type"] == one.name) return one.type;
  fail("type " + shown(tag_["type"]) + " is not a number of VTK");
}

bool VtkXmlArray::is_whole_scalar() const {
  const std::string_view components = tag_["NumberOfComponents"], type = tag_["type"];
  return (components.empty() || components == "1") && (type.starts_with("Int") || type.starts_with("UInt"));
}

bool VtkXmlArray::is_text() const {
  const std::string_view format = tag_["format"];
  if (format != "ascii" && format != "binary" && format != "appended" && !format.empty())
    fail("format " + shown(format) + ", allowed: ascii, binary or appended");
  return format.empty() || format == "ascii";
}

template <class Number, class Parse>
std::vector<Number> VtkXmlArray::words(std::size_t count, Parse&& parse) const {
  std::vector<Number> values;
  std::string_view text = tags_->text_of(tag_);
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    if (text.empty()) break;
    const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
    if (values.size() == count) fail("more than " + std::to_string(count) + " numbers");
    values.push_back(parse(word));
    text.remove_prefix(word.size());
  }
  if (values.size() != count)
    fail(std::to_string(values.size()) + " numbers, needed are " + std::to_string(count));
  return values;
}

// Compressed data begin with the number of blocks, the size of a block, that of the last one if it is
// smaller, and the compressed size of each.
std::string VtkXmlArray::inflated(std::string_view data, std::size_t size, bool is_base64,
                                  const VtkEncoding& encoding) const {
  const NumberType header{NumberType::Kind::unsigned_whole, encoding.header_size};
  const auto take = [&](std::size_t count) {
    std::string part = is_base64 ? take_base64(data, count) : take_raw(data, count);
    if (part.size() < count) fail("the data ends too early");
    return part;
  };
  const auto number = [&](std::string_view bytes, std::size_t i) {
    return static_cast<std::size_t>(whole_at(bytes.substr(i * encoding.header_size), header, encoding.order));
  };
  // A part of base64 ends with the header, so the first three numbers are decoded twice.
  std::string_view again = data;
  const std::string first = take(3 * encoding.header_size);
  const std::size_t blocks = number(first, 0), block = number(first, 1), last = number(first, 2);
  if (blocks > data.size()) fail("has " + std::to_string(blocks) + " blocks, more than the file can hold");
  data = again;
  const std::string sizes = take((3 + blocks) * encoding.header_size);
  std::string bytes;
  std::string rest;
  if (is_base64) rest = take_base64(data, data.size());
  std::string_view compressed = is_base64 ? std::string_view(rest) : data;
  for (std::size_t i = 0; i < blocks; ++i) {
    const std::size_t length = number(sizes, 3 + i), whole = i + 1 == blocks && last > 0 ? last : block;
    if (length > compressed.size()) fail("the data ends too early");
    if (whole > size - bytes.size()) fail("its blocks have more than " + std::to_string(size) + " bytes");
    const auto part = inflate(compressed.substr(0, length), whole);
    if (!part) fail("block " + std::to_string(i) + " of its compressed data is damaged");
    bytes += *part;
    compressed.remove_prefix(length);
  }
  return bytes;
}

std::string VtkXmlArray::bytes(std::size_t size, const VtkEncoding& encoding) const {
  if (size > largest_mesh_file)
    fail("has " + std::to_string(size) + " bytes, allowed: " + std::to_string(largest_mesh_file));
  const bool is_appended = tag_["format"] == "appended";
  const bool is_base64 = !is_appended || encoding.is_base64;
  std::string_view data = is_appended ? encoding.appended : tags_->text_of(tag_);
  if (is_appended) {
    const std::string_view text = tag_["offset"];
    std::size_t offset = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), offset);
    if (error != std::errc() || end != text.data() + text.size() || offset > data.size())
      fail("offset " + shown(text) + " is not in the appended data");
    data.remove_prefix(offset);
  }
  std::string found;
  if (!encoding.compressor.empty() && encoding.compressor != "vtkZLibDataCompressor")
    fail("compressor " + shown(encoding.compressor) +
         " is not supported; write the file with vtkZLibDataCompressor, or without one");
  if (!encoding.compressor.empty()) {
    found = inflated(data, size, is_base64, encoding);
  } else {
    const std::size_t all = encoding.header_size + size;
    found = is_base64 ? take_base64(data, all) : take_raw(data, all);
    if (found.size() < encoding.header_size) fail("the data ends too early");
    const NumberType header{NumberType::Kind::unsigned_whole, encoding.header_size};
    const auto announced = static_cast<std::size_t>(whole_at(found, header, encoding.order));
    if (announced != size)
      fail("has " + std::to_string(announced) + " bytes, needed are " + std::to_string(size));
    found.erase(0, encoding.header_size);
    if (found.size() > size) found.resize(size);
  }
  if (found.size() != size)
    fail("has " + std::to_string(found.size()) + " bytes, needed are " + std::to_string(size));
  return found;
}

std::vector<double> VtkXmlArray::reals(std::size_t count, const VtkEncoding& encoding) const {
  const NumberType of = type();
  if (is_text())
    return words<double>(count, [&](std::string_view word) {
      double value = 0.0;
      if (const std::string fault = number_fault(word, value); !fault.empty()) fail(fault);
      return value;
    });
  const std::string data = bytes(count * of.size, encoding);
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(real_at(std::string_view(data).substr(i * of.size), of, encoding.order));
    if (!std::isfinite(values.back())) fail("number " + std::to_string(i) + " is not finite");
  }
  return values;
}

std::vector<long long> VtkXmlArray::wholes(std::size_t count, const VtkEncoding& encoding) const {
  const NumberType of = type();
  if (of.kind == NumberType::Kind::real) fail("has real numbers, needed are whole ones");
  if (is_text())
    return words<long long>(count, [&](std::string_view word) {
      long long value = 0;
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
      if (error != std::errc() || end != word.data() + word.size())
        fail(shown(word) + " is not a whole number");
      return value;
    });
  const std::string data = bytes(count * of.size, encoding);
  std::vector<long long> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(whole_at(std::string_view(data).substr(i * of.size), of, encoding.order));
  return values;
}

}  // namespace mesh
