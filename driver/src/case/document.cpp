// SPDX-License-Identifier: Apache-2.0
// Loading a case file and applying `key.path=value` overrides.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "case/log.hpp"
#include "case/text_file.hpp"
#include "case/toml_library.hpp"
#include "driver/case_reader.hpp"

namespace driver {
namespace {

constexpr std::size_t most_parts = 100;  // of a dotted key: tables within tables are read by recursion

// The longest dotted key, or 0: dots between words outside of quotes and comments.
std::size_t longest_key(std::string_view line) {
  std::size_t dots = 0, most = 0;
  char quote = 0;
  for (const char c : line) {
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '#') {
      break;
    } else if (c == '.') {
      most = std::max(most, ++dots);
    } else if (c == ',' || c == '=' || c == '[' || c == '{') {
      dots = 0;
    }
  }
  return most;
}

void check_keys(const std::string& text, const std::string& name) {
  std::size_t number = 0, begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    ++number;
    if (longest_key(std::string_view(text).substr(begin, end - begin)) >= most_parts)
      throw CaseError(fmt::format("{}:{}:1: a key has more than {} parts", name, number, most_parts));
    begin = end + 1;
  }
}

toml::table parse(const std::string& text, const std::string& name) {
  check_keys(text, name);
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    const auto at = error.source().begin;
    throw CaseError(fmt::format("{}:{}:{}: TOML syntax: {}", name, at.line, at.column, error.description()));
  }
}

std::string option_of(const std::string& override_text) {
  return "--set " + shortened(override_text);
}

// The value of an override: TOML if it parses as TOML, else a string.
toml::table parse_override_value(const std::string& override_text, const std::string& value) {
  const std::string name = option_of(override_text);
  try {
    toml::table parsed = toml::parse("value = " + value, name);
    if (parsed.size() != 1) throw CaseError(fmt::format("{}: one value is allowed", name));
    return parsed;
  } catch (const toml::parse_error& error) {
    // Only a bare word is meant as a string.
    if (value.empty() || !(std::isalpha(static_cast<unsigned char>(value[0])) || value[0] == '_'))
      throw CaseError(fmt::format("{}: {}", name, error.description()));
    std::string quoted = "value = \"";
    for (const char c : value) quoted += (c == '"' || c == '\\') ? std::string{'\\', c} : std::string{c};
    try {
      return toml::parse(quoted + '"', name);
    } catch (const toml::parse_error& again) {
      throw CaseError(fmt::format("{}: {}", name, again.description()));
    }
  }
}

// Where the path of an override ends: its first = outside quotes.
std::size_t end_of_path(const std::string& text) {
  bool inside = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && inside)
      ++i;
    else if (text[i] == '"')
      inside = !inside;
    else if (text[i] == '=' && !inside)
      return i;
  }
  return std::string::npos;
}

// An entry of a list that the case does not have.
void require_list(const toml::node& parent, const std::vector<PathPart>& parts, std::size_t i,
                  const std::string& override_text) {
  if (!parts[i + 1].index || !parent.is_table() || parent.as_table()->contains(parts[i].key)) return;
  std::string path;
  for (std::size_t j = 0; j <= i; ++j)
    path += (j > 0 ? "." : "") + (parts[j].index ? parts[j].key : path_key(parts[j].key));
  throw CaseError(fmt::format("{}: the case has no [[{}]]", option_of(override_text), shortened(path)));
}

// The node that `part` names inside `parent`; a missing table is made, for the strict reader to judge.
toml::node& descend(toml::node& parent, const PathPart& part, const std::string& override_text) {
  const auto& [key, index] = part;
  if (auto* table = parent.as_table()) {
    if (!table->contains(key))
      table->insert(key, std::move(*toml::parse("value = {}", option_of(override_text)).get("value")));
    return *table->get(key);
  }
  if (auto* array = parent.as_array()) {
    if (index && *index < array->size()) return *array->get(*index);
    throw CaseError(fmt::format("{}: '{}' is no index of that array, 0 to {} are allowed",
                                option_of(override_text), shortened(key),
                                static_cast<long>(array->size()) - 1));
  }
  throw CaseError(
      fmt::format("{}: nothing stands below the key before '{}'", option_of(override_text), shortened(key)));
}

void unset(toml::table& root, const std::string& path) {
  toml::node* node = &root;
  const auto parts = split_path(path);
  for (std::size_t i = 0; node && i + 1 < parts.size(); ++i) {
    auto* array = node->as_array();
    const auto& [key, index] = parts[i];
    node = array && index ? array->get(*index) : node->is_table() ? node->as_table()->get(key) : nullptr;
  }
  if (auto* array = node ? node->as_array() : nullptr;
      array && parts.back().index && *parts.back().index < array->size())
    throw CaseError(fmt::format("--unset {}: one entry of a list; a key, a table or a whole list is allowed",
                                shortened(path)));
  if (!node || !node->is_table() || node->as_table()->erase(parts.back().key) == 0)
    throw CaseError(fmt::format("--unset {}: the case has no such key", shortened(path)));
}

std::string without_blanks_around(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

void apply_override(toml::table& root, const std::string& text) {
  if (text.starts_with(unset_prefix)) return unset(root, text.substr(unset_prefix.size()));
  const auto equals = end_of_path(text);
  const std::string path = without_blanks_around(text.substr(0, equals));
  if (equals == std::string::npos || path.empty())
    throw CaseError(fmt::format("{}: key.path=value is expected", option_of(text)));
  const auto parts = split_path(path);
  check_keys(text.substr(equals + 1), "--set");
  if (parts.size() > most_parts)
    throw CaseError(fmt::format("{}: a key has more than {} parts", option_of(text), most_parts));
  if (path.back() == '.' ||
      std::any_of(parts.begin(), parts.end(), [](const auto& p) { return p.key.empty(); }))
    throw CaseError(fmt::format("{}: a part of the path is empty", option_of(text)));
  toml::table value = parse_override_value(text, without_blanks_around(text.substr(equals + 1)));
  toml::node* node = &root;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    require_list(*node, parts, i, text);
    node = &descend(*node, parts[i], text);
  }
  if (auto* table = node->as_table()) {
    table->insert_or_assign(parts.back().key, std::move(*value.get("value")));
  } else if (auto* array = node->as_array()) {
    const auto& [key, index] = parts.back();
    if (!index || *index >= array->size())
      throw CaseError(fmt::format("{}: '{}' is no index of that array", option_of(text), shortened(key)));
    array->replace(array->cbegin() + static_cast<std::ptrdiff_t>(*index), std::move(*value.get("value")));
  } else {
    throw CaseError(
        fmt::format("{}: the key before '{}' is no table", option_of(text), shortened(parts.back().key)));
  }
}

}  // namespace

CaseDocument::CaseDocument(const std::filesystem::path& file, const std::vector<std::string>& overrides)
    : CaseDocument(read_text(file), file, overrides) {}

CaseDocument CaseDocument::of_text(const std::string& toml_text, const std::filesystem::path& file,
                                   const std::vector<std::string>& overrides) {
  return {toml_text, file, overrides};
}

CaseDocument::CaseDocument(const std::string& toml_text, const std::filesystem::path& file,
                           const std::vector<std::string>& overrides)
    : file_(file),
      table_(std::make_unique<toml::table>(parse(toml_text, file.string()))),
      log_(std::make_unique<CaseLog>()) {
  log_->folder = file.parent_path();
  for (const auto& text : overrides) apply_override(*table_, text);
}

CaseDocument::~CaseDocument() = default;
CaseDocument::CaseDocument(CaseDocument&&) noexcept = default;

TableReader CaseDocument::root() {
  return {*table_, "", file_.string() + ":1:1", *log_};
}

std::vector<std::filesystem::path> CaseDocument::files() const {
  auto all = log_->files;
  all.push_back(file_);
  return all;
}

const std::vector<Setting>& CaseDocument::settings() const {
  return log_->settings;
}

const std::vector<KnownKey>& CaseDocument::keys() const {
  return log_->keys;
}

}  // namespace driver
