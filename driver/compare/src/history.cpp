// SPDX-License-Identifier: Apache-2.0
#include "compare/history.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "abstat.hpp"
#include "base/case_reader.hpp"
#include "base/csv_table.hpp"
#include "base/named_units.hpp"
#include "column_names.hpp"
#include "ensemble_history.hpp"
#include "lsdyna_text.hpp"
#include "results/unit_endings.hpp"

namespace driver {
namespace {

// value [SI] = scale * (value of the file, by its unit) + offset
struct MappedColumn {
  std::string name;    // name in Gasjet
  std::string column;  // name in the file; one * stands for any characters
  double scale = 1.0;
  double offset = 0.0;
  NamedUnit unit = {};
  std::string name_label = {}, column_label = {};  // positions in the map
};

enum class Format { csv, abstat, rcforc, nodout, rbdout };

struct Map {
  Format format = Format::csv;
  int volume_number = 1;
  std::optional<int> number;          // of a contact, node or rigid body
  std::vector<MappedColumn> columns;  // the time first
};

MappedColumn read_column(TableReader&& table, const std::string& name) {
  MappedColumn column;
  column.name = name.empty() ? table.at("name").text() : name;
  if (column.name.empty()) table.fail("name", "is empty, allowed: the name of a quantity");
  column.name_label = table.label("name");
  column.column = table.at("column").text();
  column.column_label = table.label("column");
  if (column.column.empty() || std::count(column.column.begin(), column.column.end(), '*') > 1)
    table.fail("column", fmt::format("is '{}', allowed: a name with at most one *", column.column));
  column.scale = table.at("scale").number(any_number, 1.0);
  if (column.scale == 0.0) table.fail("scale", "is 0, which erases the column; allowed: another number");
  column.offset = table.at("offset").number(any_number, 0.0);
  if (table.has("unit"))
    table.located("unit", [&] {
      column.unit = unit_named(table.at("unit").text(), unit_by_ending(column.name), zero_of(column.name));
    });
  table.finish();
  return column;
}

Map read_map(const std::filesystem::path& file) {
  CaseDocument document(file, {});
  TableReader root = document.root();
  Map map;
  map.format = root.at("format").choice<Format>({{"csv", Format::csv},
                                                 {"abstat", Format::abstat},
                                                 {"rcforc", Format::rcforc},
                                                 {"nodout", Format::nodout},
                                                 {"rbdout", Format::rbdout}});
  constexpr int most = 1000000000;
  if (map.format == Format::abstat)
    map.volume_number = root.at("volume_number").integer(1, most, 1);
  else if (map.format != Format::csv && root.has("number"))
    map.number = root.at("number").integer(1, most, 1);
  map.columns.push_back(read_column(root.table("time"), "time_s"));
  for (auto& table : root.tables("quantity")) {
    map.columns.push_back(read_column(std::move(table), ""));
    const auto same = [&](const MappedColumn& c) { return c.name == map.columns.back().name; };
    if (std::count_if(map.columns.begin(), map.columns.end(), same) > 1)
      root.fail("quantity", fmt::format("{} is given twice", map.columns.back().name));
  }
  root.finish();
  return map;
}

bool matches(const std::string& pattern, const std::string& name) {
  const auto star = pattern.find('*');
  if (star == pattern.npos) return name == pattern;
  const std::string_view tail = std::string_view(pattern).substr(star + 1);
  return name.size() + 1 >= pattern.size() && name.starts_with(pattern.substr(0, star)) &&
         name.ends_with(tail);
}

using NameCounts = std::unordered_map<std::string, std::size_t>;

// The comparison that a history with foreign names is read for.
struct Purpose {
  const History& reference;
  const std::vector<std::string>& only;

  bool needs(const std::string& name) const {
    return only.empty() ? reference.find(name) != nullptr : std::ranges::find(only, name) != only.end();
  }
};

// True for components from which `compare` makes filtered accelerations.
bool is_component(const std::string& name) {
  return name == "pendulum_cg_tangential_m_s2" || name == "pendulum_cg_radial_m_s2";
}

// Names of the map that the reference does not have, with their positions.
std::vector<std::string> names_left_out(const Map& map, const Purpose& purpose) {
  std::vector<std::string> left_out;
  for (const auto& column : map.columns) {
    if (&column == &map.columns.front() || is_component(column.name)) continue;
    if (purpose.reference.find(column.name)) continue;
    for (const auto& [name, values] : purpose.reference.columns) {
      const auto same = [&wanted = name](const MappedColumn& other) { return other.name == wanted; };
      if (is_like(column.name, name) && std::ranges::none_of(map.columns, same))
        throw CaseError(fmt::format("{}: the reference has no column '{}'; is '{}' meant?", column.name_label,
                                    column.name, name));
    }
    left_out.push_back(fmt::format("{}: '{}'", column.name_label, column.name));
  }
  return left_out;
}

[[noreturn]] void fail_missing(const std::filesystem::path& file, const CsvHeader& header,
                               const MappedColumn& column) {
  const auto like =
      std::ranges::find_if(header.names, [&](const auto& name) { return is_like(name, column.column); });
  throw CaseError(fmt::format(
      "{}: '{}' is not in {}, the header has {}; {}", column.column_label, column.column, file.string(),
      fmt::join(header.names, ", "),
      like == header.names.end() ? "--columns compares others" : fmt::format("is '{}' meant?", *like)));
}

// Names of the header that match a pattern.
std::vector<std::string> matching(const CsvHeader& header, const NameCounts& counts,
                                  const std::string& pattern) {
  if (pattern.find('*') == std::string::npos) {
    const auto found = counts.find(pattern);
    return std::vector<std::string>(found == counts.end() ? 0 : found->second, pattern);
  }
  std::vector<std::string> found;
  for (const auto& name : header.names)
    if (matches(pattern, name)) found.push_back(name);
  return found;
}

// The column's name in the header; empty when it is not there.
std::string find_column(const std::filesystem::path& file, const CsvHeader& header, const NameCounts& counts,
                        const std::string& pattern) {
  const auto found = matching(header, counts, pattern);
  if (found.size() > 1)
    throw CaseError(fmt::format("{}:{}:1: '{}' is more than one column: {}", file.string(), header.line,
                                pattern, fmt::join(found, "; ")));
  return found.empty() ? "" : found.front();
}

std::vector<MappedColumn> own_columns(const CsvHeader& header) {
  std::vector<MappedColumn> columns{{"time_s", "time_s"}};
  for (const auto& name : header.names)
    if (name != "time_s") columns.push_back({name, name});
  return columns;
}

// Reads a CSV file by a map; `columns` get the file's full names. A map may name columns that the file does
// not have, unless the comparison needs them.
CsvTable read_mapped_csv(const std::filesystem::path& file, std::vector<MappedColumn>& columns,
                         const CsvHeader& header, const Purpose* purpose) {
  NameCounts counts;
  for (const auto& name : header.names) ++counts[name];
  for (auto& column : columns) {
    const auto name = find_column(file, header, counts, column.column);
    if (!name.empty())
      column.column = name;
    else if (&column == &columns.front())
      continue;  // read_csv throws for a file without time
    else if (purpose && purpose->needs(column.name))
      fail_missing(file, header, column);
    else
      column.name.clear();
  }
  std::erase_if(columns, [](const MappedColumn& c) { return c.name.empty(); });
  std::vector<std::string> names;
  for (const auto& column : columns) names.push_back(column.column);
  return read_csv(file, names);
}

// The squares of larger values and times overflow.
constexpr double largest_magnitude = 1e100;

History in_si_units(CsvTable& table, const std::vector<MappedColumn>& columns) {
  History history;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    auto values = std::move(table.values[c]);
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = columns[c].scale * columns[c].unit.to_si(values[i]) + columns[c].offset;
      if (!(std::abs(values[i]) <= largest_magnitude))
        table.fail(c, i, fmt::format("{} in SI units, allowed: a magnitude of at most 1e100", values[i]));
      if (values[i] < 0.0 && columns[c].name.ends_with(band_suffix))
        table.fail(c, i, fmt::format("{}: is not a half width of 0 or more", values[i]));
      if (values[i] < 0.0 && columns[c].name.ends_with(standard_error_suffix))
        table.fail(c, i, fmt::format("{}: is not a standard error of 0 or more", values[i]));
    }
    if (c == 0)
      history.time = std::move(values);
    else
      history.columns.emplace_back(columns[c].name, std::move(values));
  }
  return history;
}

void check_times(const CsvTable& table, const History& history) {
  constexpr std::size_t fewest = 3;  // the error of interpolation needs a parabola
  if (table.rows() < fewest)
    throw CaseError(fmt::format("{}:{}:1: has {} rows, needed: {} or more", table.file.string(),
                                table.rows() > 0 ? table.lines.back() : 1, table.rows(), fewest));
  for (std::size_t i = 1; i < history.time.size(); ++i)
    if (!(history.time[i] > history.time[i - 1]))
      table.fail(0, i,
                 fmt::format("{} s follows {} s, allowed: strictly rising times", history.time[i],
                             history.time[i - 1]));
}

// The columns of `table` that the map names, in the map's order.
CsvTable select(CsvTable&& table, const std::vector<MappedColumn>& columns) {
  CsvTable chosen{table.file, {}, {}, table.lines, {}};
  for (const auto& column : columns) {
    const auto found = std::find(table.names.begin(), table.names.end(), column.column);
    if (found == table.names.end())
      throw CaseError(fmt::format("{}: the file {} has no '{}', allowed: {}", column.column_label,
                                  table.file.string(), column.column, fmt::join(table.names, ", ")));
    const auto c = static_cast<std::size_t>(found - table.names.begin());
    chosen.names.push_back(table.names[c]);
    chosen.values.push_back(table.values[c]);
    chosen.positions.push_back(table.positions[c]);
  }
  return chosen;
}

CsvTable read_text_of(const std::filesystem::path& file, const Map& map) {
  switch (map.format) {
    case Format::rcforc:
      return read_lsdyna_text(file, LsDynaText::rcforc, map.number);
    case Format::nodout:
      return read_lsdyna_text(file, LsDynaText::nodout, map.number);
    case Format::rbdout:
      return read_lsdyna_text(file, LsDynaText::rbdout, map.number);
    default:
      return read_abstat(file, map.volume_number);
  }
}

History read(const std::filesystem::path& file, const std::filesystem::path& map_file,
             const Purpose* purpose) {
  Map map;
  if (!map_file.empty()) map = read_map(map_file);
  std::vector<std::string> left_out;
  if (purpose) left_out = names_left_out(map, *purpose);
  CsvTable table;
  if (map.format != Format::csv) {
    table = select(read_text_of(file, map), map.columns);
  } else {
    const std::string time = map_file.empty() ? "time_s" : map.columns.front().column;
    const CsvHeader header = read_csv_header(file, [&](const auto& name) { return matches(time, name); });
    if (map_file.empty()) map.columns = own_columns(header);
    if (map_file.empty() && purpose && std::ranges::find(header.names, "time_s") == header.names.end())
      throw CaseError(fmt::format("{}:{}:1: {}; --map names the columns of another program", file.string(),
                                  header.line, no_such_column("time_s", header.names)));
    table = read_mapped_csv(file, map.columns, header, map_file.empty() ? nullptr : purpose);
  }
  History history = in_si_units(table, map.columns);
  check_times(table, history);
  read_ensemble_lines(history, file);
  history.left_out = std::move(left_out);
  return history;
}

}  // namespace

const std::vector<double>* History::find(const std::string& name) const {
  for (const auto& [own, values] : columns)
    if (own == name) return &values;
  return nullptr;
}

History read_history(const std::filesystem::path& file, const std::filesystem::path& map) {
  return read(file, map, nullptr);
}

History read_history(const std::filesystem::path& file, const std::filesystem::path& map,
                     const History& reference, const std::vector<std::string>& only) {
  const Purpose purpose{reference, only};
  return read(file, map, &purpose);
}

}  // namespace driver
