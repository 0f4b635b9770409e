// SPDX-License-Identifier: Apache-2.0
#include "table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <set>

#include "base/case_reader.hpp"
#include "base/csv_table.hpp"
#include "base/number_text.hpp"
#include "compare/compare.hpp"

namespace driver {
namespace {

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file), stream_(file, std::ios::binary) {
    if (std::filesystem::is_directory(file) || !stream_) throw CaseError(file.string() + ": cannot be read");
  }
  /// The next line that is neither a comment nor empty.
  bool next(std::string& line, PageTable* table = nullptr) {
    while (std::getline(stream_, line)) {
      ++number_;
      if (number_ == 1 && line.starts_with("\xef\xbb\xbf")) line.erase(0, 3);
      // A spreadsheet fills rows with commas up to the widest.
      while (!line.empty() && (line.back() == '\r' || line.back() == ',')) line.pop_back();
      if (const auto comment = comment_of(line)) {
        const auto colon = comment->find(": ");
        if (table && colon != std::string::npos && colon > 2)
          table->lines.emplace_back(comment->substr(2, colon - 2), comment->substr(colon + 2));
      } else if (!line.empty()) {
        return true;
      }
    }
    return false;
  }
  [[noreturn]] void fail(std::size_t column, const std::string& message) const {
    throw CaseError(
        fmt::format("{}:{}:{}: {}", file_.string(), std::max<std::size_t>(1, number_), column, message));
  }

 private:
  std::filesystem::path file_;
  std::ifstream stream_;
  std::size_t number_ = 0;
};

std::vector<std::string> header(Reader& reader, PageTable& table) {
  std::string line;
  if (!reader.next(line, &table)) reader.fail(1, "has no header row");
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    names.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  if (std::ranges::count(names, "time_s") != 1) reader.fail(1, "time_s: must be one of the columns, once");
  if (std::set<std::string>(names.begin(), names.end()).size() != names.size())
    reader.fail(1, "two columns have one name");
  return names;
}

// Columns that belong to another one: ends of an interval, or its half width.
class Bands {
 public:
  explicit Bands(const std::vector<std::string>& names) : names_(names) {
    for (std::size_t c = 0; c < names.size(); ++c) {
      const auto low = names[c].rfind("_low");
      const bool whole = low != std::string::npos && (low + 4 == names[c].size() || names[c][low + 4] == '_');
      if (const auto high = whole ? place(std::string(names[c]).replace(low, 4, "_high")) : names.size();
          high < names.size())
        intervals_.emplace_back(c, high);
      for (const std::string suffix : {band_suffix, standard_error_suffix})
        if (names[c].ends_with(suffix)) half_widths_.push_back(c);
    }
  }
  const std::vector<std::pair<std::size_t, std::size_t>>& intervals() const { return intervals_; }

  void check(const Reader& reader, const std::vector<double>& values) const {
    for (const auto& [low, high] : intervals_)
      if (values[low] > values[high])
        reader.fail(
            1, fmt::format("{}: {} is above {}, {}", names_[low], values[low], names_[high], values[high]));
    for (const std::size_t c : half_widths_)
      if (values[c] < 0.0)
        reader.fail(1, fmt::format("{}: {}: is not a half width of 0 or more", names_[c], values[c]));
  }

 private:
  std::size_t place(const std::string& name) const {
    return static_cast<std::size_t>(std::ranges::find(names_, name) - names_.begin());
  }
  const std::vector<std::string>& names_;
  std::vector<std::pair<std::size_t, std::size_t>> intervals_;
  std::vector<std::size_t> half_widths_;
};

// The numbers of a row.
void parse(const Reader& reader, const std::string& line, const std::vector<std::string>& names,
           std::vector<double>& values) {
  values.clear();
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    const std::string cell = line.substr(begin, end - begin);
    if (values.size() == names.size())
      reader.fail(begin + 1, fmt::format("a row of more than {} columns", names.size()));
    const auto value = number_of(cell);
    if (!value)
      reader.fail(begin + 1, fmt::format("{}: '{}' is not a finite number", names[values.size()], cell));
    values.push_back(*value);
    begin = end + 1;
  }
  if (values.size() != names.size())
    reader.fail(1, fmt::format("has {} columns, but the header {}", values.size(), names.size()));
}

std::size_t count_rows(const std::filesystem::path& file) {
  Reader reader(file);
  std::string line;
  std::size_t rows = 0;
  while (reader.next(line)) ++rows;
  return rows - std::min<std::size_t>(rows, 1);
}

// The row with the smallest or largest value so far in a column.
struct Extreme {
  double value = 0.0;
  std::size_t row = 0;
  std::string text;
};

class Kept {
 public:
  Kept(std::size_t total, std::size_t most) : last_(total - 1), every_((total + most - 1) / most) {}
  void offer(std::size_t row, const std::string& line, const std::vector<double>& values) {
    if (row % every_ == 0 || row == last_) rows_[row] = line;
    if (every_ == 1) return;
    least_.resize(values.size());
    largest_.resize(values.size());
    for (std::size_t c = 0; c < values.size(); ++c) {
      if (row == 0 || values[c] < least_[c].value) least_[c] = {values[c], row, line};
      if (row == 0 || values[c] > largest_[c].value) largest_[c] = {values[c], row, line};
    }
  }
  const std::map<std::size_t, std::string>& rows() {
    for (const auto* list : {&least_, &largest_})
      for (const Extreme& extreme : *list) rows_[extreme.row] = extreme.text;
    return rows_;
  }

 private:
  std::size_t last_, every_;
  std::map<std::size_t, std::string> rows_;
  std::vector<Extreme> least_, largest_;  // [column]
};

}  // namespace

PageTable read_page_table(const std::filesystem::path& file, std::size_t most) {
  PageTable table;
  Reader reader(file);
  table.columns = header(reader, table);
  const Bands bands(table.columns);
  table.intervals = bands.intervals();
  table.total = count_rows(file);
  if (table.total == 0) reader.fail(1, "has no rows");
  const auto time =
      static_cast<std::size_t>(std::ranges::find(table.columns, "time_s") - table.columns.begin());
  Kept kept(table.total, most);
  std::vector<double> values;
  std::optional<double> before;
  std::string line;
  for (std::size_t row = 0; reader.next(line); ++row) {
    parse(reader, line, table.columns, values);
    if (before && !(values[time] > *before))
      reader.fail(1, fmt::format("time_s: {} does not rise", values[time]));
    bands.check(reader, values);
    before = table.end = values[time];
    kept.offer(row, line, values);
  }
  for (const auto& [row, text] : kept.rows()) table.rows += (table.rows.empty() ? "" : "\n") + text;
  table.kept = kept.rows().size();
  return table;
}

}  // namespace driver
