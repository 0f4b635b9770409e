// SPDX-License-Identifier: Apache-2.0
// Private to the reader of VTK's XML files: the tags of a text, one after the other.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace mesh {

struct XmlTag {
  std::string_view name;
  std::map<std::string_view, std::string_view> attributes;
  bool ends = false;        // </name>
  bool is_empty = false;    // <name/>
  std::size_t begin = 0;    // of the tag in the text
  std::size_t content = 0;  // behind the tag

  /// Value of an attribute; empty if it is missing.
  std::string_view operator[](std::string_view attribute) const;
};

/// Scans the tags of XML. Comments, declarations and <? ?> are skipped. Faults are MeshFileError.
class XmlTags {
 public:
  XmlTags(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  /// Reads the next tag; false at the end of the text.
  bool next(XmlTag& tag);
  /// The text from a tag to the next one.
  std::string_view text_of(const XmlTag& tag) const;
  /// Everything from this place on.
  std::string_view rest(std::size_t begin) const { return text_.substr(begin); }
  /// Throws MeshFileError at a place of the text.
  [[noreturn]] void fail(std::size_t at, const std::string& message) const;

 private:
  void skip_past(std::string_view end);
  void attribute(XmlTag& tag);

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
};

}  // namespace mesh
