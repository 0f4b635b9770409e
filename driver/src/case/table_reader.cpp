// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "case/log.hpp"
#include "case/toml_library.hpp"
#include "driver/case_reader.hpp"

namespace driver {
namespace {

std::string location(const toml::source_region& source, const std::string& otherwise) {
  if (!source.path || source.begin.line == 0) return otherwise;
  if (source.path->starts_with("--set ")) return *source.path;
  return fmt::format("{}:{}:{}", *source.path, source.begin.line, source.begin.column);
}

constexpr std::size_t most_tables = 1000;  // of one list: some work is for each pair of them

// Insertions, deletions and changes of one letter that make `a` of `b`.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, changed});
    }
  }
  return row.back();
}

const char* type_name(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (node.is_array()) return "an array";
  if (node.is_string()) return "a string";
  if (node.is_boolean()) return "a boolean";
  return node.is_number() ? "a number" : "a date or time";
}

}  // namespace

TableReader::TableReader(const toml::table& table, std::string path, std::string where, CaseLog& log)
    : table_(&table), path_(std::move(path)), where_(location(table.source(), where)), log_(&log) {}

std::string TableReader::join(const std::string& key) const {
  if (key.empty()) return path_.empty() ? "case" : path_;
  return path_.empty() ? path_key(key) : path_ + "." + path_key(key);
}

void TableReader::fail(const std::string& key, const std::string& message) const {
  std::string where = where_;
  if (const auto found = table_->find(key); found != table_->cend()) {
    where = location(found->second.source(), where_);
    if (!where.starts_with("--set ")) where = location(found->first.source(), where);
  }
  throw CaseError(fmt::format("{}: {}: {}", where, shortened(join(key)), message));
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

void TableReader::remember(const std::string& key, const std::string& value, bool is_default) {
  log_->settings.push_back({join(key), value, is_default});
}

bool TableReader::has(const std::string& key) const {
  return table_->contains(key);
}

const toml::node* TableReader::find(const std::string& key) {
  asked_.insert(key);
  return table_->get(key);
}

std::string TableReader::misspelt(const std::string& key) const {
  for (const auto& [other, node] : *table_) {
    const std::string_view name = other.str();
    const std::size_t letters = std::max(name.size(), key.size());
    if (!asked_.contains(std::string(name)) && letters < 64 &&
        edits(name, key) <= std::max<std::size_t>(1, letters / 4))
      return fmt::format("; is '{}' meant?", name);
  }
  return {};
}

const toml::node& TableReader::require(const std::string& key, const char* allowed) {
  const toml::node* node = find(key);
  if (!node) fail(key, fmt::format("is missing, {} is needed{}", allowed, misspelt(key)));
  return *node;
}

double TableReader::checked(const std::string& key, const toml::node& node, Bounds bounds) const {
  const auto value = node.value<double>();
  if (!node.is_number() || !value)
    fail(key, fmt::format("is {}, {} is allowed", type_name(node), bounds.text));
  const bool too_low = bounds.open_low ? *value <= bounds.low : *value < bounds.low;
  if (!std::isfinite(*value) || too_low || *value > bounds.high)
    fail(key, fmt::format("is {}, {} is allowed", *value, bounds.text));
  return *value;
}

double TableReader::number(const std::string& key, Bounds bounds) {
  const double value = checked(key, require(key, bounds.text), bounds);
  remember(key, fmt::format("{}", value), false);
  return value;
}

double TableReader::number(const std::string& key, Bounds bounds, double fallback) {
  if (has(key)) return number(key, bounds);
  find(key);
  remember(key, fmt::format("{}", fallback), true);
  return fallback;
}

std::optional<double> TableReader::optional_number(const std::string& key, Bounds bounds) {
  if (has(key)) return number(key, bounds);
  find(key);
  return std::nullopt;
}

int TableReader::integer(const std::string& key, int low, int high, int fallback) {
  const toml::node* node = find(key);
  const auto value = node ? node->value_exact<std::int64_t>() : std::optional<std::int64_t>(fallback);
  if (!value || *value < low || *value > high) {
    const std::string given = !value ? type_name(*node) : fmt::format("{}", *value);
    fail(key, fmt::format("is {}, a whole number from {} to {} is allowed", given, low, high));
  }
  remember(key, fmt::format("{}", *value), node == nullptr);
  return static_cast<int>(*value);
}

bool TableReader::flag(const std::string& key, bool fallback) {
  const toml::node* node = find(key);
  const auto value = node ? node->value_exact<bool>() : std::optional<bool>(fallback);
  if (!value) fail(key, fmt::format("is {}, true or false is allowed", type_name(*node)));
  remember(key, *value ? "true" : "false", node == nullptr);
  return *value;
}

std::string TableReader::text(const std::string& key) {
  const toml::node& node = require(key, "a string");
  const auto value = node.value_exact<std::string>();
  if (!value) fail(key, fmt::format("is {}, a string is allowed", type_name(node)));
  remember(key, quoted(*value), false);
  return *value;
}

std::string TableReader::text(const std::string& key, const std::string& fallback) {
  if (has(key)) return text(key);
  find(key);
  remember(key, quoted(fallback), true);
  return fallback;
}

std::size_t TableReader::choice_index(const std::string& key, const std::vector<std::string>& names,
                                      const std::string& fallback) {
  const std::string value = fallback.empty() ? text(key) : text(key, fallback);
  const auto found = std::find(names.begin(), names.end(), value);
  if (found == names.end())
    fail(key,
         fmt::format("is \"{}\", one of \"{}\" is allowed", shortened(value), fmt::join(names, "\", \"")));
  return static_cast<std::size_t>(found - names.begin());
}

std::vector<double> TableReader::numbers(const std::string& key, Bounds bounds) {
  const toml::node& node = require(key, "an array of numbers");
  if (!node.is_array()) fail(key, fmt::format("is {}, an array of numbers is allowed", type_name(node)));
  std::vector<double> values;
  for (const toml::node& element : *node.as_array()) values.push_back(checked(key, element, bounds));
  remember(key, fmt::format("[{}]", fmt::join(values, ", ")), false);
  return values;
}

std::vector<std::string> TableReader::texts(const std::string& key) {
  const toml::node* node = find(key);
  if (node && !node->is_array())
    fail(key, fmt::format("is {}, an array of strings is allowed", type_name(*node)));
  std::vector<std::string> values, written;
  if (node)
    for (const toml::node& element : *node->as_array()) {
      const auto value = element.value_exact<std::string>();
      if (!value) fail(key, fmt::format("holds {}, strings are allowed", type_name(element)));
      values.push_back(*value);
      written.push_back(quoted(*value));
    }
  remember(key, fmt::format("[{}]", fmt::join(written, ", ")), node == nullptr);
  return values;
}

Eigen::Vector3d TableReader::vector(const std::string& key) {
  const auto values = numbers(key, any_number);
  if (values.size() != 3) fail(key, fmt::format("has {} numbers, 3 are needed", values.size()));
  for (const double x : values)
    if (x != 0.0 && !(std::abs(x) >= 1e-100 && std::abs(x) <= 1e100))  // products stay normal numbers
      fail(key, fmt::format("has {}, allowed: 0, or a magnitude of 1e-100 to 1e100", x));
  return {values[0], values[1], values[2]};
}

Eigen::Vector3d TableReader::vector(const std::string& key, const Eigen::Vector3d& fallback) {
  if (has(key)) return vector(key);
  find(key);
  remember(key, fmt::format("[{}, {}, {}]", fallback.x(), fallback.y(), fallback.z()), true);
  return fallback;
}

TableReader TableReader::table(const std::string& key) {
  const toml::node& node = require(key, "a table");
  if (!node.is_table()) fail(key, fmt::format("is {}, a table is allowed", type_name(node)));
  return {*node.as_table(), join(key), where_, *log_};
}

std::optional<TableReader> TableReader::optional_table(const std::string& key) {
  if (has(key)) return table(key);
  find(key);
  return std::nullopt;
}

std::vector<TableReader> TableReader::tables(const std::string& key) {
  const toml::node* node = find(key);
  std::vector<TableReader> readers;
  if (!node) return readers;
  if (!node->is_array())
    fail(key, fmt::format("is {}, an array of tables ([[{}]]) is allowed", type_name(*node), key));
  if (node->as_array()->size() > most_tables)
    fail(key, fmt::format("has {} tables, at most {} are allowed", node->as_array()->size(), most_tables));
  for (const toml::node& element : *node->as_array()) {
    if (!element.is_table()) fail(key, fmt::format("holds {}, tables are allowed", type_name(element)));
    readers.emplace_back(*element.as_table(), fmt::format("{}.{}", join(key), readers.size()), where_, *log_);
  }
  return readers;
}

void TableReader::finish() const {
  for (const auto& [key, node] : *table_)
    if (!asked_.contains(std::string(key.str())))
      fail(std::string(key.str()), fmt::format("unknown key, allowed here: {}", fmt::join(asked_, ", ")));
}

}  // namespace driver
