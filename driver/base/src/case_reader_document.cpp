// SPDX-License-Identifier: Apache-2.0
// Loading a case file and applying `key.path=value` overrides.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/case_reader.hpp"
#include "base/text_file.hpp"
#include "case_log.hpp"
#include "toml_library.hpp"

namespace driver {
namespace {

constexpr std::size_t most_parts = 100;  // in a dotted key; nested tables are read by recursion

// Number of parts of the longest dotted key, outside quotes and comments; 0 if there is none.
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

// The value of an override: TOML if it parses, otherwise a string.
toml::table parse_override_value(const std::string& override_text, const std::string& value) {
  const std::string name = option_of(override_text);
  try {
    toml::table parsed = toml::parse("value = " + value, name);
    if (parsed.size() != 1) throw CaseError(fmt::format("{}: allowed: one value", name));
    return parsed;
  } catch (const toml::parse_error& error) {
    // Only a bare word becomes a string.
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

// End of an override's path: the first = outside quotes.
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

using Path = std::vector<PathPart>;

// Parts of a path from `begin` to before `end`.
std::string joined(const Path& parts, std::size_t begin, std::size_t end) {
  std::string path;
  for (std::size_t j = begin; j < end; ++j)
    path += (j > begin ? "." : "") + (parts[j].index ? parts[j].key : path_key(parts[j].key));
  return shortened(path);
}

// Throws CaseError for an entry of a list that the case does not have.
void require_list(const toml::node& parent, const Path& parts, std::size_t i,
                  const std::string& override_text) {
  if (!parts[i + 1].index || !parent.is_table() || parent.as_table()->contains(parts[i].key)) return;
  throw CaseError(
      fmt::format("{}: the case has no [[{}]]", option_of(override_text), joined(parts, 0, i + 1)));
}

// The entry of a list that part i of a path names. Throws a CaseError that shows valid paths.
std::size_t entry_of(const toml::array& list, const Path& parts, std::size_t i, const std::string& option) {
  const auto& index = parts[i].index;
  if (index && *index < list.size()) return *index;
  const std::string head = joined(parts, 0, i);
  if (list.empty()) throw CaseError(fmt::format("{}: {} is an empty list", option, head));
  // The parts after the number. Without a number, part i is already a key of the only entry.
  const std::size_t begin = index || !list[0].is_table() ? i + 1 : i;
  const std::string tail = begin < parts.size() ? "." + joined(parts, begin, parts.size()) : "";
  const auto with = [&](std::size_t number) { return fmt::format("{}.{}{}", head, number, tail); };
  throw CaseError(
      fmt::format("{}: {} is a list of {}, allowed: {}", option, head,
                  list.size() == 1 ? "one" : fmt::format("{}", list.size()),
                  list.size() == 1 ? with(0) : fmt::format("{} to {}", with(0), with(list.size() - 1))));
}

// A number of which a path names `part` becomes the constant { value = number }, which has that part: an
// override can scale it.
void make_constant(toml::table& table, const std::string& key, const std::string& part,
                   const std::string& option) {
  // With the last three of these the reader says what a constant may have.
  constexpr std::string_view parts[] = {"scale", "offset", "units", "time_scale", "shift", "cumulative"};
  const toml::node* node = table.get(key);
  if (!node->is_number() || std::ranges::find(parts, part) == std::end(parts)) return;
  toml::table constant = std::move(*toml::parse("value = {}", option).get_as<toml::table>("value"));
  node->visit([&](const auto& number) { constant.insert("value", number); });
  table.insert_or_assign(key, std::move(constant));
}

// The node that part i of a path names inside `parent`. Makes a missing table; the strict reader checks it
// later.
toml::node& descend(toml::node& parent, const Path& parts, std::size_t i, const std::string& override_text) {
  const std::string& key = parts[i].key;
  if (auto* table = parent.as_table()) {
    if (!table->contains(key))
      table->insert(key, std::move(*toml::parse("value = {}", option_of(override_text)).get("value")));
    make_constant(*table, key, parts[i + 1].key, option_of(override_text));
    return *table->get(key);
  }
  if (auto* array = parent.as_array())
    return *array->get(entry_of(*array, parts, i, option_of(override_text)));
  throw CaseError(
      fmt::format("{}: the key before '{}' has no parts", option_of(override_text), shortened(key)));
}

void unset(toml::table& root, const std::string& path) {
  toml::node* node = &root;
  const auto parts = split_path(path);
  const std::string option = "--unset " + shortened(path);
  for (std::size_t i = 0; node && i + 1 < parts.size(); ++i) {
    auto* array = node->as_array();
    node = array              ? array->get(entry_of(*array, parts, i, option))
           : node->is_table() ? node->as_table()->get(parts[i].key)
                              : nullptr;
  }
  if (auto* array = node ? node->as_array() : nullptr;
      array && entry_of(*array, parts, parts.size() - 1, option) < array->size())
    throw CaseError(option + ": is one entry of a list, allowed: a key, a table or a whole list");
  if (!node || !node->is_table() || node->as_table()->erase(parts.back().key) == 0)
    throw CaseError(option + ": the case has no such key");
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
    node = &descend(*node, parts, i, text);
  }
  if (auto* table = node->as_table()) {
    table->insert_or_assign(parts.back().key, std::move(*value.get("value")));
  } else if (auto* array = node->as_array()) {
    const std::size_t entry = entry_of(*array, parts, parts.size() - 1, option_of(text));
    array->replace(array->cbegin() + static_cast<std::ptrdiff_t>(entry), std::move(*value.get("value")));
  } else {
    throw CaseError(
        fmt::format("{}: the key before '{}' is not a table", option_of(text), shortened(parts.back().key)));
  }
}

bool has_nul(std::string_view text) {
  return text.find('\0') != std::string_view::npos;
}

// Throws CaseError for a NUL in a text: system calls and messages would end there.
void refuse_nul(const toml::node& node, const std::string& key) {
  const auto* text = node.as_string();
  if (has_nul(key) || (text && has_nul(text->get()))) {
    const auto at = node.source().begin;
    const std::string file = node.source().path ? *node.source().path : "";
    throw CaseError(fmt::format("{}{}: {}: has a NUL (\\u0000), allowed: a text without one", file,
                                at.line > 0 ? fmt::format(":{}:{}", at.line, at.column) : "", key));
  }
  if (const auto* table = node.as_table())
    for (const auto& [name, value] : *table) refuse_nul(value, std::string(name.str()));
  if (const auto* array = node.as_array())
    for (const toml::node& value : *array) refuse_nul(value, key);
}

}  // namespace

CaseError::CaseError(const std::string& message)
    : std::runtime_error([&] {
        std::string shown;
        for (const char c : message) c == '\0' ? shown += "\\x00" : shown += c;
        return shown;
      }()) {}

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
  refuse_nul(*table_, "");
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

const std::vector<UsedCurve>& CaseDocument::used_curves() const {
  return log_->curves;
}

const std::vector<KnownKey>& CaseDocument::keys() const {
  return log_->keys;
}

}  // namespace driver
