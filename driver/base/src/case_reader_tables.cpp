// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/case_reader.hpp"
#include "case_log.hpp"
#include "toml_library.hpp"

namespace driver {
namespace {

std::string location(const toml::source_region& source, const std::string& otherwise) {
  if (!source.path || source.begin.line == 0) return otherwise;
  if (source.path->starts_with("--set ")) return *source.path;
  return fmt::format("{}:{}:{}", *source.path, source.begin.line, source.begin.column);
}

constexpr std::size_t most_tables = 1000;  // in one list: some work grows with the number of pairs

// Number of insertions, deletions, changes and swaps of neighbours that turn `b` into `a`.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last, row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

[[noreturn]] void refuse_unknown(const TableReader& table, const std::string& key,
                                 const std::set<std::string>& names) {
  const auto like = std::ranges::find_if(names, [&](const auto& other) { return is_like(key, other); });
  table.fail(key, fmt::format("unknown key, allowed here: {}{}", fmt::join(names, ", "),
                              like == names.end() ? "" : fmt::format("; is '{}' meant?", *like)));
}

}  // namespace

bool is_like(std::string_view a, std::string_view b) {
  const std::size_t letters = std::max(a.size(), b.size());
  return letters < 64 && edits(a, b) <= std::max<std::size_t>(1, letters / 4);
}

TableReader::TableReader(const toml::table& table, std::string path, std::string where, CaseLog& log)
    : table_(&table), path_(std::move(path)), where_(location(table.source(), where)), log_(&log) {}

std::string TableReader::join(const std::string& key) const {
  if (key.empty()) return path_.empty() ? "case" : path_;
  return path_.empty() ? path_key(key) : path_ + "." + path_key(key);
}

std::string TableReader::label(const std::string& key, const std::string& place) const {
  std::string where = where_;
  if (const auto found = table_->find(place.empty() ? key : place); found != table_->cend()) {
    where = location(found->second.source(), where_);
    if (!where.starts_with("--set ")) where = location(found->first.source(), where);
  }
  return where + ": " + shortened(join(key));
}

void TableReader::fail(const std::string& key, const std::string& message) const {
  throw CaseError(label(key) + ": " + message);
}

void TableReader::located(const std::string& key, const std::function<void()>& action) const {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    fail(key, error.what());
  }
}

std::filesystem::path TableReader::beside_case(const std::string& file) const {
  log_->files.push_back(log_->folder / file);
  return log_->files.back();
}

bool TableReader::has(const std::string& key) const {
  log_->may_be_absent.insert(join(key));
  return table_->contains(key);
}

bool TableReader::is_table(const std::string& key) const {
  const toml::node* node = table_->get(key);
  return node && node->is_table();
}

bool TableReader::has_in_table(const std::string& key, const std::string& inner) const {
  return is_table(key) && table_->get(key)->as_table()->contains(inner);
}

const toml::node* TableReader::find(const std::string& key, const std::string& unit,
                                    const std::string& allowed, const std::string& fallback) {
  asked_.insert(key);
  log_->keys.push_back({join(key), unit, allowed, fallback});
  return table_->get(key);
}

// A similar key in the table that nothing has asked for; empty if there is none.
std::string TableReader::misspelt(const std::string& key) const {
  for (const auto& [other, node] : *table_) {
    const std::string_view name = other.str();
    if (!asked_.contains(std::string(name)) && is_like(name, key)) return std::string(name);
  }
  return {};
}

// `in_short` describes the key in the message that it is missing; by default `allowed` with the unit.
const toml::node& TableReader::require(const std::string& key, const std::string& unit,
                                       const std::string& allowed, const char* in_short) {
  const toml::node* node = find(key, unit, allowed, log_->may_be_absent.contains(join(key)) ? "" : "needed");
  if (node) return *node;
  const std::string message =
      fmt::format("is missing, needed: {}", in_short ? in_short : with_unit(allowed, unit));
  const std::string meant = misspelt(key);
  if (meant.empty()) fail(key, message);
  throw CaseError(fmt::format("{}: {}; is '{}' meant?", label(key, meant), message, meant));
}

TableReader TableReader::below(const std::string& key, const toml::node& node) const {
  if (!node.is_table()) fail(key, fmt::format("is {}, allowed: a table", type_name(node)));
  return {*node.as_table(), join(key), where_, *log_};
}

TableReader TableReader::table(const std::string& key) {
  return below(key, require(key, "", "a table"));
}

std::optional<TableReader> TableReader::optional_table(const std::string& key, bool defaults) {
  static const toml::table empty;
  if (has(key)) return table(key);
  find(key, "", "a table", "");
  if (defaults) return TableReader(empty, join(key), where_, *log_);
  return std::nullopt;
}

std::vector<TableReader> TableReader::tables(const std::string& key) {
  const toml::node* node = find(key, "", "tables", "");
  std::vector<TableReader> readers;
  if (!node) return readers;
  if (!node->is_array())
    fail(key, fmt::format("is {}, allowed: an array of tables ([[{}]])", type_name(*node), key));
  if (node->as_array()->size() > most_tables)
    fail(key, fmt::format("has {} tables, allowed: at most {}", node->as_array()->size(), most_tables));
  for (const toml::node& element : *node->as_array()) {
    if (!element.is_table()) fail(key, fmt::format("has {}, allowed: tables", type_name(element)));
    readers.emplace_back(*element.as_table(), fmt::format("{}.{}", join(key), readers.size()), where_, *log_);
  }
  return readers;
}

void TableReader::allow_only(const std::set<std::string>& names) const {
  for (const auto& [key, node] : *table_) {
    const std::string name(key.str());
    if (!names.contains(name)) refuse_unknown(*this, name, names);
  }
}

void TableReader::finish() const {
  std::set<std::string> names = asked_;  // and the optional keys
  const std::string head = path_.empty() ? "" : path_ + ".";
  for (const std::string& path : log_->may_be_absent)
    if (path.starts_with(head) && path.find('.', head.size()) == std::string::npos)
      names.insert(path.substr(head.size()));
  for (const auto& [key, node] : *table_)
    if (!asked_.contains(std::string(key.str()))) refuse_unknown(*this, std::string(key.str()), names);
}

}  // namespace driver
