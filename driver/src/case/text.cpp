// SPDX-License-Identifier: Apache-2.0
// A case back to text.
#define TOML_ENABLE_FORMATTERS 1
#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string_view>

#include "case/toml_library.hpp"
#include "driver/case_reader.hpp"

namespace driver {
namespace {

// The keys of a case that name files beside it.
bool names_file(const std::string& key) {
  return key == "file" || key == "initial_file" || key == "case";
}

void move_files(toml::node& node, const std::filesystem::path& from, const std::filesystem::path& to) {
  if (auto* array = node.as_array())
    for (toml::node& entry : *array) move_files(entry, from, to);
  auto* table = node.as_table();
  if (!table) return;
  for (auto&& [key, value] : *table) {
    if (auto* text = value.as_string(); text && names_file(std::string(key.str())))
      text->get() = std::filesystem::proximate(std::filesystem::absolute(from / text->get()),
                                               std::filesystem::absolute(to))
                        .string();
    else
      move_files(value, from, to);
  }
}

// As a shell takes it for one word: between apostrophes if it has any character that means something there.
std::string shell_word(const std::string& text) {
  const auto is_plain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           std::string_view("_-+./,:=%@").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace

std::string as_option(const std::string& override_text) {
  if (override_text.starts_with(unset_prefix))
    return "--unset " + shell_word(override_text.substr(unset_prefix.size()));
  return "--set " + shell_word(override_text);
}

std::string TableReader::file_name(const std::string& key, const std::string& fallback) {
  constexpr std::size_t longest = 255;  // of Linux' file systems
  std::string name = text(key, fallback);
  const auto is_barred = [](char c) { return c == '/' || static_cast<unsigned char>(c) < ' ' || c == 0x7f; };
  if (name.empty() || name == "." || name == ".." || name.size() > longest ||
      std::ranges::any_of(name, is_barred))
    fail(key, fmt::format("is {}, a file name is allowed: {} bytes at most, no / and no control characters",
                          quoted(shortened(name)), longest));
  return name;
}

std::vector<TableReader::Element> TableReader::elements(const std::string& key) {
  const toml::node& node = require(key, "an array");
  if (!node.is_array() || node.as_array()->empty()) fail(key, "is no array of one value or more");
  std::vector<Element> elements;
  for (const toml::node& element : *node.as_array()) {
    if (element.is_number()) {
      const double number = checked(key, element, any_number);
      elements.push_back({fmt::format("{}", number), number});
    } else {
      std::ostringstream text;
      element.visit([&](const auto& value) { text << value; });
      elements.push_back({text.str(), std::nullopt});
    }
  }
  remember(key, fmt::format("[{} values]", elements.size()), false);
  return elements;
}

std::string CaseDocument::text(const std::filesystem::path& folder) const {
  toml::table copy = *table_;
  move_files(copy, file_.parent_path(), folder);
  std::ostringstream text;
  text << toml::toml_formatter(copy) << '\n';
  return text.str();
}

}  // namespace driver
