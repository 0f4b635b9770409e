// SPDX-License-Identifier: Apache-2.0
#include "xml_tags.hpp"

#include <algorithm>

#include "mesh/mesh_file.hpp"
#include "mesh_text.hpp"

namespace mesh {
namespace {

constexpr std::string_view kXmlBlanks = " \t\r\n";

}  // namespace

std::string_view XmlTag::operator[](std::string_view attribute) const {
  const auto found = attributes.find(attribute);
  return found == attributes.end() ? std::string_view{} : found->second;
}

void XmlTags::fail(std::size_t at, const std::string& message) const {
  const std::string_view before = text_.substr(0, std::min(at, text_.size()));
  const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
  throw MeshFileError(file_, static_cast<std::size_t>(std::ranges::count(before, '\n')) + 1,
                      before.size() - line_begin + 1, message);
}

void XmlTags::skip_past(std::string_view end) {
  const std::size_t found = text_.find(end, at_);
  if (found == std::string_view::npos) fail(at_, "the file ends before " + std::string(end));
  at_ = found + end.size();
}

bool XmlTags::next(XmlTag& tag) {
  for (;;) {
    at_ = text_.find('<', at_);
    if (at_ == std::string_view::npos) return false;
    const std::string_view rest = text_.substr(at_);
    if (rest.starts_with("<!--"))
      skip_past("-->");
    else if (rest.starts_with("<?"))
      skip_past("?>");
    else if (rest.starts_with("<!"))
      skip_past(">");
    else
      break;
  }
  tag = {};
  tag.begin = at_++;
  tag.ends = at_ < text_.size() && text_[at_] == '/';
  if (tag.ends) ++at_;
  const std::size_t end = std::min(text_.find_first_of(" \t\r\n/>", at_), text_.size());
  tag.name = text_.substr(at_, end - at_);
  if (tag.name.empty()) fail(tag.begin, "a tag without a name");
  at_ = end;
  for (;;) {
    at_ = text_.find_first_not_of(kXmlBlanks, at_);
    if (at_ == std::string_view::npos) fail(tag.begin, "the tag " + shown(tag.name) + " does not end");
    if (text_[at_] == '>') break;
    if (text_[at_] == '/') {
      tag.is_empty = true;
      ++at_;
    } else {
      attribute(tag);
    }
  }
  tag.content = ++at_;
  return true;
}

void XmlTags::attribute(XmlTag& tag) {
  const std::size_t end = std::min(text_.find_first_of(" \t\r\n=/>", at_), text_.size());
  const std::string_view name = text_.substr(at_, end - at_);
  const std::size_t equals = text_.find_first_not_of(kXmlBlanks, end);
  if (name.empty() || equals == std::string_view::npos || text_[equals] != '=')
    fail(at_, "an attribute of " + shown(tag.name) + " has no value");
  const std::size_t quote = text_.find_first_not_of(kXmlBlanks, equals + 1);
  if (quote == std::string_view::npos || (text_[quote] != '"' && text_[quote] != '\''))
    fail(at_, "the attribute " + shown(name) + " has no value in quotes");
  const std::size_t last = text_.find(text_[quote], quote + 1);
  if (last == std::string_view::npos) fail(at_, "the attribute " + shown(name) + " does not end");
  tag.attributes.insert_or_assign(name, text_.substr(quote + 1, last - quote - 1));
  at_ = last + 1;
}

std::string_view XmlTags::text_of(const XmlTag& tag) const {
  if (tag.is_empty) return {};
  const std::size_t end = std::min(text_.find('<', tag.content), text_.size());
  return text_.substr(tag.content, end - tag.content);
}

}  // namespace mesh
