// SPDX-License-Identifier: Apache-2.0
// Paths of settings. Keys that are not bare words are quoted, so that they differ from numbers of elements.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/case_reader.hpp"

namespace driver {
namespace {

std::optional<std::size_t> as_index(const std::string& text) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return index;
}

// The quoted key that begins at path[i]; moves i past its closing quote. Empty if that is missing.
std::string unquoted(const std::string& path, std::size_t& i) {
  std::string key;
  for (++i; i < path.size() && path[i] != '"'; ++i) {
    if (path[i] == '\\' && ++i == path.size()) break;
    key += path[i];
  }
  if (i >= path.size()) return {};
  ++i;
  return key;
}

}  // namespace

std::vector<PathPart> split_path(const std::string& path) {
  std::vector<PathPart> parts;
  for (std::size_t i = 0;; ++i) {
    if (i < path.size() && path[i] == '"') {
      std::string key = unquoted(path, i);
      if (i < path.size() && path[i] != '.') key.clear();
      parts.push_back({key, {}});
      if (key.empty()) return parts;
    } else {
      const auto end = std::min(path.find('.', i), path.size());
      const std::string key = path.substr(i, end - i);
      parts.push_back({key, as_index(key)});
      i = end;
    }
    if (i >= path.size()) return parts;
  }
}

std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 200;
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80)
    --end;  // do not cut within a
            // letter
  return text.substr(0, end) + "...";
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      (c == '"' || c == '\\' ? out += '\\' : out) += c;
  }
  return out + '"';
}

std::string path_key(const std::string& key) {
  const auto is_word = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), is_word) && !as_index(key);
  return bare ? key : quoted(key);
}

}  // namespace driver
