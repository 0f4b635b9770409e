// SPDX-License-Identifier: Apache-2.0
// Private to the reader of VTK's XML files: the numbers of their arrays, in each way to write them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "number_bytes.hpp"
#include "xml_tags.hpp"

namespace mesh {

/// How a file writes its binary arrays.
struct VtkEncoding {
  ByteOrder order = ByteOrder::little;
  std::size_t header_size = 4;  // [bytes] of each number before the data
  std::string_view compressor;  // empty: the data are plain
  bool is_base64 = true;        // of appended data
  std::string_view appended;    // what is behind the _ of <AppendedData>
};

/// A <DataArray>.
class VtkXmlArray {
 public:
  VtkXmlArray(const XmlTags& tags, XmlTag tag) : tags_(&tags), tag_(std::move(tag)) {}

  std::string_view name() const { return tag_["Name"]; }
  std::size_t place() const { return tag_.begin; }
  /// One whole number for each item.
  bool is_whole_scalar() const;
  /// The `count` numbers of the array. Throws MeshFileError for another number of them, a type that is not
  /// one of VTK, and data that is damaged; reals() also for a number that is not finite.
  std::vector<double> reals(std::size_t count, const VtkEncoding& encoding) const;
  std::vector<long long> wholes(std::size_t count, const VtkEncoding& encoding) const;

 private:
  NumberType type() const;
  bool is_text() const;
  std::string bytes(std::size_t size, const VtkEncoding& encoding) const;
  std::string inflated(std::string_view data, std::size_t size, bool is_base64,
                       const VtkEncoding& encoding) const;
  [[noreturn]] void fail(const std::string& message) const;
  template <class Number, class Parse>
  std::vector<Number> words(std::size_t count, Parse&& parse) const;

  const XmlTags* tags_;
  XmlTag tag_;
};

}  // namespace mesh
