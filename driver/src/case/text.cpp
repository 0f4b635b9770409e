// SPDX-License-Identifier: Apache-2.0
// A case back to text.
#define TOML_ENABLE_FORMATTERS 1
#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string_view>

#include "case/log.hpp"
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

std::string written(const toml::node& node) {
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  return text.str();
}

std::string CaseDocument::text(const std::filesystem::path& folder) const {
  toml::table copy = *table_;
  move_files(copy, file_.parent_path(), folder);
  std::ostringstream text;
  text << toml::toml_formatter(copy) << '\n';
  return text.str();
}

}  // namespace driver
