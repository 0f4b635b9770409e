// SPDX-License-Identifier: Apache-2.0
// Strict reading of a case file (TOML). Each value is checked when it is read. An unknown or missing key is
// an error `file:line:column: key: what is wrong, what is allowed`. Defaults used are recorded for `gasjet
// check`. Curves have a reader of their own (curve_reader.hpp).
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace toml {
inline namespace v3 {
class table;
class node;
}  // namespace v3
}  // namespace toml

namespace driver {

/// A fault of the case file, of a file that it names, or of an override (exit code 2). what() is the whole
/// message.
class CaseError : public std::runtime_error {
 public:
  /// Shows a NUL, at which what() would end, as \x00.
  explicit CaseError(const std::string& message);
};

/// Allowed range of a number. All numbers must be finite.
struct Bounds {
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();
  bool open_low = false;                 // excludes `low` itself
  const char* text = "a finite number";  // text of the range, in messages and in the reference of keys
  const char* unit = "";                 // unit of the number; empty if it has none

  constexpr bool contain(double value) const {
    return value >= low && value <= high && !(open_low && value == low);
  }
  constexpr Bounds in(const char* its_unit) const { return {low, high, open_low, text, its_unit}; }
};
inline constexpr Bounds any_number{};
inline constexpr Bounds positive{0.0, std::numeric_limits<double>::max(), true, "a number above 0"};
inline constexpr Bounds non_negative{0.0, std::numeric_limits<double>::max(), false, "a number of 0 or more"};
// A gas with constant cp has no range of its own. Outside this one gases are no longer molecular, and powers
// overflow.
inline constexpr Bounds gas_temperature{1.0, 1e5, false, "1 to 1e5", "K"};
// Keeps densities and masses normal numbers.
inline constexpr Bounds gas_volume{1e-100, 1e100, false, "1e-100 to 1e100", "m³"};
inline constexpr Bounds fraction{0.0, 1.0, false, "a number from 0 to 1"};
inline constexpr Bounds positive_fraction{0.0, 1.0, true, "a number above 0, at most 1"};

/// One value of the case, given or by default.
struct Setting {
  std::string path;
  std::string value;
  bool is_default;
};

/// A key that the program has asked for, and what a case may write there.
struct KnownKey {
  std::string path;
  std::string unit;      // unit; empty if it has none
  std::string allowed;   // in words
  std::string fallback;  // the default; empty if the key may be absent without one, "needed" if it may not
};

/// One part of a setting's path: a key, or the number of an element of an array of tables.
struct PathPart {
  std::string key;
  std::optional<std::size_t> index;
};

/// Parts of a path such as `key.0."any key"`. Keys other than [A-Za-z_-][A-Za-z0-9_-]* are quoted as in JSON.
/// A quote that is not closed, or text beside quotes, gives an empty part.
std::vector<PathPart> split_path(const std::string& path);

/// `text`, or the beginning of a long one, for messages.
std::string shortened(const std::string& text);

/// True if the texts differ by so few letters that one may be a slip for the other.
bool is_like(std::string_view a, std::string_view b);

/// `text` in quotes that TOML and JSON both read.
std::string quoted(const std::string& text);

struct UsedCurve;
struct CaseLog;  // settings and keys read so far; folder of the case file
class TableReader;

/// One key of a table. Each call reads, checks and records its value. It throws CaseError if the value has
/// the wrong type or is out of range, or if there is neither a value nor a fallback. It is valid as long as
/// the table.
class KeyReader {
 public:
  KeyReader(TableReader& table, std::string key) : table_(&table), key_(std::move(key)) {}

  double number(Bounds bounds);
  /// `in_words` describes a fallback that depends on other settings.
  double number(Bounds bounds, double fallback, const char* in_words = nullptr);
  std::optional<double> optional_number(Bounds bounds);
  int integer(int low, int high, int fallback);
  bool flag(bool fallback);
  /// An empty fallback makes the key required.
  std::string text(const std::string& fallback = {});
  std::vector<double> numbers(Bounds bounds);
  /// Reads an array with some of the rising numbers `allowed`, each once. Returns it sorted; empty if the key
  /// is absent.
  std::vector<int> some_of(std::span<const int> allowed);
  /// Empty if the key is absent; `in_words` describes that default.
  std::vector<std::string> texts(const char* in_words = "none");
  /// One value of an array: its TOML text, and its number if it is one.
  struct Element {
    std::string text;
    std::optional<double> number;
  };
  /// Reads a non-empty array of values of any type.
  std::vector<Element> elements();
  Eigen::Vector3d vector(const char* unit);
  Eigen::Vector3d vector(const char* unit, const Eigen::Vector3d& fallback, const char* in_words = nullptr);
  /// Reads a non-empty array of vectors.
  std::vector<Eigen::Vector3d> vectors(const char* unit);
  /// Reads { name = fraction, ... }: each in (0, 1], with sum 1 within 1e-9. Returns them as given.
  std::map<std::string, double> composition();

  /// Reads one of the names in `choices`. An empty fallback makes the key required.
  template <typename Value>
  Value choice(const std::vector<std::pair<std::string, Value>>& choices, const std::string& fallback = {}) {
    std::vector<std::string> names;
    for (const auto& entry : choices) names.push_back(entry.first);
    return choices[choice_index(names, fallback)].second;
  }

 private:
  friend class CurveReader;
  std::size_t choice_index(const std::vector<std::string>& names, const std::string& fallback);
  std::string read_text(const std::string& allowed, const std::string& fallback);
  double checked(const toml::node& node, Bounds bounds) const;
  std::vector<double> numbers_of(const toml::node& node, Bounds bounds);
  Eigen::Vector3d vector_of(const toml::node& node);
  void remember(const std::string& value, bool is_default);
  [[noreturn]] void fail(const std::string& message) const;

  TableReader* table_;
  std::string key_;
};

/// One table of the case file. Read every key once, then call finish(), which refuses keys that were not
/// read.
class TableReader {
 public:
  TableReader(const toml::table& table, std::string path, std::string where, CaseLog& log);

  /// The value of a key.
  KeyReader at(const std::string& key) { return {*this, key}; }
  /// True if the key exists. Calling this marks the key as optional.
  bool has(const std::string& key) const;
  /// True if the key exists and is a table.
  bool is_table(const std::string& key) const;
  /// True if the key exists, is a table and has the key `inner`.
  bool has_in_table(const std::string& key, const std::string& inner) const;
  TableReader table(const std::string& key);
  /// Empty if the table is absent. With `defaults`, returns an empty table instead, so that its possible keys
  /// are still recorded.
  std::optional<TableReader> optional_table(const std::string& key, bool defaults = false);
  /// The tables of [[key]]; may be none.
  std::vector<TableReader> tables(const std::string& key);

  /// Throws CaseError for a key that is not one of `names`. Called first in tables whose keys need each
  /// other, so that an unknown key is reported before a missing one.
  void allow_only(const std::set<std::string>& names) const;
  /// Throws CaseError for a key of this table that no call above has read.
  void finish() const;

  /// `file:line:column: path.key` with the position of the key `place` (by default `key`), or of the table if
  /// it does not exist.
  std::string label(const std::string& key, const std::string& place = {}) const;
  /// Throws CaseError: the label of the key, and the message.
  [[noreturn]] void fail(const std::string& key, const std::string& message) const;
  /// Runs `action`. A std::invalid_argument from it becomes a CaseError at `key`, or at the table if `key` is
  /// empty.
  void located(const std::string& key, const std::function<void()>& action) const;
  /// Path of `file`, which the case names relative to its own folder.
  std::filesystem::path beside_case(const std::string& file) const;
  const std::string& path() const { return path_; }

 private:
  friend class KeyReader;
  friend class CurveReader;
  const toml::node* find(const std::string& key, const std::string& unit, const std::string& allowed,
                         const std::string& fallback);
  const toml::node& require(const std::string& key, const std::string& unit, const std::string& allowed,
                            const char* in_short = nullptr);
  TableReader below(const std::string& key, const toml::node& node) const;
  std::string misspelt(const std::string& key) const;
  std::string join(const std::string& key) const;

  const toml::table* table_;
  std::string path_;
  std::string where_;
  CaseLog* log_;
  std::set<std::string> asked_;
};

/// The text of a key that is the name of a file or folder, not a path.
std::string file_name(TableReader& table, const std::string& key, const std::string& fallback);

/// Prefix of an override that removes a key or a table from the case: "unset key.path".
inline constexpr std::string_view unset_prefix = "unset ";

/// An override as written on a command line: `--set key.path=value` or `--unset key.path`, in apostrophes if
/// the shell needs them.
std::string as_option(const std::string& override_text);

/// A parsed case file with its overrides applied. It owns the data that its readers refer to.
class CaseDocument {
 public:
  /// `overrides`, applied in order, are `key.path=value`, with the value in TOML syntax (a bare word is a
  /// string), or `unset key.path`. Throws CaseError.
  CaseDocument(const std::filesystem::path& file, const std::vector<std::string>& overrides);
  /// The same for a text. `file` is its name in messages; files that it names are relative to the folder of
  /// `file`.
  static CaseDocument of_text(const std::string& toml_text, const std::filesystem::path& file,
                              const std::vector<std::string>& overrides);
  ~CaseDocument();
  CaseDocument(CaseDocument&&) noexcept;
  TableReader root();
  const std::vector<Setting>& settings() const;
  /// The keys that the program has asked for so far, in that order, including keys of curves and
  /// compositions.
  const std::vector<KnownKey>& keys() const;
  /// Curves read so far that the case does not show as they are used.
  const std::vector<UsedCurve>& used_curves() const;
  const std::filesystem::path& file() const { return file_; }
  /// The case file and those files named in it that have been read.
  std::vector<std::filesystem::path> files() const;
  /// The files that the case names, whether or not they have been read.
  std::vector<std::filesystem::path> named_files() const;
  /// The case as TOML with its overrides applied, to be stored in `folder`: paths of the files that it names
  /// are relative to `folder`.
  std::string text(const std::filesystem::path& folder) const;

 private:
  CaseDocument(const std::string& toml_text, const std::filesystem::path& file,
               const std::vector<std::string>& overrides);

  std::filesystem::path file_;
  std::unique_ptr<toml::table> table_;
  std::unique_ptr<CaseLog> log_;
};

}  // namespace driver
