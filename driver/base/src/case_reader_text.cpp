// SPDX-License-Identifier: Apache-2.0
// Writes a case as text.
#define TOML_ENABLE_FORMATTERS 1
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <sstream>
#include <string_view>

#include "base/case_reader.hpp"
#include "case_log.hpp"
#include "toml_library.hpp"

namespace driver {
namespace {

// The keys of a case that name files beside it.
bool names_file(const std::string& key) {
  return key == "file" || key == "initial_file" || key == "case";
}

void for_each_file(toml::node& node, const std::function<void(std::string&)>& change) {
  if (auto* array = node.as_array())
    for (toml::node& entry : *array) for_each_file(entry, change);
  auto* table = node.as_table();
  if (!table) return;
  for (auto&& [key, value] : *table) {
    if (auto* text = value.as_string(); text && names_file(std::string(key.str())))
      change(text->get());
    else
      for_each_file(value, change);
  }
}

// `text` as one word of a shell: in apostrophes if it has a character with a meaning there.
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

std::vector<std::filesystem::path> CaseDocument::named_files() const {
  std::vector<std::filesystem::path> files;
  for_each_file(*table_, [&](const std::string& name) { files.push_back(log_->folder / name); });
  return files;
}

std::string CaseDocument::text(const std::filesystem::path& folder) const {
  toml::table copy = *table_;
  const auto from = file_.parent_path();
  const auto to = std::filesystem::absolute(folder);
  for_each_file(copy, [&](std::string& name) {
    name = std::filesystem::proximate(std::filesystem::absolute(from / name), to).string();
  });
  std::ostringstream text;
  text << toml::toml_formatter(copy) << '\n';
  return text.str();
}

}  // namespace driver
