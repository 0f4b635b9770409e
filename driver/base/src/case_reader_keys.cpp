// SPDX-License-Identifier: Apache-2.0
// The values of keys, except curves (curve_reader.cpp).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/case_reader.hpp"
#include "case_log.hpp"
#include "toml_library.hpp"

namespace driver {
namespace {

constexpr const char* three_numbers = "an array of 3 numbers";

std::string text_of(const Eigen::Vector3d& vector) {
  return fmt::format("[{}, {}, {}]", vector.x(), vector.y(), vector.z());
}

// A number of which an override names the scale.
bool is_changed_constant(const toml::node& node) {
  const auto* table = node.as_table();
  return table && table->contains("value");
}

}  // namespace

std::string with_unit(const std::string& allowed, const std::string& unit) {
  return unit.empty() ? allowed : fmt::format("{} [{}]", allowed, unit);
}

const char* type_name(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (node.is_array()) return "an array";
  if (node.is_string()) return "a string";
  if (node.is_boolean()) return "a boolean";
  return node.is_number() ? "a number" : "a date or time";
}

void KeyReader::fail(const std::string& message) const {
  table_->fail(key_, message);
}

void KeyReader::remember(const std::string& value, bool is_default) {
  table_->log_->settings.push_back({table_->join(key_), value, is_default});
}

double KeyReader::checked(const toml::node& node, Bounds bounds) const {
  const auto value = node.value<double>();
  if (!node.is_number() || !value)
    fail(fmt::format("{}, allowed: {}",
                     is_changed_constant(node) ? "is not a curve, so it cannot have scale, offset or units"
                                               : fmt::format("is {}", type_name(node)),
                     with_unit(bounds.text, bounds.unit)));
  if (!std::isfinite(*value) || !bounds.contain(*value))
    fail(fmt::format("is {}, allowed: {}", *value, with_unit(bounds.text, bounds.unit)));
  return *value;
}

double KeyReader::number(Bounds bounds) {
  const double value = checked(table_->require(key_, bounds.unit, bounds.text), bounds);
  remember(fmt::format("{}", value), false);
  return value;
}

double KeyReader::number(Bounds bounds, double fallback, const char* in_words) {
  const std::string text = fmt::format("{}", fallback);
  const toml::node* node = table_->find(key_, bounds.unit, bounds.text, in_words ? in_words : text);
  const double value = node ? checked(*node, bounds) : fallback;
  remember(fmt::format("{}", value), !node);
  return value;
}

std::optional<double> KeyReader::optional_number(Bounds bounds) {
  const toml::node* node = table_->find(key_, bounds.unit, bounds.text, "");
  if (!node) return std::nullopt;
  const double value = checked(*node, bounds);
  remember(fmt::format("{}", value), false);
  return value;
}

int KeyReader::integer(int low, int high, int fallback) {
  const toml::node* node = table_->find(key_, "", fmt::format("a whole number from {} to {}", low, high),
                                        fmt::format("{}", fallback));
  const auto value = node ? node->value_exact<std::int64_t>() : std::optional<std::int64_t>(fallback);
  if (!value || *value < low || *value > high) {
    const std::string given = !value ? type_name(*node) : fmt::format("{}", *value);
    fail(fmt::format("is {}, allowed: a whole number from {} to {}", given, low, high));
  }
  remember(fmt::format("{}", *value), node == nullptr);
  return static_cast<int>(*value);
}

bool KeyReader::flag(bool fallback) {
  const toml::node* node = table_->find(key_, "", "true or false", fallback ? "true" : "false");
  const auto value = node ? node->value_exact<bool>() : std::optional<bool>(fallback);
  if (!value) fail(fmt::format("is {}, allowed: true or false", type_name(*node)));
  remember(*value ? "true" : "false", node == nullptr);
  return *value;
}

// The text of the key, or the fallback, which is empty if the key is needed.
std::string KeyReader::read_text(const std::string& allowed, const std::string& fallback) {
  const toml::node* node = fallback.empty() ? &table_->require(key_, "", allowed)
                                            : table_->find(key_, "", allowed, quoted(fallback));
  const auto value = node ? node->value_exact<std::string>() : std::optional<std::string>(fallback);
  if (!value) fail(fmt::format("is {}, allowed: a string", type_name(*node)));
  remember(quoted(*value), !node);
  return *value;
}

std::string KeyReader::text(const std::string& fallback) {
  return read_text("a string", fallback);
}

std::string file_name(TableReader& table, const std::string& key, const std::string& fallback) {
  constexpr std::size_t longest = 255;  // limit of Linux file systems
  std::string name = table.at(key).text(fallback);
  const auto is_barred = [](char c) { return c == '/' || static_cast<unsigned char>(c) < ' ' || c == 0x7f; };
  if (name.empty() || name == "." || name == ".." || name.size() > longest ||
      std::ranges::any_of(name, is_barred))
    table.fail(
        key, fmt::format("is {}, allowed: a file name of at most {} bytes, without / and control characters",
                         quoted(shortened(name)), longest));
  return name;
}

std::size_t KeyReader::choice_index(const std::vector<std::string>& names, const std::string& fallback) {
  const std::string allowed = fmt::format("one of \"{}\"", fmt::join(names, "\", \""));
  const std::string value = read_text(allowed, fallback);
  const auto found = std::find(names.begin(), names.end(), value);
  if (found == names.end()) fail(fmt::format("is \"{}\", allowed: {}", shortened(value), allowed));
  return static_cast<std::size_t>(found - names.begin());
}

std::vector<double> KeyReader::numbers(Bounds bounds) {
  return numbers_of(table_->require(key_, bounds.unit, "an array of numbers"), bounds);
}

std::vector<double> KeyReader::numbers_of(const toml::node& node, Bounds bounds) {
  if (!node.is_array()) fail(fmt::format("is {}, allowed: an array of numbers", type_name(node)));
  std::vector<double> values;
  for (const toml::node& element : *node.as_array()) values.push_back(checked(element, bounds));
  remember(fmt::format("[{}]", fmt::join(values, ", ")), false);
  return values;
}

std::vector<int> KeyReader::some_of(std::span<const int> allowed) {
  const auto words = fmt::format("an array of {}", fmt::join(allowed, ", "));
  const toml::node* node = table_->find(key_, "", words, "none");
  if (node && !node->is_array()) fail(fmt::format("is {}, allowed: {}", type_name(*node), words));
  std::vector<int> values;
  if (node)
    for (const toml::node& element : *node->as_array()) {
      const auto value = element.value_exact<std::int64_t>();
      const auto found = value ? std::ranges::find(allowed, *value) : allowed.end();
      if (found == allowed.end())
        fail(fmt::format("has {}, allowed: {}", value ? fmt::format("{}", *value) : type_name(element),
                         words));
      if (std::ranges::find(values, *found) != values.end())
        fail(fmt::format("has {} twice, allowed: once", *found));
      values.push_back(*found);
    }
  std::ranges::sort(values);
  remember(fmt::format("[{}]", fmt::join(values, ", ")), node == nullptr);
  return values;
}

Eigen::Vector3d KeyReader::vector_of(const toml::node& node) {
  const auto values = numbers_of(node, any_number);
  if (values.size() != 3) fail(fmt::format("has {} numbers, needed: 3", values.size()));
  for (const double x : values)
    if (x != 0.0 && !(std::abs(x) >= 1e-100 && std::abs(x) <= 1e100))  // so that products stay normal numbers
      fail(fmt::format("has {}, allowed: 0, or a magnitude of 1e-100 to 1e100", x));
  return {values[0], values[1], values[2]};
}

Eigen::Vector3d KeyReader::vector(const char* unit) {
  return vector_of(table_->require(key_, unit, three_numbers));
}

Eigen::Vector3d KeyReader::vector(const char* unit, const Eigen::Vector3d& fallback, const char* in_words) {
  const std::string text = text_of(fallback);
  const toml::node* node = table_->find(key_, unit, three_numbers, in_words ? in_words : text);
  if (node) return vector_of(*node);
  remember(text, true);
  return fallback;
}

std::vector<Eigen::Vector3d> KeyReader::vectors(const char* unit) {
  const toml::node& node = table_->require(key_, unit, "an array of arrays of 3 numbers");
  if (!node.is_array() || node.as_array()->empty()) fail("is not an array of arrays of 3 numbers");
  std::vector<Eigen::Vector3d> rows;
  for (const toml::node& row : *node.as_array()) rows.push_back(vector_of(row));
  return rows;
}

std::vector<std::string> KeyReader::texts(const char* in_words) {
  const toml::node* node = table_->find(key_, "", "an array of strings", in_words);
  if (node && !node->is_array()) fail(fmt::format("is {}, allowed: an array of strings", type_name(*node)));
  std::vector<std::string> values, written;
  if (node)
    for (const toml::node& element : *node->as_array()) {
      const auto value = element.value_exact<std::string>();
      if (!value) fail(fmt::format("has {}, allowed: strings", type_name(element)));
      values.push_back(*value);
      written.push_back(quoted(*value));
    }
  remember(fmt::format("[{}]", fmt::join(written, ", ")), node == nullptr);
  return values;
}

std::map<std::string, double> KeyReader::composition() {
  const toml::node& node = table_->require(key_, "", "a composition", "a table");
  TableReader reader = table_->below(key_, node);
  std::map<std::string, double> fractions;
  double sum = 0.0;
  for (const auto& [key, value] : *node.as_table()) {
    const std::string name(key.str());
    sum += fractions[name] = reader.at(name).number(positive_fraction);
  }
  // Fractions are typed by hand: nine digits distinguish a slip from rounding.
  if (std::abs(sum - 1.0) > 1e-9) fail(fmt::format("fractions sum to {}, allowed: 1", sum));
  return fractions;
}

std::vector<KeyReader::Element> KeyReader::elements() {
  const toml::node& node = table_->require(key_, "", "an array");
  if (!node.is_array() || node.as_array()->empty()) fail("is not an array with at least one value");
  std::vector<Element> elements;
  for (const toml::node& element : *node.as_array()) {
    if (element.is_number()) {
      const double number = checked(element, any_number);
      elements.push_back({fmt::format("{}", number), number});
    } else {
      elements.push_back({written(element), std::nullopt});
    }
  }
  remember(fmt::format("[{} values]", elements.size()), false);
  return elements;
}

}  // namespace driver
